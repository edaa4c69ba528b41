//! A number over two others, as colours.

use plotters::prelude::*;

use super::{Axis, FONT, label, sheet};
use crate::picture::Svg;

/// Cells in a plane, each with the colour of its number.
#[derive(Clone, PartialEq, Debug)]
pub struct HeatMap {
    /// Its title.
    pub title: String,
    /// What the horizontal axis shows.
    pub x: String,
    /// What the vertical axis shows.
    pub y: String,
    /// What the colours show.
    pub of: String,
    /// The command that made it.
    pub command: String,
    /// Where each cell is, and its number.
    pub cells: Vec<[f64; 3]>,
}

/// Colours of the least number, of those between, and of the greatest.
const COLOURS: [[f64; 3]; 4] = [[40.0, 30.0, 90.0], [40.0, 130.0, 140.0], [150.0, 200.0, 80.0], [253.0, 231.0, 60.0]];

/// Steps of the scale beside the map.
const SCALE: u32 = 64;

impl HeatMap {
    /// The map as a picture.
    #[must_use]
    pub fn svg(&self) -> Svg {
        let numbers = self.cells.iter().map(|cell| cell[2]);
        let (least, most) = numbers.fold((f64::MAX, f64::MIN), |(a, b), number| (a.min(number), b.max(number)));
        let share = |number: f64| if most > least { (number - least) / (most - least) } else { 0.0 };
        let [width, height] = [0, 1].map(|axis| self.pitch(axis));
        let cells = self.cells.iter().map(|&[x, y, number]| {
            let corners = [(x - width / 2.0, y - height / 2.0), (x + width / 2.0, y + height / 2.0)];
            Rectangle::new(corners, colour(share(number)).filled())
        });
        let [x, y] =
            [(&self.x, width, 0), (&self.y, height, 1)].map(|(name, pitch, axis)| self.axis(name, pitch, axis));
        sheet(&self.title, &self.command, |area| {
            let (map, scale) = area.split_horizontally(680);
            let mut builder = ChartBuilder::on(&map);
            let sized = builder.margin(12).x_label_area_size(44).y_label_area_size(64);
            if let Ok(mut chart) = sized.build_cartesian_2d(x.range[0]..x.range[1], y.range[0]..y.range[1]) {
                let mut mesh = chart.configure_mesh();
                let mesh = mesh.x_desc(&x.name).y_desc(&y.name).label_style((FONT, 13)).axis_desc_style((FONT, 14));
                let _ = mesh.x_label_formatter(&label).y_label_formatter(&label).disable_mesh().draw();
                let _ = chart.draw_series(cells);
            }
            let named = scale.titled(&self.of, (FONT, 13)).unwrap_or(scale);
            let mut builder = ChartBuilder::on(&named);
            let sized = builder.margin(12).margin_bottom(56).y_label_area_size(64);
            let (least, most) = if most > least { (least, most) } else { (least.min(0.0), least.min(0.0) + 1.0) };
            if let Ok(mut chart) = sized.build_cartesian_2d(0.0..1.0, least..most) {
                let mut mesh = chart.configure_mesh();
                let _ = mesh.disable_mesh().x_labels(0).y_label_formatter(&label).label_style((FONT, 12)).draw();
                let step = (most - least) / f64::from(SCALE);
                let _ = chart.draw_series((0..SCALE).map(|i| {
                    let low = least + step * f64::from(i);
                    let filled = colour(f64::from(i) / f64::from(SCALE - 1)).filled();
                    Rectangle::new([(0.0, low), (1.0, low + step)], filled)
                }));
            }
        })
    }

    /// The least distance of two cells along an axis; 1 for a single one.
    fn pitch(&self, axis: usize) -> f64 {
        let mut places: Vec<_> = self.cells.iter().map(|cell| cell[axis]).collect();
        places.sort_by(f64::total_cmp);
        let steps = places.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
        steps.min_by(f64::total_cmp).unwrap_or(1.0)
    }

    fn axis(&self, name: &str, pitch: f64, axis: usize) -> Axis {
        let edges = self.cells.iter().flat_map(|cell| [cell[axis] - pitch / 2.0, cell[axis] + pitch / 2.0]);
        let (least, most) = edges.fold((f64::MAX, f64::MIN), |(a, b), number| (a.min(number), b.max(number)));
        Axis { name: name.to_owned(), range: if least < most { [least, most] } else { [0.0, 1.0] } }
    }
}

/// The colour of a share of the scale, 0 to 1.
fn colour(share: f64) -> RGBColor {
    let place = share.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let low = (place as usize).min(COLOURS.len() - 2);
    let part =
        |i: usize| (COLOURS[low][i] + (COLOURS[low + 1][i] - COLOURS[low][i]) * (place - low as f64)).round() as u8;
    RGBColor(part(0), part(1), part(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cell_has_the_colour_of_its_number_and_all_is_named() {
        let cells = vec![[0.0, 0.0, 1.0], [2.0, 0.0, 5.0], [0.0, 3.0, 9.0], [2.0, 3.0, 1.0]];
        let [title, x, y, of, command] =
            ["A map", "major, steps", "minor, steps", "deviation", "stepwright sweep"].map(str::to_owned);
        let svg = HeatMap { title, x, y, of, command, cells }.svg();
        let svg = svg.text();
        for text in ["A map", "major, steps", "minor, steps", "deviation", "stepwright sweep"] {
            assert!(svg.contains(text), "{text}");
        }
        // Least and greatest stand on the scale once, too; the number in the middle has no step of its own there.
        let filled =
            |[red, green, blue]: [u8; 3]| svg.matches(&format!("fill=\"#{red:02X}{green:02X}{blue:02X}\"")).count();
        assert_eq!((filled([40, 30, 90]), filled([253, 231, 60]), filled([95, 165, 110])), (3, 2, 1));
    }

    #[test]
    fn a_map_of_one_cell_or_none_is_drawn_without_its_scale_running_away() {
        for cells in [vec![], vec![[1.0, 1.0, 4.0]], vec![[1.0, 1.0, 4.0], [2.0, 1.0, 4.0]]] {
            let [title, x, y, of, command] = [""; 5].map(str::to_owned);
            assert!(HeatMap { title, x, y, of, command, cells }.svg().png().is_ok());
        }
    }
}
