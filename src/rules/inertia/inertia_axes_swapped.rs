//! Moments of inertia that belong to other axes.
use super::super::context::DocumentCx;
use super::super::geometry::is_scaled_wrong;
use super::super::rule::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::joined::{is_in_world, shape};
use super::moments::{inertia_tag, short};
use model::{Inertial, Link};

pub(super) static RULE: Rule = Rule {
    code: "INR013",
    name: "inertia-axes-swapped",
    category: Category::Inertia,
    severity: Severity::Warning,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page("inertia-axes-swapped"),
    check: Check::Link(check),
};

/// How far a moment may be from that of a box.
const FIT: f64 = 0.05;
/// From this ratio on, a moment is another one.
const OTHER: f64 = 2.0;
/// The entries, by axis.
const NAMES: [&str; 3] = ["ixx", "iyy", "izz"];

fn check(cx: &DocumentCx<'_>, link: &Link, out: &mut Sink<'_>) {
    let Some(inertial) = &link.inertial else {
        return;
    };
    let Some((found, expected)) = moments(cx, link, inertial) else {
        return;
    };
    let Some((a, b)) = swapped(found, expected) else {
        return;
    };
    if is_scaled_wrong(cx, link) || is_in_world(cx, link) {
        return;
    }
    let [first, second] = [a, b].map(|i| NAMES.get(i).copied().unwrap_or_default());
    let message = format!(
        "`{first}` and `{second}` of link `{}` seem to be swapped",
        link.shown()
    );
    let [one, other] = [a, b].map(|i| found.get(i).copied().map_or_else(String::new, short));
    let help = format!(
        "write {first}=\"{other}\" and {second}=\"{one}\"; these fit the box around the link"
    );
    out.report(inertia_tag(cx.expansion, inertial), message)
        .help(help)
        .done();
}

/// The moments of a link, and those of the box around it with the same mass.
fn moments(cx: &DocumentCx<'_>, link: &Link, inertial: &Inertial) -> Option<([f64; 3], [f64; 3])> {
    let [xx, xy, xz, yy, yz, zz] = inertial.entries()?;
    let is_turned = inertial
        .origin
        .as_ref()
        .is_some_and(|origin| origin.angles() != Some([0.0; 3]));
    if is_turned || [xy, xz, yz] != [0.0; 3] {
        return None;
    }
    let mass = inertial.mass().filter(|&mass| mass > 0.0)?;
    let [x, y, z] = shape(cx, link)?.size();
    let expected = [(y, z), (x, z), (x, y)].map(|(a, b)| mass * (a * a + b * b) / 12.0);
    Some(([xx, yy, zz], expected))
}

/// The two axes whose moments are right when they are exchanged, and wrong as they are.
fn swapped(found: [f64; 3], expected: [f64; 3]) -> Option<(usize, usize)> {
    [(0, 1), (0, 2), (1, 2)].into_iter().find(|&(a, b)| {
        let mut exchanged = found;
        exchanged.swap(a, b);
        let all_fit = exchanged
            .iter()
            .zip(&expected)
            .all(|(&found, &expected)| fits(found, expected));
        let pair = [a, b].map(|i| found.get(i).zip(expected.get(i)));
        all_fit
            && pair
                .into_iter()
                .flatten()
                .all(|(&found, &expected)| is_other(found, expected))
    })
}

/// Whether a moment is that of a box, but for rounded edges.
fn fits(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= FIT * expected
}

/// Whether a moment is not that of a box.
fn is_other(found: f64, expected: f64) -> bool {
    found > OTHER * expected || found * OTHER < expected
}
