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
    /// By file name; a sentence for one that cannot be had.
    files: HashMap<String, Result<(SourceId, Arc<str>), String>>,
    /// By the block that wants it and the value that names it; `None` for one whose mistakes have been told.
    read: HashMap<(&'static str, i64), Option<Arc<MemoryImage>>>,
}

impl<'e> Images<'e> {
    /// Files of `library`, their texts to be added to `sources`.
    pub(in crate::netlist) fn new(library: &'e dyn Library, sources: &'e mut Sources) -> Self {
        Self { library, sources, files: HashMap::new(), read: HashMap::new() }
    }

    fn text(&mut self, file: &str) -> Result<(SourceId, Arc<str>), String> {
        let Self { library, sources, files, .. } = self;
        let find = || match library.find(file) {
            Some(Ok((name, text))) => Ok((sources.add(name, Arc::clone(&text)), text)),
            Some(Err(report)) => {
                let messages: Vec<_> = report.diagnostics.into_iter().map(|diagnostic| diagnostic.message).collect();
                Err(messages.join("; "))
            }
            None => Err(format!("there is no file `{file}` beside the circuit")),
        };
        files.entry(file.to_owned()).or_insert_with(find).clone()
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
        let key = (block.description().name, value);
        if !self.elaborator.images.read.contains_key(&key) {
            let image = self.read_image(format, value).map_err(|errors| self.tell(errors, format, instance));
            self.elaborator.images.read.insert(key, image.ok().map(Arc::new));
        }
        let image = self.elaborator.images.read[&key].as_ref();
        image.map(|image| parameters.set_image(Arc::clone(image))).is_some()
    }

    /// Tells what is wrong with an image, at its own places or where it is wanted.
    fn tell(&mut self, errors: Vec<Diagnostic>, format: &ImageFormat, instance: &'t Instance) {
        let given = instance.overrides.iter().find(|given| *given.name.text == *format.parameter);
        let wanted = given.map_or(instance.name.span, |given| given.span);
        for error in errors {
            let has_place = !error.labels.is_empty();
            self.report(if has_place { error } else { error.at(wanted, "wanted here") });
        }
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
        let (source, text) = self.elaborator.images.text(&file).map_err(|message| wrong("N050", message))?;
        if text.len() > limits::IMAGE_BYTES {
            let most = limits::IMAGE_BYTES;
            return Err(wrong("N006", format!("`{file}` has {} bytes; at most {most} are read", text.len())));
        }
        (format.read)(source, &text)
    }
}
