//! Stroke sequencer: takes the instructions of a character one after another, each when the one before has stopped.
//!
//! ```text
//!                              .-------------------------------------------.
//!                              v  curve             scaled                 | stop
//!   start --> accepted --> fetch -----> loaded --> scaling -> start_512 -> drawing
//!                          |  ^ \
//!                     exit |  |  '------> scaling --> add --> place
//!                          v  |  position    scaled            |
//!                        done '--------------------------------'
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "stroke_sequencer",
    kind: Kind::Timing,
    summary: "Steps through the instructions of a character on the stop signals of the generator.",
    doc: "A start while idle raises `accepted` in that tick. Then each instruction has one tick of `fetch`, in which 505 \
          decodes it. A curve: 507 loads, `start_514` a tick later, `start_512` when `scaled` comes, `drawing` from \
          the next tick to that of `stop`, in which `store` is high; then the next fetch. A position: `start_514` in \
          the tick of `fetch`, `add` when `scaled` comes, `place` a tick later; then the next fetch. An exit ends it. So \
          does, with `fault` high for a tick: an unknown character, an instruction that is none of the three, a number \
          that does not fit (`too_large` when `scaled` comes, `beyond` when `place` is due), a stroke that the \
          generator stops with `failed`. `done` is high for a tick after the end, good or bad. `busy` is high from the tick \
          after `accepted` to that before `done`. A start while busy is ignored.",
    source: "US 3,809,868, FIG. 17, processor 503; its states are chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("start", Width::BIT, "a character begins"),
        PortDescription::input("known", Width::BIT, "500: there is such a character"),
        PortDescription::input("curve", Width::BIT, "505: a curve"),
        PortDescription::input("position", Width::BIT, "505: a positioning move"),
        PortDescription::input("exit", Width::BIT, "505: the end of the set"),
        PortDescription::input("scaled", Width::BIT, "514: the result stands"),
        PortDescription::input("too_large", Width::BIT, "514: it does not fit"),
        PortDescription::input("beyond", Width::BIT, "the position is outside of the coordinates"),
        PortDescription::input("stop", Width::BIT, "512: the stroke has stopped"),
        PortDescription::input("failed", Width::BIT, "512: and was not drawn rightly"),
        PortDescription::output("accepted", Width::BIT, "a start is accepted"),
        PortDescription::output("fetch", Width::BIT, "the instruction stands at 504"),
        PortDescription::output("start_514", Width::BIT, "scale J to M, or X and Y"),
        PortDescription::output("add", Width::BIT, "X and Y are scaled"),
        PortDescription::output("place", Width::BIT, "509 and 510 take the position"),
        PortDescription::output("start_512", Width::BIT, "J to M, X0 and Y0 are ready"),
        PortDescription::output("drawing", Width::BIT, "the generator is at work"),
        PortDescription::output("store", Width::BIT, "509 and 510 take X(t) and Y(t)"),
        PortDescription::output("busy", Width::BIT, "a character is under way"),
        PortDescription::output("done", Width::BIT, "high for a tick after the end"),
        PortDescription::output("fault", Width::BIT, "high in the tick that ends a wrong character"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    // At most one of them is 1, none at rest.
    let states = [0; 6].map(|_| b.hold(1, 0));
    let tokens = states.map(|state| state.q);
    let [fetch, loaded, scaling_curve, scaling_position, adding, drawing] = tokens;
    let busy = b.any(&tokens);
    let idle = b.not(busy);
    let accepted = b.and(b.input("start"), idle);

    let ([curve, position, exit], unknown) = decoded(b, fetch);
    let curve_514 = answer(b, scaling_curve, "scaled", "too_large");
    let position_514 = answer(b, scaling_position, "scaled", "too_large");
    let stroke_512 = answer(b, drawing, "stop", "failed");
    let fits = b.not(b.input("beyond"));
    let [place, outside] = [fits, b.input("beyond")].map(|answer| b.and(adding, answer));

    let fault = b.any(&[unknown, curve_514.bad, position_514.bad, outside, stroke_512.bad]);
    let next_fetch = b.any(&[accepted, place, stroke_512.good]);
    let next = [
        next_fetch,
        curve,
        b.or(loaded, curve_514.waiting),
        b.or(position, position_514.waiting),
        position_514.good,
        b.or(curve_514.good, stroke_512.waiting),
    ];
    for (state, next) in states.into_iter().zip(next) {
        b.load(state, next, None, None);
    }
    let ended = b.or(exit, fault);
    let outputs = [
        ("accepted", accepted),
        ("fetch", fetch),
        ("start_514", b.or(loaded, position)),
        ("add", position_514.good),
        ("place", place),
        ("start_512", curve_514.good),
        ("drawing", drawing),
        ("store", stroke_512.good),
        ("busy", busy),
        ("done", b.delay(ended)),
        ("fault", fault),
    ];
    outputs.into_iter().for_each(|(name, value)| b.output(name, value));
}

/// What 505 says in the tick of the fetch, and whether that is nothing, or the character is unknown.
fn decoded(b: &mut Builder, fetch: ValueId) -> ([ValueId; 3], ValueId) {
    let good = b.and(fetch, b.input("known"));
    let lines = ["curve", "position", "exit"].map(|line| b.and(good, b.input(line)));
    let some = b.any(&lines);
    let none = b.not(some);
    (lines, b.and(fetch, none))
}

/// A unit that is waited for.
struct Answer {
    good: ValueId,
    bad: ValueId,
    waiting: ValueId,
}

fn answer(b: &mut Builder, state: ValueId, ready: &str, wrong: &str) -> Answer {
    let (ready, wrong) = (b.input(ready), b.input(wrong));
    let [right, silent] = [wrong, ready].map(|input| b.not(input));
    Answer { good: b.all(&[state, ready, right]), bad: b.all(&[state, ready, wrong]), waiting: b.and(state, silent) }
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    const OUTPUTS: [&str; 11] =
        ["accepted", "fetch", "start_514", "add", "place", "start_512", "drawing", "store", "busy", "done", "fault"];

    /// The outputs that are high, tick by tick, with these inputs high.
    fn run(ticks: &[&[&str]]) -> Vec<String> {
        let mut bench = Bench::new("stroke_sequencer", &[]);
        let inputs = ["start", "known", "curve", "position", "exit", "scaled", "too_large", "beyond", "stop", "failed"];
        let tick = |high: &&[&str]| {
            inputs.iter().for_each(|input| bench.set(input, i64::from(high.contains(input))));
            let outputs: Vec<_> = OUTPUTS.into_iter().filter(|output| bench.get(output) == 1).collect();
            bench.tick();
            outputs.join(" ")
        };
        ticks.iter().map(tick).collect()
    }

    #[test]
    fn a_position_a_curve_and_an_exit_follow_each_other_on_the_answers_of_514_and_512() {
        let shown = run(&[
            &["start"],
            &["known", "position"],
            &[],
            &["scaled"],
            &[],
            &["known", "curve"],
            &[],
            &["scaled"],
            &["start"],
            &["stop"],
            &["known", "exit"],
            &[],
            &[],
        ]);
        assert_eq!(
            shown,
            [
                "accepted",
                "fetch start_514 busy",
                "busy",
                "add busy",
                "place busy",
                "fetch busy",
                "start_514 busy",
                "start_512 busy",
                "drawing busy",
                "drawing store busy",
                "fetch busy",
                "done",
                "",
            ]
        );
    }

    #[test]
    fn each_fault_ends_the_character_before_anything_wrong_is_started() {
        let cases: [(&[&[&str]], &str); 6] = [
            (&[&["start"], &["position"]], "fetch busy fault"),
            (&[&["start"], &["known"]], "fetch busy fault"),
            (&[&["start"], &["known", "curve"], &[], &["scaled", "too_large"]], "busy fault"),
            (&[&["start"], &["known", "position"], &["scaled", "too_large"]], "busy fault"),
            (&[&["start"], &["known", "position"], &["scaled"], &["beyond"]], "busy fault"),
            (&[&["start"], &["known", "curve"], &[], &["scaled"], &["stop", "failed"]], "drawing busy fault"),
        ];
        for (ticks, last) in cases {
            let shown = run(&[ticks, &[&[], &["start"]]].concat());
            assert_eq!(shown[ticks.len() - 1..], [last, "done", "accepted"], "{ticks:?}");
        }
    }
}
