//! Pieces: some bits after one another, as connections name them.

use super::template::{LocalSource, Piece};
use crate::base::{Diagnostic, Span};

/// The bits of a connection, low first.
pub(super) type Bits = Vec<Piece>;

/// How many bits there are.
pub(super) fn width(bits: &[Piece]) -> u32 {
    bits.iter().map(|piece| piece.width()).sum()
}

/// Adds a piece, as part of the last one when it goes on from there.
pub(super) fn append(bits: &mut Bits, piece: Piece) {
    if let (Some(Piece::Net { net: last, low, width }), Piece::Net { net, low: next, width: more }) =
        (bits.last_mut(), piece)
        && *last == net
        && *low + *width == next
    {
        *width += more;
        return;
    }
    bits.push(piece);
}

/// Pieces as what drives others.
pub(super) fn as_sources(bits: &[Piece]) -> Vec<(LocalSource, u32)> {
    let source = |piece: &Piece| match *piece {
        Piece::Net { net, low, width } => (LocalSource::Net { net, low }, width),
        Piece::Const { value, width } => (LocalSource::Const(value), width),
    };
    bits.iter().map(source).collect()
}

/// `n bits`
pub(super) fn bit_count(width: u32) -> String {
    if width == 1 { "1 bit".into() } else { format!("{width} bits") }
}

/// A connection of unequal widths.
pub(super) fn mismatch(span: Span, given: u32, wanted: u32) -> Diagnostic {
    let message = format!("{} given, {wanted} wanted", bit_count(given));
    let diagnostic = Diagnostic::new("N009", message).at(span, bit_count(given));
    diagnostic.help(if given > wanted {
        match wanted {
            1 => "select the bit that is meant, as in `x[0]`".to_owned(),
            _ => format!("select the bits that are meant, as in `x[{}:0]`", wanted - 1),
        }
    } else {
        format!("widen it, with zeros: `{{{}'d0, x}}`", wanted - given)
    })
}
