//! A block: what it is called, what it connects to, and how it is made of ops.

use std::fmt;

use super::{Builder, Description, ImageFormat, Parameters};

/// A part that circuits are made of.
///
/// There is no second, hand-written behaviour anywhere: every engine and the Verilog printer take their meaning from
/// what [`Block::build`] makes.
pub struct Block {
    description: &'static Description,
    check: fn(&Parameters) -> Result<(), String>,
    image: Option<&'static ImageFormat>,
    build: fn(&mut Builder),
}

impl Block {
    /// A block that takes every set of parameters within their ranges.
    #[must_use]
    pub const fn new(description: &'static Description, build: fn(&mut Builder)) -> Self {
        Self { description, check: |_| Ok(()), image: None, build }
    }

    /// The same block, refusing some sets of parameters although each parameter is within its range. `check` says
    /// what is wrong as a sentence that tells what to change.
    #[must_use]
    pub const fn with_check(self, check: fn(&Parameters) -> Result<(), String>) -> Self {
        Self { check, ..self }
    }

    /// The same block, its memory loaded from a file of `format` (see [`Builder::image`]).
    #[must_use]
    pub const fn with_image(self, format: &'static ImageFormat) -> Self {
        Self { image: Some(format), ..self }
    }

    /// Where its memory comes from, for a block whose memory is loaded from a file.
    #[must_use]
    pub fn image(&self) -> Option<&'static ImageFormat> {
        self.image
    }

    /// Name, ports, parameters, documentation.
    #[must_use]
    pub fn description(&self) -> &'static Description {
        self.description
    }

    /// What is wrong with a set of parameters although each is within its range.
    ///
    /// # Errors
    /// A sentence that tells what to change.
    pub fn check(&self, parameters: &Parameters) -> Result<(), String> {
        (self.check)(parameters)
    }

    /// Builds the block out of ops, for parameters that are within their ranges and pass [`Block::check`].
    pub fn build(&self, b: &mut Builder) {
        (self.build)(b);
    }
}

impl fmt::Debug for Block {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.description.name)
    }
}
