//! A sheet: title, axes, layers, legend, and the command that made it, composed as SVG.

use std::fmt::Write as _;

use kurbo::{Affine, BezPath, PathEl, Point, Rect, Vec2};
use xmlwriter::{Options, XmlWriter};

use super::layer::{Layer, Shape};
use super::scale::{marks, step};
use super::{FONT, Svg};

/// The longer side of the field, in units of the picture.
const FIELD: f64 = 880.0;
/// The shorter side is not less, so that a flat path has a picture, too.
const LEAST: f64 = 120.0;
/// Room for labels left of the field and on its other sides.
const LEFT: f64 = 76.0;
const AROUND: f64 = 44.0;
/// Height of a line of text.
const LINE: f64 = 20.0;
/// Colours of lines and letters around the field.
const INK: &str = "#222222";
const GRID: &str = "#e3e3e3";

/// A picture in a plane, both axes to the same scale.
#[derive(Clone, PartialEq, Debug)]
pub struct Picture {
    title: String,
    unit: String,
    command: String,
    layers: Vec<Layer>,
}

/// Where the field of a sheet is, and what of the plane it shows.
struct Frame {
    field: Rect,
    to_sheet: Affine,
    shown: Rect,
    width: f64,
}

impl Picture {
    /// An empty sheet: what it shows, in which unit its axes are, and the command that makes it.
    #[must_use]
    pub fn new(title: impl Into<String>, unit: impl Into<String>, command: impl Into<String>) -> Self {
        Self { title: title.into(), unit: unit.into(), command: command.into(), layers: Vec::new() }
    }

    /// Adds a layer above the others.
    #[must_use]
    pub fn layer(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// Composes the sheet. Coordinates are rounded to a hundredth of a unit of the picture.
    #[must_use]
    pub fn svg(&self) -> Svg {
        let titles = wrapped(&self.title, 70);
        let commands = wrapped(&self.command, 110);
        let legend: Vec<_> = self.layers.iter().filter(|layer| layer.name.is_some()).collect();
        let frame = Frame::around(&self.layers, titles.len());
        let below = frame.field.y1 + 2.0 * LINE;
        let height = below + LINE * (legend.len() + commands.len() + 1) as f64;
        let mut svg = XmlWriter::new(Options::default());
        svg.start_element("svg");
        svg.write_attribute("xmlns", "http://www.w3.org/2000/svg");
        for (name, side) in [("width", frame.width), ("height", height)] {
            svg.write_attribute(name, &number(side));
        }
        svg.write_attribute_fmt("viewBox", format_args!("0 0 {} {}", number(frame.width), number(height)));
        svg.write_attribute("font-family", FONT);
        svg.start_element("title");
        svg.write_text(&escaped(&self.title));
        svg.end_element();
        line(&mut svg, "fill", "white", |d| _ = write!(d, "M0 0H{}V{}H0Z", number(frame.width), number(height)));
        let lines = |from: f64| move |i: usize| from + LINE * i as f64;
        for (i, title) in titles.iter().enumerate() {
            text(&mut svg, [LEFT, lines(1.5 * LINE)(i)], 16.0, "start", title);
        }
        frame.axes(&mut svg, &self.unit);
        self.layers.iter().for_each(|layer| draw(&mut svg, layer, frame.to_sheet));
        for (i, layer) in legend.iter().enumerate() {
            sample(&mut svg, layer, [LEFT, lines(below)(i) + LINE / 2.0]);
        }
        for (i, command) in commands.iter().enumerate() {
            let y = lines(below + LINE * (legend.len() as f64 + 0.75))(i);
            text(&mut svg, [LEFT, y], 12.0, "start", command);
        }
        Svg::new(svg.end_document() + "\n")
    }
}

impl Frame {
    fn around(layers: &[Layer], titles: usize) -> Self {
        let all = layers.iter().filter_map(Layer::extent).reduce(|one, other| one.union(other));
        let all = all.filter(Rect::is_finite).unwrap_or_default();
        let long = all.width().max(all.height());
        let margin = if long > 0.0 { long * 0.03 } else { 1.0 };
        let least = (long + 2.0 * margin) * LEAST / FIELD;
        let spread = |side: f64| ((least - side) / 2.0).max(margin);
        let shown = all.inflate(spread(all.width()), spread(all.height()));
        let scale = FIELD / shown.width().max(shown.height());
        let corner = Point::new(LEFT, LINE * (titles as f64 + 1.5));
        let field = Rect::from_origin_size(corner, (shown.width() * scale, shown.height() * scale));
        let to_sheet = Affine::translate(Vec2::new(field.x0, field.y1))
            * Affine::scale_non_uniform(scale, -scale)
            * Affine::translate(Vec2::new(-shown.x0, -shown.y0));
        Self { field, to_sheet, shown, width: (field.x1 + AROUND).max(LEFT + FIELD + AROUND) }
    }

    fn axes(&self, svg: &mut Writer, unit: &str) {
        let step = step(self.shown.width().max(self.shown.height()), 10);
        let Rect { x0, y0, x1, y1 } = self.field;
        let across: Vec<_> = marks(self.shown.x0, self.shown.x1, step)
            .map(|(x, label)| ((self.to_sheet * Point::new(x, 0.0)).x, label))
            .collect();
        let up: Vec<_> = marks(self.shown.y0, self.shown.y1, step)
            .map(|(y, label)| ((self.to_sheet * Point::new(0.0, y)).y, label))
            .collect();
        line(svg, "stroke", GRID, |d| {
            across.iter().for_each(|(x, _)| _ = write!(d, "M{} {}V{}", number(*x), number(y0), number(y1)));
            up.iter().for_each(|(y, _)| _ = write!(d, "M{} {}H{}", number(x0), number(*y), number(x1)));
        });
        line(svg, "stroke", INK, |d| {
            _ = write!(d, "M{} {}V{}H{}", number(x0), number(y0), number(y1), number(x1));
        });
        across.iter().for_each(|(x, label)| text(svg, [*x, y1 + 16.0], 12.0, "middle", label));
        up.iter().for_each(|(y, label)| text(svg, [x0 - 6.0, y + 4.0], 12.0, "end", label));
        text(svg, [x1, y1 + 32.0], 12.0, "end", unit);
    }
}

type Writer = XmlWriter;

/// A path of one colour, which `fills` or `strokes` it.
fn line(svg: &mut Writer, how: &str, colour: &str, data: impl FnOnce(&mut String)) {
    svg.start_element("path");
    svg.write_attribute("fill", if how == "fill" { colour } else { "none" });
    if how == "stroke" {
        svg.write_attribute("stroke", colour);
    }
    let mut d = String::new();
    data(&mut d);
    svg.write_attribute("d", &d);
    svg.end_element();
}

fn draw(svg: &mut Writer, layer: &Layer, to_sheet: Affine) {
    svg.start_element("path");
    let stroke = |svg: &mut Writer, width: f64, cap: &str| {
        svg.write_attribute("fill", "none");
        svg.write_attribute("stroke", layer.colour);
        svg.write_attribute("stroke-width", &number(width));
        svg.write_attribute("stroke-linecap", cap);
        svg.write_attribute("stroke-linejoin", "round");
    };
    let mut d = String::new();
    match &layer.shape {
        Shape::Area(path) => {
            svg.write_attribute("fill", layer.colour);
            data(&mut d, path, to_sheet);
        }
        Shape::Line(path, width) => {
            stroke(svg, *width, "round");
            data(&mut d, path, to_sheet);
        }
        Shape::Dashes(path, width) => {
            stroke(svg, *width, "butt");
            svg.write_attribute("stroke-dasharray", "5 4");
            data(&mut d, path, to_sheet);
        }
        // A line of no length with round ends is a dot; it takes the least room.
        Shape::Dots(dots, radius) => {
            stroke(svg, 2.0 * radius, "round");
            for dot in dots {
                _ = write!(d, "M{}h0", place(to_sheet * *dot));
            }
        }
    }
    svg.write_attribute("d", &d);
    svg.end_element();
}

/// A line of the legend.
fn sample(svg: &mut Writer, layer: &Layer, [x, y]: [f64; 2]) {
    let short =
        BezPath::from_vec(vec![PathEl::MoveTo((x, y - 4.0).into()), PathEl::LineTo((x + 24.0, y - 4.0).into())]);
    let shape = match &layer.shape {
        Shape::Line(_, width) => Shape::Line(short, *width),
        Shape::Dashes(_, width) => Shape::Dashes(short, *width),
        Shape::Area(_) => Shape::Line(short, 8.0),
        Shape::Dots(_, radius) => Shape::Dots(vec![Point::new(x + 12.0, y - 4.0)], *radius),
    };
    draw(svg, &Layer { shape, ..layer.clone() }, Affine::IDENTITY);
    text(svg, [x + 32.0, y], 12.0, "start", layer.name.as_deref().unwrap_or_default());
}

fn text(svg: &mut Writer, [x, y]: [f64; 2], size: f64, anchor: &str, words: &str) {
    svg.start_element("text");
    for (name, value) in [("x", x), ("y", y), ("font-size", size)] {
        svg.write_attribute(name, &number(value));
    }
    svg.write_attribute("text-anchor", anchor);
    svg.write_attribute("fill", INK);
    // Line breaks of the writer would become spaces.
    svg.set_preserve_whitespaces(true);
    svg.write_text(&escaped(words));
    svg.end_element();
    svg.set_preserve_whitespaces(false);
}

/// Text that the writer, which escapes `<` alone, may take: no bare `&`, no character that XML does not have.
fn escaped(words: &str) -> String {
    let words: String = words.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    words.replace('&', "&amp;")
}

fn data(d: &mut String, path: &BezPath, to_sheet: Affine) {
    for element in path.elements() {
        _ = match to_sheet * *element {
            PathEl::MoveTo(to) => write!(d, "M{}", place(to)),
            PathEl::LineTo(to) => write!(d, "L{}", place(to)),
            PathEl::QuadTo(by, to) => write!(d, "Q{} {}", place(by), place(to)),
            PathEl::CurveTo(first, second, to) => write!(d, "C{} {} {}", place(first), place(second), place(to)),
            PathEl::ClosePath => write!(d, "Z"),
        };
    }
}

fn place(point: Point) -> String {
    format!("{} {}", number(point.x), number(point.y))
}

/// A number rounded to a hundredth, without a sign on zero.
fn number(value: f64) -> String {
    ((value * 100.0).round() / 100.0 + 0.0).to_string()
}

/// Lines of about so many characters, broken between words.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.last_mut().expect("there is one");
        if !last.is_empty() && last.chars().count() + word.chars().count() >= most {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use kurbo::{Circle, Line, Shape as _};
    use resvg::usvg::{Node, Options, Tree};

    use super::*;
    use crate::picture::fonts;

    fn tree(picture: &Picture) -> Tree {
        Tree::from_str(picture.svg().text(), &Options { fontdb: fonts(), ..Options::default() }).expect("an SVG")
    }

    fn texts(picture: &Picture) -> Vec<String> {
        let text = |node: &Node| match node {
            Node::Text(text) => Some(text.chunks().iter().map(|chunk| chunk.text()).collect()),
            _ => None,
        };
        tree(picture).root().children().iter().filter_map(text).collect()
    }

    #[test]
    fn a_picture_says_its_title_its_unit_its_layers_and_its_command() {
        let line = Line::new((0.0, 0.0), (8.0, 3.0)).to_path(0.1);
        let layer = Layer::new("red", Shape::Line(line, 1.0)).named("ideal < & \"line\"");
        let texts = texts(&Picture::new("Дуга & arc", "counts", "stepwright draw 'a\u{1} <b>.svg'").layer(layer));
        for text in ["Дуга & arc", "counts", "ideal < & \"line\"", "stepwright draw 'a <b>.svg'", "0", "8", "3"] {
            assert!(texts.iter().any(|known| known == text), "{text} is not in {texts:?}");
        }
    }

    #[test]
    fn a_circle_stays_round_and_y_runs_upwards() {
        let circle = Circle::new((100.0, -50.0), 20.0).to_path(1e-6);
        let dot = Shape::Dots(vec![Point::new(100.0, -30.0)], 2.0);
        let picture =
            Picture::new("", "", "").layer(Layer::new("red", Shape::Area(circle))).layer(Layer::new("blue", dot));
        let tree = tree(&picture);
        let boxes: Vec<_> = tree.root().children().iter().map(Node::abs_stroke_bounding_box).collect();
        let [circle, dot] = boxes[boxes.len() - 2..] else { panic!("{} nodes", boxes.len()) };
        assert!((circle.width() - circle.height()).abs() < 0.1 && circle.width() > 500.0, "{circle:?}");
        assert!((dot.y() + dot.height() / 2.0 - circle.y()).abs() < 0.1, "{dot:?} at the top of {circle:?}");
    }

    #[test]
    fn a_picture_of_nothing_of_a_point_and_of_a_flat_line_is_a_picture_and_the_same_each_time() {
        let flat = Line::new((-5.0, 7.0), (1e6, 7.0)).to_path(0.1);
        for shape in [Shape::Area(BezPath::new()), Shape::Dots(vec![Point::ZERO], 1.0), Shape::Line(flat, 1.0)] {
            let picture = Picture::new("t", "u", "c").layer(Layer::new("red", shape));
            let [one, other] = [picture.svg(), picture.svg()];
            assert_eq!(one, other);
            assert!(!one.text().contains("NaN") && !one.text().contains("inf"), "{}", one.text());
            assert_eq!(one.png().expect("a PNG"), other.png().expect("a PNG"));
        }
    }

    #[test]
    fn long_lines_are_broken_between_words() {
        assert_eq!(wrapped("one two three", 8), ["one two", "three"]);
        assert_eq!(wrapped("incomprehensible word", 4), ["incomprehensible", "word"]);
        assert_eq!(wrapped("", 4), [""]);
    }
}
