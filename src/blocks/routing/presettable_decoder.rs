//! Presettable decoder: opens in each state of a counter the line that has been set for it.
//!
//! ```text
//!   order --[ register, preset ]-- third | second | first
//!                                           |
//!   state -------------------------------[select]--[decode]--> lines
//! ```

use crate::blocks::{Block, Builder, Description, Kind, PortDescription, Width};

/// States that have a code.
const STATES: u32 = 3;

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "presettable_decoder",
    kind: Kind::Routing,
    summary: "Decodes the first three states of a counter into lines, in an order that is set beforehand.",
    doc: "order is held from the end of a tick in which `preset` is 1: three codes of two bits, that of the first state \
          lowest. lines[i] = (code of the present state == i): just one line is high; 0 at power-on means line 0 in every \
          state. In the fourth state no line is high.",
    source: "US 3,809,868, FIG. 20, presettable decoder 616: settable to alter which rotation is performed first and \
             which second; the code is chosen",
    parameters: &[],
    ports: &[
        PortDescription::input("preset", Width::BIT, "takes the order"),
        PortDescription::input("order", Width::Fixed(2 * STATES), "number of the line for each state, first lowest"),
        PortDescription::input("state", Width::Fixed(2), "state of the counter, 0 is the first"),
        PortDescription::output("lines", Width::Fixed(4), "the line of this state is high"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let held = b.hold(2 * STATES, 0);
    let order = b.load(held, b.input("order"), b.input("preset"), None);
    let state = b.input("state");
    let mut lines = b.constant(0, 4);
    for number in 0..STATES {
        let code = b.slice(order, 2 * number, 2);
        let one = b.constant(1, 4);
        let decoded = b.shift_left(one, code);
        let present = b.is(state, number.into());
        let opened = b.gate(present, decoded);
        lines = b.or(lines, opened);
    }
    b.output("lines", lines);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn each_state_opens_the_line_that_its_order_names() {
        let mut bench = Bench::new("presettable_decoder", &[]);
        for codes in (0..64).map(|order| [order & 3, order >> 2 & 3, order >> 4]) {
            let order = codes[0] + 4 * codes[1] + 16 * codes[2];
            bench.set_all(&[("order", order), ("preset", 1)]);
            bench.tick();
            bench.set_all(&[("order", 63 - order), ("preset", 0)]);
            bench.tick();
            for (state, lines) in (0..).zip([1 << codes[0], 1 << codes[1], 1 << codes[2], 0]) {
                bench.set("state", state);
                assert_eq!(bench.get("lines"), lines, "order {codes:?}, state {state}");
            }
        }
    }
}
