//! The five conversions in real numbers against ellipses that the data were taken from.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use serde_json::Value;
use stepwright::host::{Case, Curve, Point, Refusal};

use super::assert_near;
use crate::converters::arcs::Numbers;
use crate::us3809868::vectors::{list, read, reals};

/// The case of an entry of the vectors, and its ends.
fn case_of(case: usize, entry: &Value) -> (Case, Point, Point) {
    // JSON has no infinite numbers: there they are strings.
    let number = |name: &str| entry["in"][name].as_f64().unwrap_or(f64::INFINITY);
    let point = |i: usize| [format!("X{i}"), format!("Y{i}")].map(|name| number(&name));
    let found = match case {
        1 => Case::I { s0: number("S0"), s1: number("S1") },
        2 => Case::II { p3: point(3), s0: number("S0") },
        3 => Case::III { p3: point(3), s1: number("S1") },
        4 => Case::IV { p3: point(3), s3: number("S3") },
        _ => Case::V { p2: point(2) },
    };
    (found, point(0), point(1))
}

#[test]
fn every_vector_of_every_case_comes_out_and_what_has_no_solution_is_refused() {
    let mut judged = [0; 3];
    for case in 1..=5 {
        let file = read(&format!("case{case}.json"));
        for entry in list(&file["random"]).iter().chain(list(&file["edges"])) {
            let (data, p0, p1) = case_of(case, entry);
            let got = data.curve(p0, p1);
            let name = format!("case {case}: {entry}: {got:?}");
            let has_vertical = entry["in"].as_object().expect("data").values().any(Value::is_string);
            match (&got, entry["error"].as_str()) {
                (Err(Refusal::Vertical), _) => judged[0] += usize::from(has_vertical),
                (Err(refusal), Some(error)) => {
                    let right = match refusal {
                        Refusal::EqualSlopes => error == "PARALLEL",
                        Refusal::Inflection { .. } => ["RANGE", "DEGEN"].contains(&error),
                        Refusal::Tangent { .. } => ["GNEG", "RANGE", "DEGEN"].contains(&error),
                        _ => false,
                    };
                    assert!(right, "{name}");
                    judged[1] += 1;
                }
                (Ok(curve), None) => {
                    assert_near(&curve.jklm, &reals(&entry["JKLM"]), &name);
                    judged[2] += 1;
                }
                _ => panic!("{name}"),
            }
        }
    }
    // Three vertical tangents of case I and one each of II to IV; the other edges by their names.
    assert_eq!((judged[0], judged[1]), (6, 15));
    assert!(judged[2] >= 5 * 60);
}

#[test]
fn an_ellipse_comes_back_from_its_points_and_tangents() {
    let mut numbers = Numbers(18);
    let mut judged = 0;
    while judged < 2000 {
        let jklm = [(); 4].map(|()| numbers.between(-900.0, 900.0));
        let [j, k, l, m] = jklm;
        let from = [(); 2].map(|()| numbers.between(-900.0, 900.0));
        let t = numbers.between(0.2, 1.35);
        // Flat ones and steep tangents are badly conditioned.
        if (j * m - k * l).abs() < 1e5 || [j, k].iter().any(|x| x.abs() < 20.0) {
            continue;
        }
        let at = |t: f64| [from[0] + j * (t.cos() - 1.0) + k * t.sin(), from[1] + l * (t.cos() - 1.0) + m * t.sin()];
        let slope = |t: f64| (m * t.cos() - l * t.sin()) / (k * t.cos() - j * t.sin());
        let cases = [
            Case::I { s0: m / k, s1: l / j },
            Case::II { p3: at(t), s0: m / k },
            Case::III { p3: at(t), s1: l / j },
            Case::IV { p3: at(t), s3: slope(t) },
            Case::V { p2: at(FRAC_PI_4) },
        ];
        for case in cases {
            let curve = case.curve(from, at(FRAC_PI_2)).unwrap_or_else(|refusal| panic!("{case:?}: {refusal}"));
            let off = curve.jklm.iter().zip(jklm).map(|(got, wanted)| (got - wanted).abs()).fold(0.0, f64::max);
            assert!(off < 1e-5, "{case:?}: {curve:?}, not {jklm:?}");
            judged += 1;
        }
    }
}

#[test]
fn a_curve_ends_and_arrives_as_its_equations_say_after_any_number_of_quarters() {
    for quarters in 1..=4 {
        let curve = Curve { from: [5.0, -6.0], jklm: [30.0, -7.0, 11.0, 19.0], quarters };
        let t = f64::from(quarters) * FRAC_PI_2;
        assert_near(&curve.end(), &curve.at(t), "the end");
        let step = 1e-6;
        let ([xa, ya], [xb, yb]) = (curve.at(t - step), curve.at(t + step));
        let direction = [(xb - xa) / (2.0 * step), (yb - ya) / (2.0 * step)];
        assert!(curve.arrives().iter().zip(direction).all(|(a, b)| (a - b).abs() < 1e-6), "{direction:?}");
    }
}
