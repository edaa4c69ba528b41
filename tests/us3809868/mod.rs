//! The figures of US 3,809,868 against the patent's equations, its reading's vectors, and data sheets.

mod fig09_errors;
mod fig09_lanes;
mod fig09_path;
mod fig09_strokes;
mod fig10_control;
mod fig16_clipping;
mod fig17_errors;
mod fig17_glyphs;
mod fig17_image;
mod fig17_processor;
mod glyph_file;
mod machine;
mod multipliers;
mod tables;
mod vectors;
