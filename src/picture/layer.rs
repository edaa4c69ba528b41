//! What is drawn on a sheet, layer upon layer.

use kurbo::{BezPath, Point, Rect, Shape as _};

/// A layer: a shape in the units of the sheet, in one colour, and what the legend says of it.
#[derive(Clone, PartialEq, Debug)]
pub struct Layer {
    /// What the legend says; a layer without a name is not in the legend.
    pub name: Option<String>,
    /// A colour, as SVG writes it.
    pub colour: &'static str,
    /// What is drawn.
    pub shape: Shape,
}

/// What a layer draws. Coordinates are those of the sheet, Y upwards.
#[derive(Clone, PartialEq, Debug)]
pub enum Shape {
    /// A line of so many units of the picture (there are about 1000 across), whatever the scale.
    Line(BezPath, f64),
    /// A broken line of so many units.
    Dashes(BezPath, f64),
    /// An area.
    Area(BezPath),
    /// Dots of a radius in units of the picture.
    Dots(Vec<Point>, f64),
}

impl Layer {
    /// A layer without a name.
    #[must_use]
    pub fn new(colour: &'static str, shape: Shape) -> Self {
        Self { name: None, colour, shape }
    }

    /// The layer with its name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// The box around the shape; `None` when there is nothing in it.
    pub(super) fn extent(&self) -> Option<Rect> {
        match &self.shape {
            Shape::Line(path, _) | Shape::Dashes(path, _) | Shape::Area(path) => {
                path.elements().first().map(|_| path.bounding_box())
            }
            Shape::Dots(dots, _) => {
                let mut boxes = dots.iter().map(|dot| Rect::from_points(*dot, *dot));
                let first = boxes.next()?;
                Some(boxes.fold(first, |all, dot| all.union(dot)))
            }
        }
    }
}
