//! Every sequence of four events at a plant, with a question after each.

use super::model::{Event, buffer, watchdog};
use crate::case::{Case, File, Role};
use crate::command::active;

pub(super) fn files() -> Vec<File> {
    vec![of_watchdog(), of_buffer()]
}

const EVENTS: [(&str, char); 5] = [("command", 'c'), ("duplicate", 'd'), ("wait", 'w'), ("back", 'b'), ("reset", 'r')];

/// Sequences of four of these, each with what it begins with.
fn sequences<const N: usize>() -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for _ in 0..4 {
        all = all
            .into_iter()
            .flat_map(|sequence| {
                (0..N).map(move |event| {
                    let mut longer = sequence.clone();
                    longer.push(event);
                    longer
                })
            })
            .collect();
    }
    all
}

fn of_watchdog() -> File {
    let mut cases = Vec::new();
    for sequence in sequences::<5>() {
        let letters: String = sequence.iter().filter_map(|at| EVENTS.get(*at)).map(|(_, letter)| *letter).collect();
        // What comes before the first command only waits.
        if !letters.starts_with('c') {
            continue;
        }
        let (mut now, mut seq, mut events) = (8.0, 0, Vec::new());
        for letter in letters.chars() {
            match letter {
                'c' => {
                    seq += 1;
                    events.push(Event::Command(active(seq), now));
                }
                'd' => events.push(Event::Command(active(seq), now)),
                'w' => now += 0.25,
                'b' => now -= 0.5,
                _ => events.push(Event::Reset),
            }
            events.push(Event::Ask(now));
            now += 0.125;
        }
        events.push(Event::Ask(now));
        let (args, pattern, decided) = watchdog(&events);
        let rules =
            rules(&letters, &[('b', "NCP-RES-008"), ('d', "NCP-RES-009"), ('r', "NCP-RES-011"), ('w', "NCP-RES-002")]);
        cases.push(
            Case::new(letters.clone(), &rules, &[Role::Body])
                .call("watchdog.run", args)
                .shows(pattern)
                .decided_throughout_by(&decided)
                .title(format!(
                    "The plant moves only by the liveness rule over the events {letters} (command, \
                                duplicate, wait, back, reset)."
                ))
                .flags(&["liveness"])
                .because(
                    "The liveness rule of section 8.1, asked after each event; after a step of the clock \
                          backward a plant may also hold.",
                ),
        );
    }
    let about = "The watchdog over every sequence of four events that begins with a command: commands (c), \
                 duplicates (d), waits (w), steps of the clock backward (b) and resets (r).";
    File::new("resilience", "liveness", about, cases)
}

const MODES: [(&str, char); 5] = [("active", 'a'), ("hold", 'h'), ("estop", 'e'), ("older", 'o'), ("reset", 'r')];

fn of_buffer() -> File {
    let mut cases = Vec::new();
    for sequence in sequences::<5>() {
        let letters: String = sequence.iter().filter_map(|at| MODES.get(*at)).map(|(_, letter)| *letter).collect();
        // A plant that has never moved shows little.
        if !letters.starts_with('a') {
            continue;
        }
        let (mut now, mut seq, mut events) = (8.0, 10, Vec::new());
        for letter in letters.chars() {
            seq += 2;
            match letter {
                'a' => events.push(Event::Command(active(seq), now)),
                'h' => events.push(Event::Command(active(seq).mode("hold"), now)),
                'e' => events.push(Event::Command(active(seq).mode("estop"), now)),
                'o' => {
                    seq -= 2;
                    events.push(Event::Command(active(seq - 1), now));
                }
                _ => {
                    events.push(Event::Reset);
                    seq = 10;
                }
            }
            events.push(Event::Ask(now));
            now += 0.125;
        }
        events.push(Event::Ask(now));
        let (args, pattern, decided) = buffer(&events, false);
        let rules = rules(
            &letters,
            &[
                ('e', "NCP-RES-021"),
                ('h', "NCP-RES-023"),
                ('o', "NCP-RES-020"),
                ('r', "NCP-RES-031"),
                ('a', "NCP-RES-026"),
            ],
        );
        cases.push(
            Case::new(letters.clone(), &rules, &[Role::Body])
                .call("buffer.run", args)
                .shows(pattern)
                .decided_throughout_by(&decided)
                .title(format!(
                    "The buffer acts only on the newest active command over the events {letters} \
                                (active, hold, ESTOP, older active, reset)."
                ))
                .flags(if letters.contains('e') { &["lost-estop"] } else { &["liveness"] })
                .because(
                    "Sections 8.1 and 8.2, asked after each event: newest by seq, latched by ESTOP, held by a \
                          HOLD, cleared by a reset, and expired after 250 ms.",
                ),
        );
    }
    let about = "The action buffer over every sequence of four events that begins with an active command: active \
                 (a), hold (h) and ESTOP (e) commands, older active ones (o) and resets (r).";
    File::new("resilience", "buffer_modes", about, cases)
}

/// The rules of the events that occur, the least usual one first.
fn rules(letters: &str, of: &[(char, &'static str)]) -> Vec<&'static str> {
    let mut rules: Vec<_> = of.iter().filter(|(letter, _)| letters.contains(*letter)).map(|(_, rule)| *rule).collect();
    rules.push("NCP-RES-010");
    rules
}
