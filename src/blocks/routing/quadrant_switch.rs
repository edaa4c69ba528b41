//! Quadrant switch: connects one table in odd quadrants, the other in even ones.
//!
//! ```text
//!   odd_table  --\
//!                 [switch]--> word
//!   even_table --/    ^ even_quadrant
//! ```

use crate::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "quadrant_switch",
    kind: Kind::Routing,
    summary: "Connects one table in quadrants 1 and 3, the other in quadrants 2 and 4.",
    doc: "word = even_quadrant ? even_table : odd_table. Combinational. Two of them exchange the tables of sine and \
          cosine: with t = pi/2 + u, |d sin t| = sin u du and |d cos t| = cos u du.",
    source: "US 3,809,868, FIG. 10, switches 330, 331",
    parameters: &[Parameter { name: "WIDTH", default: 6, min: 1, max: 64, doc: "bits of a table's word" }],
    ports: &[
        PortDescription::input("odd_table", Width::Param("WIDTH"), "word for quadrants 1 and 3"),
        PortDescription::input("even_table", Width::Param("WIDTH"), "word for quadrants 2 and 4"),
        PortDescription::input("even_quadrant", Width::BIT, "1 in quadrants 2 and 4"),
        PortDescription::output("word", Width::Param("WIDTH"), "the word connected"),
    ],
    clocked: false,
};

fn build(b: &mut Builder) {
    let word = b.mux(b.input("even_quadrant"), b.input("even_table"), b.input("odd_table"));
    b.output("word", word);
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    #[test]
    fn the_table_of_the_quadrant_is_connected() {
        let mut bench = Bench::new("quadrant_switch", &[]);
        bench.set_all(&[("odd_table", 50), ("even_table", 3)]);
        for (even, word) in [(0, 50), (1, 3)] {
            bench.set("even_quadrant", even);
            assert_eq!(bench.get("word"), word);
        }
    }
}
