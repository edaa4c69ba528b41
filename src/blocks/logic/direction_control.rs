//! Direction control: whether a pulse counts up, from the quadrant and the sign of the coefficient it belongs to.

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "direction_control",
    kind: Kind::Logic,
    summary: "Tells whether a pulse counts up, by the count-up truth table of the patent.",
    doc: "A pulse of the cosine generator tests the sign of J (or L), one of the sine generator that of K (or M); \
          `cosine` says whose turn it is. The pulse counts up when the coefficient has this sign:\n\
          quadrant 1: J -, K +;  quadrant 2: J -, K -;  quadrant 3: J +, K -;  quadrant 4: J +, K +.\n\
          With the quadrant coded 0 to 3 as q1 q0: cosine up = q1 xor negative_cosine, sine up = not (q1 xor q0 xor \
          negative_sine). Combinational.",
    source: "US 3,809,868, FIG. 9, direction controls 298, 308; the scan prints row 1 of its \
             table like row 4, so row 1 rests on the signs of d(cos) and d(sin)",
    parameters: &[],
    ports: &[
        PortDescription::input("quadrant", Width::Fixed(2), "quadrant less one"),
        PortDescription::input("negative_cosine", Width::BIT, "sign of J (or L), for pulses of the cosine generator"),
        PortDescription::input("negative_sine", Width::BIT, "sign of K (or M), for pulses of the sine generator"),
        PortDescription::input("cosine", Width::BIT, "1: test the coefficient of the cosine generator"),
        PortDescription::output("up", Width::BIT, "1: the pulse counts up"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let quadrant = b.input("quadrant");
    let (q0, q1) = (b.pick(quadrant, 0), b.pick(quadrant, 1));
    let cosine_up = b.xor(q1, b.input("negative_cosine"));
    let sine_rises = b.xor(q1, q0);
    let sine_down = b.xor(sine_rises, b.input("negative_sine"));
    let sine_up = b.not(sine_down);
    let up = b.mux(b.input("cosine"), cosine_up, sine_up);
    b.output("up", up);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    /// A pulse is a unit of |d cos| or |d sin|; it counts up when coefficient times differential is positive.
    #[test]
    fn a_pulse_counts_up_when_the_differential_times_the_coefficient_is_positive() {
        let mut bench = Bench::new("direction_control", &[]);
        for quadrant in 0..4_i32 {
            let t = (f64::from(quadrant) + 0.5) * std::f64::consts::FRAC_PI_2;
            for (cosine, differential) in [(1, -t.sin()), (0, t.cos())] {
                for negative in [0, 1] {
                    let coefficient = if negative == 1 { -1.0 } else { 1.0 };
                    bench.set_all(&[("quadrant", quadrant.into()), ("cosine", cosine)]);
                    let tested = if cosine == 1 { "negative_cosine" } else { "negative_sine" };
                    let other = if cosine == 1 { "negative_sine" } else { "negative_cosine" };
                    for ignored in [0, 1] {
                        bench.set_all(&[(tested, negative), (other, ignored)]);
                        assert_eq!(bench.get("up") == 1, coefficient * differential > 0.0, "quadrant {quadrant}");
                    }
                }
            }
        }
    }
}
