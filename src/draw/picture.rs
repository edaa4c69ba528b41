//! The path that the pulses drew, over the curves that were wanted.

use kurbo::{BezPath, Point, Shape as _};

use super::measure::Gauge;
use super::run::Done;
use super::{Report, Sheet, Stroke};
use crate::picture::{Layer, Picture, Shape};

/// Most dots that are shown.
const MOST_DOTS: usize = 1 << 16;
/// Points of the path that are kept in full; of a longer one, ever fewer of those that follow.
const MOST_POINTS: usize = 1 << 18;
/// Steps that a picture can show along its longer side.
const RESOLUTION: f64 = 3500.0;

/// What a picture shows besides path and curves.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Look {
    /// A dot for each place where the pen has been.
    pub dots: bool,
    /// Strokes in alternate colours.
    pub alternate: bool,
    /// Ways with the pen up.
    pub moves: bool,
}

/// What is gathered while strokes are drawn: figures, and what a picture needs.
pub struct Canvas<'s> {
    sheet: &'s Sheet,
    look: Look,
    gauge: Gauge,
    paths: [BezPath; 2],
    moves: BezPath,
    dots: Vec<Point>,
    resolution: f64,
    points: usize,
    pen: Option<(usize, Point)>,
    strokes: usize,
}

impl<'s> Canvas<'s> {
    /// An empty one.
    #[must_use]
    pub fn new(sheet: &'s Sheet, look: Look) -> Self {
        let extent = sheet.curves.iter().map(BezPath::bounding_box).reduce(|one, other| one.union(other));
        let long = extent.map_or(0.0, |extent| extent.width().max(extent.height()));
        let resolution = long / RESOLUTION;
        let paths = [BezPath::new(), BezPath::new()];
        let gauge = Gauge::new(sheet);
        let (moves, dots) = (BezPath::new(), Vec::new());
        Self { sheet, look, gauge, paths, moves, dots, resolution, points: 0, pen: None, strokes: 0 }
    }

    /// Takes the next stroke.
    pub fn take(&mut self, stroke: &Stroke, done: &Done<'_>) {
        let path = &mut self.paths[usize::from(self.look.alternate && self.strokes % 2 == 1)];
        let [x, y] = stroke.words.from.map(f64::from);
        let start = Point::new(x, y);
        if let Some((curve, up)) = self.pen.filter(|(curve, up)| *curve != stroke.curve || *up != start) {
            debug_assert!(curve <= stroke.curve, "curves are drawn in order");
            self.moves.move_to(up);
            self.moves.line_to(start);
        }
        path.move_to(start);
        let (mut kept, mut last) = (start, start);
        self.gauge.take(stroke, done, |place| {
            let place = Point::new(f64::from(place[0]), f64::from(place[1]));
            if place.distance(kept) >= self.resolution {
                path.line_to(place);
                self.points += 1;
                kept = place;
            }
            if self.look.dots && self.dots.len() < MOST_DOTS {
                self.dots.push(place);
            }
            last = place;
        });
        if last != kept {
            path.line_to(last);
        }
        if self.points > MOST_POINTS {
            (self.points, self.resolution) = (0, (2.0 * self.resolution).max(1.0));
        }
        self.pen = Some((stroke.curve, last));
        self.strokes += 1;
    }

    /// The figures, and the picture with its title and the command that made it.
    #[must_use]
    pub fn finish(self, title: &str, command: &str) -> (Report, Picture) {
        let mut ideal = BezPath::new();
        self.sheet.curves.iter().for_each(|curve| ideal.extend(curve.iter()));
        let mut picture = Picture::new(title, "counts", command);
        if self.look.moves {
            picture = picture.layer(Layer::new("#9a9a9a", Shape::Dashes(self.moves, 0.8)).named("pen up"));
        }
        picture = picture.layer(Layer::new("#f2a65a", Shape::Line(ideal, 2.2)).named("what was wanted"));
        let names =
            if self.look.alternate { ["every other stroke", "the others"] } else { ["what the pulses drew", ""] };
        for ((path, colour), name) in self.paths.into_iter().zip(["#1f4e9c", "#b3203a"]).zip(names) {
            if !path.is_empty() {
                picture = picture.layer(Layer::new(colour, Shape::Line(path, 0.9)).named(name));
            }
        }
        if self.look.dots {
            let all = if self.dots.len() < MOST_DOTS { "places of the pen" } else { "the first places of the pen" };
            picture = picture.layer(Layer::new("#222222", Shape::Dots(self.dots, 1.4)).named(all));
        }
        (self.gauge.report(), picture)
    }
}
