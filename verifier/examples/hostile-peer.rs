//! A peer for the verifier's own tests: it answers honestly over `ncp-spec`, until it does what its mode says.
//!
//! The trigger is the request that asks for version `9.9`, or the n-th request of the process. In a version that it is
//! asked for, `own` stands for the wire version, so that the tests' vectors need not name it.

#![forbid(unsafe_code)]

use std::io::{BufRead as _, Read as _, Write as _};
use std::process::exit;
use std::thread::sleep;
use std::time::Duration;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use ncp_spec::version::check_version;
use ncp_spec::wire::{Kind, decode};
use ncp_spec::{CONTRACT_HASH, WIRE_VERSION};
use serde_json::{Value, json};

fn main() {
    let mode = std::env::args().nth(1).unwrap_or_default();
    match mode.as_str() {
        "exits-at-once" => {
            eprintln!("no configuration found");
            exit(7);
        }
        "says-hello" => println!("Hello, I am a peer."),
        _ => {}
    }
    let mut held = Vec::new();
    let luck = usize::try_from(std::process::id() % 13).unwrap_or_default();
    for (count, line) in (1_usize..).zip(std::io::stdin().lock().lines()) {
        let Ok(line) = line else { break };
        let Ok(request) = serde_json::from_str::<Value>(&line) else { exit(9) };
        let answer = answer(&mode, &request);
        let target = request["args"]["version"] == "9.9";
        let case = request["call"] != "describe";
        match mode.as_str() {
            "die-on-7th" if count == 7 => exit(101),
            "die-on-target" if target => {
                eprintln!("assertion failed: version < 9");
                std::process::abort();
            }
            "die-after-target" if target => {
                say(&answer);
                exit(3);
            }
            // As a program with a backtrace does: it says more when it is told to.
            "die-on-even" if case && text_of(&request).ends_with(['0', '2', '4', '6', '8']) => {
                eprintln!("the minor version is even");
                if std::env::var("RUST_BACKTRACE").is_ok_and(|told| told == "1") {
                    (0..40).for_each(|frame| eprintln!("frame {frame}"));
                }
                std::process::abort();
            }
            // 150 of 8,000 versions.
            "die-on-150" if case && is_one_of_150(&request) => std::process::abort(),
            "die-on-checks" if request["call"] == "version.check" => exit(1),
            "die-once-broken" if case && std::env::args().nth(2).is_some_and(|flag| ruined(&flag, target)) => exit(1),
            "die-on-every-case" if case => exit(1),
            "sleep-forever" if case => forever(),
            "sleep-on-target" if target => forever(),
            "binary-on-target" if target => raw(&[0, 0xff, 0xfe, b'{', 7, b'\n']),
            "binary-on-every-case" if case => raw(&[0, 0xff, 0xfe, b'{', 7, b'\n']),
            "prints-after-target" if target => {
                say(&answer);
                raw(b"DEBUG: answered\n");
            }
            // As over a slow road, or on a busy machine.
            "prints-late-after-target" if target => {
                say(&answer);
                sleep(Duration::from_millis(200));
                raw(b"DEBUG: answered\n");
            }
            "twice-on-target" if target => {
                say(&answer);
                say(&answer);
            }
            "twice-always" if case => {
                say(&answer);
                say(&answer);
            }
            // As a peer whose buffer is too small.
            "cuts-large" if line.len() > 1 << 20 => {
                say(&json!({"id": request["id"], "result": {"text": &text_in(&answer)[..1 << 20]}}));
            }
            "skips-target" if target => {}
            "skips-7th" if count == 7 => {}
            "unknown-id-on-target" if target => say(&json!({"id": 999_999, "result": {}})),
            "no-result-on-target" if target => say(&json!({"id": request["id"]})),
            "huge-line-on-target" if target => {
                // 1 GiB, unless nobody reads any more.
                let piece = [b'x'; 1 << 16];
                let mut out = std::io::stdout().lock();
                while out.write_all(&piece).is_ok() {}
                forever();
            }
            "floods-stderr" => {
                let piece = [b'e'; 1 << 16];
                for _ in 0..32 {
                    let _ = std::io::stderr().write_all(&piece);
                }
                say(&answer);
            }
            "slow" => {
                sleep(Duration::from_millis(120));
                say(&answer);
            }
            // It is slow, and writes down what it was asked.
            "writes-down" if case => {
                note(&format!("{}\n", text_of(&request)));
                sleep(Duration::from_millis(1));
                say(&answer);
            }
            // It dies after a few answers, until it has died as often as it was told.
            "dies-at-random" if case => {
                say(&answer);
                if count > 1 + luck && deaths_left() {
                    note("x");
                    std::process::abort();
                }
            }
            "unordered" if case => {
                held.push(answer);
                if held.len() == 5 {
                    held.drain(..).rev().for_each(|answer| say(&answer));
                }
            }
            "stops-reading" if count == 2 => forever(),
            "half-a-line-on-target" if target => {
                raw(b"{\"id\":");
                exit(0);
            }
            _ => say(&answer),
        }
    }
    held.iter().rev().for_each(say);
    match mode.as_str() {
        "never-ends" => forever(),
        "ends-badly" => exit(5),
        "prints-at-the-end" => raw(b"bye\n"),
        _ => {}
    }
}

fn answer(mode: &str, request: &Value) -> Value {
    let args = &request["args"];
    let text = |name: &str| args[name].as_str().unwrap_or_default().to_owned();
    let outcome = match request["call"].as_str() {
        Some("describe") => Ok(describe(mode)),
        _ if mode == "unsupported" => return json!({"id": request["id"], "unsupported": true}),
        _ if mode == "panics" => Err(("internal", "a panic was caught".to_owned())),
        Some("version.check") => check_version(&text("version").replace("own", WIRE_VERSION), args["strict"] == true)
            .map(|compatible| json!({"compatible": compatible != (mode == "wrong-answer" && text("version") == "9.9")}))
            .map_err(|error| ("version", error.to_string())),
        Some("decode") => {
            let frame = if args["base64"].is_string() {
                STANDARD.decode(text("base64")).unwrap_or_default()
            } else {
                text("text").into_bytes()
            };
            let kind = Kind::parse(&text("kind")).unwrap_or(Kind::Error);
            decode(kind, &frame)
                .map_err(|error| (error.code().as_str(), error.to_string()))
                .and_then(|message| message.encode().map_err(|error| (error.code().as_str(), error.to_string())))
                .map(|text| json!({ "text": text }))
        }
        _ => return json!({"id": request["id"], "unsupported": true}),
    };
    match outcome {
        Ok(mut result) => {
            if mode == "talkative" {
                result["elapsed_ms"] = json!(3);
                result["trace"] = json!({"text": "x", "compatible": null});
            }
            json!({"id": request["id"], "result": result})
        }
        Err((code, message)) => {
            let code = if mode == "other-codes" { "limit" } else { code };
            json!({"id": request["id"], "error": {"code": code, "message": message}})
        }
    }
}

fn describe(mode: &str) -> Value {
    let mut about = json!({
        "name": "hostile", "version": "1.0", "language": "Rust", "wire_version": WIRE_VERSION,
        "contract_hash": CONTRACT_HASH, "roles": ["body", "observer"],
    });
    match mode {
        "wrong-describe" => about["contract_hash"] = json!("2cf0763ad61e4f1c"),
        "claims-nothing" => about["roles"] = json!([]),
        "half-described" => about["roles"] = Value::Null,
        _ => {}
    }
    about
}

fn text_of(request: &Value) -> &str {
    request["args"]["version"].as_str().unwrap_or_default()
}

fn text_in(answer: &Value) -> &str {
    answer["result"]["text"].as_str().unwrap_or_default()
}

/// Whether the minor version is one of 150 below 8,000: thirteen side by side, and the others far apart.
fn is_one_of_150(request: &Value) -> bool {
    let minor: u32 = text_of(request).trim_start_matches("9.").parse().unwrap_or_default();
    (4000..4013).contains(&minor) || (minor < 4000 && minor % 29 == 28)
}

/// Whether the file that stands for a broken machine is there; `now` breaks it.
fn ruined(flag: &str, now: bool) -> bool {
    now && std::fs::write(flag, "").is_ok() || std::path::Path::new(flag).exists()
}

/// Appends to the file that is named.
fn note(text: &str) {
    let file = std::env::args().nth(2).unwrap_or_default();
    let written = std::fs::OpenOptions::new().append(true).create(true).open(file);
    if written.and_then(|mut file| file.write_all(text.as_bytes())).is_err() {
        exit(9);
    }
}

/// Whether the file that is named has fewer bytes than the number behind it.
fn deaths_left() -> bool {
    let (file, most) = (std::env::args().nth(2), std::env::args().nth(3));
    let died = std::fs::metadata(file.unwrap_or_default()).map_or(0, |file| file.len());
    most.and_then(|most| most.parse().ok()).is_some_and(|most: u64| died < most)
}

fn say(answer: &Value) {
    raw(format!("{answer}\n").as_bytes());
}

fn raw(bytes: &[u8]) {
    let mut out = std::io::stdout().lock();
    if out.write_all(bytes).and_then(|()| out.flush()).is_err() {
        exit(0);
    }
}

/// Longer than any test waits.
fn forever() -> ! {
    // Even the end of the input changes nothing.
    let _ = std::io::stdin().lock().read_to_end(&mut Vec::new());
    loop {
        sleep(Duration::from_secs(600));
    }
}
