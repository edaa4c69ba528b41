//! Mistakes in a scenario are told all at once, each with its line.

use super::{folder, refuses, stderr, stepwright_in, written};

#[test]
fn every_mistake_carries_its_line() {
    let folder = folder();
    let text = r#"circuit = "su1522157/interpolator"
require = ["minor_34 <= major_33"]
[inputs]
major_32 = 5000
minr_34 = 3
[[at]]
tick = 1
set = { start_33 = 2 }
[stop]
until = "!busi"
limit = 100
[trace]
signals = ["tapp_23",
    "a["]
[table]
when = ["and_16_ot"]
columns = ["f_2"]
[plot]
x = "major"
y = { step_x_3 = 1 }
pen = "bsy"
[expect]
outputs = { busy = 2 }
pulses = { f_1 = 3 }
"#;
    written(folder.path(), "bad.toml", text);
    let output = stepwright_in(folder.path(), &["run", "bad.toml"]);
    refuses(&output, &["did you mean `busy`?", "did you mean `and_16_out`?", "did you mean `step_x_36`?"]);
    let message = stderr(&output);
    for (code, line) in [
        ("S010", 2),
        ("S011", 4),
        ("S010", 5),
        ("S011", 8),
        ("S012", 10),
        ("W002", 13),
        ("W001", 14),
        ("S012", 16),
        ("S012", 17),
        ("S012", 19),
        ("S012", 20),
        ("S012", 21),
        ("S011", 23),
        ("S016", 24),
    ] {
        let told =
            message.split("error[").any(|part| part.starts_with(code) && part.contains(&format!("bad.toml:{line}:")));
        assert!(told, "{code} in line {line} is not in:\n{message}");
    }
}

#[test]
fn an_unknown_circuit_or_parameter_carries_its_line() {
    let folder = folder();
    let run = |text: &str| {
        written(folder.path(), "bad.toml", text);
        stepwright_in(folder.path(), &["run", "bad.toml"])
    };
    refuses(&run("title = \"x\"\ncircuit = \"su1522157/interpolatr\"\n"), &["C001", "bad.toml:2:11", "did you mean"]);
    refuses(&run("title = \"x\"\ncircuit = \"none.v\"\n"), &["C002", "bad.toml:2:11"]);
    let parameter = "circuit = \"su1522157/interpolator\"\n[parameters]\nWIDHT = 9\n";
    refuses(&run(parameter), &["N014", "bad.toml:3:1", "did you mean `WIDTH`?"]);
    refuses(&run("circuit = \"a\"\nrequire = [\"a = b\"]\n"), &["S006", "bad.toml:2:12"]);
    refuses(&run("circuit = \"a\"\ngolden = \"mine.toml\"\n"), &["S003", "bad.toml:2:10", "ends in .vcd"]);
}
