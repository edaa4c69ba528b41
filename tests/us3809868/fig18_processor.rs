//! FIG. 18: registers, command and status on the bus.

use super::machine::{Machine, Random, SMALL, Stroke};

const ERROR: u64 = 1 << 15;
const BUSY: u64 = 1 << 11;
const DONE: u64 = 1 << 7;

fn machine() -> Machine {
    Machine::shipped("us3809868/fig18_processor", SMALL)
}

fn write(machine: &mut Machine, address: i64, data: i64) {
    machine.set(&[("write", 1), ("address", address), ("data", data & 0xFFFF)]);
    machine.tick();
    machine.set(&[("write", 0), ("address", 7 - address), ("data", !data & 0xFFFF)]);
}

fn load(machine: &mut Machine, stroke: &Stroke) {
    let words = stroke.jklm.into_iter().chain(stroke.from);
    (0..).zip(words).for_each(|(address, word)| write(machine, address, word));
}

/// The command that starts a stroke, with its mark.
fn start(stroke: &Stroke) -> i64 {
    1 | (stroke.quarters - 1) << 2
}

/// What was seen until `done`: rising edges on the four lines, ticks with the mark, all ticks.
fn finish(machine: &mut Machine, mut meanwhile: impl FnMut(&mut Machine, u64)) -> ([i64; 4], u64, u64) {
    let lines = ["up_304", "down_306", "up_314", "down_316"].map(|line| machine.find(line));
    let [mark, busy, done] = ["mark", "busy", "done"].map(|name| machine.find(name));
    let (mut edges, mut marked, mut ticks, mut before) = ([0; 4], 0, 0, [0; 4]);
    while machine.word(done) == 0 {
        assert_eq!(machine.word(busy), 1, "busy until done");
        for line in 0..4 {
            let now = machine.word(lines[line]);
            edges[line] += i64::from((before[line], now) == (0, 1));
            before[line] = now;
        }
        marked += machine.word(mark);
        meanwhile(machine, ticks);
        machine.tick();
        ticks += 1;
        assert!(ticks < 1 << 18, "the stroke does not end");
    }
    (edges, marked, ticks)
}

fn place(machine: &Machine) -> [i64; 2] {
    ["x", "y"].map(|axis| machine.get_signed(axis))
}

#[test]
fn what_the_registers_hold_is_drawn_and_the_status_tells_it() {
    let mut random = Random(18);
    let mut machine = machine();
    assert_eq!(machine.get("status"), 0);
    for round in 0..12 {
        let stroke = random.stroke(511);
        let blank = round % 3 == 2;
        load(&mut machine, &stroke);
        write(&mut machine, 6, start(&stroke) | i64::from(blank) << 4);
        let shown = ((stroke.quarters - 1) << 2) as u64 | u64::from(blank) << 4;
        assert_eq!(machine.get("status"), BUSY | shown);
        let (edges, marked, _) = finish(&mut machine, |_, _| {});
        assert_eq!((place(&machine), edges), (stroke.end(), stroke.counts()), "{stroke:?}");
        assert_eq!(marked, if blank { 0 } else { 4096 * stroke.quarters as u64 });
        assert_eq!(machine.get("status"), DONE | shown);
        machine.tick();
        assert_eq!((machine.get("status"), machine.get("done")), (DONE | shown, 0));
    }
}

#[test]
fn registers_keep_their_words_from_stroke_to_stroke() {
    let mut machine = machine();
    let first = Stroke { jklm: [-60, 5, 7, 80], from: [100, -100], quarters: 1 };
    load(&mut machine, &first);
    write(&mut machine, 6, start(&first));
    finish(&mut machine, |_, _| {});
    // Only K and Y0 are written anew.
    write(&mut machine, 1, -9);
    write(&mut machine, 5, 33);
    let second = Stroke { jklm: [-60, -9, 7, 80], from: [100, 33], quarters: 3 };
    write(&mut machine, 6, start(&second));
    finish(&mut machine, |_, _| {});
    assert_eq!(place(&machine), second.end());
}

#[test]
fn writes_to_registers_and_starts_while_busy_set_error_and_change_nothing() {
    let stroke = Stroke { jklm: [-100, 50, 60, 90], from: [3, 4], quarters: 2 };
    let mut calm = machine();
    load(&mut calm, &stroke);
    write(&mut calm, 6, start(&stroke));
    let seen = finish(&mut calm, |_, _| {});
    // From the first tick after the start, when 366 is at work, to the last one.
    for tick in [0, 3, 9, 11, 5000, seen.2 - 1] {
        for (address, data) in [(0, 7), (1, 7), (2, 7), (3, 7), (4, 7), (5, 7), (6, 1), (6, 0b10001)] {
            let mut machine = machine();
            load(&mut machine, &stroke);
            write(&mut machine, 6, start(&stroke));
            let disturbed = finish(&mut machine, |machine, now| {
                machine.set(&[("write", i64::from(now == tick)), ("address", address), ("data", data)]);
                assert_eq!(machine.get("error"), u64::from(now > tick), "{address} in tick {now}");
            });
            assert_eq!((disturbed, place(&machine)), (seen, stroke.end()), "{address} in tick {tick}");
            assert_eq!(machine.get("status"), ERROR | DONE | 0b100);
            machine.set(&[("write", 0)]);
            write(&mut machine, 6, start(&stroke));
            assert_eq!(machine.get("error"), 0, "a start takes it back");
            finish(&mut machine, |_, _| {});
            assert_eq!(place(&machine), stroke.end(), "the registers are as they were");
        }
    }
}

#[test]
fn a_write_to_address_7_sets_error_at_any_time_and_nothing_else() {
    let stroke = Stroke { jklm: [-10, 20, 30, 40], from: [0, 0], quarters: 1 };
    let mut machine = machine();
    write(&mut machine, 7, 0xFFFF);
    assert_eq!((machine.get("status"), machine.get("error"), machine.get("busy")), (ERROR, 1, 0));
    load(&mut machine, &stroke);
    assert_eq!(machine.get("error"), 1, "a register takes it not back");
    write(&mut machine, 6, start(&stroke));
    assert_eq!(machine.get("error"), 0);
    finish(&mut machine, |machine, now| machine.set(&[("write", i64::from(now == 700)), ("address", 7)]));
    assert_eq!((place(&machine), machine.get("status")), (stroke.end(), ERROR | DONE));
}

#[test]
fn a_stopped_stroke_rests_where_it_is_and_goes_on_with_the_same_pulses() {
    let stroke = Stroke { jklm: [-300, 200, 100, 400], from: [0, 0], quarters: 2 };
    let run = |stop: u64, rest: u64| {
        let mut machine = machine();
        load(&mut machine, &stroke);
        write(&mut machine, 6, start(&stroke));
        let mut stood = Vec::new();
        let seen = finish(&mut machine, |machine, now| {
            let command = if now == stop { Some(0b10) } else { (now == stop + rest).then_some(0) };
            machine.set(&[("write", command.is_some().into()), ("address", 6), ("data", command.unwrap_or(0))]);
            // The clock that is under way comes to its end: four ticks.
            if (stop + 6..stop + rest).contains(&now) {
                stood.push(place(machine));
                assert_eq!(machine.get("status"), BUSY | 0b110);
            }
        });
        assert!(stood.iter().all(|point| *point == stood[0]), "it moves while it is stopped at {stop}");
        assert_eq!((place(&machine), machine.get("error")), (stroke.end(), 0));
        seen
    };
    let (edges, _, ticks) = run(u64::MAX / 2, 1);
    let mut random = Random(568);
    for _ in 0..10 {
        let (stop, rest) = (random.word() % (ticks - 10), 100 + random.word() % 500);
        let (stopped_edges, marked, stopped_ticks) = run(stop, rest);
        assert_eq!(stopped_edges, edges, "stopped at {stop}");
        assert!(stopped_ticks > ticks + rest - 12 && stopped_ticks <= ticks + rest + 4, "{stop}: {stopped_ticks}");
        assert!(marked + 12 > stopped_ticks, "the mark stays");
    }
}

#[test]
fn a_start_with_the_stop_bit_waits_at_the_first_point() {
    let stroke = Stroke { jklm: [0, 20, 0, 40], from: [7, -7], quarters: 1 };
    let mut machine = machine();
    load(&mut machine, &stroke);
    write(&mut machine, 6, start(&stroke) | 2);
    for _ in 0..500 {
        machine.tick();
    }
    assert_eq!((place(&machine), machine.get("busy"), machine.get("mark")), ([7, -7], 1, 1));
    write(&mut machine, 6, 0);
    finish(&mut machine, |_, _| {});
    assert_eq!(place(&machine), stroke.end());
}

#[test]
fn what_554_or_the_generator_refuses_is_not_drawn() {
    let stroke = Stroke { jklm: [0, 20, 0, 40], from: [32000, 0], quarters: 1 };
    let bad: [&[(&str, i64)]; 3] = [
        &[("control_382", 8), ("factor_471", 4096 * 7), ("angle_410", 0)], // 1400 * 7 is more than 511
        &[("control_382", 16), ("offset_x_488", 768)],                     // 32768
        &[("control_382", 1)],                                             // no control of 372
    ];
    for inputs in bad {
        let mut machine = machine();
        machine.set(inputs);
        load(&mut machine, &Stroke { jklm: [0, 200, 0, 40], ..stroke });
        write(&mut machine, 6, 1);
        let (edges, marked, _) = finish(&mut machine, |_, _| {});
        assert_eq!((edges, marked, machine.get("status")), ([0; 4], 0, ERROR | DONE), "{inputs:?}");
    }
    // Beyond 16 bits on the way: the mark goes off there.
    let mut machine = machine();
    load(&mut machine, &Stroke { jklm: [0, 400, 0, 0], from: [32700, 0], ..stroke });
    write(&mut machine, 6, 1);
    let (_, marked, _) = finish(&mut machine, |_, _| {});
    assert_eq!(machine.get("status"), ERROR | DONE);
    assert!((10..2000).contains(&marked), "{marked}");
}
