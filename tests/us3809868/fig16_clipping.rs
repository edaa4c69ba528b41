//! FIG. 16: what is inside a window.

use super::machine::{Machine, Random, Stroke, session};

const CIRCUIT: &str = "us3809868/fig16_clipping";

const OUTPUTS: [&str; 4] = ["inside", "mark_inhibit_100", "full_speed_109", "error"];

fn judge(machine: &mut Machine, [x, y]: [i64; 2], [x_min, x_max, y_min, y_max]: [i64; 4]) -> [u64; 4] {
    let window = [("x_min_390", x_min), ("x_max_392", x_max), ("y_min_394", y_min), ("y_max_396", y_max)];
    machine.set(&[("x", x), ("y", y)]);
    machine.set(&window);
    OUTPUTS.map(|output| machine.get(output))
}

/// The rule in words: inside is between the limits, the limits included.
fn rule([x, y]: [i64; 2], [x_min, x_max, y_min, y_max]: [i64; 4]) -> [u64; 4] {
    let inside = (x_min..=x_max).contains(&x) && (y_min..=y_max).contains(&y);
    let error = x_min > x_max || y_min > y_max;
    [inside, !inside, !inside, error].map(u64::from)
}

#[test]
fn every_point_and_window_of_three_bits_is_judged_by_the_rule() {
    let mut machine = Machine::shipped(CIRCUIT, &[("WIDTH", 3)]);
    for x_min in -4..4 {
        for x_max in -4..4 {
            for y_min in [-4, -1, 0, 2] {
                for y_max in [-3, 0, 3] {
                    let window = [x_min, x_max, y_min, y_max];
                    for point in (-4..4).flat_map(|x| (-4..4).map(move |y| [x, y])) {
                        assert_eq!(judge(&mut machine, point, window), rule(point, window), "{point:?} in {window:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn random_words_of_sixteen_bits_and_both_extremes_are_judged_by_the_rule() {
    let mut machine = Machine::shipped(CIRCUIT, &[]);
    let mut random = Random(16);
    let mut number = || match random.word() % 8 {
        0 => -32768,
        1 => 32767,
        2 => random.within(2),
        _ => random.within(32767),
    };
    for _ in 0..20_000 {
        let (point, window) = ([number(), number()], [number(), number(), number(), number()]);
        assert_eq!(judge(&mut machine, point, window), rule(point, window), "{point:?} in {window:?}");
    }
}

/// FIG. 9 behind FIG. 16, as FIG. 11 has them.
const CLIPPED: &str = "
module clipped (
    input wire clk,
    input wire start,
    input wire signed [15:0] j,
    input wire signed [15:0] k,
    input wire signed [15:0] l,
    input wire signed [15:0] m,
    input wire signed [15:0] x0,
    input wire signed [15:0] y0,
    input wire [2:0] quarters,
    output wire signed [15:0] x,
    output wire signed [15:0] y,
    output wire busy,
    output wire mark_inhibit_100
);
    fig09_function_generator #(.WIDTH(9), .ENTRIES(32), .ENTRY_WIDTH(5)) generator_370 (
        .clk(clk), .start(start), .j(j), .k(k), .l(l), .m(m), .x0(x0), .y0(y0), .quarters(quarters),
        .x(x), .y(y), .up_304(), .down_306(), .up_314(), .down_316(), .busy(busy), .done(), .error()
    );
    fig16_clipping clipping_384 (
        .x(x), .y(y), .x_min_390(-16'sd200), .x_max_392(16'sd500), .y_min_394(-16'sd100), .y_max_396(16'sd150),
        .inside(), .mark_inhibit_100(mark_inhibit_100), .full_speed_109(), .error()
    );
endmodule
";

#[test]
fn on_a_stroke_the_mark_is_off_just_while_the_point_is_outside() {
    let mut machine = Machine::new(&session("us3809868/clipped", CLIPPED, &[], &[]));
    let stroke = Stroke { jklm: [-300, 0, 0, 250], from: [-150, 0], quarters: 4 };
    machine.set(&stroke.inputs());
    machine.tick();
    machine.set(&[("start", 0)]);
    let mut changes = 0;
    let mut before = 0;
    while machine.get("busy") == 1 {
        let point = ["x", "y"].map(|name| machine.get_signed(name));
        let inhibited = machine.get("mark_inhibit_100");
        assert_eq!(inhibited, rule(point, [-200, 500, -100, 150])[1], "{point:?}");
        changes += u64::from(inhibited != before);
        before = inhibited;
        machine.tick();
    }
    assert_eq!(changes, 4, "the ellipse leaves and enters the window above and below");
}
