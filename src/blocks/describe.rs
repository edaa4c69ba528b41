//! How a block describes itself: its ports with their widths, its parameters with their ranges.

use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use crate::base::MemoryImage;
use crate::base::word::clog2;

/// What the registry, the netlist checks, `stepwright show` and the Verilog printer know of a block.
#[derive(Debug)]
pub struct Description {
    /// Module name in circuit files.
    pub name: &'static str,
    /// Its folder.
    pub kind: Kind,
    /// One sentence.
    pub summary: &'static str,
    /// What a user must know: state equation, timing, table.
    pub doc: &'static str,
    /// Figure, claim, data sheet or paper.
    pub source: &'static str,
    /// Parameters in order.
    pub parameters: &'static [Parameter],
    /// Ports in order, without the clock.
    pub ports: &'static [PortDescription],
    /// Whether it holds state and so has the port `clk`, which comes first.
    pub clocked: bool,
}

impl Description {
    /// The ports of one direction, in order: the order of [`super::Body::inputs`] and [`super::Body::outputs`].
    pub fn ports_of(&self, direction: Direction) -> impl Iterator<Item = &'static PortDescription> {
        self.ports.iter().filter(move |port| port.direction == direction)
    }
}

/// What a block is for; the folder of its file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// Sums, products, quotients, roots.
    Arithmetic,
    /// Gates and decisions.
    Logic,
    /// Registers, triggers, counters, memories.
    Memory,
    /// Pulse trains and their rates.
    Pulses,
    /// Switches and multiplexers.
    Routing,
    /// Clocks, delays, sequences.
    Timing,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Kind::Arithmetic => "arithmetic",
            Kind::Logic => "logic",
            Kind::Memory => "memory",
            Kind::Pulses => "pulses",
            Kind::Routing => "routing",
            Kind::Timing => "timing",
        })
    }
}

/// A parameter: a whole number with a range.
#[derive(Debug)]
pub struct Parameter {
    /// Name, in capitals.
    pub name: &'static str,
    /// Value when the circuit does not say.
    pub default: i64,
    /// Least value.
    pub min: i64,
    /// Greatest value.
    pub max: i64,
    /// What it means, with its unit.
    pub doc: &'static str,
}

/// Which way a port goes, seen from the block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// Into the block.
    Input,
    /// Out of the block.
    Output,
}

/// A port.
#[derive(Debug)]
pub struct PortDescription {
    /// Name in circuit files.
    pub name: &'static str,
    /// Which way it goes.
    pub direction: Direction,
    /// Bits, as a function of the parameters.
    pub width: Width,
    /// Whether the word is two's complement.
    pub signed: bool,
    /// What it means.
    pub doc: &'static str,
}

impl PortDescription {
    /// An unsigned input.
    #[must_use]
    pub const fn input(name: &'static str, width: Width, doc: &'static str) -> Self {
        Self { name, direction: Direction::Input, width, signed: false, doc }
    }

    /// An unsigned output.
    #[must_use]
    pub const fn output(name: &'static str, width: Width, doc: &'static str) -> Self {
        Self { name, direction: Direction::Output, width, signed: false, doc }
    }

    /// The same port with a two's-complement word.
    #[must_use]
    pub const fn signed(self) -> Self {
        Self { signed: true, ..self }
    }
}

/// A port width as an expression over parameters; prints as Verilog.
#[derive(Clone, Copy, Debug)]
pub enum Width {
    /// So many bits.
    Fixed(u32),
    /// The value of a parameter.
    Param(&'static str),
    /// A sum.
    Add(&'static Width, &'static Width),
    /// A product.
    Mul(&'static Width, &'static Width),
    /// The bits that count so many states.
    Clog2(&'static Width),
}

impl Width {
    /// One bit.
    pub const BIT: Width = Width::Fixed(1);

    /// The width in bits for these parameters.
    #[must_use]
    pub fn bits(&self, parameters: &Parameters) -> i64 {
        match self {
            Width::Fixed(bits) => i64::from(*bits),
            Width::Param(name) => parameters.get(name),
            Width::Add(a, b) => a.bits(parameters) + b.bits(parameters),
            Width::Mul(a, b) => a.bits(parameters) * b.bits(parameters),
            Width::Clog2(a) => i64::from(clog2(a.bits(parameters).unsigned_abs())),
        }
    }
}

impl fmt::Display for Width {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Width::Fixed(bits) => write!(f, "{bits}"),
            Width::Param(name) => f.write_str(name),
            Width::Add(a, b) => write!(f, "({a} + {b})"),
            Width::Mul(a, b) => write!(f, "{a} * {b}"),
            Width::Clog2(a) => write!(f, "$clog2({a})"),
        }
    }
}

/// The values of a block's parameters, in the order of its description, and the memory image that one of them names.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Parameters {
    values: Vec<(&'static str, i64)>,
    image: Option<Arc<MemoryImage>>,
}

/// By the values alone: an image is long, and one of the values names it.
impl Hash for Parameters {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.values.hash(state);
    }
}

impl Parameters {
    /// The defaults of a block.
    #[must_use]
    pub fn defaults(description: &Description) -> Self {
        let values = description.parameters.iter().map(|p| (p.name, p.default)).collect();
        Self { values, image: None }
    }

    /// Sets a parameter; `false` when the block has none of that name.
    pub fn set(&mut self, name: &str, value: i64) -> bool {
        let slot = self.values.iter_mut().find(|(known, _)| *known == name);
        slot.map(|(_, old)| *old = value).is_some()
    }

    /// The value of a parameter.
    ///
    /// # Panics
    /// When the block has no parameter of that name: its file contradicts itself, which the registry tests find.
    #[must_use]
    pub fn get(&self, name: &str) -> i64 {
        self.values.iter().find(|(known, _)| *known == name).unwrap_or_else(|| panic!("no parameter {name}")).1
    }

    /// Adds the memory image that a parameter names.
    pub fn set_image(&mut self, image: Arc<MemoryImage>) {
        self.image = Some(image);
    }

    /// The memory image, if a parameter names one.
    #[must_use]
    pub fn image(&self) -> Option<&MemoryImage> {
        self.image.as_deref()
    }

    /// Names and values, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, i64)> + '_ {
        self.values.iter().copied()
    }
}
