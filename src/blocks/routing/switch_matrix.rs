//! Switch matrix: each of eight controls connects the four outputs to four of eight words.
//!
//! ```text
//!              J -J  K -K  L -L  M -M        a control closes four switches, one in each row:
//!   J' --------o--o--------o--o--------      J' from J, -J, L or -L, and so on
//!   K' --------------o--o--------o--o--
//!   L' --------o--o--------o--o--------
//!   M' --------------o--o--------o--o--
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

const WORD: Width = Width::Param("WIDTH");

/// What each control does to a point (x, y): whether x and y are exchanged, then x, then y negated.
const MAPS: [(bool, bool, bool); 8] = [
    (true, true, false),
    (false, true, true),
    (true, false, true),
    (false, true, false),
    (false, false, true),
    (true, false, false),
    (true, true, true),
    (false, false, false),
];

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "switch_matrix",
    kind: Kind::Routing,
    summary: "Connects four outputs to four words or their negatives, as one of eight controls says.",
    doc: "controls[0]: (J', K', L', M') = (-L, -M, J, K), a quarter turn counter-clockwise; [1]: (-J, -K, -L, -M), a half \
          turn; [2]: (L, M, -J, -K), a quarter turn clockwise; [3]: (-J, -K, L, M), left and right exchanged; [4]: (J, K, \
          -L, -M), up and down exchanged; [5]: (L, M, J, K), reflected in y = x; [6]: (-L, -M, -J, -K), reflected in y = \
          -x; [7]: (J, K, L, M). With no control the outputs are 0, with several the or of the words; then `single` is 0. \
          Combinational.",
    source: "US 3,809,868, FIG. 13, matrix 440: 16 switches. The table of FIG. 13A is lost: the eight maps are forced, \
             which of the first seven controls does which is chosen",
    parameters: &[Parameter { name: "WIDTH", default: 17, min: 1, max: 64, doc: "bits of the words" }],
    ports: &[
        PortDescription::input("controls", Width::Fixed(8), "one of them is 1"),
        PortDescription::input("j", WORD, "coefficient J").signed(),
        PortDescription::input("k", WORD, "coefficient K").signed(),
        PortDescription::input("l", WORD, "coefficient L").signed(),
        PortDescription::input("m", WORD, "coefficient M").signed(),
        PortDescription::input("minus_j", WORD, "its negative, -J").signed(),
        PortDescription::input("minus_k", WORD, "its negative, -K").signed(),
        PortDescription::input("minus_l", WORD, "its negative, -L").signed(),
        PortDescription::input("minus_m", WORD, "its negative, -M").signed(),
        PortDescription::output("j_out", WORD, "transformed J").signed(),
        PortDescription::output("k_out", WORD, "transformed K").signed(),
        PortDescription::output("l_out", WORD, "transformed L").signed(),
        PortDescription::output("m_out", WORD, "transformed M").signed(),
        PortDescription::output("single", Width::BIT, "just one control is 1"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let pairs = [("j", "minus_j"), ("k", "minus_k"), ("l", "minus_l"), ("m", "minus_m")];
    let [j, k, l, m] = pairs.map(|(word, negative)| (b.input(word), b.input(negative)));
    for (output, straight, exchanged, vertical) in
        [("j_out", j, l, false), ("k_out", k, m, false), ("l_out", l, j, true), ("m_out", m, k, true)]
    {
        let row = row(b, straight, exchanged, vertical);
        b.output(output, row);
    }
    let controls = b.input("controls");
    let (one, some) = (b.constant(1, 8), b.reduce_or(controls));
    let below = b.sub(controls, one);
    let others = b.and(controls, below);
    let alone = b.is(others, 0);
    let single = b.and(some, alone);
    b.output("single", single);
}

/// The row of switches of one output: which of a word, the word of the other axis, and their negatives it gets.
fn row(b: &mut Builder, straight: (ValueId, ValueId), exchanged: (ValueId, ValueId), vertical: bool) -> ValueId {
    let controls = b.input("controls");
    let mut output = b.constant(0, b.count("WIDTH"));
    for (control, (exchange, negate_x, negate_y)) in (0..).zip(MAPS) {
        let (word, negative) = if exchange { exchanged } else { straight };
        let negate = if vertical { negate_y } else { negate_x };
        let closed = b.pick(controls, control);
        let connected = b.gate(closed, if negate { negative } else { word });
        output = b.or(output, connected);
    }
    output
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn bench() -> Bench {
        let mut bench = Bench::new("switch_matrix", &[("WIDTH", 5)]);
        bench.set_all(&[("j", 1), ("k", 2), ("l", 3), ("m", 4)]);
        bench.set_all(&[("minus_j", -1), ("minus_k", -2), ("minus_l", -3), ("minus_m", -4)]);
        bench
    }

    #[test]
    fn each_control_makes_its_row_of_the_table() {
        let table = [
            [-3, -4, 1, 2],
            [-1, -2, -3, -4],
            [3, 4, -1, -2],
            [-1, -2, 3, 4],
            [1, 2, -3, -4],
            [3, 4, 1, 2],
            [-3, -4, -1, -2],
            [1, 2, 3, 4],
        ];
        let mut bench = bench();
        for (control, expected) in table.into_iter().enumerate() {
            bench.set("controls", 1 << control);
            assert_eq!(["j_out", "k_out", "l_out", "m_out"].map(|word| bench.get_signed(word)), expected, "{control}");
        }
    }

    #[test]
    fn single_tells_one_control_from_none_and_several() {
        let mut bench = bench();
        for controls in 0..256_i64 {
            bench.set("controls", controls);
            assert_eq!(bench.get("single") == 1, controls.count_ones() == 1, "{controls:08b}");
        }
    }
}
