//! Headers: values of parameters, widths of ports and nets.

use super::constant::{Const, Shape};
use super::evaluate::{evaluate, evaluate_as, number};
use super::names::{Meaning, Names};
use super::range;
use super::template::{LocalDrive, LocalNet, LocalScope, LocalSource, Override, Template};
use crate::base::Diagnostic;
use crate::base::word::MAX_WIDTH;
use crate::blocks::Direction;
use crate::netlist::checked::TopParameter;
use crate::netlist::errors::Errors;
use crate::netlist::syntax::{Module, Name, NetType, Parameter, ParameterKind, Port, Range};

type Result<T> = std::result::Result<T, Diagnostic>;

/// The template of a module as far as its header tells, and the names that its inside can use.
pub(super) fn elaborate<'t>(
    module: &'t Module,
    overrides: &[Override<'t>],
    errors: &mut Errors,
) -> (Template<'t>, Names<'t>) {
    let mut header = Header { template: empty(module), names: Names::new() };
    for given in overrides {
        check_name(module, given).unwrap_or_else(|error| errors.push(error));
    }
    range::check_attributes(module).into_iter().for_each(|error| errors.push(error));
    for parameter in &module.parameters {
        header.parameter(parameter, overrides).unwrap_or_else(|error| errors.push(error));
    }
    for port in &module.ports {
        header.port(port).unwrap_or_else(|error| errors.push(error));
    }
    header.template.ports = header.template.nets.len();
    (header.template, header.names)
}

pub(super) fn empty(module: &Module) -> Template<'_> {
    let Name { text, span } = &module.name;
    Template {
        module,
        parameters: Vec::new(),
        scopes: vec![LocalScope { parent: None, name: text.to_string(), module: (**text).into(), span: *span }],
        nets: Vec::new(),
        ports: 0,
        cells: Vec::new(),
        instances: Vec::new(),
    }
}

/// Whether a module has the parameter that is given.
fn check_name(module: &Module, given: &Override<'_>) -> Result<()> {
    let all: Vec<&Parameter> = module.all_parameters().collect();
    let found = all.iter().find(|parameter| *parameter.name.text == *given.name);
    let message = match found {
        Some(parameter) if !parameter.local => return Ok(()),
        Some(_) => format!("`{}` of `{}` is a localparam and cannot be given", given.name, module.name.text),
        None => format!("`{}` has no parameter `{}`", module.name.text, given.name),
    };
    let names = all.iter().filter(|parameter| !parameter.local).map(|parameter| &*parameter.name.text);
    let list: Vec<_> = names.clone().collect();
    let mut diagnostic = Diagnostic::new("N014", message).nearest(given.name, names);
    if let Some(span) = given.span {
        diagnostic = diagnostic.at(span, "given here").at(module.name.span, "the module");
    }
    Err(if list.is_empty() { diagnostic } else { diagnostic.help(format!("its parameters: {}", list.join(", "))) })
}

struct Header<'t> {
    template: Template<'t>,
    names: Names<'t>,
}

impl<'t> Header<'t> {
    fn parameter(&mut self, parameter: &'t Parameter, overrides: &[Override<'t>]) -> Result<()> {
        let value = parameter_value(&self.names, self.template.module, parameter, overrides);
        let meaning = value.as_ref().map_or(Meaning::Wrong, |value| Meaning::Constant(*value));
        self.names.declare(&parameter.name, meaning)?;
        if !parameter.local {
            let kept = kept_parameter(&self.names, self.template.module, parameter, value?)?;
            self.template.parameters.push(kept);
        }
        Ok(())
    }

    fn port(&mut self, port: &'t Port) -> Result<()> {
        let place = self.template.nets.len() as u32;
        let mut net = match net(&self.names, &port.name, &port.net_type) {
            Ok(net) => net,
            Err(error) => return self.names.declare(&port.name, Meaning::Wrong).and(Err(error)),
        };
        net.port = Some(port.direction);
        net.is_clock = *port.name.text == *"clk";
        if net.is_clock && (port.direction == Direction::Output || net.is_vector) {
            let message = "`clk` is the name of the clock, an input of one bit";
            let diagnostic = Diagnostic::new("N023", message).at(port.name.span, "another thing here");
            return Err(diagnostic.help("write `input wire clk`, or choose another name"));
        }
        if port.direction == Direction::Input && !net.is_clock {
            let (width, span) = (net.width, net.span);
            net.drives.push(LocalDrive { low: 0, width, source: LocalSource::Outside, span });
        }
        self.template.nets.push(net);
        self.names.declare(&port.name, Meaning::Net(place))
    }
}

/// A parameter's value: the one given, or its own; brought to its declared type, and within the range that the module
/// states.
pub(super) fn parameter_value(
    names: &Names<'_>,
    module: &Module,
    parameter: &Parameter,
    given: &[Override<'_>],
) -> Result<Const> {
    let value = typed_value(names, parameter, given)?;
    range::check(names, module, parameter, value.number(), given).map(|()| value)
}

fn typed_value(names: &Names<'_>, parameter: &Parameter, given: &[Override<'_>]) -> Result<Const> {
    let declared = match &parameter.kind {
        ParameterKind::Untyped => None,
        ParameterKind::Integer => Some(Shape::INTEGER),
        ParameterKind::Vector(vector) => match &vector.range {
            None => None,
            Some(range) => {
                let (_, width) = bounds(names, range)?;
                Some(Shape { width, signed: vector.signed, sized: true })
            }
        },
    };
    let given = given.iter().find(|given| !parameter.local && *given.name == *parameter.name.text);
    let value = match (given, declared) {
        (Some(given), _) => given.value,
        (None, Some(shape)) => evaluate_as(names, &parameter.value, shape)?,
        (None, None) => evaluate(names, &parameter.value)?,
    };
    let Some(shape) = declared else {
        // IEEE 1364-2005, 12.2.1: the sign alone leaves the range to the value, whose bits are then taken as signed.
        let signed = value.shape.signed || matches!(parameter.kind, ParameterKind::Vector(_));
        return Ok(Const { shape: Shape { signed, ..value.shape }, ..value });
    };
    value.fitted(shape).ok_or_else(|| {
        let (kind, bits) = (if shape.signed { "signed" } else { "unsigned" }, shape.width);
        let message = format!("{} does not fit `{}`", value.number(), parameter.name.text);
        let place = given.and_then(|given| given.span).unwrap_or(parameter.value.span);
        let diagnostic = Diagnostic::new("N015", message).at(place, "too large or of the wrong sign");
        diagnostic.at(parameter.name.span, format!("{kind}, {bits} bits"))
    })
}

/// A value as a parameter of the netlist.
pub(super) fn kept_parameter(
    names: &Names<'_>,
    module: &Module,
    parameter: &Parameter,
    value: Const,
) -> Result<TopParameter> {
    let name = &parameter.name;
    let value = i64::try_from(value.number()).map_err(|_| {
        let message = format!("`{}` is beyond a 64-bit signed number", name.text);
        Diagnostic::new("N015", message).at(name.span, "declared here")
    })?;
    let [least, most] = range::stated(names, module, parameter)?.map(|end| end.map(|end| end.bound));
    Ok(TopParameter { name: name.text.to_string(), value, least, most })
}

/// Lowest index and width of `[msb:lsb]`.
fn bounds(names: &Names<'_>, range: &Range) -> Result<(i64, u32)> {
    let (msb, lsb) = (number(names, &range.msb)?, number(names, &range.lsb)?);
    if msb < lsb {
        let diagnostic = Diagnostic::new("N028", format!("the range [{msb}:{lsb}] runs upwards"));
        let help = if msb == lsb.saturating_sub(1) {
            "a word has at least one bit".to_owned()
        } else {
            format!("write the highest bit first, as in [{lsb}:{msb}]")
        };
        return Err(diagnostic.at(range.span, "here").help(help));
    }
    let width = i128::from(msb) - i128::from(lsb) + 1;
    match u32::try_from(width) {
        Ok(width) if width <= MAX_WIDTH => Ok((lsb, width)),
        _ => {
            let diagnostic = Diagnostic::new("N018", format!("a word of {width} bits"));
            Err(diagnostic.at(range.span, format!("at most {MAX_WIDTH} bits fit")).help("use several nets"))
        }
    }
}

/// A net of the module itself, driven by nobody yet.
pub(super) fn net(names: &Names<'_>, name: &Name, net_type: &NetType) -> Result<LocalNet> {
    let (lsb, width) = net_type.range.as_ref().map_or(Ok((0, 1)), |range| bounds(names, range))?;
    let fraction = net_type.fraction.as_ref().map(|bits| {
        let value = number(names, bits)?;
        u32::try_from(value).ok().filter(|bits| *bits <= MAX_WIDTH).ok_or_else(|| {
            Diagnostic::new("N030", format!("{value} fraction bits")).at(bits.span, "0 to 64 are possible")
        })
    });
    Ok(LocalNet {
        scope: 0,
        name: name.text.to_string(),
        width,
        lsb,
        is_vector: net_type.range.is_some(),
        signed: net_type.signed,
        fraction: fraction.transpose()?,
        port: None,
        is_clock: false,
        drives: Vec::new(),
        span: name.span,
    })
}
