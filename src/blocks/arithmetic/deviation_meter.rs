//! Deviation meter: follows the steps of a linear interpolator and keeps how far they went from the segment.
//!
//! ```text
//!   start -----------+
//!   major, minor --->[ e = p minor - q major ]---> greatest    max |e|
//!   whole ---------->[ 4 major - p           ]---> left_major
//!   combined ------->[ 4 minor - q           ]---> left_minor
//!                    [ run of equal steps    ]---> longest_run
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

const PROJECTION: Width = Width::Param("WIDTH");
const GREATEST: Width = Width::Add(&PROJECTION, &Width::Fixed(3));
const LEFT: Width = Width::Add(&PROJECTION, &Width::Fixed(4));
const RUN: Width = Width::Add(&PROJECTION, &Width::Fixed(1));

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "deviation_meter",
    kind: Kind::Arithmetic,
    summary: "Keeps the greatest deviation of an interpolator's nodes from the segment, and where its path ends.",
    doc: "(p, q) is the node that the steps have come to, in quarters of a whole step: a whole step adds 4 to p, a \
          combined one COMBINED to p and to q. `start` puts it at (0, 0) and clears all; `major` and `minor`, the end \
          of the segment in whole steps, hold until the frame is over.\n\
          e = p minor - q major is four times the length of the segment times the node's distance from it. greatest(t+1) = \
          max(greatest(t), |e(t)|), so that a node counts in the tick after the one behind its step; all ones stand \
          for that much or more. `left_major` and `left_minor` are what is left to go, 4 major - p and 4 minor - q: at \
          the end the error of the end point. longest_run(t+1) = max(longest_run(t), run(t)), where run is the number \
          of equal steps in a row up to the last one.",
    source: "chosen: the accuracy that SU 1522157 claims with FIG. 5, measured inside the netlist",
    parameters: &[
        Parameter { name: "WIDTH", default: 12, min: 1, max: 48, doc: "bits of a projection" },
        Parameter { name: "COMBINED", default: 3, min: 1, max: 4, doc: "quarters of a combined step along each axis" },
    ],
    ports: &[
        PortDescription::input("start", Width::BIT, "begins a frame"),
        PortDescription::input("major", PROJECTION, "the segment's greater projection, in whole steps"),
        PortDescription::input("minor", PROJECTION, "its lesser projection"),
        PortDescription::input("whole", Width::BIT, "a whole step along the major axis: one tick"),
        PortDescription::input("combined", Width::BIT, "a combined step: one tick, and not together with a whole one"),
        PortDescription::output("greatest", GREATEST, "greatest |p minor - q major| of a node"),
        PortDescription::output("left_major", LEFT, "quarters left to go along the major axis").signed(),
        PortDescription::output("left_minor", LEFT, "quarters left to go along the minor axis").signed(),
        PortDescription::output("longest_run", RUN, "most equal steps in a row"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let greatest = greatest(b);
    b.output("greatest", greatest);
    let (whole, combined) = (b.input("whole"), b.input("combined"));
    let (four, part) = (4, b.count("COMBINED").into());
    let left_major = left(b, "major", &[(whole, four), (combined, part)]);
    let left_minor = left(b, "minor", &[(combined, part)]);
    b.output("left_major", left_major);
    b.output("left_minor", left_minor);
    let longest = longest_run(b);
    b.output("longest_run", longest);
}

fn greatest(b: &mut Builder) -> ValueId {
    let width = b.count("WIDTH") + 5;
    let (major, minor) = (b.input("major"), b.input("minor"));
    let (major, minor) = (b.zero_extend(major, width), b.zero_extend(minor, width));
    let [four, part] = [4, b.count("COMBINED").into()].map(|quarters| b.constant(quarters, width));
    let by_whole = b.mul(minor, four);
    let difference = b.sub(minor, major);
    let by_combined = b.mul(difference, part);

    let e = b.hold(width, 0);
    let by_whole = b.gate(b.input("whole"), by_whole);
    let change = b.mux(b.input("combined"), by_combined, by_whole);
    let next = b.add(e.q, change);
    let e = b.load(e, next, None, b.input("start"));
    b.name_signed("e", e);

    let is_negative = b.sign(e);
    let opposite = b.negate(e);
    let magnitude = b.mux(is_negative, opposite, e);
    let kept = width - 2;
    let beyond = b.slice(magnitude, kept, 2);
    let beyond = b.reduce_or(beyond);
    let full = b.constant(u64::MAX, kept);
    let magnitude = b.slice(magnitude, 0, kept);
    let magnitude = b.mux(beyond, full, magnitude);
    running_maximum(b, magnitude)
}

/// Four times the projection less the quarters of each strobe that has come since `start`.
fn left(b: &mut Builder, projection: &str, strobes: &[(ValueId, u64)]) -> ValueId {
    let width = b.count("WIDTH") + 4;
    let left = b.hold(width, 0);
    let mut gone = b.constant(0, width);
    for &(strobe, quarters) in strobes {
        let quarters = b.constant(quarters, width);
        gone = b.mux(strobe, quarters, gone);
    }
    let next = b.sub(left.q, gone);
    let zeros = b.constant(0, 2);
    let all = b.concat(b.input(projection), zeros);
    let all = b.zero_extend(all, width);
    let next = b.mux(b.input("start"), all, next);
    b.load(left, next, None, None)
}

fn longest_run(b: &mut Builder) -> ValueId {
    let width = b.count("WIDTH") + 1;
    let (whole, combined) = (b.input("whole"), b.input("combined"));
    let step = b.or(whole, combined);
    let last = b.hold(1, 0);
    let is_other = b.xor(last.q, combined);
    b.load(last, combined, step, None);
    let run = b.hold(width, 0);
    let goes_on = b.not(is_other);
    let before = b.gate(goes_on, run.q);
    let one = b.constant(1, width);
    let next = b.add(before, one);
    let run = b.load(run, next, step, b.input("start"));
    running_maximum(b, run)
}

/// The greatest word so far, cleared by `start`.
fn running_maximum(b: &mut Builder, word: ValueId) -> ValueId {
    let greatest = b.hold(b.width(word), 0);
    let is_greater = b.less(greatest.q, word);
    b.load(greatest, word, is_greater, b.input("start"))
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// A meter that has been shown a frame of whole (`U`) and combined (`D`) steps, three ticks apart.
    fn shown(combined: i64, (major, minor): (i64, i64), steps: &str) -> Bench {
        let mut bench = Bench::new("deviation_meter", &[("WIDTH", 4), ("COMBINED", combined)]);
        frame(&mut bench, (major, minor), steps);
        bench
    }

    fn frame(bench: &mut Bench, (major, minor): (i64, i64), steps: &str) {
        bench.set_all(&[("major", major), ("minor", minor), ("start", 1)]);
        bench.tick();
        bench.set("start", 0);
        for step in steps.chars() {
            let line = if step == 'U' { "whole" } else { "combined" };
            bench.set(line, 1);
            bench.tick();
            bench.set(line, 0);
            (0..2).for_each(|_| bench.tick());
        }
    }

    /// The greatest distance of a node from the line through the origin and the end, by vectors: the rejection of the
    /// node's vector from the segment's.
    fn distance(combined: i64, (major, minor): (i64, i64), steps: &str) -> f64 {
        let end = [major as f64, minor as f64];
        let length = end[0].hypot(end[1]);
        let part = combined as f64 / 4.0;
        let (mut node, mut greatest) = ([0.0, 0.0], 0.0_f64);
        for step in steps.chars() {
            let by = if step == 'U' { [1.0, 0.0] } else { [part, part] };
            node = [node[0] + by[0], node[1] + by[1]];
            let along = (node[0] * end[0] + node[1] * end[1]) / (length * length);
            let off = [node[0] - along * end[0], node[1] - along * end[1]];
            greatest = greatest.max(off[0].hypot(off[1]));
        }
        greatest
    }

    #[test]
    fn the_greatest_deviation_is_that_of_the_vectors_and_the_rest_is_counted() {
        for combined in [3, 4] {
            for end in [(8, 3), (3, 3), (15, 0), (15, 11), (5, 4)] {
                for steps in ["", "U", "D", "UDUDUDUDU", "UUUDD", "DDDUUUUDDU"] {
                    let bench = shown(combined, end, steps);
                    let length = f64::hypot(end.0 as f64, end.1 as f64);
                    let measured = bench.get("greatest") as f64 / (4.0 * length);
                    let most = 127.0 / (4.0 * length); // all ones stand for that much or more
                    let expected = distance(combined, end, steps).min(most);
                    assert!((measured - expected).abs() < 1e-12, "{end:?} {steps}: {measured} {expected}");
                    let [whole, both] = ['U', 'D'].map(|step| steps.matches(step).count() as i64);
                    let left = (bench.get_signed("left_major"), bench.get_signed("left_minor"));
                    assert_eq!(left, (4 * end.0 - 4 * whole - combined * both, 4 * end.1 - combined * both));
                    let has_run = |&n: &usize| ["U", "D"].iter().any(|step| steps.contains(&step.repeat(n)));
                    let longest = (0..=10).rev().find(has_run);
                    assert_eq!(Some(bench.get("longest_run") as usize), longest, "{steps}");
                }
            }
        }
    }

    #[test]
    fn a_path_that_goes_astray_reads_all_ones_and_never_less_again() {
        let mut bench = shown(3, (15, 15), "UUUUUUU");
        assert_eq!(bench.get("greatest"), 127, "7 steps of 4 times 15 are more than 7 bits hold");
        for _ in 0..200 {
            bench.set("whole", 1);
            bench.tick();
            assert_eq!(bench.get("greatest"), 127);
        }
    }

    #[test]
    fn a_start_forgets_the_frame_before() {
        let mut bench = shown(3, (15, 1), "DDDD");
        frame(&mut bench, (8, 3), "U");
        assert_eq!((bench.get("greatest"), bench.get("longest_run")), (12, 1));
        assert_eq!((bench.get_signed("left_major"), bench.get_signed("left_minor")), (28, 12));
    }
}
