//! Memory images: text files beside the circuit that a block's parameter names, read once each.

use std::collections::HashMap;
use std::sync::Arc;

use super::inside::Inside;
use crate::base::{Diagnostic, MemoryImage, SourceId, Sources};
use crate::blocks::{Block, ImageFormat, Parameters};
use crate::netlist::syntax::Instance;
use crate::netlist::{Library, limits};

/// The files that have been asked for.
pub(in crate::netlist) struct Images<'e> {
    library: &'e dyn Library,
    sources: &'e mut Sources,
    /// By file name; `None` for one that does not exist.
    known: HashMap<String, Option<(SourceId, Arc<str>)>>,
}

impl<'e> Images<'e> {
    /// Files of `library`, their texts to be added to `sources`.
    pub(in crate::netlist) fn new(library: &'e dyn Library, sources: &'e mut Sources) -> Self {
        Self { library, sources, known: HashMap::new() }
    }

    fn text(&mut self, file: &str) -> Option<(SourceId, Arc<str>)> {
        let Self { library, sources, known } = self;
        let add = || library.find(file).map(|(name, text)| (sources.add(name, Arc::clone(&text)), text));
        known.entry(file.to_owned()).or_insert_with(add).clone()
    }
}

impl<'t> Inside<'_, '_, 't> {
    /// Reads the file that one of the parameters names, if the block has such a one; `false` after telling what is
    /// wrong.
    pub(super) fn load_image(
        &mut self,
        block: &'static Block,
        parameters: &mut Parameters,
        instance: &'t Instance,
    ) -> bool {
        let Some(format) = block.image() else { return true };
        let value = parameters.get(format.parameter);
        if value == 0 {
            return true;
        }
        let errors = match self.read_image(format, value) {
            Ok(image) => {
                parameters.set_image(image);
                return true;
            }
            Err(errors) => errors,
        };
        let given = instance.overrides.iter().find(|given| *given.name.text == *format.parameter);
        let place = given.map_or(instance.name.span, |given| given.span);
        for error in errors {
            let has_place = !error.labels.is_empty();
            self.report(if has_place { error } else { error.at(place, "wanted here") });
        }
        false
    }

    fn read_image(&mut self, format: &ImageFormat, value: i64) -> Result<MemoryImage, Vec<Diagnostic>> {
        let wrong = |code, message| {
            let ImageFormat { parameter, ending, summary, .. } = format;
            let help =
                format!("`{parameter}` names a file beside the circuit, without its ending `.{ending}`: {summary}");
            vec![Diagnostic::new(code, message).help(help)]
        };
        let Some(file) = format.file_name(value) else {
            return Err(wrong("N050", format!("`{}` is {value}, which is no name of a file", format.parameter)));
        };
        let Some((source, text)) = self.elaborator.images.text(&file) else {
            return Err(wrong("N050", format!("there is no file `{file}` beside the circuit")));
        };
        if text.len() > limits::IMAGE_BYTES {
            let most = limits::IMAGE_BYTES;
            return Err(wrong("N006", format!("`{file}` has {} bytes; at most {most} are read", text.len())));
        }
        (format.read)(source, &text)
    }
}
