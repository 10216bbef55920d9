//! Model checking of the protocol. See `README.md`.

mod explore;
mod plant;
mod sessions;

fn main() {
    for c in explore::check::<sessions::Sessions>(false) { println!("{} {} {} {} {:?}", c.id, c.result, c.states, c.seconds, c.evidence); }
    for c in explore::refute::<sessions::Sessions>() { println!("{} {}", c.id, c.refuted); }
    for c in explore::refute::<plant::PlantSide>() { println!("{} {}", c.id, c.refuted); }
    for c in explore::check::<plant::PlantSide>(false) { println!("{} {} {} {}", c.id, c.result, c.states, c.seconds); }
}
