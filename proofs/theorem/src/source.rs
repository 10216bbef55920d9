//! The kernel's functions, each run on numbers that record.

use ncp_kernel::{Channel, Decision, Gates, Limit, Mode, Plan, Plant, Reason, Received};

use crate::coq::Export;
use crate::term::{
    Name, Term, Tree, asked_before, explore, explore_after, in_full, last_tested, name_last_tested, presume, quietly,
    unknown, variable,
};

/// What the export cannot say of the kernel.
#[derive(Debug, thiserror::Error)]
pub enum SourceError {
    /// The function does not do the same on each tick.
    #[error("{function} does something else on tick {tick} than on tick {first}")]
    Uneven {
        /// Its name.
        function: &'static str,
        /// The tick.
        tick: usize,
        /// The first one that was tried.
        first: usize,
    },
    /// A state shows more than is known of it.
    #[error("{0} has a part that the model does not know, or a command was limited by another limit")]
    Unknown(String),
}

/// The longest horizon of a frame.
const MOST_STEPS: usize = 4096;

/// All exports.
///
/// # Errors
/// The kernel does what the export cannot say.
pub fn all() -> Result<Vec<Export>, SourceError> {
    let mut exports = functions();
    exports.push(tick_share()?);
    exports.extend([projection(0), projection(1)]);
    exports.push(iteration()?);
    exports.extend(plant());
    exports.extend(gates());
    match exports.iter().find(|export| shows_unknown(&export.tree)) {
        Some(export) => Err(SourceError::Unknown(export.name.clone())),
        None => Ok(exports),
    }
}

/// What stands in a leaf for what the model has no word for.
const NO_WORD: &str = "no word for it";

fn shows_unknown(tree: &Tree) -> bool {
    match tree {
        Tree::Leaf(answer) => answer.contains(NO_WORD),
        Tree::Node(_, yes, no) => shows_unknown(yes) || shows_unknown(no),
    }
}

fn export(name: &str, parameters: &str, model: &str, run: &dyn Fn() -> String) -> Export {
    let (name, parameters, model) = (name.to_owned(), parameters.to_owned(), model.to_owned());
    Export { name, parameters, given: Vec::new(), model, tree: explore(run) }
}

fn vec3(names: [&str; 3]) -> [Term; 3] {
    names.map(variable)
}

fn triple([x, y, z]: [Term; 3]) -> String {
    format!("({x}, {y}, {z})")
}

fn option<T: std::fmt::Display>(value: Option<T>) -> String {
    value.map_or_else(|| "None".to_owned(), |value| format!("(Some {value})"))
}

/// The functions without a state, on numbers that are not known.
fn functions() -> Vec<Export> {
    use ncp_kernel as kernel;
    let place = || vec3(["x", "y", "z"]);
    let clamped = |changed: Option<String>, vector: [Term; 3]| match changed {
        Some(changed) => format!("(Some ({}, {changed}))", triple(vector)),
        None => "None".to_owned(),
    };
    vec![
        export("is_duration", "(a : num S)", "is_duration a", &|| kernel::is_duration(variable("a")).to_string()),
        export("age_ms", "(a b : num S)", "age_ms a b", &|| kernel::age_ms(variable("a"), variable("b")).to_string()),
        export("enforced_ttl_ms", "(a : num S)", "enforced_ttl_ms a", &|| {
            option(kernel::enforced_ttl_ms(variable("a")))
        }),
        export("within_deadline", "(a b c : num S)", "within_deadline a b c", &|| {
            kernel::within_deadline(variable("a"), variable("b"), variable("c")).to_string()
        }),
        export("is_fresh", "(a b c : num S)", "is_fresh a b c", &|| {
            kernel::is_fresh(variable("a"), variable("b"), variable("c")).to_string()
        }),
        export("limit_of_none", "(a : num S)", "limit_of None", &|| limit_text(kernel::limit::<Term>(None))),
        export("limit_of", "(a : num S)", "limit_of (Some a)", &|| limit_text(kernel::limit(Some(variable("a"))))),
        export("norm", "(x y z : num S)", "(norm (x, y, z), scale (x, y, z))", &|| {
            in_full();
            let kernel::Norm { length, scale } = kernel::norm(&place());
            format!("({length}, {scale})")
        }),
        export("all_finite", "(x y z : num S)", "all_finite (x, y, z)", &|| kernel::all_finite(&place()).to_string()),
        export("inside", "(x y z r : num S)", "inside (x, y, z) r", &|| {
            kernel::inside(&place(), variable("r")).to_string()
        }),
        export("travel", "(x y z u v w t : num S)", "travel (x, y, z) (u, v, w) t", &|| {
            triple(kernel::travel(&place(), &vec3(["u", "v", "w"]), variable("t")))
        }),
        export("bring_within", "(x y z m : num S)", "bring_within (x, y, z) m", &|| {
            let mut vector = place();
            let changed = kernel::bring_within(&mut vector, variable("m"));
            clamped(changed.map(|changed| changed.to_string()), vector)
        }),
        export(
            "clamp",
            "(x y z m : num S)",
            "match bring_within (x, y, z) m with Some (v, _) => Some (v, true) | None => None end",
            &|| {
                let mut vector = place();
                let clamped_it = kernel::clamp(&mut vector, variable("m"));
                clamped(clamped_it.then(|| "true".to_owned()), vector)
            },
        ),
        export("limit_velocity", "(x y z m : num S)", "limit_velocity (x, y, z) m", &|| {
            let mut data = place();
            let channel = Channel { data: &mut data, is_velocity: true, in_mps: true };
            match kernel::limit_tick(std::iter::once(channel), Limit::Enabled(variable("m"))) {
                Ok(changed) => format!("(Ok ({}, {changed}))", triple(data)),
                Err(reason) => format!("(Err {})", reason_text(reason)),
            }
        }),
        export("advances", "(a b : seq Q)", "advances (Some a) b", &|| {
            kernel::advances(Some(Name::new("a")), Name::new("b")).to_string()
        }),
        export("hold_takes_effect", "(a b : seq Q)", "hold_takes_effect (Some a) b", &|| {
            kernel::hold_takes_effect(Some(Name::new("a")), Name::new("b")).to_string()
        }),
    ]
}

/// The share of a tick: of each tick of a horizon, and the same on all.
fn tick_share() -> Result<Export, SourceError> {
    let of = |tick: usize| {
        // A tick that is not known is written as its constant in Coq, here with a name.
        let tree = explore(&|| ncp_kernel::tick_share_ms(tick, variable("dt"), variable("ttl")).to_string());
        named(&tree, &format!("(dyadic ({tick}) (0))"))
    };
    let first = 4095;
    let tree = of(first);
    for tick in 1..=MOST_STEPS {
        if of(tick) != tree {
            return Err(SourceError::Uneven { function: "tick_share_ms", tick, first });
        }
    }
    Ok(Export {
        name: "tick_share_ms".to_owned(),
        parameters: "(k : nat) (dt ttl : num S)".to_owned(),
        given: Vec::new(),
        model: "tick_share_ms k dt ttl".to_owned(),
        tree,
    })
}

/// A tree with another constant in the place of one.
fn named(tree: &Tree, constant: &str) -> Tree {
    let tick = "(dyadic (Z.of_nat k) 0)";
    match tree {
        Tree::Leaf(answer) => Tree::Leaf(answer.replace(constant, tick)),
        Tree::Node(condition, yes, no) => {
            Tree::Node(condition.replace(constant, tick), Box::new(named(yes, constant)), Box::new(named(no, constant)))
        }
    }
}

/// A command of which nothing is known: each tick may have a velocity or none, and be within the limits or not.
struct Command {
    mode: Mode,
    steps: usize,
    dt_ms: Option<Term>,
    max_mps: Option<Term>,
    wrong: bool,
    /// The tick at whose velocity the last end gets the names of a place.
    named_at: Option<usize>,
}

impl Command {
    fn new(steps: usize) -> Self {
        let dt_ms = (steps > 0).then(|| variable("dt"));
        Self { mode: Mode::Active, steps, dt_ms, max_mps: None, wrong: false, named_at: None }
    }
}

impl Plan<Term> for Command {
    fn mode(&self) -> Mode {
        self.mode
    }
    fn ttl_ms(&self) -> Term {
        variable("ttl")
    }
    fn dt_ms(&self) -> Option<Term> {
        self.dt_ms
    }
    fn steps(&self) -> usize {
        self.steps
    }
    fn limit(&mut self, tick: usize, max_mps: Limit<Term>) -> Result<bool, Reason> {
        self.wrong |= match (max_mps, self.max_mps) {
            (Limit::Enabled(max), Some(known)) => max != known,
            (Limit::Disabled, None) => false,
            _ => true,
        };
        if !unknown(&format!("ok{tick}")) {
            return Err(Reason::NoVelocity);
        }
        Ok(unknown(&format!("changed{tick}")))
    }
    fn velocity(&self, tick: usize) -> Option<[Term; 3]> {
        let here = self.named_at == Some(tick);
        if here {
            name_last_tested(["x", "y", "z"]);
        }
        let name = |letter: &str| if here { letter.to_owned() } else { format!("{letter}{tick}") };
        unknown(&name("has")).then(|| ["u", "v", "w"].map(|letter| variable(&name(letter))))
    }
    fn truncate(&mut self, steps: usize) {
        self.steps = steps;
    }
}

/// The parameters of the first ticks, and the model's command of them.
fn command(steps: usize) -> (String, String) {
    let ticks = |what: &str| (0..=steps).map(|tick| format!("{what}{tick}")).collect::<Vec<_>>().join(" ");
    let numbers = format!("{} {} {}", ticks("u"), ticks("v"), ticks("w"));
    let parameters =
        format!("({} {} {} : bool) ({numbers} ttl dt : num S)", ticks("has"), ticks("ok"), ticks("changed"));
    let by_tick = |of: &dyn Fn(usize) -> String, other: &str| {
        let arms: String = (0..=steps).map(|tick| format!("{tick} => {} | ", of(tick))).collect();
        format!("(fun k : nat => match k with {arms}_ => {other} end)")
    };
    let velocity = by_tick(&|k| format!("if has{k} then Some (u{k}, v{k}, w{k}) else None"), "None");
    let limited = by_tick(&|k| format!("if ok{k} then Ok changed{k} else Err NoVelocity"), "Err NoVelocity");
    let dt = if steps > 0 { "(Some dt)" } else { "None" };
    (parameters, format!("ttl {dt} {steps} {limited} {velocity}"))
}

/// The projection of a whole horizon.
fn projection(steps: usize) -> Export {
    let (parameters, plan) = command(steps);
    export(
        &format!("steps_inside_{steps}"),
        &format!("{parameters} (x y z r : num S)"),
        &format!("steps_inside (Build_plan Active {plan}) (x, y, z) r"),
        &|| match ncp_kernel::steps_inside(&Command::new(steps), &vec3(["x", "y", "z"]), variable("r")) {
            Ok(kept) => format!("(Ok {kept})"),
            Err(reason) => format!("(Err {})", reason_text(reason)),
        },
    )
}

/// One turn of the projection's loop: from the place where the tick before ended. The same on each tick that is tried.
fn iteration() -> Result<Export, SourceError> {
    let of = |tick: usize| {
        let run = move || {
            let plan = Command { named_at: Some(tick), ..Command::new(tick) };
            match ncp_kernel::steps_inside(&plan, &vec3(["a", "b", "c"]), variable("r")) {
                Ok(kept) if kept == tick => option(last_tested().map(triple)),
                Ok(kept) if kept + 1 == tick => "None".to_owned(),
                _ => NO_WORD.to_owned(),
            }
        };
        let before = asked_before("has", &run);
        let tree = explore_after(before, &run);
        named(&tree, &format!("(dyadic ({tick}) (0))"))
    };
    let first = 2;
    let tree = of(first);
    let ticks = (first..=40).chain([63, 64, 65, 255, 256, 257, 1023, MOST_STEPS]);
    for tick in ticks {
        if of(tick) != tree {
            return Err(SourceError::Uneven { function: "a turn of steps_inside", tick, first });
        }
    }
    Ok(Export {
        name: "iteration".to_owned(),
        parameters: "(k : nat) (has : bool) (u v w x y z dt ttl r : num S)".to_owned(),
        given: vec!["finite r".to_owned(), "lt (dyadic (0) (0)) r".to_owned()],
        model: "(if has then after (x, y, z) (u, v, w) (tick_share_ms k dt ttl) r else None)".to_owned(),
        tree,
    })
}

/// The states of a plant that can be told apart, each with each input.
fn plant() -> Vec<Export> {
    type Made = Plant<Term, Name>;
    type Input = (&'static str, String, Box<dyn Fn(&mut Made) -> String>);
    let parameters = "(q p : seq Q) (r ttl now t dt : num S)";
    let (q, r, ttl) = (|| Name::new("q"), || variable("r"), || variable("ttl"));
    let new = move || Made::new();
    let follows = move || {
        let mut plant = new();
        plant.on_command(Mode::Active, r(), ttl(), q());
        plant
    };
    let held = move || {
        let mut plant = follows();
        plant.on_command(Mode::Hold, r(), ttl(), q());
        plant
    };
    let states: [(&str, &str, &dyn Fn() -> Made); 3] = [
        ("new", "None None", &new),
        ("following", "(Some q) (Some (r, ttl))", &follows),
        ("held", "(Some q) None", &held),
    ];
    let inputs: [Input; 10] = {
        let command = |mode: Mode| -> Box<dyn Fn(&mut Made) -> String> {
            Box::new(move |plant| {
                received_text(plant.on_command(mode, variable("now"), variable("t"), Name::new("p"))).to_owned()
            })
        };
        let ask = |steps: Option<usize>| -> Box<dyn Fn(&mut Made) -> String> {
            Box::new(move |plant| {
                let tick = plant.active(variable("now"), steps.map(|_| variable("dt")), steps.unwrap_or_default());
                tick.map_or_else(|| "@None nat".to_owned(), |tick| option(Some(tick)))
            })
        };
        let model = |mode: &str| format!("on_command STATE {mode} now t p");
        [
            ("init", model("Init"), command(Mode::Init)),
            ("active", model("Active"), command(Mode::Active)),
            ("hold", model("Hold"), command(Mode::Hold)),
            ("estop", model("Estop"), command(Mode::Estop)),
            ("ask", "active STATE now None 0".to_owned(), ask(None)),
            ("ask_0", "active STATE now (Some dt) 0".to_owned(), ask(Some(0))),
            ("ask_1", "active STATE now (Some dt) 1".to_owned(), ask(Some(1))),
            ("ask_3", "active STATE now (Some dt) 3".to_owned(), ask(Some(3))),
            (
                "stop",
                "(stop STATE, tt)".to_owned(),
                Box::new(|plant| {
                    plant.stop();
                    "tt".to_owned()
                }),
            ),
            (
                "reset",
                "(@new_plant S Q, tt)".to_owned(),
                Box::new(|plant| {
                    plant.reset();
                    "tt".to_owned()
                }),
            ),
        ]
    };
    let mut exports = Vec::new();
    for (state, fields, make) in states {
        for stopped in [false, true] {
            for (input, model, act) in &inputs {
                let run = || {
                    let mut plant = quietly(
                        |_, _| false,
                        || {
                            let mut plant = make();
                            if stopped {
                                plant.stop();
                            }
                            plant
                        },
                    );
                    let answer = act(&mut plant);
                    format!("({}, {answer})", plant_text(&plant))
                };
                let name = format!("plant_{state}{}_{input}", if stopped { "_stopped" } else { "" });
                let model = model.replace("STATE", &format!("(Plant {fields} {stopped})"));
                exports.push(export(&name, parameters, &model, &run));
            }
        }
    }
    exports
}

/// The whole state of a plant, or that there is more of it.
fn plant_text(plant: &Plant<Term, Name>) -> String {
    let (last, deadline, stopped) = (plant.watchdog().last_seq(), plant.watchdog().deadline(), plant.is_stopped());
    let whole =
        format!("Plant {{ watchdog: Watchdog {{ last_seq: {last:?}, deadline: {deadline:?} }}, estop: {stopped:?} }}");
    if format!("{plant:?}") != whole {
        return NO_WORD.to_owned();
    }
    let deadline = deadline.map(|(received, ttl)| format!("({received}, {ttl})"));
    format!("(Plant {} {} {stopped} : plant S Q)", option(last), option(deadline))
}

/// The gates: as they are opened, and commands of up to one step through them, with and without a fence and a speed
/// limit, faulty and latched.
fn gates() -> Vec<Export> {
    let mut exports = Vec::new();
    for (has_speed, has_fence) in [(false, false), (true, false), (false, true), (true, true)] {
        let opened = |is: bool, name| if is { format!("(Some {name})") } else { "None".to_owned() };
        let model = format!("open_gates {} {} a", opened(has_speed, "m"), opened(has_fence, "r"));
        let name = format!("open_gates{}", suffix(has_speed, has_fence));
        exports.push(export(&name, "(m r a : num S)", &model, &|| gates_text(&open(has_speed, has_fence))));
        for mode in Mode::KNOWN {
            exports.push(governed(*mode, 0, has_speed, has_fence, History::Fresh));
        }
        if has_speed || !has_fence {
            exports.push(governed(Mode::Active, 1, has_speed, has_fence, History::Fresh));
        }
        for history in [History::Unbound, History::Burst, History::Quiet, History::Reset] {
            exports.push(governed(Mode::Active, 0, has_speed, has_fence, history));
        }
    }
    exports
}

/// What gates have been through before the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum History {
    Fresh,
    Unbound,
    Burst,
    Quiet,
    Reset,
}

impl History {
    fn apply(self, gates: &mut Gates<Term>) {
        match self {
            Self::Fresh => gates.bind(true, true),
            Self::Unbound => gates.bind(false, false),
            Self::Burst => gates.note_link(true),
            Self::Quiet => gates.note_link(false),
            Self::Reset => {
                gates.note_link(true);
                gates.reset();
            }
        }
    }

    fn model(self, gates: &str) -> String {
        match self {
            Self::Fresh => format!("(bind {gates} true true)"),
            Self::Unbound => format!("(bind {gates} false false)"),
            Self::Burst => format!("(note_link {gates} true)"),
            Self::Quiet => format!("(note_link {gates} false)"),
            Self::Reset => format!("(reset_gates (note_link {gates} true))"),
        }
    }
}

fn suffix(has_speed: bool, has_fence: bool) -> String {
    format!("{}{}", if has_speed { "_speed" } else { "" }, if has_fence { "_fence" } else { "" })
}

fn open(has_speed: bool, has_fence: bool) -> Gates<Term> {
    let some = |is: bool, name| is.then(|| variable(name));
    Gates::new(some(has_speed, "m"), some(has_fence, "r"), variable("a"))
}

/// A command through gates whose limits are enabled or disabled.
fn governed(mode: Mode, steps: usize, has_speed: bool, has_fence: bool, history: History) -> Export {
    let (parameters, plan) = command(steps);
    let enabled = |is: bool, name: &str| if is { format!("(Enabled {name})") } else { "Disabled".to_owned() };
    let presumed = if steps > 0 && has_fence { FULL_TICK } else { &[] };
    let run = || {
        presume(presumed);
        // Limits that are finite and above 0.
        let positive = |operation: &str, terms: &[String]| {
            operation == "finite" || terms.first().is_some_and(|first| first == "(dyadic (0) (0))")
        };
        let mut gates = quietly(positive, || open(has_speed, has_fence));
        history.apply(&mut gates);
        let mut plan = Command { mode, max_mps: has_speed.then(|| variable("m")), ..Command::new(steps) };
        let last = unknown("fresh").then(|| variable("last"));
        let position = || unknown("located").then(|| vec3(["x", "y", "z"]));
        let decision = gates.govern(&mut plan, variable("now"), last, position);
        if plan.wrong {
            return NO_WORD.to_owned();
        }
        format!("({}, {}, {})", decision_text(decision), gates_text(&gates), plan.steps)
    };
    let before = format!("(Build_gates {} {} a false false)", enabled(has_speed, "m"), enabled(has_fence, "r"));
    let model = format!(
        "govern {} (Build_plan {mode:?} {plan}) now \
         (if fresh then Some last else None) (if located then Some (x, y, z) else None)",
        history.model(&before)
    );
    let mut governed = export(
        &format!("govern_{mode}_{steps}{}_{history:?}", suffix(has_speed, has_fence)),
        &format!("{parameters} (fresh located : bool) (m r a now last x y z : num S)"),
        &model,
        &run,
    );
    governed.given = presumed.iter().map(|&condition| condition.to_owned()).collect();
    governed
}

/// That tick 0 is followed to its end, and the ttl is not cut: so that a whole horizon through the gates has few enough
/// paths. The projection on its own has all of them.
const FULL_TICK: &[&str] = &[
    "finite ttl",
    "lt (dyadic (0) (0)) ttl",
    "lt ttl (dyadic (60000) (0))",
    "lt (mul (dyadic (0) (0)) dt) ttl",
    "lt dt (sub ttl (mul (dyadic (0) (0)) dt))",
];

/// The whole state of the gates, or that there is more of it.
fn gates_text(gates: &Gates<Term>) -> String {
    let whole = format!("{gates:?}");
    let fields = whole.strip_prefix("Gates { ").and_then(|rest| rest.strip_suffix(" }")).unwrap_or_default();
    let fields: Vec<&str> = fields.split(", ").collect();
    let names = ["max_speed_mps: ", "fence_m: ", "timeout_ms: ", "config_fault: ", "estop: "];
    let values: Option<Vec<String>> = fields
        .iter()
        .zip(names)
        .map(|(field, name)| {
            let value = field.strip_prefix(name)?;
            let bound = value.strip_prefix("Enabled(").and_then(|bound| bound.strip_suffix(')'));
            Some(bound.map_or_else(|| value.to_owned(), |bound| format!("(Enabled {bound})")))
        })
        .collect();
    match values {
        Some(values) if fields.len() == names.len() => format!("(Build_gates {})", values.join(" ")),
        _ => NO_WORD.to_owned(),
    }
}

fn decision_text(decision: Decision) -> String {
    match decision {
        Decision::Passed => "Passed".to_owned(),
        Decision::Limited => "Limited".to_owned(),
        Decision::Held(reason) => format!("Held {}", reason_text(reason)),
        Decision::Stopped(reason) => format!("Stopped {}", reason_text(reason)),
    }
}

fn received_text(received: Received) -> &'static str {
    match received {
        Received::Accepted => "WasAccepted",
        Received::Held => "WasHeld",
        Received::Stopped => "WasStopped",
        Received::Dropped => "WasDropped",
    }
}

fn limit_text(limit: Limit<Term>) -> String {
    match limit {
        Limit::Disabled => "(@Disabled S)".to_owned(),
        Limit::Enabled(bound) => format!("(Enabled {bound})"),
        Limit::Faulty => "(@Faulty S)".to_owned(),
    }
}

fn reason_text(reason: Reason) -> &'static str {
    match reason {
        Reason::Estop => "EstopReason",
        Reason::ConfigFault => "ConfigFault",
        Reason::StaleSensor => "StaleSensor",
        Reason::NoPosition => "NoPosition",
        Reason::OutsideFence => "OutsideFence",
        Reason::NotActive => "NotActive",
        Reason::NotFinite => "NotFinite",
        Reason::NoVelocity => "NoVelocity",
        Reason::BadHorizon => "BadHorizon",
        Reason::LeavesFence => "LeavesFence",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_function_has_the_paths_that_it_had() {
        let exports = all().unwrap();
        let paths = |name: &str| exports.iter().find(|export| export.name == name).map(|export| export.tree.paths());
        assert_eq!(paths("inside"), Some(7));
        assert_eq!(paths("tick_share_ms"), Some(3));
        assert_eq!(paths("iteration"), Some(16));
        assert_eq!(paths("steps_inside_1"), Some(785));
        assert_eq!(exports.len(), 119);
        assert_eq!(exports.iter().map(|export| export.tree.paths()).sum::<usize>(), 2025);
    }
}
