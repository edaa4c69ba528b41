//! Processor 503 of FIG. 17 against a model of what the text says, with random memories, good and bad. The test plays
//! the memory and the generator.

use super::machine::{Machine, Random};

const CIRCUIT: &str = "us3809868/character_processor";

/// A stroke as the generator is told to draw it: J, K, L, M, X0, Y0.
type Order = [i64; 6];

/// What came of a character.
#[derive(PartialEq, Debug)]
struct Outcome {
    orders: Vec<Order>,
    end: [i64; 2],
    error: bool,
}

/// A character to be drawn.
#[derive(Debug)]
struct Case {
    memory: Vec<i64>,
    pointer: i64,
    known: bool,
    from: [i64; 2],
    scale: i64,
    /// The stroke, counted from 0, that the generator cannot draw.
    failing: usize,
}

/// A number that 16 bits hold.
fn word(number: i64) -> Option<i64> {
    i16::try_from(number).ok().map(i64::from)
}

/// The text, instruction by instruction. `None` ends a wrong character.
fn model(case: &Case) -> Outcome {
    let mut outcome = Outcome { orders: Vec::new(), end: case.from, error: false };
    outcome.error = work_off(case, &mut outcome).is_none();
    outcome
}

fn work_off(case: &Case, outcome: &mut Outcome) -> Option<()> {
    let scaled = |number: i64| word((number as f64 * case.scale as f64 / 4096.0).round() as i64);
    let mut at = case.known.then_some(case.pointer as usize)?;
    loop {
        match *case.memory.get(at)? {
            1 => {
                let [j, k, l, m] = case.memory.get(at + 1..at + 5)?.try_into().expect("four words");
                let [j, k, l, m] = [scaled(j)?, scaled(k)?, scaled(l)?, scaled(m)?];
                let [x, y] = outcome.end;
                outcome.orders.push([j, k, l, m, x, y]);
                if outcome.orders.len() > case.failing {
                    return None;
                }
                outcome.end = drawn([j, k, l, m, x, y]);
                at += 5;
            }
            2 => {
                let [x, y] = case.memory.get(at + 1..at + 3)?.try_into().expect("two words");
                let [x, y] = [scaled(x)?, scaled(y)?];
                outcome.end = [word(case.from[0] + x)?, word(case.from[1] + y)?];
                at += 3;
            }
            3 => return Some(()),
            _ => return None,
        }
    }
}

/// Where the generator stops: anywhere, as long as both sides know.
fn drawn([j, k, l, m, x, y]: Order) -> [i64; 2] {
    [x - j + k, y - l + m].map(|number| i64::from(number as i16))
}

/// The netlist, tick by tick, on this memory.
fn run(machine: &mut Machine, case: &Case, random: &mut Random) -> Outcome {
    let ([x0, y0], known) = (case.from, i64::from(case.known));
    machine.set(&[("x0", x0), ("y0", y0), ("scale_514", case.scale), ("start", 1), ("error_512", 0)]);
    machine.set(&[("pointer_500", case.pointer), ("known_500", known)]);
    let mut orders: Vec<Order> = Vec::new();
    let mut left = None;
    for _ in 0..2000 {
        show_memory(machine, case);
        machine.tick();
        machine.set(&[("start", 0), ("stop_512", 0)]);
        if machine.get("done") == 1 {
            let end = ["x", "y"].map(|name| machine.get_signed(name));
            return Outcome { orders, end, error: machine.get("error") == 1 };
        }
        show_memory(machine, case);
        lead_back(machine);
        if machine.get("start_512") == 1 {
            assert_eq!(left, None, "a start while the generator is at work");
            orders.push(["j", "k", "l", "m", "x_509", "y_510"].map(|name| machine.get_signed(name)));
            left = Some(1 + random.word() % 4);
        } else if let Some(ticks) = left {
            left = (ticks > 1).then_some(ticks - 1);
            let [x, y] = drawn(*orders.last().expect("a stroke"));
            let (stop, failed) = (i64::from(left.is_none()), i64::from(orders.len() > case.failing));
            machine.set(&[("stop_512", stop), ("error_512", failed * stop), ("x_512", x), ("y_512", y)]);
        }
    }
    panic!("no end: {case:?}");
}

/// What 514 gives goes back into the processor as it is, as in FIG. 17.
fn lead_back(machine: &mut Machine) {
    let words =
        [("done_366", "start_366"), ("k_366", "k"), ("m_366", "m")].map(|(to, from)| (to, machine.get_signed(from)));
    machine.set(&words);
}

fn show_memory(machine: &mut Machine, case: &Case) {
    let address = machine.get("address_504") as usize;
    let word = |offset: usize| case.memory.get(address + offset).copied().unwrap_or(0);
    let count = case.memory.len().saturating_sub(address).min(5) as i64;
    machine.set(&[
        ("control_502", word(0) & 0xFFFF),
        ("word_1", word(1)),
        ("word_2", word(2)),
        ("word_3", word(3)),
        ("word_4", word(4)),
        ("count_502", count),
    ]);
}

/// Instructions, most of them good, and an end that may be missing.
fn random_case(random: &mut Random) -> Case {
    let mut memory = Vec::new();
    let chance = |random: &mut Random, of: u64| random.word().is_multiple_of(of);
    let large = chance(random, 4);
    let most = if large { 30_000 } else { 900 };
    for _ in 0..random.word() % 8 {
        let (control, words) = if chance(random, 3) { (2, 2) } else { (1, 4) };
        memory.push(if chance(random, 30) { random.within(32767) } else { control });
        memory.extend((0..words).map(|_| random.within(most)));
    }
    memory.push(if chance(random, 10) { 0 } else { 3 });
    memory.truncate(if chance(random, 8) { memory.len() - 1 } else { memory.len() });
    Case {
        pointer: if chance(random, 15) { random.within(40).abs() } else { 0 },
        known: !chance(random, 20),
        from: [random.within(most), random.within(most)],
        scale: if chance(random, 4) { random.within(32767) } else { random.within(4096) },
        failing: if chance(random, 20) { 1 } else { usize::MAX },
        memory,
    }
}

#[test]
fn random_memories_good_and_bad_give_just_the_strokes_of_the_text_or_an_error() {
    let mut machine = Machine::shipped(CIRCUIT, &[]);
    let mut random = Random(17);
    let (mut good, mut bad) = (0, 0);
    for _ in 0..4000 {
        let case = random_case(&mut random);
        let outcome = run(&mut machine, &case, &mut random);
        assert_eq!(outcome, model(&case), "{case:?}");
        *(if outcome.error { &mut bad } else { &mut good }) += 1;
    }
    assert!(good > 1000 && bad > 1000, "{good} good, {bad} bad");
}

#[test]
fn each_kind_of_bad_memory_is_an_error_and_draws_nothing_after_it() {
    let good = vec![2, 10, 20, 1, 1, 2, 3, 4, 3];
    let case =
        |memory: Vec<i64>| Case { memory, pointer: 0, known: true, from: [5, 6], scale: 4096, failing: usize::MAX };
    let orders = |case: Case| {
        let outcome = run(&mut Machine::shipped(CIRCUIT, &[]), &case, &mut Random(1));
        (outcome.orders.len(), outcome.error)
    };
    assert_eq!(orders(case(good.clone())), (1, false));
    let unknown = Case { known: false, ..case(good.clone()) };
    let outside = Case { pointer: 9, ..case(good.clone()) };
    let far_outside = Case { pointer: 65535, ..case(good.clone()) };
    let undefined = case(vec![2, 10, 20, 4, 1, 2, 3, 4, 3]);
    let no_exit = case(good[..8].to_vec());
    let cut_off = case(good[..7].to_vec());
    let too_large = Case { scale: 32767, ..case(vec![1, 9000, 0, 0, 0, 3]) };
    let beyond = Case { from: [32760, 0], ..case(good) };
    for (case, strokes) in [
        (unknown, 0),
        (outside, 0),
        (far_outside, 0),
        (undefined, 0),
        (no_exit, 1),
        (cut_off, 0),
        (too_large, 0),
        (beyond, 0),
    ] {
        let text = format!("{case:?}");
        assert_eq!(orders(case), (strokes, true), "{text}");
    }
}
