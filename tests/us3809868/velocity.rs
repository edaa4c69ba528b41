//! The table of docs/velocity.md is what its example prints.

#[path = "../../examples/velocity_table.rs"]
#[expect(dead_code, reason = "the program itself is not run here")]
pub mod velocity_table;

#[test]
fn every_row_of_the_page_is_what_the_machine_does() {
    let page = include_str!("../../docs/velocity.md");
    let printed: Vec<_> = page.lines().filter(|line| line.starts_with("| ")).skip(1).collect();
    let rows = (0..velocity_table::CONTROLS.len())
        .map(|row| velocity_table::table_row(row).unwrap_or_else(|report| panic!("{report}")));
    assert_eq!(printed, rows.collect::<Vec<_>>());
}
