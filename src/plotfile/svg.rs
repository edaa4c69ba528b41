//! SVG through `usvg`: every path that can be seen, with its transforms; text as outlines in the font that the program
//! carries. Of an area the edge is drawn, of a line its middle.

use kurbo::{BezPath, Shape as _};
use resvg::usvg::roxmltree::{Document, Node as Element, ParsingOptions};
use resvg::usvg::tiny_skia_path::PathSegment;
use resvg::usvg::{FontResolver, Group, ImageHrefResolver, Node, Options, Paint, Path, Tree};
use svgtypes::{PathParser, PointsParser};

use super::{FARTHEST, Reading};

/// Millimetres of a user unit, of which 96 are an inch.
const MILLIMETRES: f64 = 25.4 / 96.0;

pub(super) fn read(reading: &mut Reading) {
    let text = std::sync::Arc::clone(&reading.text);
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = match Document::parse_with_options(&text, options) {
        Ok(document) => document,
        Err(error) => {
            let (row, column) = (error.pos().row as usize, error.pos().col as usize);
            let line = text.split_inclusive('\n').take(row.saturating_sub(1)).map(str::len).sum::<usize>();
            let rest = text[line.min(text.len())..].char_indices().nth(column.saturating_sub(1));
            let at = line + rest.map_or(0, |(at, _)| at);
            reading.wrong("F002", at..at, format!("this is no well-formed XML: {error}"), "");
            return;
        }
    };
    if !document.root_element().has_tag_name("svg")
        && !document.root_element().has_tag_name(("http://www.w3.org/2000/svg", "svg"))
    {
        let at = document.root_element().range().start;
        reading.wrong("F001", at..at + 1, "this is XML, but no SVG", "the outermost element of an SVG is `svg`");
        return;
    }
    document.descendants().filter(Element::is_element).for_each(|element| check(reading, &element));
    if !reading.wrong.is_empty() {
        return;
    }
    let options = Options {
        fontdb: crate::picture::fonts(),
        font_resolver: only_font(),
        // A drawing reads no other files.
        image_href_resolver: ImageHrefResolver {
            resolve_data: Box::new(|_, _, _| None),
            resolve_string: Box::new(|_, _| None),
        },
        ..Options::default()
    };
    match Tree::from_xmltree(&document, &options) {
        Ok(tree) => {
            let height = f64::from(tree.size().height());
            walk(reading, tree.root(), height);
        }
        Err(error) => {
            let at = document.root_element().range().start;
            reading.wrong("F002", at..at + 1, error.to_string(), "");
        }
    }
}

/// Whatever family is asked for, the font is the one there is.
fn only_font() -> FontResolver<'static> {
    FontResolver {
        select_font: Box::new(|_, fonts| fonts.faces().next().map(|face| face.id)),
        select_fallback: Box::new(|_, _, _| None),
    }
}

/// What is wrong with an element's data, which `usvg` would draw as far as it goes; and what is left out of it.
fn check(reading: &mut Reading, element: &Element<'_, '_>) {
    let at = |name: &str| element.attribute_node(name).map(|attribute| attribute.range_value());
    match element.tag_name().name() {
        "path" => {
            if let (Some(data), Some(at)) = (element.attribute("d"), at("d")) {
                let mut pieces = 0;
                let wrong = PathParser::from(data).inspect(|_| pieces += 1).find_map(Result::err);
                reading.count(pieces, at.clone());
                if let Some(wrong) = wrong.filter(|_| !["", "none"].contains(&data.trim())) {
                    reading.wrong(
                        "F004",
                        at,
                        format!("this is no path: {wrong}"),
                        "a path begins with M and has commands with their numbers",
                    );
                }
            }
        }
        "polyline" | "polygon" => {
            if let (Some(points), Some(at)) = (element.attribute("points"), at("points")) {
                let numbers = svgtypes::NumberListParser::from(points);
                if let Some(wrong) = numbers.clone().find_map(Result::err) {
                    reading.wrong("F004", at.clone(), format!("these are no points: {wrong}"), "");
                }
                reading.count(PointsParser::from(points).count(), at);
            }
        }
        "image" => reading.note(element.range(), "a picture made of pixels is left out"),
        "text" => reading.note(element.range(), "text is drawn in DejaVu Sans, whatever font it asks for"),
        "clipPath" | "mask" | "filter" => {
            let what = format!("`{}` is left out: curves are drawn whole", element.tag_name().name());
            reading.note(element.range(), &what);
        }
        _ => {}
    }
}

fn walk(reading: &mut Reading, group: &Group, height: f64) {
    for node in group.children() {
        match node {
            Node::Group(group) => walk(reading, group, height),
            Node::Path(path) => add(reading, path, height),
            Node::Text(text) => walk(reading, text.flattened(), height),
            Node::Image(_) => {}
        }
    }
}

fn add(reading: &mut Reading, path: &Path, height: f64) {
    let seen = |paint: Option<&Paint>| paint.is_some();
    let is_seen = seen(path.fill().map(|fill| fill.paint())) || seen(path.stroke().map(|stroke| stroke.paint()));
    if !path.is_visible() || !is_seen {
        return;
    }
    let transform = path.abs_transform();
    let point = |p: resvg::usvg::tiny_skia_path::Point| {
        let [x, y] = [f64::from(p.x), f64::from(p.y)];
        let [x, y] = [
            f64::from(transform.sx) * x + f64::from(transform.kx) * y + f64::from(transform.tx),
            f64::from(transform.ky) * x + f64::from(transform.sy) * y + f64::from(transform.ty),
        ];
        kurbo::Point::new(x * MILLIMETRES, (height - y) * MILLIMETRES)
    };
    let mut curve = BezPath::new();
    for segment in path.data().segments() {
        match segment {
            PathSegment::MoveTo(to) => {
                finish(reading, &mut curve);
                curve.move_to(point(to));
            }
            PathSegment::LineTo(to) => curve.line_to(point(to)),
            PathSegment::QuadTo(by, to) => curve.quad_to(point(by), point(to)),
            PathSegment::CubicTo(first, second, to) => curve.curve_to(point(first), point(second), point(to)),
            PathSegment::Close => curve.close_path(),
        }
    }
    finish(reading, &mut curve);
}

/// Puts the pen up.
fn finish(reading: &mut Reading, curve: &mut BezPath) {
    let curve = std::mem::take(curve);
    if curve.segments().next().is_none() {
        return;
    }
    let extent = curve.bounding_box();
    if ![extent.x0, extent.y0, extent.x1, extent.y1].iter().all(|side| side.abs() <= FARTHEST) {
        reading.wrong(
            "F004",
            0..1,
            "a path lies farther away than any drawing",
            "look for numbers or transforms that are too large",
        );
        return;
    }
    reading.plot.curves.push(curve);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::plotfile::{Kind, MOST_PIECES, Plot, read};

    fn svg(inside: &str) -> String {
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"96\" height=\"48\">\n{inside}\n</svg>\n")
    }

    fn plot(text: &str) -> Plot {
        read(Kind::Svg, "a.svg", &text.into()).unwrap_or_else(|report| panic!("{report}"))
    }

    fn codes(text: &str) -> Vec<(&'static str, String)> {
        let report = read(Kind::Svg, "a.svg", &text.into()).expect_err("mistakes");
        let place = |label: Option<&(crate::base::Span, String)>| label.map(|(span, _)| report.sources.place(*span));
        report.diagnostics.iter().map(|d| (d.code, place(d.labels.first()).unwrap_or_default())).collect()
    }

    #[test]
    fn an_inch_is_96_units_and_y_runs_upwards() {
        let plot = plot(&svg("<g transform='translate(0 8) scale(2)'><path d='M0 0 H48 V20' stroke='red'/></g>"));
        assert_eq!(plot.curves.len(), 1);
        let extent = plot.curves[0].bounding_box();
        let expected = [0.0, 0.0, 25.4, 40.0 * 25.4 / 96.0];
        for (side, expected) in [extent.x0, extent.y0, extent.x1, extent.y1].into_iter().zip(expected) {
            assert!((side - expected).abs() < 1e-5, "{extent:?}");
        }
    }

    #[test]
    fn circles_curves_letters_and_copies_are_drawn_and_what_nobody_sees_is_not() {
        let lengths = |inside: &str| -> Vec<f64> {
            plot(&svg(inside)).curves.iter().map(|curve| curve.perimeter(1e-6) / MILLIMETRES).collect()
        };
        let circle = lengths("<circle cx='50' cy='20' r='10' stroke='red'/>");
        assert!(circle.len() == 1 && (circle[0] / (20.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3, "{circle:?}");
        let copies = "<defs><path id='a' d='M0 0h5'/></defs><g stroke='red'><use href='#a'/><use href='#a' y='3'/></g>";
        assert_eq!(lengths(copies).len(), 2);
        assert_eq!(lengths("<text y='20'>OIÄ</text>").len(), 2 + 1 + 4, "an O and an A have two edges, dots one each");
        for unseen in ["<path d='M0 0h5' fill='none'/>", "<path d='M0 0h5' stroke='red' display='none'/>"] {
            assert!(lengths(unseen).is_empty(), "{unseen}");
        }
    }

    #[test]
    fn what_is_left_out_is_said_with_its_place() {
        let plot = plot(&svg("<image href='secret.png' width='9' height='9'/>\n<text y='9'>a</text>"));
        assert!(plot.notes[0].starts_with("a.svg:2:1: a picture"), "{:?}", plot.notes);
        assert!(plot.notes[1].starts_with("a.svg:3:1: text"), "{:?}", plot.notes);
    }

    #[test]
    fn every_mistake_has_its_code_and_place_and_all_are_told_at_once() {
        let bad = svg("<path d='M0 0 L nan 3' stroke='red'/>\n<path d='5 5'/>\n<polyline points='1,2 x'/>");
        assert_eq!(codes(&bad), ["2:10", "3:10", "4:19"].map(|at| ("F004", format!("a.svg:{at}"))));
        assert_eq!(codes("<svg>\n <g>\n</svg>"), [("F002", "a.svg:3:1".to_owned())]);
        assert_eq!(codes("<html/>"), [("F001", "a.svg:1:1".to_owned())]);
        assert_eq!(codes("G1 X3"), [("F001", "a.svg:1:1".to_owned())]);
        assert_eq!(codes(&svg("<path d='M0 0L3e20 3e20' stroke='red'/>"))[0].0, "F004");
        let many = codes(&svg(&"<path d='x'/>".repeat(30)));
        assert_eq!((many.len(), many.iter().filter(|(code, _)| *code == "F006").count()), (21, 1));
    }

    #[test]
    fn a_path_of_millions_of_points_and_a_copy_of_itself_are_refused_or_end() {
        let long = svg(&format!("<path d='M0 0{}' stroke='red'/>", "h1".repeat(MOST_PIECES + 1)));
        assert_eq!(codes(&long)[0].0, "F005");
        assert!(plot(&svg("<g id='a' stroke='red'><path d='M0 0h5'/><use href='#a'/></g>")).curves.len() <= 2);
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(inside in "[MLCQAZmlcqaz0-9.,e -]{0,60}", tag in "path|text|g|use|polyline") {
            let text = svg(&format!("<{tag} d='{inside}' points='{inside}' transform='{inside}' stroke='red'>{inside}</{tag}>"));
            let _ = read(Kind::Svg, "a.svg", &text.as_str().into());
        }
    }
}
