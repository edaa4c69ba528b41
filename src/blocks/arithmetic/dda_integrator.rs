//! Integrator of a digital differential analyzer: a register Y, an accumulator R, and overflow pulses.
//!
//! ```text
//!   up, down --> Y += up - down
//!   dx ------->  R += Y;  dz = the overflow of R, + or -        dz = Y dx / 2^WIDTH
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "dda_integrator",
    kind: Kind::Arithmetic,
    summary: "Adds up increments in Y, adds Y to R at each dx, and gives the overflows of R as increments.",
    doc: "Y, in two's complement with a sign bit above WIDTH, grows at the end of each tick by the number of `up` inputs \
          that are 1 and shrinks by the number of `down` inputs. In a tick with `dx` = 1, Y is added to R, which holds \
          WIDTH bits: when the sum is 2^WIDTH or more `dz_up` is 1, when it is below 0 `dz_down` is 1, and R keeps the \
          rest. So in the long run dz is Y dx / 2^WIDTH. All are strobes: each tick with a 1 is an increment. R begins at \
          half. `clear` sets Y to 0 and R to half. Y wraps when it leaves its range; a loop that feeds dz back keeps it.",
    source: "US 3,809,868, FIG. 10, digital differential analyzer 338 \"of standard design\"; the integrator of period \
             practice",
    parameters: &[
        Parameter { name: "WIDTH", default: 10, min: 2, max: 30, doc: "bits of R" },
        Parameter { name: "LINES", default: 2, min: 1, max: 4, doc: "increments to Y each way" },
    ],
    ports: &[
        PortDescription::input("clear", Width::BIT, "begins anew"),
        PortDescription::input("dx", Width::BIT, "adds Y to R"),
        PortDescription::input("up", Width::Param("LINES"), "increments of Y"),
        PortDescription::input("down", Width::Param("LINES"), "decrements of Y"),
        PortDescription::output("y", Width::Add(&Width::Param("WIDTH"), &Width::Fixed(1)), "register Y").signed(),
        PortDescription::output("dz_up", Width::BIT, "R overflows above"),
        PortDescription::output("dz_down", Width::BIT, "R overflows below"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (width, clear, dx) = (b.count("WIDTH"), b.input("clear"), b.input("dx"));
    let y = b.hold(width + 1, 0);
    let (more, less) = (ones(b, "up", width + 1), ones(b, "down", width + 1));
    let raised = b.add(y.q, more);
    let next = b.sub(raised, less);
    b.load(y, next, None, clear);
    b.output("y", y.q);

    let r = b.hold(width, 1 << (width - 1));
    b.name("r", r.q);
    let (wide_r, wide_y) = (b.zero_extend(r.q, width + 2), b.sign_extend(y.q, width + 2));
    let sum = b.add(wide_r, wide_y);
    let rest = b.slice(sum, 0, width);
    b.load(r, rest, dx, clear);
    let (below, carry) = (b.sign(sum), b.pick(sum, width));
    let not_below = b.not(below);
    let dz_up = b.all(&[dx, carry, not_below]);
    b.output("dz_up", dz_up);
    let dz_down = b.and(dx, below);
    b.output("dz_down", dz_down);
}

/// How many of an input's bits are 1.
fn ones(b: &mut Builder, input: &str, width: u32) -> ValueId {
    let lines = b.input(input);
    let mut sum = b.constant(0, width);
    for line in 0..b.count("LINES") {
        let bit = b.pick(lines, line);
        let bit = b.zero_extend(bit, width);
        sum = b.add(sum, bit);
    }
    sum
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// The sum of the increments that come out is the integral of Y over x in units of 2^WIDTH, rounded.
    #[test]
    fn what_comes_out_is_the_integral_of_y_over_x() {
        for width in [4, 10] {
            let mut bench = Bench::new("dda_integrator", &[("WIDTH", width)]);
            let scale = f64::from(1 << width);
            let (mut y, mut integral, mut z) = (0, 0.0, 0);
            for tick in 0..4000_i64 {
                // A triangle of Y as high and as low as the word goes, with a dx in three ticks of four.
                let rising = (tick / ((1 << width) - 1) + 1) / 2 % 2 == 0;
                let dx = i64::from(tick % 4 != 3);
                bench.set_all(&[("up", i64::from(rising)), ("down", i64::from(!rising)), ("dx", dx)]);
                assert_eq!(bench.get_signed("y"), y);
                z += bench.get("dz_up") as i64 - bench.get("dz_down") as i64;
                integral += (dx * y) as f64 / scale;
                assert_eq!(z as f64, (integral + 0.5).floor(), "WIDTH {width}, tick {tick}");
                y += if rising { 1 } else { -1 };
                bench.tick();
            }
        }
    }

    #[test]
    fn every_line_counts_each_way_and_a_clear_begins_anew() {
        let mut bench = Bench::new("dda_integrator", &[("LINES", 3)]);
        for (up, down, y) in [(0b111, 0b000, 3), (0b001, 0b110, 2), (0, 0b111, -1), (0b101, 0b010, 0)] {
            bench.set_all(&[("up", up), ("down", down)]);
            bench.tick();
            assert_eq!(bench.get_signed("y"), y);
        }
        bench.set_all(&[("up", 7), ("down", 0), ("dx", 1)]);
        (0..50).for_each(|_| bench.tick());
        bench.set("clear", 1);
        bench.tick();
        assert_eq!((bench.get_signed("y"), bench.get("r")), (0, 512));
    }
}
