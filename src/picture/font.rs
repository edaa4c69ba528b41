//! The font that travels with the program: a subset of DejaVu Sans with Latin, Greek and Cyrillic letters.

use std::sync::{Arc, LazyLock};

use resvg::usvg::fontdb::Database;

/// The family to name in an SVG. A browser takes its own copy of it, or its own sans-serif letters.
pub const FONT: &str = "DejaVu Sans, sans-serif";

/// The one font there is, whatever is installed on the machine.
#[must_use]
pub fn fonts() -> Arc<Database> {
    static FONTS: LazyLock<Arc<Database>> = LazyLock::new(|| {
        let mut fonts = Database::new();
        fonts.load_font_data(include_bytes!("DejaVuSans.ttf").to_vec());
        // Whatever family is asked for, this is what there is.
        fonts.set_serif_family("DejaVu Sans");
        fonts.set_sans_serif_family("DejaVu Sans");
        fonts.set_monospace_family("DejaVu Sans");
        fonts.set_cursive_family("DejaVu Sans");
        fonts.set_fantasy_family("DejaVu Sans");
        Arc::new(fonts)
    });
    Arc::clone(&FONTS)
}
