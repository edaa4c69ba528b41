//! The figures of US 3,809,868 against the patent's equations, its reading's vectors, and data sheets.

mod analyzer_338;
mod fig09_errors;
mod fig09_lanes;
mod fig09_path;
mod fig09_strokes;
mod fig10_control;
mod fig10_system;
mod fig12_rotation;
mod fig13_quarter_turns;
mod fig14_fig15;
mod fig16_clipping;
mod fig17_errors;
mod fig17_glyphs;
mod fig17_image;
mod fig17_processor;
mod fig20_display;
mod fig20_rotation3d;
mod glyph_file;
mod machine;
mod multipliers;
mod pulse_edges;
mod tables;
mod transform;
mod transformations;
mod vectors;
mod velocity;
