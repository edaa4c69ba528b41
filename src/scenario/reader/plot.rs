//! The table `[plot]` of a scenario.

use super::{Number, Reader, Value};
use crate::scenario::model::{Axis, Plot};

impl Reader {
    pub(super) fn plot(&mut self, value: &Value<'_>) -> Option<Plot> {
        let (mut x, mut y, mut pen) = (None, None, None);
        let table = self.table(value)?;
        self.keys_of("plot", table, |reader, key, value| match key {
            "x" => x = reader.axis(value),
            "y" => y = reader.axis(value),
            _ => pen = reader.one_name(value),
        });
        if !table.contains_key("x") || !table.contains_key("y") {
            self.missing(value, "a [plot] needs both `x` and `y`");
        }
        Some(Plot { x: x?, y: y?, pen })
    }

    fn axis(&mut self, value: &Value<'_>) -> Option<Axis> {
        if value.get_ref().is_table() {
            let length = |reader: &mut Self, value: &Value<'_>| reader.number(value).map(Number::to_f64);
            return Some(Axis::Steps(self.entries(value, length)));
        }
        self.one_name(value).map(Axis::Signal)
    }
}
