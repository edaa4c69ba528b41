//! Every parameter of a shipped circuit says what it may be, and means it.

use stepwright::base::{Diagnostic, Report};
use stepwright::netlist::TopParameter;
use stepwright::simulation::{Circuit, Design, shipped};

fn with(circuit: &str, name: &str, value: i64) -> Result<Design, Report> {
    Circuit::shipped(circuit)?.session().parameter(name, value).elaborate()
}

/// Why a value fails, but for that it does not go together with the values of other parameters, as a block then says.
fn breaks(design: Result<Design, Report>) -> Option<Report> {
    let report = design.err()?;
    let goes_alone = |one: &Diagnostic| !one.message.contains("refuses its parameters");
    report.diagnostics.iter().any(goes_alone).then_some(report)
}

/// What is wrong with the range of a parameter.
fn judge(circuit: &str, parameter: &TopParameter) -> Option<String> {
    let TopParameter { name, least: Some(least), most: Some(most), .. } = parameter else {
        return Some(format!("{circuit}: `{}` states no range", parameter.name));
    };
    let is_refused = |value| match with(circuit, name, value) {
        Ok(_) => false,
        Err(report) => report.diagnostics.iter().any(|one| one.message.contains(&format!("`{name}`"))),
    };
    let broken = [*least, *most].into_iter().find_map(|end| Some((end, breaks(with(circuit, name, end))?)));
    match broken {
        Some((end, why)) => Some(format!("{circuit}: `{name}` = {end} is within its range but fails\n{why}")),
        None if !is_refused(least - 1) => Some(format!("{circuit}: `{name}` = {} is not refused", least - 1)),
        None if !is_refused(most + 1) => Some(format!("{circuit}: `{name}` = {} is not refused", most + 1)),
        None => None,
    }
}

#[test]
fn every_parameter_of_a_shipped_circuit_states_its_range_and_both_ends_of_it_work() {
    let mut wrong = Vec::new();
    for circuit in shipped::names("v") {
        let design = Circuit::shipped(circuit).and_then(|shipped| shipped.session().elaborate());
        let design = design.unwrap_or_else(|report| panic!("{report}"));
        // The name of a memory image is no number.
        let numbers = design.netlist().parameters.iter().filter(|parameter| parameter.name != "IMAGE");
        wrong.extend(numbers.filter_map(|parameter| judge(circuit, parameter)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
