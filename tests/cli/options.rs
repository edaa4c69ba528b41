//! Options that contradict each other or do nothing are refused before anything runs.

use std::fs;

use super::{folder, refuses, stepwright_in};

#[test]
fn contradictory_options_are_refused_and_nothing_is_written() {
    const FRAME: &str = "su1522157/table1";
    const CIRCUIT: &str = "su1522157/interpolator";
    let folder = folder();
    for (arguments, said) in [
        (&["run", FRAME, "--from", "100", "--to", "50", "--vcd", "x.vcd"][..], "C008"),
        (&["run", FRAME, "--ticks", "20", "--from", "30", "--vcd", "x.vcd"], "C008"),
        (&["run", FRAME, "--ticks", "20", "--until", "busy"], "cannot be used with"),
        (&["run", FRAME, "--ticks", "20", "--limit", "10"], "C007"),
        (&["run", FRAME, "-s", "major_32=3", "-s", "major_32=4"], "C007"),
        (&["run", FRAME, "-p", "WIDTH=8", "-p", "WIDTH=9"], "C007"),
        (&["run", FRAME, "--trace", "f_1"], "--wave"),
        (&["run", FRAME, "--gtkw", "x.gtkw"], "--wave"),
        (&["run", FRAME, "--from", "3"], "--wave"),
        (&["run", FRAME, "--columns", "f_1"], "--table"),
        (&["run", FRAME, "--when", "busy"], "--table"),
        (&["run", FRAME, "--wave", "x.png"], "W005"),
        (&["run", "us3809868/brm12", "--plot"], "C008"),
        (&["show", FRAME, "--source", "--json"], "cannot be used with"),
        (&["sweep", CIRCUIT, "--over", "major_32=1..3", "--out", "x.svg"], "C068"),
        (&["sweep", CIRCUIT, "--over", "major_32=1..3", "-s", "major_32=3"], "C062"),
        (&["sweep", CIRCUIT, "--over", "major_32=1..3", "--resume"], "--out"),
        (&["sweep", CIRCUIT, "--out", "x.csv"], "--over"),
        (&["export", CIRCUIT], "--verilog"),
        (&["run", FRAME, "--last", "5"], "--wave"),
        (&["run", FRAME, "--last", "0", "--vcd", "x.vcd"], "--last"),
        (&["run", FRAME, "--last", "5", "--from", "3", "--vcd", "x.vcd"], "cannot be used with"),
        (&["run", FRAME, "--last", "5", "--when", "busy", "--vcd", "x.vcd"], "cannot be used with"),
        (&["run", FRAME, "--when", "busi", "--vcd", "x.vcd"], "S012"),
        (&["run", FRAME, "--when", "step_y_37", "--vcd", "x.vcd"], "W009"),
        (&["run", FRAME, "--last", "9000000000000", "--vcd", "x.vcd"], "W008"),
        (&["check", "--bless", "--since", "HEAD"], "cannot be used with"),
        (&["diff", "x.vcd"], "<B>"),
        (&["diff", "x.vcd", "y.vcd", "--from", "5", "--to", "4"], "C008"),
        (&["diff", "x.vcd", "y.vcd", "--near=-1"], "--near"),
        (&["diff", "x.vcd", "y.vcd", "--map", "top"], "A=B"),
    ] {
        refuses(&stepwright_in(folder.path(), arguments), &[said]);
        assert_eq!(fs::read_dir(folder.path()).expect("the folder").count(), 0, "{arguments:?}");
    }
}

#[test]
fn a_refused_sweep_leaves_the_file_that_is_there() {
    let folder = folder();
    let path = super::written(folder.path(), "rows.csv", "mine\n");
    let sweep = ["sweep", "su1522157/interpolator", "--over", "major_32=1..3", "--out", "rows.csv"];
    let output = stepwright_in(folder.path(), &[&sweep[..], &["--engine", "native", "--threads", "2"]].concat());
    refuses(&output, &["C067"]);
    assert_eq!(fs::read_to_string(path).expect("a file"), "mine\n");
}
