//! A block made of random ops: every op, at every width, with registers and memories.

use stepwright::base::word::mask;
use stepwright::base::{MemoryImage, MemoryWrite, ValueId};
use stepwright::blocks::{Block, Builder, Description, Kind, Parameter, PortDescription, Width};

use super::random::Random;

/// The block.
pub static MIXTURE: Block = Block::new(&DESCRIPTION, build);

static DESCRIPTION: Description = Description {
    name: "mixture",
    kind: Kind::Logic,
    summary: "Random ops.",
    doc: "",
    source: "",
    parameters: &[Parameter { name: "SEED", default: 0, min: 0, max: i64::MAX, doc: "which ops" }],
    ports: &[
        PortDescription::input("a", Width::Fixed(64), ""),
        PortDescription::input("b", Width::Fixed(64), ""),
        PortDescription::input("c", Width::Fixed(64), ""),
        PortDescription::output("x", Width::Fixed(64), ""),
        PortDescription::output("y", Width::Fixed(64), ""),
        PortDescription::output("z", Width::Fixed(64), ""),
    ],
    clocked: true,
};

fn build(b: &mut Builder) {
    let random = Random(b.param("SEED") as u64);
    let values = ["a", "b", "c"].map(|name| b.input(name)).to_vec();
    let mut mixer = Mixer { b, random, values };
    mixer.mix();
}

struct Mixer<'a> {
    b: &'a mut Builder,
    random: Random,
    values: Vec<ValueId>,
}

impl Mixer<'_> {
    fn mix(&mut self) {
        let mut hold = || {
            let (width, init) = (self.width(), self.random.word());
            self.b.hold(width, init)
        };
        let held = [hold(), hold(), hold(), hold()];
        self.values.extend(held.iter().map(|held| held.q));
        for _ in 0..60 {
            let value = self.op();
            self.values.push(value);
        }
        for held in held {
            let next = self.of_width(self.b.width(held.q));
            let enable = self.control();
            let clear = self.control();
            self.b.load(held, next, enable, clear);
        }
        for name in ["x", "y", "z"] {
            let mut parts = vec![self.of_width(64)];
            // The last values, so that most of what was built can be seen.
            for back in 0..8 {
                let value = self.values[self.values.len() - 1 - back];
                parts.push(self.fit(value, 64));
            }
            let word = parts[1..].iter().fold(parts[0], |sum, &part| {
                let turned = self.b.constant(0x9E37_79B9_7F4A_7C15, 64);
                let sum = self.b.xor(sum, turned);
                self.b.add(sum, part)
            });
            self.b.output(name, word);
        }
    }

    fn width(&mut self) -> u32 {
        match self.random.below(4) {
            0 => 1,
            1 => self.random.below(8) as u32 + 1,
            2 => 64,
            _ => self.random.below(64) as u32 + 1,
        }
    }

    fn any(&mut self) -> ValueId {
        let count = self.values.len() as u64;
        self.values[self.random.below(count) as usize]
    }

    fn of_width(&mut self, width: u32) -> ValueId {
        if self.random.below(8) == 0 {
            let value = self.random.word() >> self.random.below(64);
            return self.b.constant(value, width);
        }
        let value = self.any();
        self.fit(value, width)
    }

    fn fit(&mut self, value: ValueId, width: u32) -> ValueId {
        let own = self.b.width(value);
        match self.random.below(2) {
            _ if own > width => {
                let low = self.random.below(u64::from(own - width) + 1) as u32;
                self.b.slice(value, low, width)
            }
            0 => self.b.zero_extend(value, width),
            _ => self.b.sign_extend(value, width),
        }
    }

    fn control(&mut self) -> Option<ValueId> {
        (self.random.below(2) == 0).then(|| self.of_width(1))
    }

    fn op(&mut self) -> ValueId {
        let width = self.width();
        let (a, b, bit) = (self.of_width(width), self.of_width(width), self.of_width(1));
        let amount_width = self.width();
        let amount = self.of_width(amount_width);
        match self.random.below(20) {
            0 => self.b.not(a),
            1 => self.b.and(a, b),
            2 => self.b.or(a, b),
            3 => self.b.xor(a, b),
            4 => self.b.add(a, b),
            5 => self.b.sub(a, b),
            6 => self.b.mul(a, b),
            7 => self.b.eq(a, b),
            8 => self.b.less(a, b),
            9 => self.b.less_signed(a, b),
            10 => self.b.shift_left(a, amount),
            11 => self.b.shift_right(a, amount),
            12 => self.b.shift_right_signed(a, amount),
            13 => self.b.mux(bit, a, b),
            14 => self.b.reduce_and(a),
            15 => self.b.reduce_or(a),
            16 => self.b.reduce_xor(a),
            17 if width < 64 => self.b.concat(a, bit),
            18 => self.rom(amount),
            19 => self.ram(a, bit),
            _ => self.b.delay(a),
        }
    }

    fn image(&mut self, width: u32) -> MemoryImage {
        let depth = self.random.below(20) + 1;
        MemoryImage::from_words(width, (0..depth).map(|_| self.random.word() & mask(width)).collect::<Vec<_>>())
    }

    fn rom(&mut self, address: ValueId) -> ValueId {
        let width = self.width();
        let image = self.image(width);
        self.b.rom(image, address)
    }

    fn ram(&mut self, data: ValueId, enable: ValueId) -> ValueId {
        // Never a constant: Icarus warns of one beyond the depth.
        let address = self.any();
        let image = self.image(self.b.width(data));
        let read = self.of_width(4);
        self.b.ram(image, MemoryWrite { enable, address, data }, read)
    }
}
