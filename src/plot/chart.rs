//! Lines and dots over two axes.

use plotters::prelude::*;

use super::{Axis, FONT, label, sheet};
use crate::picture::Svg;

/// How the points of a series are shown.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Style {
    /// Joined by a line.
    Line,
    /// Each by a dot.
    Dots,
}

/// Points that belong together.
#[derive(Clone, PartialEq, Debug)]
pub struct Series {
    /// What they are, for the legend.
    pub name: String,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// How they are shown.
    pub style: Style,
    /// Where they are.
    pub points: Vec<[f64; 2]>,
}

/// A plot of series.
#[derive(Clone, PartialEq, Debug)]
pub struct Chart {
    /// Its title.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The command that made it.
    pub command: String,
    /// What it shows; later ones above earlier ones.
    pub series: Vec<Series>,
}

impl Chart {
    /// The plot as a picture.
    #[must_use]
    pub fn svg(&self) -> Svg {
        sheet(&self.title, &self.command, |area| {
            let [x, y] = [&self.x, &self.y].map(|axis| axis.range[0]..axis.range[1]);
            let mut builder = ChartBuilder::on(area);
            let sized = builder.margin(12).x_label_area_size(44).y_label_area_size(64);
            let Ok(mut chart) = sized.build_cartesian_2d(x, y) else { return };
            let mut mesh = chart.configure_mesh();
            let mesh =
                mesh.x_desc(&self.x.name).y_desc(&self.y.name).label_style((FONT, 13)).axis_desc_style((FONT, 14));
            let mesh = mesh.x_label_formatter(&label).y_label_formatter(&label);
            let _ = mesh.light_line_style(TRANSPARENT).draw();
            for series in &self.series {
                let [red, green, blue] = series.colour;
                let colour = RGBColor(red, green, blue);
                let points = series.points.iter().map(|&[x, y]| (x, y));
                let drawn = match series.style {
                    Style::Line => chart.draw_series(LineSeries::new(points, colour.stroke_width(2))),
                    Style::Dots => chart.draw_series(points.map(|point| Circle::new(point, 3, colour.filled()))),
                };
                if let Ok(drawn) = drawn {
                    let mark = move |(x, y)| Rectangle::new([(x, y - 4), (x + 14, y + 4)], colour.filled());
                    drawn.label(&series.name).legend(mark);
                }
            }
            let mut labels = chart.configure_series_labels();
            let labels = labels.position(SeriesLabelPosition::UpperLeft).label_font((FONT, 13));
            let _ = labels.background_style(WHITE.mix(0.85)).border_style(BLACK.mix(0.3)).draw();
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> Chart {
        let points = vec![[0.0, 0.0], [10.0, 5.0], [20.0, 0.0]];
        let line = Series { name: "a line".into(), colour: [1, 2, 3], style: Style::Line, points: points.clone() };
        let dots = Series { name: "dots".into(), colour: [200, 2, 3], style: Style::Dots, points };
        Chart {
            title: "A title <&>".into(),
            x: Axis { name: "angle, degrees".into(), range: [0.0, 20.0] },
            y: Axis { name: "deviation, steps".into(), range: [0.0, 5.0] },
            command: "stepwright accuracy x".into(),
            series: vec![line, dots],
        }
    }

    #[test]
    fn it_states_title_axes_legend_and_command_and_draws_each_point() {
        let svg = chart().svg();
        let svg = svg.text();
        for text in
            ["A title &lt;&amp;&gt;", "angle, degrees", "deviation, steps", "a line", "dots", "stepwright accuracy x"]
        {
            assert!(svg.contains(text), "{text}");
        }
        assert_eq!((svg.matches("<circle").count(), svg.contains("width=\"800\"")), (3, true));
    }

    #[test]
    fn the_middle_point_is_in_the_middle_and_above_the_others() {
        let svg = chart().svg();
        let svg = svg.text();
        let number = |circle: &str, name: &str| -> f64 {
            let rest = circle.split(&format!("{name}=\"")).nth(1).expect("an attribute");
            rest.split('"').next().expect("a value").parse().expect("a number")
        };
        let at: Vec<_> =
            svg.split("<circle").skip(1).map(|circle| [number(circle, "cx"), number(circle, "cy")]).collect();
        assert!(
            (2.0 * at[1][0] - at[0][0] - at[2][0]).abs() <= 1.0 && at[1][1] < at[0][1] && at[0][1] == at[2][1],
            "{at:?}"
        );
    }

    #[test]
    fn the_same_chart_gives_the_same_text() {
        assert_eq!(chart().svg(), chart().svg());
    }
}
