//! Shift register: a word that can be loaded, shifted towards the top, cleared, and given out in either code.
//!
//! ```text
//!            load  shift  clear  transfer
//!              |     |      |       |
//!   word --->[        contents        ]---> true_out     contents, while `transfer`
//!            [                        ]---> inverse_out  ~contents, while `transfer`
//! ```

use crate::base::ValueId;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "shift_register",
    kind: Kind::Memory,
    summary: "Holds a word that is loaded at once, doubled by each shift, and given out while `transfer` is high.",
    doc: "loaded = load ? word : q, or with SET_ONLY = 1: q | (load ? word : 0), as through the set inputs of its \
          digits, which asks for a clear before each load.\n\
          q(t+1) = clear ? 0 : shift ? 2 * loaded : loaded. A shift fills in 0 at the bottom and loses the top digit.\n\
          `contents` is q, or with TRANSPARENT = 1 `loaded`: the word is already there in the tick that loads it.",
    source: "SU 1522157, registers 2 and 3 of FIG. 1",
    parameters: &[
        Parameter { name: "WIDTH", default: 16, min: 1, max: 64, doc: "bits of the word" },
        Parameter { name: "TRANSPARENT", default: 0, min: 0, max: 1, doc: "1: a word shows while it is loaded" },
        Parameter { name: "SET_ONLY", default: 0, min: 0, max: 1, doc: "1: loading sets ones and never resets any" },
    ],
    ports: &[
        PortDescription::input("word", Width::Param("WIDTH"), "the word to load"),
        PortDescription::input("load", Width::BIT, "loads"),
        PortDescription::input("shift", Width::BIT, "shifts by one digit towards the top"),
        PortDescription::input("clear", Width::BIT, "sets all digits to 0; wins over `load` and `shift`"),
        PortDescription::input("transfer", Width::BIT, "opens the two gated outputs"),
        PortDescription::output("contents", Width::Param("WIDTH"), "the word held"),
        PortDescription::output("true_out", Width::Param("WIDTH"), "the word while `transfer` is high, otherwise 0"),
        PortDescription::output("inverse_out", Width::Param("WIDTH"), "its inverse while `transfer` is high"),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let q = b.hold(b.count("WIDTH"), 0);
    let (shift, clear, transfer) = (b.input("shift"), b.input("clear"), b.input("transfer"));
    let loaded = loaded(b, q.q);
    let doubled = doubled(b, loaded);
    let next = b.mux(shift, doubled, loaded);
    let q = b.load(q, next, None, clear);
    let contents = if b.param("TRANSPARENT") == 1 { loaded } else { q };
    let inverse = b.not(contents);
    let true_out = b.gate(transfer, contents);
    let inverse_out = b.gate(transfer, inverse);
    b.output("contents", contents);
    b.output("true_out", true_out);
    b.output("inverse_out", inverse_out);
}

fn loaded(b: &mut Builder, q: ValueId) -> ValueId {
    let (word, load) = (b.input("word"), b.input("load"));
    if b.param("SET_ONLY") == 1 {
        let ones = b.gate(load, word);
        b.or(q, ones)
    } else {
        b.mux(load, word, q)
    }
}

fn doubled(b: &mut Builder, word: ValueId) -> ValueId {
    let by_one = b.bit(true);
    b.shift_left(word, by_one)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn loaded(word: i64, parameters: &[(&str, i64)]) -> Bench {
        let mut bench = Bench::new("shift_register", &[&[("WIDTH", 4)], parameters].concat());
        bench.set_all(&[("word", word), ("load", 1)]);
        bench.tick();
        bench.set("load", 0);
        bench
    }

    #[test]
    fn a_shift_moves_every_digit_up_and_fills_in_zero() {
        let mut bench = loaded(0b1011, &[]);
        bench.set("shift", 1);
        for contents in [0b0110, 0b1100, 0b1000, 0b0000, 0b0000] {
            bench.tick();
            assert_eq!(bench.get("contents"), contents);
        }
    }

    #[test]
    fn the_word_stays_until_something_is_asked_of_it() {
        let mut bench = loaded(0b1011, &[]);
        bench.set("word", 0b0100);
        bench.tick();
        assert_eq!(bench.get("contents"), 0b1011);
        bench.set("load", 1);
        bench.tick();
        assert_eq!(bench.get("contents"), 0b0100, "a load replaces the word");
    }

    #[test]
    fn clear_wins_over_load_and_shift() {
        let mut bench = loaded(0b1011, &[]);
        bench.set_all(&[("word", 15), ("load", 1), ("shift", 1), ("clear", 1)]);
        bench.tick();
        assert_eq!(bench.get("contents"), 0);
    }

    #[test]
    fn a_load_and_a_shift_in_one_tick_leave_the_word_doubled() {
        let mut bench = loaded(0, &[]);
        bench.set_all(&[("word", 0b0101), ("load", 1), ("shift", 1)]);
        bench.tick();
        assert_eq!(bench.get("contents"), 0b1010);
    }

    #[test]
    fn the_outputs_show_both_codes_only_while_transfer_is_high() {
        let mut bench = loaded(0b1011, &[]);
        assert_eq!((bench.get("true_out"), bench.get("inverse_out")), (0, 0));
        bench.set("transfer", 1);
        assert_eq!((bench.get("true_out"), bench.get("inverse_out")), (0b1011, 0b0100));
    }

    #[test]
    fn a_word_shows_while_it_is_loaded_only_when_the_register_is_transparent() {
        for (transparent, seen) in [(0, 0b0000), (1, 0b1011)] {
            let mut bench = Bench::new("shift_register", &[("WIDTH", 4), ("TRANSPARENT", transparent)]);
            bench.set_all(&[("word", 0b1011), ("load", 1), ("transfer", 1)]);
            assert_eq!((bench.get("contents"), bench.get("true_out")), (seen, seen));
            bench.tick();
            bench.set("load", 0);
            assert_eq!(bench.get("contents"), 0b1011);
        }
    }

    #[test]
    fn set_inputs_add_ones_to_what_is_there() {
        let mut bench = loaded(0b1010, &[("SET_ONLY", 1)]);
        bench.set_all(&[("word", 0b0110), ("load", 1)]);
        bench.tick();
        assert_eq!(bench.get("contents"), 0b1110);
    }
}
