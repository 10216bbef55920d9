//! The rules of chapters 1 and 6, one by one: what is rejected and why, and what is not.
#![allow(clippy::expect_used, clippy::panic, reason = "helpers of tests may panic as tests may")]

use ncp_spec::wire::{
    BulkObservation, Capabilities, ChannelMap, ChannelValue, CommandFrame, DecodeError, ErrorFrame, Frame, Kind,
    MAX_ENTRIES, MAX_FRAME_BYTES, MAX_ITEMS, MAX_OBSERVATION_BYTES, Message, Mode, NetworkRef, Observable,
    ObservationFrame, OpenSession, RunRequest, SensorFrame, SessionOpened, SimProvenance, StepRequest, StimulusFrame,
    build, decode, decode_any,
};
use ncp_spec::{CONTRACT_HASH, ErrorCode, WIRE_VERSION};

fn command(members: &str) -> Result<CommandFrame, DecodeError> {
    CommandFrame::decode(format!(r#"{{"kind":"command_frame"{members}}}"#).as_bytes())
}

/// Asserts that each text, as further members of a command frame, is rejected for a reason.
fn rejected(code: ErrorCode, members: &[&str]) {
    for members in members {
        let error = command(members).expect_err(members);
        assert_eq!(error.code(), code, "{members}: {error}");
    }
}

fn accepted(members: &[&str]) {
    for members in members {
        command(members).unwrap_or_else(|error| panic!("{members}: {error}"));
    }
}

// ---- 1.1 frames ------------------------------------------------------------------------------

#[test]
fn bytes_that_are_not_one_json_object_in_utf8_are_malformed() {
    let whole = br#"{"kind":"command_frame"}"#;
    let frames: [&[u8]; 18] = [
        b"",
        b" ",
        b"[]",
        b"null",
        b"0",
        br#""command_frame""#,
        br#"{"kind":"command_frame""#,
        br#"{"kind":"command_frame"}}"#,
        br#"{"kind":"command_frame"} x"#,
        br#"{"kind":"command_frame"}{}"#,
        br#"{"kind":"command_frame",}"#,
        br#"{,"kind":"command_frame"}"#,
        br#"{"kind":"command_frame" "seq":1}"#,
        br#"{'kind':'command_frame'}"#,
        b"\xef\xbb\xbf{\"kind\":\"command_frame\"}",
        b"{\"kind\":\"command_frame\"}\0",
        b"{\"kind\":\"command_frame\",\"x\":\"\xff\"}",
        b"\xff\xfe{\0\"\0k\0",
    ];
    for frame in frames {
        let error = CommandFrame::decode(frame).expect_err(&String::from_utf8_lossy(frame));
        assert_eq!(error.code(), ErrorCode::Malformed, "{error}");
    }
    // Every beginning of a frame, too.
    for len in 0..whole.len() {
        assert!(CommandFrame::decode(&whole[..len]).is_err(), "{len}");
        assert!(decode_any(&whole[..len]).is_err(), "{len}");
    }
}

#[test]
fn white_space_may_stand_between_all_tokens_and_nothing_else_may() {
    let frame = " \t\r\n{ \n\"kind\" \t:\r \"command_frame\" , \
        \"channels\" : { \"a\" : { \"data\" : [ 1 , 2 ] } } , \"seq\"\n:\n7 } \n\n";
    let read = CommandFrame::decode(frame.as_bytes()).unwrap();
    assert_eq!((read.seq, &read.channels["a"].data), (7, &vec![1.0, 2.0]));
    for other in ["\u{b}", "\u{c}", "\u{a0}", "\u{feff}", "\0", "/**/"] {
        let frame = format!(r#"{{"kind":{other}"command_frame"}}"#);
        assert!(CommandFrame::decode(frame.as_bytes()).is_err(), "{other:?}");
    }
}

#[test]
fn a_name_may_not_occur_twice_at_any_depth_and_in_any_spelling() {
    rejected(
        ErrorCode::Malformed,
        &[
            r#","seq":1,"seq":1"#,
            r#","seq":1,"s\u0065q":1"#,
            r#","kind":"command_frame""#,
            r#","k\u0069nd":"command_frame""#,
            r#","horizon_dt_ms":null,"horizon_dt_ms":null"#,
            r#","x":1,"x":2"#,
            r#","x":1,"y":0,"\u0078":2"#,
            r#","":1,"":2"#,
            r#","channels":{"a":{},"b":{},"a":{}}"#,
            r#","channels":{"b":{},"a":{},"\u0061":{}}"#,
            r#","channels":{"a":{"data":[],"data":[]}}"#,
            r#","channels":{"a":{"x":1,"x":1}}"#,
            r#","horizon":[{},{"a":{},"a":{}}]"#,
            r#","x":{"a":1,"a":1}"#,
            r#","x":[[{"a":{"b":0,"b":0}}]]"#,
            r#","x":{"a":{"c":1},"b":{"c":1,"d":1},"a":1}"#,
        ],
    );
    // The same name in different objects is no repetition.
    accepted(&[
        r#","x":{"a":1,"b":{"a":1}},"y":[{"a":1},{"a":1}]"#,
        r#","channels":{"a":{"x":1},"b":{"x":1}},"x":1"#,
        r#","X":1,"x":1,"Seq":1"#,
    ]);
}

#[test]
fn strings_hold_what_the_grammar_allows() {
    let read = command(r#","frame_id":"\"\\\/\b\f\n\r\t\u00e9\ud83d\ude81é🚁\u0000""#).unwrap();
    assert_eq!(read.frame_id, "\"\\/\u{8}\u{c}\n\r\té🚁é🚁\0");
    rejected(
        ErrorCode::Malformed,
        &[
            r#","frame_id":"\x""#,
            r#","frame_id":"\u12g4""#,
            r#","frame_id":"\u123""#,
            r#","frame_id":"\U0041""#,
            ",\"frame_id\":\"\n\"",
            ",\"frame_id\":\"\u{0}\"",
            ",\"frame_id\":\"a\u{1f}\"",
            ",\"frame_id\":\"aaaaaaaaaaaaaaaaaaaa\u{1f}\"",
            r#","frame_id":"\ud83d""#,
            r#","frame_id":"\ude81""#,
            r#","frame_id":"\ude81\ud83d""#,
            r#","frame_id":"\ude81\ude81""#,
            r#","frame_id":"\ud83d\ud83d\ude81""#,
            r#","frame_id":"\ud83dx""#,
            r#","frame_id":"\ud83d\n""#,
            r#","x":"\ud83d""#,
            r#","\ud83d":1"#,
            r#","frame_id":"a"#,
            r#","frame_id":"a\"#,
        ],
    );
    accepted(&[",\"frame_id\":\"\u{7f}\u{80}\u{ffff}\"", r#","frame_id":"\uffff\u0000""#]);
}

// ---- 1.2 numbers -----------------------------------------------------------------------------

#[test]
fn an_integer_has_one_spelling_and_53_bits() {
    for (spelled, value) in [
        ("0", 0),
        ("7", 7),
        ("-1", -1),
        ("9007199254740991", 9_007_199_254_740_991),
        ("-9007199254740991", -9_007_199_254_740_991),
    ] {
        assert_eq!(command(&format!(r#","seq":{spelled}"#)).unwrap().seq, value);
    }
    for spelled in ["1.0", "1e3", "-0", "0.0", "1E0", "0e0", "-0.0", "9007199254740991.0"] {
        rejected(ErrorCode::Type, &[&format!(r#","seq":{spelled}"#)]);
    }
    for spelled in [
        "9007199254740992",
        "-9007199254740992",
        "9223372036854775807",
        "-9223372036854775808",
        "18446744073709551616",
        "18446744073709551615",
        "100000000000000000000000000000000000000000",
    ] {
        rejected(ErrorCode::Value, &[&format!(r#","seq":{spelled}"#)]);
    }
    for spelled in ["01", "00", "-01", "+1", "0x1", "1_0", "--1", "-", "1.", ".1", "1e", "1e+", "١"] {
        rejected(ErrorCode::Malformed, &[&format!(r#","seq":{spelled}"#)]);
    }
}

#[test]
fn a_number_is_the_nearest_double() {
    for (spelled, value) in [
        ("5", 5.0),
        ("5.0", 5.0),
        ("50e-1", 5.0),
        ("0.5E+1", 5.0),
        ("5e00", 5.0),
        ("1.7976931348623158e308", f64::MAX),
        ("17976931348623157e292", f64::MAX),
        ("5e-324", f64::from_bits(1)),
        ("2.4703282292062327e-324", 0.0),
        ("2.4703282292062328e-324", f64::from_bits(1)),
        ("2.2250738585072011e-308", 2.225_073_858_507_201e-308),
        ("9007199254740993", 9_007_199_254_740_992.0),
        ("9007199254740993.00000000000000000000000000001", 9_007_199_254_740_994.0),
        ("0.1", 0.1),
        ("0.30000000000000004", 0.1 + 0.2),
        ("1e-400", 0.0),
        ("0e999999999999999999999999", 0.0),
        ("1e-999999999999999999999999", 0.0),
        ("123456789012345678", 123_456_789_012_345_680.0),
        ("1e22", 1e22),
        ("1e23", 1e23),
        ("9007199254740991e22", 9.007_199_254_740_99e37),
    ] {
        for sign in ["", "-"] {
            let t = command(&format!(r#","t":{sign}{spelled}"#)).unwrap().t;
            let expected = if sign.is_empty() { value } else { -value };
            assert_eq!(t.to_bits(), expected.to_bits(), "{sign}{spelled}");
        }
    }
    let many = format!("0.{}1", "0".repeat(100_000));
    assert_eq!(command(&format!(r#","t":{many}"#)).unwrap().t, 0.0);
}

#[test]
fn a_number_beyond_the_largest_double_is_rejected_also_where_it_is_ignored() {
    for spelled in ["1.7976931348623159e308", "1e309", "-1e309", "1e999999999999999999999", "17976931348623159e292"] {
        rejected(
            ErrorCode::Malformed,
            &[
                &format!(r#","t":{spelled}"#),
                &format!(r#","channels":{{"a":{{"data":[0,{spelled}]}}}}"#),
                &format!(r#","x":{spelled}"#),
                &format!(r#","x":[{{"y":{spelled}}}]"#),
            ],
        );
    }
}

// ---- 1.3 fields ------------------------------------------------------------------------------

#[test]
fn a_field_of_another_type_is_rejected_and_named() {
    rejected(
        ErrorCode::Type,
        &[
            r#","seq":"1""#,
            r#","seq":null"#,
            r#","seq":true"#,
            r#","seq":[1]"#,
            r#","t":"0""#,
            r#","t":null"#,
            r#","frame_id":1"#,
            r#","frame_id":null"#,
            r#","mode":null"#,
            r#","mode":2"#,
            r#","mode":["estop"]"#,
            r#","channels":null"#,
            r#","channels":[]"#,
            r#","channels":{"a":null}"#,
            r#","channels":{"a":[1]}"#,
            r#","channels":{"a":{"data":null}}"#,
            r#","channels":{"a":{"data":[null]}}"#,
            r#","channels":{"a":{"data":["1"]}}"#,
            r#","channels":{"a":{"data":{}}}"#,
            r#","channels":{"a":{"unit":1}}"#,
            r#","horizon":{}"#,
            r#","horizon":[null]"#,
            r#","horizon":[[]]"#,
            r#","horizon":[{"channels":{"a":{}},"x":[]}]"#,
            r#","horizon_dt_ms":"1""#,
            r#","horizon_dt_ms":false"#,
            r#","ncp_version":5"#,
            r#","ncp_version":null"#,
        ],
    );
    let error = command(r#","horizon":[{},{"a":{"data":[0,"x"]}}]"#).unwrap_err();
    assert_eq!(error.path(), "horizon[1].a.data[1]");
    assert_eq!(error.to_string(), "horizon[1].a.data[1]: expected a number, found a string (byte 54)");
}

#[test]
fn an_error_in_a_string_or_of_a_repeated_name_says_where_and_what() {
    let said = |members: &str| command(members).unwrap_err().to_string();
    let command = r#"{"kind":"command_frame""#.len();
    let at = |place: usize| format!("(byte {})", command + place);
    assert_eq!(said(r#","x":"\n"#).replace(&at(9), "there"), "x: not JSON: expected '\"' there");
    assert_eq!(
        said(",\"x\":\"\\n\u{1}\"").replace(&at(8), "there"),
        "x: not JSON: expected no control character in a string there"
    );
    assert_eq!(said(r#","x":1,"y":2,"x":3"#).replace(&at(13), "there"), "x: the member occurs twice there");
}

// [NCP-WIRE-008]
#[test]
fn a_first_half_of_a_pair_does_not_pair_with_bare_digits() {
    rejected(
        ErrorCode::Malformed,
        &[
            r#","x":"\ud83d\ude00" ,"y":"\ud83d..de00""#,
            r#","x":"\ud83d\nde00""#,
            r#","x":"\ud83d\\de00""#,
            r#","x":"\ude00\ude00""#,
        ],
    );
    accepted(&[r#","x":"\ud83d\ude00..de00""#]);
}

// [NCP-WIRE-015]
#[test]
fn digits_that_wrap_around_64_bits_are_read_as_they_stand() {
    // 2^64 + 1, with the point in each place.
    let digits = "18446744073709551617";
    for point in 1..digits.len() {
        let (whole, fraction) = digits.split_at(point);
        let number = format!("{whole}.{fraction}");
        let read = command(&format!(r#","ttl_ms":{number}"#)).unwrap();
        assert_eq!(read.ttl_ms, number.parse::<f64>().unwrap(), "{number}");
    }
}

#[test]
fn an_absent_field_is_its_default_and_null_stands_for_an_absent_optional() {
    let absent = command("").unwrap();
    let expected = CommandFrame { mode: Mode::Hold, ..CommandFrame::default() };
    assert_eq!(absent, expected);
    let null = command(r#","horizon_dt_ms":null,"channels":{"a":{"unit":null}}"#).unwrap();
    assert_eq!(null.horizon_dt_ms, None);
    assert_eq!(null.channels["a"], ChannelValue::default());

    let opened = SessionOpened::decode(br#"{"kind":"session_opened","session_id":"s"}"#).unwrap();
    assert_eq!(opened.contract_hash, None);
    assert_eq!(opened, SessionOpened { session_id: "s".into(), contract_hash: None, ..Default::default() });
    let open = br#"{"kind":"open_session","session_id":"s","network":{}}"#;
    let open = OpenSession::decode(open).unwrap();
    assert_eq!((open.contract_hash, open.network), (None, NetworkRef::default()));
}

#[test]
fn what_the_tables_do_not_list_is_ignored_whatever_it_is() {
    accepted(&[
        r#","x":null"#,
        r#","x":[1,"a",{"y":[]},[[]],true,false,null,-0,1e5]"#,
        r#","Mode":"estop","MODE":1,"mode ":[]"#,
        r#","channels":{"a":{"kind":7}}"#,
        r#","session_id":5"#,
        r#","":"""#,
    ]);
    rejected(
        ErrorCode::Malformed,
        &[
            r#","x":nul"#,
            r#","x":tru"#,
            r#","x":[1,]"#,
            r#","x":[,1]"#,
            r#","x":{1:1}"#,
            r#","x":"#,
            r#","x""#,
            r#","x":[1 2]"#,
            r#","x":{"a" 1}"#,
        ],
    );
}

#[test]
fn a_required_field_must_be_there_and_of_its_type() {
    let frame = |kind: &str, members: &str| format!(r#"{{"kind":"{kind}"{members}}}"#);
    let missing = |kind: &str, members: &str, field: &str| {
        let error = decode_any(frame(kind, members).as_bytes()).unwrap_err();
        assert_eq!((error.code(), error.path()), (ErrorCode::Missing, field), "{error}");
    };
    missing("open_session", r#","network":{}"#, "session_id");
    missing("open_session", r#","session_id":"s""#, "network");
    missing("run_request", r#","session_id":"s""#, "duration_ms");
    missing("capabilities", "", "controller_id");
    for kind in
        ["session_opened", "stimulus_frame", "step_request", "observation_frame", "close_session", "session_closed"]
    {
        missing(kind, "", "session_id");
    }
    for kind in ["sensor_frame", "command_frame", "control_status", "link_status", "bulk_observation"] {
        decode_any(frame(kind, "").as_bytes()).unwrap();
    }
    let null = frame("open_session", r#","session_id":"s","network":null"#);
    assert_eq!(decode_any(null.as_bytes()).unwrap_err().code(), ErrorCode::Type);
    assert_eq!(Capabilities::decode(br#"{"kind":"capabilities","controller_id":""}"#).unwrap().controller_id, "");
}

#[test]
fn a_frame_must_say_that_it_is_of_the_kind_expected() {
    for (frame, code) in [
        ("{}", ErrorCode::Kind),
        (r#"{"seq":1}"#, ErrorCode::Kind),
        (r#"{"kind":"sensor_frame"}"#, ErrorCode::Kind),
        (r#"{"kind":"Command_frame"}"#, ErrorCode::Kind),
        (r#"{"kind":"commandframe"}"#, ErrorCode::Kind),
        (r#"{"kind":""}"#, ErrorCode::Kind),
        (r#"{"kind":"error","error":"x"}"#, ErrorCode::Kind),
        (r#"{"kind":null}"#, ErrorCode::Type),
        (r#"{"kind":11}"#, ErrorCode::Type),
    ] {
        let error = CommandFrame::decode(frame.as_bytes()).expect_err(frame);
        assert_eq!(error.code(), code, "{frame}: {error}");
    }
    assert!(CommandFrame::decode(br#"{"\u006bind":"command\u005fframe"}"#).is_ok());
    assert!(CommandFrame::decode(br#"{"x":[{"kind":"a"}],"seq":1,"kind":"command_frame"}"#).is_ok());
}

#[test]
fn decode_any_reads_each_kind_wherever_the_kind_stands() {
    for kind in Kind::ALL {
        let frame = format!(
            r#"{{"x":{{"kind":"error"}},"session_id":"s","network":{{}},{}"kind":"{kind}"}}"#,
            r#""duration_ms":1,"controller_id":"c","error":"e","#
        );
        // `error` is also a field of the reply to an open session.
        assert_eq!(decode_any(frame.as_bytes()).unwrap().kind(), kind);
        assert_eq!(decode_any(frame.as_bytes()), decode(kind, frame.as_bytes()));
    }
    for (frame, code) in [
        ("{}", ErrorCode::Kind),
        (r#"{"kind":"dance"}"#, ErrorCode::Kind),
        (r#"{"kind":5}"#, ErrorCode::Type),
        (r#"{"kind":"command_frame","kind":"command_frame"}"#, ErrorCode::Malformed),
        (r#"{"x":1,"kind":"command_frame","x":1}"#, ErrorCode::Malformed),
        ("[]", ErrorCode::Malformed),
    ] {
        assert_eq!(decode_any(frame.as_bytes()).expect_err(frame).code(), code, "{frame}");
    }
}

#[test]
fn a_required_session_id_is_a_valid_segment_and_an_optional_one_may_be_anything() {
    for bad in ["", " ", "a/b", "a*", "@a", ".", "..", "a\\u0000", "\\u0085", &"a".repeat(257)] {
        for kind in [
            "open_session",
            "session_opened",
            "stimulus_frame",
            "step_request",
            "run_request",
            "observation_frame",
            "close_session",
            "session_closed",
        ] {
            let frame = format!(r#"{{"kind":"{kind}","session_id":"{bad}","network":{{}},"duration_ms":1}}"#);
            let error = decode_any(frame.as_bytes()).expect_err(&frame);
            assert_eq!((error.code(), error.path()), (ErrorCode::Value, "session_id"));
        }
        let link = format!(r#"{{"kind":"link_status","session_id":"{bad}"}}"#);
        assert!(decode_any(link.as_bytes()).is_ok());
    }
}

#[test]
fn decoding_does_not_judge_the_version() {
    for version in ["", "0.4", "9", "x", "0.4.0"] {
        let read = command(&format!(r#","ncp_version":"{version}""#)).unwrap();
        assert_eq!(read.ncp_version, version);
    }
    assert_eq!(command("").unwrap().ncp_version, WIRE_VERSION);
}

#[test]
fn a_stimulus_inside_a_request_takes_over_what_it_leaves_out() {
    let step = |members: &str| {
        StepRequest::decode(format!(r#"{{"kind":"step_request","session_id":"s1"{members}}}"#).as_bytes())
    };
    let stimulus = |members: &str| step(members).unwrap().stimulus.unwrap();
    let expected = StimulusFrame { session_id: "s1".into(), ..Default::default() };
    for given in [
        "",
        r#""kind":"stimulus_frame""#,
        r#""session_id":"s1""#,
        &format!(r#""ncp_version":"{WIRE_VERSION}""#),
        &format!(r#""ncp_version":"{WIRE_VERSION}","kind":"stimulus_frame","session_id":"s1""#),
    ] {
        assert_eq!(stimulus(&format!(r#","stimulus":{{{given}}}"#)), expected, "{given}");
    }
    assert_eq!(stimulus(r#","stimulus":{},"ncp_version":"0.7""#).ncp_version, "0.7");
    assert_eq!(step(r#","stimulus":null"#).unwrap().stimulus, None);
    for (given, code) in [
        (r#""kind":"sensor_frame""#, ErrorCode::Kind),
        (r#""kind":"step_request""#, ErrorCode::Kind),
        (r#""kind":"""#, ErrorCode::Kind),
        (r#""kind":null"#, ErrorCode::Type),
        (r#""session_id":"s2""#, ErrorCode::Value),
        (r#""session_id":"""#, ErrorCode::Value),
        (r#""session_id":null"#, ErrorCode::Type),
        (r#""ncp_version":"0.4""#, ErrorCode::Value),
        (r#""ncp_version":"0.50""#, ErrorCode::Value),
        (r#""ncp_version":"""#, ErrorCode::Value),
        (r#""t":null"#, ErrorCode::Type),
        (r#""t":0,"t":0"#, ErrorCode::Malformed),
    ] {
        let error = step(&format!(r#","stimulus":{{{given}}}"#)).expect_err(given);
        assert_eq!(error.code(), code, "{given}: {error}");
        assert!(error.path().starts_with("stimulus"), "{error}");
    }
    let run =
        br#"{"stimulus":{"t":1,"values":{"p":{"data":[2]}}},"duration_ms":5,"session_id":"s1","kind":"run_request"}"#;
    let run = RunRequest::decode(run).unwrap();
    assert_eq!(run.stimulus.unwrap().session_id, "s1");
    // On its own, a stimulus frame has no request to take anything from.
    assert!(decode_any(br#"{"kind":"stimulus_frame"}"#).is_err());
    // And the request itself may leave out nothing because its stimulus has it.
    let headless = br#"{"kind":"step_request","stimulus":{"session_id":"s1","kind":"stimulus_frame"}}"#;
    assert_eq!(decode_any(headless).unwrap_err().code(), ErrorCode::Missing);
    let kindless = br#"{"session_id":"s1","stimulus":{"session_id":"s1","kind":"stimulus_frame"}}"#;
    assert_eq!(StepRequest::decode(kindless).unwrap_err().code(), ErrorCode::Kind);
}

// ---- 1.4 enums -------------------------------------------------------------------------------

#[test]
fn an_unknown_mode_holds() {
    for unknown in ["", "Active", "ACTIVE", "active ", "unknown", "dance"] {
        assert_eq!(command(&format!(r#","mode":"{unknown}""#)).unwrap().mode, Mode::Hold);
        let status = format!(r#"{{"kind":"control_status","mode":"{unknown}"}}"#);
        let Message::ControlStatus(status) = decode_any(status.as_bytes()).unwrap() else { panic!() };
        assert_eq!(status.mode, Mode::Hold);
    }
    for mode in Mode::KNOWN {
        assert_eq!(command(&format!(r#","mode":"{mode}""#)).unwrap().mode, *mode);
    }
    let Message::ControlStatus(silent) = decode_any(br#"{"kind":"control_status"}"#).unwrap() else { panic!() };
    assert_eq!(silent.mode, Mode::Init);
}

#[test]
fn an_unknown_sim_mode_is_rejected() {
    let open = |mode: &str| {
        let frame = format!(r#"{{"kind":"open_session","session_id":"s","network":{{}},"sim":{{"mode":"{mode}"}}}}"#);
        decode_any(frame.as_bytes())
    };
    assert!(open("stream").is_ok() && open("batch").is_ok());
    for unknown in ["", "Stream", "unknown"] {
        let error = open(unknown).unwrap_err();
        assert_eq!((error.code(), error.path()), (ErrorCode::Value, "sim.mode"));
    }
}

#[test]
fn an_unknown_string_of_a_descriptive_enum_is_written_unchanged() {
    let unknown = "quantum \u{1f9e0} \"x\"";
    let spelled = serde_json::to_string(unknown).unwrap();
    let frame = format!(
        r#"{{"kind":"open_session","session_id":"s","network":{{"kind":{spelled}}},
        "record":{{"targets":[{{"observable":{spelled}}}]}},"stimulus":{{"targets":[{{"kind":{spelled}}}]}},
        "bindings":[{{"entity":{{"role":{spelled}}}}}]}}"#
    );
    let written = decode_any(frame.as_bytes()).unwrap().encode().unwrap();
    assert_eq!(written.matches(&spelled).count(), 4, "{written}");
    let frame = format!(
        r#"{{"kind":"capabilities","controller_id":"c","role":{spelled},"sensor_channels":[{{"kind":{spelled}}}]}}"#
    );
    let written = decode_any(frame.as_bytes()).unwrap().encode().unwrap();
    assert_eq!(written.matches(&spelled).count(), 2, "{written}");
}

// ---- 1.6 limits ------------------------------------------------------------------------------

#[test]
fn a_frame_at_its_limit_is_read_and_one_byte_more_is_not() {
    let padded = |kind: &str, len: usize| {
        let frame = format!(r#"{{"kind":"{kind}","session_id":"s"}}"#);
        frame.clone() + &" ".repeat(len - frame.len())
    };
    for (kind, limit) in [("command_frame", MAX_FRAME_BYTES), ("observation_frame", MAX_OBSERVATION_BYTES)] {
        assert!(decode_any(padded(kind, limit).as_bytes()).is_ok());
        let error = decode_any(padded(kind, limit + 1).as_bytes()).unwrap_err();
        assert_eq!(error.code(), ErrorCode::Limit, "{error}");
    }
    let error = CommandFrame::decode(padded("observation_frame", MAX_FRAME_BYTES + 1).as_bytes());
    assert_eq!(error.unwrap_err().code(), ErrorCode::Limit);
    let error = ErrorFrame::decode(&[b' '; MAX_FRAME_BYTES + 1]);
    assert_eq!(error.unwrap_err().code(), ErrorCode::Limit);
}

#[test]
fn the_64th_level_is_read_and_the_65th_is_not() {
    // The frame itself is the first level.
    for (open, close) in [("[", "]"), (r#"{"a":"#, "}"), (r#"[{"a":"#, "}]")] {
        let levels_each = open.chars().filter(|c| "[{".contains(*c)).count();
        let nested = |levels: usize| {
            let times = levels / levels_each;
            let rest = if levels.is_multiple_of(levels_each) { "0" } else { "[]" };
            format!(r#","x":{}{rest}{}"#, open.repeat(times), close.repeat(times))
        };
        accepted(&[&nested(63)]);
        rejected(ErrorCode::Limit, &[&nested(64), &nested(10_000)]);
    }
    accepted(&[&format!(r#","x":{}{}"#, "[".repeat(63), "]".repeat(63))]);
    rejected(ErrorCode::Limit, &[&format!(r#","x":{}"#, "[".repeat(500_000))]);
    // A level that was left does not count.
    accepted(&[&format!(r#","x":[{}[]]"#, "[[]],".repeat(1_000))]);
}

#[test]
fn a_map_has_4096_entries_at_most_in_any_order() {
    let channels = |count: usize| {
        let entries: Vec<_> = (0..count).map(|i| format!(r#""{}":{{}}"#, i * 7919 % 65_536)).collect();
        format!(r#","channels":{{{}}}"#, entries.join(","))
    };
    let read = command(&channels(4_096)).unwrap();
    assert_eq!(read.channels.len(), 4_096);
    assert!(read.channels.keys().is_sorted());
    rejected(ErrorCode::Limit, &[&channels(4_097)]);
}

#[test]
fn an_array_has_4096_items_at_most_unless_they_are_numbers() {
    let horizon = |count: usize| format!(r#","horizon":[{}]"#, vec!["{}"; count].join(","));
    assert_eq!(command(&horizon(4_096)).unwrap().horizon.len(), 4_096);
    rejected(ErrorCode::Limit, &[&horizon(4_097)]);

    let data = format!(r#","channels":{{"a":{{"data":[{}]}}}}"#, vec!["0"; 100_000].join(","));
    assert_eq!(command(&data).unwrap().channels["a"].data.len(), 100_000);

    let names = |count: usize| {
        let record = format!(r#"{{"targets":[{{"recordables":[{}]}}]}}"#, vec![r#""""#; count].join(","));
        let frame = format!(r#"{{"kind":"open_session","session_id":"s","network":{{}},"record":{record}}}"#);
        decode_any(frame.as_bytes()).map(drop).map_err(|e| e.code())
    };
    assert_eq!(names(4_096), Ok(()));
    assert_eq!(names(4_097), Err(ErrorCode::Limit));
    // What is ignored has no such limit.
    accepted(&[&format!(r#","x":[{}]"#, vec!["{}"; 10_000].join(","))]);
}

// ---- 1.7 encoders ----------------------------------------------------------------------------

#[test]
fn doubles_are_written_so_that_they_are_no_integers_and_come_back() {
    for (value, spelled) in [
        (0.0, "0.0"),
        (-0.0, "-0.0"),
        (5.0, "5.0"),
        (-3.5, "-3.5"),
        (0.001, "0.001"),
        (999_999.999, "999999.999"),
        (1_000_000.0, "1000000.0"),
        (-4_294_967.295, "-4294967.295"),
        (4_294_967.296, "4294967.296"),
        (0.1 + 0.2, "0.30000000000000004"),
        (f64::MAX, "1.7976931348623157e+308"),
        (f64::from_bits(1), "5e-324"),
        (133.333_333_333_333_34, "133.33333333333334"),
    ] {
        let frame = SensorFrame { t: value, ..Default::default() }.encode().unwrap();
        assert!(frame.contains(&format!(r#""t":{spelled},"#)), "{spelled}: {frame}");
        assert_eq!(SensorFrame::decode(frame.as_bytes()).unwrap().t.to_bits(), value.to_bits());
    }
}

#[test]
fn a_number_that_json_lacks_is_refused_and_named() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let in_t = SensorFrame { t: value, ..Default::default() };
        let mut in_data = SensorFrame::default();
        in_data.channels.insert("pose_position", ChannelValue::new([0.0, value], "m"));
        let in_option = CommandFrame { horizon_dt_ms: Some(value), ..Default::default() };
        for (refused, path) in [
            (in_t.encode(), "t"),
            (in_data.encode(), "channels.pose_position.data[1]"),
            (in_option.encode(), "horizon_dt_ms"),
        ] {
            let error = refused.unwrap_err();
            assert_eq!((error.code(), error.path()), (ErrorCode::NonFinite, path));
        }
    }
}

#[test]
fn what_every_receiver_would_reject_is_refused() {
    let code = |message: Message| message.encode().map_err(|e| e.code());
    for seq in [1 << 53, -(1 << 53), i64::MAX, i64::MIN] {
        let frame = SensorFrame { seq, ..Default::default() };
        assert_eq!(code(frame.into()), Err(ErrorCode::Value), "{seq}");
    }
    assert!(code(SensorFrame { seq: -((1 << 53) - 1), ..Default::default() }.into()).is_ok());
    assert_eq!(code(StepRequest::default().into()), Err(ErrorCode::Value));
    let step = |stimulus: StimulusFrame| StepRequest {
        session_id: "s".into(),
        stimulus: Some(stimulus),
        ..Default::default()
    };
    let fits = StimulusFrame { session_id: "s".into(), ..Default::default() };
    assert!(code(step(fits.clone()).into()).is_ok());
    let other_session = StimulusFrame { session_id: "t".into(), ..fits.clone() };
    assert_eq!(code(step(other_session).into()), Err(ErrorCode::Value));
    let other_version = StimulusFrame { ncp_version: "0.4".into(), ..fits };
    assert_eq!(code(step(other_version).into()), Err(ErrorCode::Value));

    let mut many = SensorFrame::default();
    many.channels.extend((0..4_097).map(|i| (i.to_string(), ChannelValue::default())));
    assert_eq!(code(many.clone().into()), Err(ErrorCode::Limit));
    many.channels.remove("0");
    assert!(code(many.into()).is_ok());
    let long = CommandFrame { horizon: vec![Default::default(); 4_097], ..Default::default() };
    assert_eq!(code(long.into()), Err(ErrorCode::Limit));
    let mut wide = SensorFrame::default();
    wide.channels.insert("a", ChannelValue::without_unit(vec![0.0; 300_000]));
    assert_eq!(code(wide.into()), Err(ErrorCode::Limit));
}

#[test]
fn strings_are_written_with_the_escapes_that_must_be() {
    let note = "\"\\/\u{0}\u{8}\t\n\u{b}\u{c}\r\u{1f}\u{7f}é🚁";
    let frame = ErrorFrame { error: note.into(), session_id: None }.encode().unwrap();
    assert_eq!(frame, "{\"kind\":\"error\",\"error\":\"\\\"\\\\/\\u0000\\b\\t\\n\\u000b\\f\\r\\u001f\u{7f}é🚁\"}");
    assert_eq!(ErrorFrame::decode(frame.as_bytes()).unwrap().error, note);
    for control in '\u{0}'..' ' {
        let error = format!("a{control}z");
        let frame = ErrorFrame { error: error.clone().into(), session_id: None };
        let text = frame.encode().unwrap();
        let read: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(read["error"], *error, "{text}");
    }
}

#[test]
fn a_frame_is_written_up_to_its_limit_and_no_further() {
    let frame = |len: usize| SensorFrame { frame_id: "a".repeat(len).into(), ..SensorFrame::default() };
    let rest = frame(0).encode().unwrap().len();
    let longest = frame(MAX_FRAME_BYTES - rest).encode().unwrap();
    assert_eq!(longest.len(), MAX_FRAME_BYTES);
    assert!(SensorFrame::decode(longest.as_bytes()).is_ok());
    let error = frame(MAX_FRAME_BYTES - rest + 1).encode().unwrap_err();
    assert_eq!(error.code(), ErrorCode::Limit);
}

// ---- the error frame, bulk observations, provenance --------------------------------------------

#[test]
fn an_error_frame_has_an_error_and_perhaps_a_session() {
    let read = |frame: &str| ErrorFrame::decode(frame.as_bytes());
    let frame = read(r#"{"kind":"error","error":"no"}"#).unwrap();
    assert_eq!(frame, ErrorFrame { error: "no".into(), session_id: None });
    assert_eq!(frame.encode().unwrap(), r#"{"kind":"error","error":"no"}"#);
    let frame = read(r#"{"session_id":"s","ncp_version":7,"error":"no","kind":"error"}"#).unwrap();
    assert_eq!(frame.encode().unwrap(), r#"{"kind":"error","error":"no","session_id":"s"}"#);
    assert_eq!(read(r#"{"kind":"error","error":"no","session_id":null}"#).unwrap().session_id, None);
    for (frame, code) in [
        (r#"{"kind":"error"}"#, ErrorCode::Missing),
        (r#"{"kind":"error","error":null}"#, ErrorCode::Type),
        (r#"{"kind":"error","error":{}}"#, ErrorCode::Type),
        (r#"{"error":"no"}"#, ErrorCode::Kind),
        (r#"{"kind":"session_closed","error":"no"}"#, ErrorCode::Kind),
        (r#"{"kind":"error","error":"a","error":"b"}"#, ErrorCode::Malformed),
        (r#"{"kind":"error","error":"a","x":1,"x":1}"#, ErrorCode::Malformed),
    ] {
        assert_eq!(read(frame).expect_err(frame).code(), code, "{frame}");
    }
}

#[test]
fn a_block_travels_as_padded_base64() {
    let frame =
        BulkObservation { observable: Observable::Spikes, block: vec![0xfb, 0xff, 0xfe, 0], ..Default::default() };
    let written = frame.encode().unwrap();
    assert_eq!(
        written,
        format!(
            r#"{{"ncp_version":"{WIRE_VERSION}","kind":"bulk_observation","port":"","target":"",{}"#,
            r#""observable":"spikes","unit":null,"recordable":null,"block":"+//+AA=="}"#
        )
    );
    assert_eq!(BulkObservation::decode(written.as_bytes()).unwrap(), frame);
    for bad in ["+//+AA", "+//+AA=", "-__-AA==", "+//+AB==", "+//+ AA==", "=", "A"] {
        let frame = format!(r#"{{"kind":"bulk_observation","block":"{bad}"}}"#);
        let error = BulkObservation::decode(frame.as_bytes()).expect_err(bad);
        assert_eq!((error.code(), error.path()), (ErrorCode::Value, "block"));
    }
}

#[test]
fn the_pins_of_an_observation_hold_for_who_reads_and_for_who_writes() {
    let observation = |members: &str| {
        ObservationFrame::decode(format!(r#"{{"kind":"observation_frame","session_id":"s"{members}}}"#).as_bytes())
            .map_err(|e| e.code())
    };
    let absent = observation("").unwrap();
    assert!(absent.is_simulation_output && !absent.calibrated_posterior);
    assert_eq!(observation(r#","calibrated_posterior":false,"is_simulation_output":true"#), Ok(absent));
    for (members, code) in [
        (r#","calibrated_posterior":true"#, ErrorCode::Provenance),
        (r#","is_simulation_output":false"#, ErrorCode::Provenance),
        (r#","calibrated_posterior":null"#, ErrorCode::Type),
        (r#","calibrated_posterior":0"#, ErrorCode::Type),
        (r#","calibrated_posterior":"false""#, ErrorCode::Type),
        (r#","is_simulation_output":null"#, ErrorCode::Type),
        (r#","is_simulation_output":1"#, ErrorCode::Type),
    ] {
        assert_eq!(observation(members), Err(code), "{members}");
    }
    let frame = ObservationFrame { session_id: "s".into(), ..Default::default() };
    assert!(frame.encode().is_ok());
    for lie in [
        ObservationFrame { calibrated_posterior: true, ..frame.clone() },
        ObservationFrame { is_simulation_output: false, ..frame },
    ] {
        assert_eq!(lie.encode().unwrap_err().code(), ErrorCode::Provenance);
    }
}

#[test]
fn the_pins_of_a_provenance_hold_for_who_reads_and_for_who_writes() {
    let opened = |provenance: &str| {
        SessionOpened::decode(
            format!(r#"{{"kind":"session_opened","session_id":"s","provenance":{provenance}}}"#).as_bytes(),
        )
        .map_err(|e| e.code())
    };
    assert_eq!(opened("null").unwrap().provenance, None);
    assert_eq!(opened("{}").unwrap().provenance, Some(SimProvenance::default()));
    for (provenance, code) in [
        (r#"{"calibrated_posterior":true}"#, ErrorCode::Provenance),
        (r#"{"is_simulation_output":false}"#, ErrorCode::Provenance),
        (r#"{"is_simulation_output":null}"#, ErrorCode::Type),
        ("[]", ErrorCode::Type),
        ("false", ErrorCode::Type),
    ] {
        assert_eq!(opened(provenance), Err(code), "{provenance}");
    }
    let lie = SimProvenance { calibrated_posterior: true, ..Default::default() };
    let frame = SessionOpened { session_id: "s".into(), provenance: Some(lie), ..Default::default() };
    assert_eq!(frame.encode().unwrap_err().code(), ErrorCode::Provenance);
}

// ---- building --------------------------------------------------------------------------------

/// The fewest fields that a message is built of.
const fn least(kind: Kind) -> &'static [u8] {
    match kind {
        Kind::Error => br#"{"error":""}"#,
        _ => b"{}",
    }
}

/// [NCP-WIRE-100] [NCP-WIRE-034] It is not required there, so rule 31 says nothing of it.
#[test]
fn the_session_of_an_error_frame_may_be_any_string() {
    for id in ["s", "", "a/b", "**", "@s", "\u{85}"] {
        let frame = format!(r#"{{"kind":"error","error":"no such session","session_id":"{id}"}}"#);
        let Message::Error(read) = decode_any(frame.as_bytes()).unwrap() else { panic!("{frame}") };
        assert_eq!(read.session_id.as_deref(), Some(id));
    }
}

/// [NCP-WIRE-101]
#[test]
fn an_error_frame_is_not_built_without_saying_what_went_wrong() {
    for fields in ["{}", r#"{"session_id":"s"}"#, r#"{"kind":"error"}"#] {
        let refused = build(Kind::Error, fields.as_bytes()).unwrap_err();
        assert_eq!(refused.code(), ErrorCode::Missing, "{fields}");
        assert_eq!(refused.path(), "error", "{fields}");
    }
    assert!(build(Kind::Error, br#"{"error":""}"#).is_ok());
}

#[test]
fn what_a_program_builds_has_the_programs_defaults() {
    for kind in Kind::ALL {
        let built = build(kind, least(kind)).unwrap();
        assert_eq!(built.kind(), kind);
    }
    let Message::CommandFrame(frame) = build(Kind::CommandFrame, br#"{"seq":3}"#).unwrap() else { panic!() };
    assert_eq!(frame, CommandFrame { seq: 3, ..Default::default() });
    assert_eq!(frame.mode, Mode::Active);
    let Message::OpenSession(open) = build(Kind::OpenSession, b"{}").unwrap() else { panic!() };
    assert_eq!(open, OpenSession::default());
    assert_eq!(open.contract_hash.as_deref(), Some(CONTRACT_HASH));
    let unset = build(Kind::OpenSession, br#"{"contract_hash":null}"#).unwrap();
    assert!(matches!(unset, Message::OpenSession(open) if open.contract_hash.is_none()));
}

#[test]
fn a_program_may_name_numbers_that_json_lacks_and_no_field_that_is_not_there() {
    let built = build(
        Kind::CommandFrame,
        br#"{"t":"NaN","ttl_ms":"Infinity","horizon_dt_ms":"-Infinity","channels":{"a":{"data":["-0"]}}}"#,
    );
    let Message::CommandFrame(frame) = built.unwrap() else { panic!() };
    assert!(frame.t.is_nan());
    assert_eq!((frame.ttl_ms, frame.horizon_dt_ms), (f64::INFINITY, Some(f64::NEG_INFINITY)));
    assert_eq!(frame.channels["a"].data[0].to_bits(), (-0.0_f64).to_bits());
    assert_eq!(build(Kind::CommandFrame, br#"{"t":"nan"}"#).unwrap_err().code(), ErrorCode::Type);
    assert_eq!(build(Kind::CommandFrame, br#"{"speed":1}"#).unwrap_err().code(), ErrorCode::Invalid);
    let over = build(Kind::SensorFrame, br#"{"seq":9223372036854775807}"#).unwrap();
    assert_eq!(over.encode().unwrap_err().code(), ErrorCode::Value);
    // A frame that came over the wire may not spell numbers so.
    assert_eq!(command(r#","t":"NaN""#).unwrap_err().code(), ErrorCode::Type);
}

#[test]
fn what_a_message_holds_is_shown_whatever_it_is() {
    let unsendable = Message::from(CommandFrame {
        seq: -i64::MAX,
        t: f64::INFINITY,
        ttl_ms: f64::NEG_INFINITY,
        horizon_dt_ms: Some(-0.0),
        ..Default::default()
    });
    assert!(unsendable.encode().is_err());
    let again = build(Kind::CommandFrame, unsendable.fields().as_bytes());
    assert_eq!(again.unwrap(), unsendable);
    for kind in Kind::ALL {
        let built = build(kind, least(kind)).unwrap();
        assert_eq!(build(kind, built.fields().as_bytes()).unwrap(), built);
    }

    let lost = Message::from(SensorFrame { t: f64::NAN, ..Default::default() });
    assert!(lost.fields().contains(r#""t":"NaN","#), "{}", lost.fields());
    let name = |nth: usize| (nth.to_string(), ChannelValue::default());
    let many = Message::from(CommandFrame {
        horizon: vec![ChannelMap::new(); MAX_ITEMS + 1],
        channels: (0..=MAX_ENTRIES).map(name).collect(),
        ..Default::default()
    });
    assert!(many.encode().is_err());
    let shown: serde_json::Value = serde_json::from_str(&many.fields()).unwrap();
    assert_eq!(shown["horizon"].as_array().unwrap().len(), MAX_ITEMS + 1);
    assert_eq!(shown["channels"].as_object().unwrap().len(), MAX_ENTRIES + 1);
}
