//! Drawings: curves in, strokes through the machine, figures and pictures out.

use std::fs;
use std::process::{Command, Output};
use std::sync::atomic::AtomicBool;

use serde_json::Value;
use stepwright::draw::{Canvas, How, Look, Placement, cut, draw};
use stepwright::plotfile::{Kind, read};

/// A circle, a curve with a loop, a corner, and letters.
const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 80">
<circle cx="30" cy="30" r="20" stroke="black"/>
<path d="M60 10 C 90 10 90 60 60 60 S 30 80 95 75 l-9 -9" fill="none" stroke="red"/>
<text x="5" y="75" font-size="14">Дуга</text>
</svg>
"##;

fn run(folder: &tempfile::TempDir, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stepwright"));
    command.arg("draw").args(arguments).current_dir(folder).output().expect("it starts")
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.svg"), DRAWING).expect("a file");
    folder
}

#[test]
fn strokes_drawn_at_once_and_one_after_another_give_the_same_pulses_at_the_same_ticks() {
    let plot = read(Kind::Svg, "a.svg", &DRAWING.into()).expect("an SVG");
    let sheet = Placement::Size(200.0).place(&plot.curves).expect("it has room");
    let strokes = cut(&sheet, 1.0);
    let [at_once, one_by_one] = [How::AtOnce, How::OneByOne].map(|how| {
        let mut canvas = Canvas::new(&sheet, Look::default());
        let whole = draw(&strokes, how, &AtomicBool::new(false), |done| canvas.take(&strokes[done.index], &done));
        assert!(whole.expect("the machine takes them"));
        canvas.finish("", "").0
    });
    assert!(strokes.len() > 40 && at_once.pulses > 1000, "{at_once:?}");
    assert_eq!(at_once, one_by_one);
}

#[test]
fn the_figures_of_a_circle_are_those_of_its_formula() {
    let folder = tempfile::tempdir().expect("a folder");
    let circle =
        "<svg xmlns='http://www.w3.org/2000/svg' width='96' height='96'><circle cx='48' cy='48' r='48'/></svg>";
    fs::write(folder.path().join("c.svg"), circle).expect("a file");
    let output = run(&folder, &["c.svg", "--size", "4000", "--json"]);
    let object: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(object["strokes"], 4);
    assert_eq!(object["ticks"], 4 * 32_770, "a quarter is 2 * 8192 clocks of two ticks, and two more");
    assert_eq!(object["pulses"], 8 * 2000, "each quarter goes 2000 counts along X and along Y");
    assert_eq!(object["box"], serde_json::json!([0, 0, 4000, 4000]));
    let length = object["length"].as_f64().expect("a number");
    assert!((length / (4000.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3, "{length}");
    assert_eq!(object["deviation"]["end"], 0.0);
    let most = object["deviation"]["max"].as_f64().expect("a number");
    assert!(most > 0.5 && most < 6.0, "{most}: the rate multipliers of 12 bits are some counts off on the way");
    assert_eq!((&object["unit"], &object["format"]), (&"mm".into(), &1.into()));
    assert!((object["counts_per_unit"].as_f64().expect("a number") - 4000.0 / 25.4).abs() < 1e-3);
}

#[test]
fn a_picture_says_what_it_shows_and_the_command_that_made_it() {
    let folder = folder();
    let output = run(
        &folder,
        &["a.svg", "--svg", "o.svg", "--png", "o.png", "--dots", "--moves", "--alternate", "--size", "300"],
    );
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let svg = fs::read_to_string(folder.path().join("o.svg")).expect("an SVG");
    for words in [
        "a.svg, drawn by us3809868/fig09_function_generator",
        "counts",
        "pen up",
        "what was wanted",
        "places of the pen",
        "stepwright draw a.svg --svg o.svg --png o.png --dots --moves --alternate --size 300",
    ] {
        assert!(svg.contains(words), "{words}");
    }
    assert!(fs::read(folder.path().join("o.png")).expect("a PNG").starts_with(b"\x89PNG"));
    // What it drew can be drawn again.
    assert!(run(&folder, &["o.svg", "--json"]).status.success());
}

#[test]
fn what_contradicts_itself_is_refused_and_nothing_is_written() {
    let folder = folder();
    fs::write(folder.path().join("a.nc"), "<svg/>").expect("a file");
    for (arguments, told) in [
        (&["a.svg", "--size", "0"][..], "more than 0"),
        (&["a.svg", "--size", "nan"], "more than 0"),
        (&["a.svg", "--size", "9", "--fit"], "cannot be used with"),
        (&["a.svg", "--dots"], "required"),
        (&["a.svg", "--size", "99999"], "D002"),
        (&["a.svg", "--tolerance", "0.5"], "C007"),
        (&["a.svg", "--png", "a.svg"], "C030"),
        (&["a.txt"], "F001"),
        (&["a.nc"], "F001"),
        (&["none.svg"], "C002"),
    ] {
        let mut arguments = arguments.to_vec();
        if !arguments.contains(&"--dots") {
            arguments.extend(["--svg", "out.svg"]);
        }
        let output = run(&folder, &arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(told), "{arguments:?}: {said}");
        assert!(!folder.path().join("out.svg").exists(), "{arguments:?}");
    }
}
