//! FIG. 19 against the reading's vectors, and what the computer tells its operator.

use serde_json::Value;
use stepwright::host::{Carry, Chain, Entry, Linked, Note, Refusal, Section, Step};

use super::{assert_near, given, linked_chain, point, spiral};
use crate::converters::arcs::Numbers;
use crate::us3809868::vectors::{list, numbers, read, reals};

/// The numerals of the operations that a chain goes through.
fn trace(chain: &Chain) -> Vec<i64> {
    chain.flow().map(|step| step.numeral().into()).collect()
}

fn assert_section(section: &Section, wanted: &Value) {
    let name = wanted.to_string();
    assert_eq!(Some(u64::from(section.case)), wanted["case"].as_u64(), "{name}");
    assert_near(&section.curve.from, &[&wanted["X0"], &wanted["Y0"]].map(|word| word.as_f64().expect("X0, Y0")), &name);
    assert_near(&section.to, &[&wanted["X1"], &wanted["Y1"]].map(|word| word.as_f64().expect("X1, Y1")), &name);
    assert_near(&section.curve.jklm, &reals(&wanted["p"]), &name);
    let slopes = ["S0", "S1"].map(|slope| wanted[slope].as_f64().expect("a slope"));
    assert_near(&[section.s0, section.s1], &slopes, &name);
}

#[test]
fn the_chain_of_the_vectors_takes_the_same_way_and_gives_the_same_strokes() {
    let file = read("fig19_linked.json");
    assert_eq!(trace(&given()), numbers(&file["trace"]));
    let Linked { sections, notes } = given().link();
    let (rejected, accepted): (Vec<_>, Vec<_>) =
        list(&file["strokes"]).iter().partition(|stroke| stroke.get("rejected").is_some());
    assert_eq!((sections.len(), notes.len()), (accepted.len(), rejected.len()));
    sections.iter().zip(accepted).for_each(|(section, wanted)| assert_section(section, wanted));
    let cancelled = |note: &Note| match note {
        Note::Cancelled { points, refusal: Refusal::Inflection { .. } } => points.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(notes.iter().map(cancelled).collect::<Vec<_>>(), [4..=5, 6..=7]);
    // A rejected section goes on from where the chain stood.
    for stroke in rejected {
        assert_eq!(point(&stroke["at"]), sections[0].to);
    }
}

#[test]
fn with_the_slope_that_is_printed_the_chain_of_the_vectors_has_corners_of_the_right_size() {
    let file = read("fig19_linked.json");
    let linked = given().carrying(Carry::AsPrinted).link();
    let wanted = list(&file["as_printed_M/K"]);
    linked.sections.iter().zip(wanted).for_each(|(section, wanted)| assert_section(section, wanted));
    // Directions at (60, 50): it arrives along (-J, -L), and leaves along (1, 4) as K is positive.
    let [arrived, leaves] = [(-6.569_600_2_f64).atan2(45.857_6), 4.0_f64.atan2(1.0)];
    let Note::Corner { point: 3, degrees } = linked.notes[0] else { panic!("{:?}", linked.notes) };
    assert!((degrees - (leaves - arrived).to_degrees()).abs() < 1e-3, "{degrees}");
    assert_eq!(linked.notes[0].to_string(), "corner of 84.1 degrees at point 3");
    assert!(given().link().notes.iter().all(|note| !matches!(note, Note::Corner { .. })));
}

#[test]
fn the_example_is_the_chain_of_the_vectors() {
    assert_eq!(linked_chain::chain(), given());
}

#[test]
fn long_random_chains_have_no_corner_but_cusps_where_k_turns_against_j_and_no_gap() {
    let mut numbers = Numbers(19);
    let (mut joints, mut cusps) = (0, 0);
    for _ in 0..40 {
        let mut next = || [(); 2].map(|()| numbers.between(-300.0, 300.0).round());
        let mut chain = Chain::new([0.0, 0.0], 0.7);
        for _ in 0..60 {
            chain = chain.then(Entry::Two { p3: next(), p1: next() });
        }
        let linked = chain.link();
        let mut expected = 0;
        for pair in linked.sections.windows(2) {
            let [[j, _, l, _], [_, k, _, m]] = [pair[0].curve.jklm, pair[1].curve.jklm];
            // The slope is the same, m/k = l/j; the direction is opposite when k has the sign of j.
            assert!((m * j - l * k).abs() <= 1e-9 * (m * j).abs().max((l * k).abs()).max(1.0), "{pair:?}");
            expected += usize::from(k * j > 0.0);
            assert_eq!(pair[0].stroke.end(), pair[1].stroke.from.map(i32::from));
            joints += 1;
        }
        let seen = linked.notes.iter().filter(|note| matches!(note, Note::Cusp { .. })).count();
        assert_eq!(seen, expected);
        assert!(linked.notes.iter().all(|note| !matches!(note, Note::Corner { .. })));
        cusps += seen;
    }
    assert!(joints > 300 && cusps > 20, "{joints} joints, {cusps} cusps");
}

#[test]
fn a_cusp_is_told_at_its_point_and_not_at_the_first_one() {
    // Alone this stroke leaves against the direction of its slope, which is no cusp where nothing has arrived.
    let back = Entry::Two { p3: [-60.0, -250.0], p1: [100.0, -300.0] };
    let alone = Chain::new([0.0, 0.0], 0.5).then(back).link();
    assert_eq!((alone.sections.len(), alone.notes.len()), (1, 0));
    // K < 0, as the reading says: -410.
    assert_eq!(alone.sections[0].stroke.jklm[1], -410);
    // A straight stroke that arrives along (2, 1) before it.
    let straight = Chain::new([-200.0, -100.0], 0.0).then(Entry::One { p1: [0.0, 0.0], s1: 0.5 }).then(back).link();
    assert_eq!(straight.notes, [Note::Cusp { point: 2 }]);
    assert_eq!(straight.notes[0].to_string(), "cusp at point 2");
}

#[test]
fn what_cannot_be_drawn_is_cancelled_with_its_reason_and_the_chain_goes_on_from_where_it_stood() {
    let good = Entry::Two { p3: [20.0, 35.0], p1: [60.0, 50.0] };
    let cases = [
        (Entry::Two { p3: [1.0, 100.0], p1: [2.0, 3.0] }, 2..=3, "points 2 and 3 cancelled: E = 20.2000 is not"),
        (Entry::One { p1: [5.0, 5.0], s1: 4.0 }, 2..=2, "point 2 cancelled: the slopes at both ends are equal"),
        (Entry::One { p1: [9000.0, 0.0], s1: 0.0 }, 2..=2, "point 2 cancelled: J = -9000 is not from -4095 to 4095"),
        (
            Entry::One { p1: [40000.0, 0.0], s1: 1.0 },
            2..=2,
            "point 2 cancelled: X1 = 40000 is not from -32768 to 32767",
        ),
        (Entry::One { p1: [5.0, 5.0], s1: f64::INFINITY }, 2..=2, "point 2 cancelled: a vertical tangent has no slope"),
        (Entry::Two { p3: [f64::NAN, 0.0], p1: [2.0, 3.0] }, 2..=3, "points 2 and 3 cancelled: E = NaN is not"),
    ];
    let right = Chain::new([0.0, 0.0], 4.0).then(good).link();
    for (bad, numbers, message) in cases {
        let linked = Chain::new([0.0, 0.0], 4.0).then(bad).then(good).link();
        assert_eq!(linked.sections, right.sections, "{bad:?}");
        let [note @ Note::Cancelled { points, .. }] = &linked.notes[..] else { panic!("{:?}", linked.notes) };
        assert_eq!(*points, numbers);
        assert!(note.to_string().starts_with(message), "{note}");
    }
}

#[test]
fn a_straight_section_of_case_1_has_no_slope_to_carry_on() {
    let chain = Chain::new([0.0, 0.0], 1.0)
        .then(Entry::One { p1: [50.0, 50.0], s1: 3.0 })
        .then(Entry::Two { p3: [60.0, 60.0], p1: [90.0, 70.0] });
    let Linked { sections, notes } = chain.link();
    // From (0, 0) with slope 1 to (50, 50): J = L = 0, the slope of the end is 0/0.
    assert_eq!((sections.len(), sections[0].stroke.jklm), (1, [0, 50, 0, 50]));
    assert!(matches!(&notes[..], [Note::Cancelled { refusal: Refusal::Vertical, .. }]), "{notes:?}");
}

#[test]
fn a_chain_may_begin_with_one_point_or_be_empty() {
    let empty = Chain::new([1.0, 2.0], 3.0);
    assert_eq!(trace(&empty), [580, 582, 602]);
    let one = empty.then(Entry::One { p1: [50.0, 20.0], s1: 0.0 });
    assert_eq!(trace(&one), [580, 582, 604, 606, 590, 592, 594, 596, 598, 600, 602]);
    assert!(matches!(one.flow().last(), Some(Step::End)));
}

#[test]
fn a_spiral_is_smooth_in_quarter_turns_and_swings_until_it_is_cancelled_in_shorter_ones() {
    let quarters = spiral(90.0).link();
    assert_eq!((quarters.sections.len(), quarters.notes), (9, Vec::new()));
    let shorter = spiral(70.0).link();
    assert!(shorter.notes.iter().any(|note| matches!(note, Note::Cancelled { .. })), "{shorter:?}");
}
