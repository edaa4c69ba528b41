//! A stroke turned in space and drawn in X, Y and Z.

use super::machine::{Machine, Random, shipped_session};
use super::transform::Transformer;

/// Generators of 8 bits, 1024 ticks a quarter.
const SMALL: &[(&str, i64)] = &[("WIDTH", 8), ("ENTRIES", 16), ("ENTRY_WIDTH", 5)];
const LIMIT: u32 = 10_000;

const COEFFICIENTS: [&str; 6] = ["j", "k", "l", "m", "n", "p"];
const TURNED: [&str; 6] = ["j_out", "k_out", "l_out", "m_out", "n_out", "p_out"];

/// Where the pen was in each tick up to `done`, or `None` with an error.
fn draw(display: &mut Machine, inputs: &[(&str, i64)]) -> Option<Vec<[i64; 3]>> {
    let [x, y, z, done, error] = ["x", "y", "z", "done", "error"].map(|net| display.find(net));
    display.set(inputs);
    display.set(&[("start", 1)]);
    display.tick();
    display.set(&[("start", 0)]);
    let mut path = Vec::new();
    for _ in 0..LIMIT {
        display.tick();
        path.push([x, y, z].map(|net| display.number(net)));
        if display.word(done) == 1 {
            return (display.word(error) == 0).then_some(path);
        }
    }
    panic!("done does not come");
}

/// X, Y or Z at the end of so many quarters: from + a (cos t - 1) + b sin t.
fn end(from: i64, a: i64, b: i64, quarters: i64) -> i64 {
    let (cosine, sine) = [(0, 1), (-1, 0), (0, -1), (1, 0)][quarters as usize - 1];
    from + a * (cosine - 1) + b * sine
}

#[test]
fn x_y_and_z_end_where_the_turned_coefficients_say() {
    let mut display = Machine::new(&shipped_session("us3809868/fig20_display", SMALL, &[]));
    let mut rotation = Transformer::shipped("fig20_rotation3d", &TURNED, &[]);
    let mut random = Random(642);
    for round in 0..20 {
        let mut inputs: Vec<_> = COEFFICIENTS.into_iter().map(|name| (name, random.within(140))).collect();
        for angle in ["angle_628", "angle_632", "angle_636"] {
            inputs.push((angle, (random.word() >> 48) as i64));
        }
        inputs.push(("order_616", (random.word() >> 58) as i64));
        let turned = rotation.run(&inputs).expect("small");

        let (from, quarters) = ([0; 3].map(|_| random.within(1000)), round % 4 + 1);
        let start = ["x0", "y0", "z0"].into_iter().zip(from).chain([("quarters", quarters)]);
        inputs.extend(start);
        let path = draw(&mut display, &inputs).expect("small");
        let ends = [0, 1, 2].map(|axis| end(from[axis], turned[2 * axis], turned[2 * axis + 1], quarters));
        assert_eq!(path.last(), Some(&ends), "{inputs:?}");
    }
}

#[test]
fn a_circle_turned_in_space_lies_on_its_sphere_and_in_its_plane() {
    let mut display = Machine::new(&shipped_session("us3809868/fig20_display", SMALL, &[]));
    // Upright in x and z, turned about Z by 60 degrees, then about X by 50.
    let circle = [("k", 100), ("n", 100), ("order_616", 0b00_01_11), ("angle_636", 10_923), ("angle_628", 9102)];
    let path = draw(&mut display, &[&circle[..], &[("quarters", 4)]].concat()).expect("small");
    let (about_z, about_x) = (60_f64.to_radians(), 50_f64.to_radians());
    let turned = |[x, y, z]: [f64; 3]| {
        let (x, y) = (x * about_z.cos() - y * about_z.sin(), x * about_z.sin() + y * about_z.cos());
        [x, y * about_x.cos() - z * about_x.sin(), y * about_x.sin() + z * about_x.cos()]
    };
    let (centre, normal) = (turned([0.0, 0.0, -100.0]), turned([0.0, 1.0, 0.0]));
    for point in &path {
        let from_centre = [0, 1, 2].map(|axis| point[axis] as f64 - centre[axis]);
        let dot = |other: [f64; 3]| from_centre.iter().zip(other).map(|(a, b)| a * b).sum::<f64>();
        let (radius, height) = (dot(from_centre).sqrt(), dot(normal));
        assert!((radius - 100.0).abs() < 4.0 && height.abs() < 4.0, "{point:?}: {radius}, {height}");
    }
    let far = path.iter().map(|point| point[0].abs()).max();
    assert!(far >= Some(48), "x goes to 50: {far:?}");
}

#[test]
fn what_a_generator_would_refuse_is_an_error_and_nothing_is_drawn() {
    let mut display = Machine::new(&shipped_session("us3809868/fig20_display", SMALL, &[]));
    let good = [("k", 100), ("n", 50), ("quarters", 1), ("x0", 3), ("y0", 4), ("z0", 5)];
    let end = draw(&mut display, &good).expect("small").last().copied();
    assert_eq!(end, Some([103, 4, -45]));
    for bad in COEFFICIENTS.map(|name| (name, 256)).into_iter().chain([("quarters", 0), ("quarters", 5)]) {
        let zeros = COEFFICIENTS.map(|name| (name, 0));
        assert_eq!(draw(&mut display, &[&zeros[..], &[("quarters", 1), bad]].concat()), None, "{bad:?}");
        assert_eq!(Some(["x", "y", "z"].map(|net| display.get_signed(net))), end, "{bad:?}");
    }
    let beyond = [("j", 30_000), ("l", -30_000), ("order_616", 3), ("angle_636", 0x2000), ("quarters", 1)];
    assert_eq!(draw(&mut display, &beyond), None);
}

#[test]
fn linked_edges_begin_where_the_pen_is_so_a_rectangle_in_space_closes() {
    let mut display = Machine::new(&shipped_session("us3809868/fig20_display", SMALL, &[]));
    let from = [5, -6, 7];
    let turned = [("order_616", 0b01_11_10), ("angle_628", 9000), ("angle_632", -20_000 & 0xFFFF), ("angle_636", 777)];
    let first = [("x0", 5), ("y0", -6), ("z0", 7), ("quarters", 1), ("k", 0), ("m", 0)];
    let mut pen = draw(&mut display, &[&turned[..], &first].concat()).expect("small").pop();
    assert_eq!(pen, Some(from));
    for (k, m) in [(90, 0), (0, 61), (-90, 0), (0, -61)] {
        let edge = draw(&mut display, &[("linked", 1), ("x0", 1000), ("y0", 999), ("z0", -1), ("k", k), ("m", m)]);
        let edge = edge.expect("small");
        assert_eq!(edge.first().copied(), pen, "no jump");
        let end = edge.last().copied();
        assert_ne!(end, pen);
        pen = end;
    }
    assert_eq!(pen, Some(from));
}
