//! docs/host.md shows what its example prints.

use stepwright::host::Carry;

use super::linked_chain;

#[test]
fn the_steps_on_the_page_are_those_that_the_example_prints() {
    let page = include_str!("../../../docs/host.md");
    let mut blocks = page.split("```text\n").skip(1).map(|rest| rest.split("```").next().expect("an end"));
    assert_eq!(blocks.next().expect("a block"), linked_chain::transcript(Carry::EndSlope));
    let printed = blocks.next().expect("another");
    assert!(printed.lines().count() > 3);
    let all = linked_chain::transcript(Carry::AsPrinted);
    assert!(printed.lines().all(|line| line == "..." || all.lines().any(|other| other == line)), "{printed}");
}
