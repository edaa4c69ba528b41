//! The tables of FIG. 10 and the count-up table of FIG. 9.

use super::machine::{Machine, session, shipped_session};
use super::vectors::{list, number, numbers, read};

#[test]
fn tables_333_and_334_hold_the_words_of_the_reading() {
    let tables = read("brm_tables.json");
    for (name, table) in tables.as_object().expect("tables by name") {
        // A name like n12_N128_w6 gives the parameters.
        let size = |letter: char| {
            let part = name.split('_').find(|part| part.starts_with(letter)).expect("a parameter");
            part[1..].parse::<i64>().expect("its value")
        };
        let (sum, entries, width) = (size('n'), size('N'), size('w'));
        for (column, reversed) in [("t333", 0), ("t334", 1)] {
            let text = format!(
                "module t(input wire [$clog2({entries})-1:0] address, output wire [{width}-1:0] word);
                   table_memory #(.ENTRIES({entries}), .WIDTH({width}), .SUM_BITS({sum}), .REVERSED({reversed})) u
                     (.address(address), .word(word));
                 endmodule"
            );
            let mut machine = Machine::new(&session("t", &text, &[], &[]));
            let words = (0..entries).map(|address| {
                machine.set(&[("address", address)]);
                machine.get("word") as i64
            });
            assert_eq!(words.collect::<Vec<_>>(), numbers(&table[column]), "{name} {column}");
        }
    }
}

const DIRECTION_BLOCK: &str = "module t(input wire [1:0] quadrant, input wire negative_cosine, negative_sine, cosine,
      output wire up);
    direction_control u (.quadrant(quadrant), .negative_cosine(negative_cosine), .negative_sine(negative_sine),
      .cosine(cosine), .up(up));
  endmodule";

#[test]
fn block_and_gates_of_the_direction_control_follow_every_row_of_the_count_up_table() {
    let block = session("t", DIRECTION_BLOCK, &[], &[]);
    let gates = shipped_session("us3809868/direction_control_298", &[], &[]);
    let table = read("fig9_truth_table.json");
    let rows = list(&table["count_up"]["full"]);
    assert_eq!(rows.len(), 16);
    for program in [block, gates] {
        let mut machine = Machine::new(&program);
        for row in rows {
            let cosine = row["gen"] == "cos";
            let (tested, other) =
                if cosine { ("negative_cosine", "negative_sine") } else { ("negative_sine", "negative_cosine") };
            for ignored in [0, 1] {
                machine.set(&[("quadrant", number(&row["quadrant"]) - 1), ("cosine", cosine.into())]);
                machine.set(&[(tested, (row["sign"] == "-").into()), (other, ignored)]);
                assert_eq!(machine.get("up") == 1, row["count"] == "UP", "{row}");
            }
        }
    }
}
