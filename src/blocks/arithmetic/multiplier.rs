//! Multiplier of two fixed-point words, low bits of the product cut, an output held from the strobe on.
//!
//! A product of up to 64 bits is formed at once. A wider one is formed as hardware forms it, from two partial
//! products of the narrower word (here a), of which the low bits are cut before they are added:
//!
//! ```text
//!   b = high * 2^n + low      a b / 2^n = a high + floor(a low / 2^n)      n = A_WIDTH + B_WIDTH - 64
//! ```

use super::words::{self, clocked};
use crate::base::ValueId;
use crate::base::word::MAX_WIDTH;
use crate::blocks::{Block, Builder, Description, Kind, Parameter, Parameters, PortDescription, Width};

/// The block.
pub static BLOCK: Block = Block::new(&DESCRIPTION, build).with_check(check);

static DESCRIPTION: Description = Description {
    name: "multiplier",
    kind: Kind::Arithmetic,
    summary: "Multiplies two two's-complement words at a strobe.",
    doc: "product(t+1) = strobe(t) ? floor(a(t) * b(t) / 2^DROP) : product(t). With fA and fB fraction bits the product \
          has fA + fB - DROP. `overflow` is held with it and is 1 when it does not fit WIDTH bits. A product of more \
          than 64 bits is formed from two partial products; then DROP must cut at least the excess.",
    source: "US 3,809,868, FIG. 3 to 8 (multipliers)",
    parameters: &[
        Parameter { name: "A_WIDTH", default: 16, min: 1, max: 62, doc: "bits of a" },
        Parameter { name: "B_WIDTH", default: 16, min: 1, max: 62, doc: "bits of b" },
        Parameter { name: "DROP", default: 0, min: 0, max: 63, doc: "low bits of the product that are cut" },
        Parameter { name: "WIDTH", default: 32, min: 1, max: 64, doc: "bits of the product kept" },
    ],
    ports: &[
        PortDescription::input("strobe", Width::BIT, "clocks the module"),
        PortDescription::input("a", Width::Param("A_WIDTH"), "multiplicand").signed(),
        PortDescription::input("b", Width::Param("B_WIDTH"), "multiplier").signed(),
        PortDescription::output("product", Width::Param("WIDTH"), "the product at the last strobe").signed(),
        PortDescription::output("overflow", Width::BIT, "that product did not fit"),
    ],
    clocked: true,
};

fn check(parameters: &Parameters) -> Result<(), String> {
    let [a, b, drop] = ["A_WIDTH", "B_WIDTH", "DROP"].map(|name| parameters.get(name));
    let excess = (a + b - i64::from(MAX_WIDTH)).max(0);
    if drop < excess {
        return Err(format!("the product has {} bits, {excess} more than 64: DROP must cut as many", a + b));
    }
    if drop >= a + b {
        return Err(format!("DROP is {drop}: nothing is left of a product of {} bits", a + b));
    }
    if a.min(b) + excess > i64::from(MAX_WIDTH) {
        return Err(format!("a word of {a} bits times one of {b} is too wide for two partial products"));
    }
    Ok(())
}

fn build(b: &mut Builder) {
    let [narrow, wide] = by_width(b, b.input("a"), b.input("b"));
    let full = b.width(narrow) + b.width(wide);
    let cut = full.saturating_sub(MAX_WIDTH);
    let product = if cut == 0 { product(b, narrow, wide, full) } else { partial_products(b, narrow, wide, cut) };
    let low = b.count("DROP") - cut;
    let kept = b.slice(product, low, b.width(product) - low);
    let width = b.count("WIDTH");
    let result = words::narrow(b, kept, width);
    clocked(b, result, "product");
}

fn by_width(b: &Builder, x: ValueId, y: ValueId) -> [ValueId; 2] {
    if b.width(x) > b.width(y) { [y, x] } else { [x, y] }
}

fn product(b: &mut Builder, x: ValueId, y: ValueId, width: u32) -> ValueId {
    let (x, y) = (b.sign_extend(x, width), b.sign_extend(y, width));
    b.mul(x, y)
}

/// floor(x y / 2^cut) in 64 bits.
fn partial_products(b: &mut Builder, x: ValueId, y: ValueId, cut: u32) -> ValueId {
    let (low, high) = (b.slice(y, 0, cut), b.slice(y, cut, b.width(y) - cut));
    let upper = product(b, x, high, MAX_WIDTH);
    let width = b.width(x) + cut;
    let (wide, low) = (b.sign_extend(x, width), b.zero_extend(low, width));
    let lower = b.mul(wide, low);
    let carried = b.slice(lower, cut, width - cut);
    let carried = b.sign_extend(carried, MAX_WIDTH);
    b.add(upper, carried)
}

#[cfg(test)]
mod tests {
    use crate::blocks::bench::Bench;

    fn multiply(bench: &mut Bench, a: i64, b: i64) -> (i64, u64) {
        bench.set_all(&[("a", a), ("b", b), ("strobe", 1)]);
        bench.tick();
        (bench.get_signed("product"), bench.get("overflow"))
    }

    #[test]
    fn products_are_exact_and_cut_towards_minus_infinity() {
        let mut whole = Bench::new("multiplier", &[("A_WIDTH", 6), ("B_WIDTH", 5), ("WIDTH", 11)]);
        let mut cut = Bench::new("multiplier", &[("A_WIDTH", 6), ("B_WIDTH", 5), ("DROP", 3), ("WIDTH", 6)]);
        for a in -32..32 {
            for b in -16..16 {
                assert_eq!(multiply(&mut whole, a, b), (a * b, 0));
                let expected = (a * b).div_euclid(8);
                let (product, overflow) = multiply(&mut cut, a, b);
                assert_eq!(overflow == 1, !(-32..32).contains(&expected), "{a} * {b}");
                assert!(overflow == 1 || product == expected, "{a} * {b}");
            }
        }
    }

    #[test]
    fn a_product_wider_than_a_word_is_formed_from_partial_products() {
        let widths = [("A_WIDTH", 37), ("B_WIDTH", 41), ("DROP", 28), ("WIDTH", 50)];
        let mut bench = Bench::new("multiplier", &widths);
        let (b_end, a_end) = (1 << 40, 1 << 36);
        for a in [-a_end, -34_567_890_123, -1, 0, 1, 45_678_901_234, a_end - 1] {
            for b in [-b_end, -b_end + 1, -98_765_432_101, -1, 0, 1, 123_456_789_012, b_end - 1] {
                let expected = (i128::from(a) * i128::from(b)) >> 28;
                assert_eq!(multiply(&mut bench, a, b), (expected as i64, 0), "{a} * {b}");
            }
        }
    }

    #[test]
    fn the_product_is_held_between_strobes() {
        let mut bench = Bench::new("multiplier", &[]);
        multiply(&mut bench, 7, -6);
        bench.set_all(&[("a", 9), ("strobe", 0)]);
        bench.tick();
        assert_eq!(bench.get_signed("product"), -42);
    }
}
