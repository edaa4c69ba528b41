//! Phase detector: tells when a sine and a cosine wave arrive at the quarter points.

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "phase_detector",
    kind: Kind::Logic,
    summary: "Strobes each quarter point of a pair of waves: pi/2, pi, 3 pi/2, 2 pi.",
    doc: "strobes[0], pi/2: the cosine has arrived at 0 from above; strobes[1], pi: the sine from above; strobes[2], \
          3 pi/2: the cosine from below; strobes[3], 2 pi: the sine from below. Each in the very tick in which the wave \
          is 0 and was not in the tick before.",
    source: "US 3,809,868, FIG. 4, phase detector 94 (thresholding of the outputs of generators 90 and 92)",
    parameters: &[Parameter { name: "WIDTH", default: 30, min: 2, max: 64, doc: "bits of the waves" }],
    ports: &[
        PortDescription::input("sine", Width::Param("WIDTH"), "the sine wave").signed(),
        PortDescription::input("cosine", Width::Param("WIDTH"), "the cosine wave").signed(),
        PortDescription::output("strobes", Width::Fixed(4), "the quarter points, pi/2 lowest"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let (sine, cosine) = (b.input("sine"), b.input("cosine"));
    let [half, full] = arrivals(b, sine);
    let [quarter, three_quarters] = arrivals(b, cosine);
    let strobes = b.join(&[quarter, half, three_quarters, full]);
    b.output("strobes", strobes);
}

/// Whether the wave is 0 and was above, was below, in the tick before.
fn arrivals(b: &mut Builder, wave: ValueId) -> [ValueId; 2] {
    let zero = b.is(wave, 0);
    let moving = b.not(zero);
    let below = b.sign(wave);
    let positive = b.not(below);
    let above = b.and(moving, positive);
    [above, below].map(|side| {
        let was = b.delay(side);
        b.and(zero, was)
    })
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_quarter_point_of_two_periods_is_strobed_once() {
        let mut bench = Bench::new("phase_detector", &[("WIDTH", 8)]);
        let mut seen = Vec::new();
        for step in 0..=32 {
            let angle = f64::from(step) * std::f64::consts::PI / 8.0;
            let wave = |value: f64| (value * 100.0).round() as i64;
            bench.set_all(&[("sine", wave(angle.sin())), ("cosine", wave(angle.cos()))]);
            if bench.get("strobes") != 0 {
                seen.push((step, bench.get("strobes")));
            }
            bench.tick();
        }
        assert_eq!(seen, [(4, 1), (8, 2), (12, 4), (16, 8), (20, 1), (24, 2), (28, 4), (32, 8)]);
    }
}
