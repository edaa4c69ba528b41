//! A page: lines of text with indentation.

/// Text under construction.
#[derive(Debug, Default)]
pub(super) struct Page {
    text: String,
    depth: usize,
}

impl Page {
    /// Adds a line; an empty one gets no indentation.
    pub(super) fn line(&mut self, line: impl AsRef<str>) {
        let line = line.as_ref();
        if !line.is_empty() {
            self.text.extend(std::iter::repeat_n("    ", self.depth));
        }
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// Adds a line, what `inside` writes one step further in, and a closing line.
    pub(super) fn block(&mut self, open: impl AsRef<str>, close: &str, inside: impl FnOnce(&mut Self)) {
        self.line(open);
        self.rest(close, inside);
    }

    /// Adds what `inside` writes one step in, and a closing line.
    pub(super) fn rest(&mut self, close: &str, inside: impl FnOnce(&mut Self)) {
        self.depth += 1;
        inside(self);
        self.depth -= 1;
        self.line(close);
    }

    /// The finished text.
    pub(super) fn finish(self) -> String {
        self.text
    }
}
