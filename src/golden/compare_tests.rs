//! Comparing by meaning: what does not matter, and that every change that does is found.

use proptest::prelude::*;

use super::*;
use crate::golden::read;

const HEADER: &str = "$timescale 1 ns $end $scope module t $end $var wire 1 ! busy $end $var wire 12 \" f [11:0] $end \
                      $var wire 12 \" copy [11:0] $end $upscope $end $enddefinitions $end\n";

fn wave(text: &str) -> Waveform {
    read("test", text.as_bytes()).unwrap()
}

fn with(body: &str) -> Waveform {
    wave(&format!("{HEADER}{body}"))
}

#[test]
fn codes_order_dates_and_dump_commands_do_not_matter() {
    let mine = with("#0\n$dumpvars\n0!\nb0 \"\n$end\n#7\n1!\nb11 \"\n#20\n");
    let other = wave(
        "$date yesterday $end $timescale 100 ps $end $scope module t $end $var reg 12 aa copy $end \
         $var wire 12 bb f [11:0] $end $var wire 1 cc busy $end $upscope $end $enddefinitions $end\n\
         b000000000000 aa\nb0 bb\n0cc\n#10\n0cc\n#70\n0cc\nb11 aa\n1cc\nb000000000011 bb\n#200\n",
    );
    let comparison = compare(&mine, &other, Signals::All);
    assert!(comparison.is_equal(), "{comparison}");
    assert_eq!((comparison.nets, comparison.span), (3, 0..200));
}

#[test]
fn the_report_names_tick_nets_values_and_the_ticks_around() {
    let expected = with("#0\n0!\nb0 \"\n#3\nb10 \"\n#6\n1!\nb111111111101 \"\n#7\nb101 \"\n#9\n");
    let got = with("#0\n0!\nb0 \"\n#3\nb10 \"\n#6\n1!\nb111111111100 \"\n#7\nb101 \"\n#8\n0!\n#9\n");
    let text = compare(&expected, &got, Signals::All).to_string();
    let table = "\
tick 6: t.f expected 0xffd (4093, signed -3), got 0xffc (4092, signed -4)
tick 6: t.copy expected 0xffd (4093, signed -3), got 0xffc (4092, signed -4)
                                           v
  tick                1    2    3    4    5    6    7    8
  t.f     expected  000  000  002  002  002  ffd  005  005
          got       000  000  002  002  002  ffc  005  005
  t.copy  expected  000  000  002  002  002  ffd  005  005
          got       000  000  002  002  002  ffc  005  005
";
    let (text, table) = (tidied(&text), tidied(table));
    assert_eq!(text, table);
}

/// Without regard to how many blanks stand between columns.
fn tidied(text: &str) -> Vec<Vec<&str>> {
    text.lines().map(|line| line.split_whitespace().collect()).collect()
}

#[test]
fn signals_that_only_one_has_and_other_widths_are_told() {
    let expected = with("#0\n0!\nb0 \"\n#5\n");
    let got =
        wave(&format!("{}#0\n0!\nb0 \"\n#5\n", HEADER.replace(" copy", " kopy").replace("12 \" f [11:0]", "1 ! f")));
    let comparison = compare(&expected, &got, Signals::All);
    assert_eq!(comparison.missing, ["t.copy"]);
    assert_eq!(comparison.extra, ["t.kopy"]);
    assert_eq!(comparison.widths, [("t.f".to_owned(), 12, 1)]);
    let shared = compare(&expected, &got, Signals::Shared);
    assert!(!shared.needs_all && shared.nets == 1);
}

#[test]
fn a_shorter_run_is_a_difference_of_goldens_but_not_of_shared_ticks() {
    let (long, short) = (with("#0\n0!\nb0 \"\n#9\n"), with("#0\n0!\nb0 \"\n#8\n"));
    assert!(!compare(&long, &short, Signals::All).is_equal());
    assert!(compare(&long, &short, Signals::Shared).is_equal());
}

#[test]
fn waveforms_with_nothing_in_common_are_not_equal() {
    let comparison = compare(&with("#0\n0!\n#2\n").below("nowhere"), &with("#0\n0!\n#2\n"), Signals::Shared);
    assert!(!comparison.is_equal());
    let text = comparison.to_string();
    assert!(text.starts_with("the waveforms have no signal in common\n"), "{text}");
    assert!(text.ends_with("not compared, being only in the other one: t.busy, t.f, t.copy\n"), "{text}");
}

proptest! {
    /// Flips one value bit of a file's text and expects just its net and tick.
    #[test]
    fn a_changed_bit_anywhere_is_found_at_its_tick(words in prop::collection::vec(0u64..4096, 1..40), pick: prop::sample::Index) {
        let lines: Vec<_> = words.iter().map(|word| format!("b{word:012b} \"\n{}!\n", word & 1)).collect();
        let text = |flip: Option<usize>| {
            let mut text = String::new();
            let mut bit = 0;
            for (tick, line) in lines.iter().enumerate() {
                text += &format!("#{tick}\n");
                for c in line.chars() {
                    let is_bit = c == '0' || c == '1';
                    let is_flipped = is_bit && flip == Some(bit);
                    bit += usize::from(is_bit);
                    text.push(if is_flipped { if c == '0' { '1' } else { '0' } } else { c });
                }
            }
            text + &format!("#{}\n", lines.len())
        };
        let flipped = pick.index(lines.len() * 13);
        let comparison = compare(&with(&text(None)), &with(&text(Some(flipped))), Signals::All);
        let divergence = comparison.divergence.expect("a bit differs");
        prop_assert_eq!(divergence.tick, flipped as u64 / 13);
        let names: Vec<_> = divergence.nets.iter().map(|net| net.name.as_str()).collect();
        prop_assert_eq!(names, if flipped % 13 == 12 { vec!["t.busy"] } else { vec!["t.f", "t.copy"] });
    }

    #[test]
    fn a_waveform_equals_itself_at_any_code_and_unit(words in prop::collection::vec(0u64..4096, 1..40)) {
        let body = |scale: usize, code: &str| {
            let line = |(tick, word): (usize, &u64)| format!("#{}\nb{word:b} {code}\n0!\n", tick * scale);
            words.iter().enumerate().map(line).collect::<String>() + &format!("#{}\n", words.len() * scale)
        };
        let mine = with(&body(1, "\""));
        let other = wave(&(HEADER.replace('"', "zz").replace("1 ns", "1 ps") + &body(1000, "zz")));
        prop_assert!(compare(&mine, &other, Signals::All).is_equal());
    }
}
