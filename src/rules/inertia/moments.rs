//! Principal moments of inertia.
use std::sync::Arc;

use ecow::{EcoString, eco_format};
use nalgebra::{Matrix3, SymmetricEigen};

use super::super::context::DocumentCx;
use expand::{Expansion, Origin};
use model::{Inertial, Link, tag_start, transform};

/// Negative moments smaller than this part of the greatest are rounding of the program that computed them.
const ROUNDING: f64 = 7e-6;
/// Moments smaller than this part of the greatest are zero but for our own rounding.
const ZERO: f64 = 1e-13;

/// Smaller moments and products are zero, kg m^2.
const NOISE: f64 = 1e-15;
/// Products smaller than this part of the trace are zero.
const NOISE_OF_TRACE: f64 = 1e-12;
/// Links that weigh less stand for frames: nothing depends on their inertia, kg.
pub(super) const NEGLIGIBLE_MASS: f64 = 1e-5;

/// What an inertia matrix is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum InertiaClass {
    /// Zero, but for rounding.
    Zero,
    /// One of its principal moments is negative.
    Negative,
    /// One of its principal moments is zero.
    Singular,
    /// Its principal moments in rising order; none is clearly negative, kg m^2.
    Definite([f64; 3]),
}

/// What an inertial is, worked out once.
pub(super) struct Judged {
    /// Its matrix, when its numbers are known.
    pub class: Option<InertiaClass>,
    /// Moments that no body has.
    pub impossible: Option<Impossible>,
}

/// Principal moments of which the last one is more than the sum of the others.
pub(super) struct Impossible {
    /// In rising order, kg m^2.
    pub moments: [f64; 3],
    /// What is wrong with them.
    pub said: EcoString,
    /// Whether it may be so by the digits that were left out.
    pub is_rounded: bool,
    /// What is the same of inertias with the same numbers.
    pub numbers: EcoString,
    /// The matrix in the axes of the link, kg m^2; none where its frame is not known.
    pub tensor: Option<Matrix3<f64>>,
}

/// A largest moment that is less than this part too large is so by rounding.
const ROUNDING_OF_SUM: f64 = 1e-6;

/// What an inertial is: many rules ask, and writing numbers takes long.
pub(super) fn judged(inertial: &Inertial) -> Arc<Judged> {
    inertial.cached(|inertial| {
        let class = inertial.entries().map(verdict);
        let impossible = match class {
            Some(InertiaClass::Definite(moments @ [a, b, c]))
                if a + b < c * (1.0 - ROUNDING_OF_SUM) =>
            {
                let [least, middle, most] = moments.map(short);
                Some(Impossible {
                    moments,
                    said: eco_format!(
                        "is impossible: moment {most} exceeds the sum of {least} and {middle}"
                    ),
                    is_rounded: is_rounded(inertial, c - a - b, c),
                    numbers: same_numbers(inertial),
                    tensor: in_link(inertial),
                })
            }
            _ => None,
        };
        Arc::new(Judged { class, impossible })
    })
}

/// Whether the largest moment is too large by what the digits leave open in which the moments are written: those of a thin disc are
/// 0.0125, 0.0125 and 0.025, or 0.012, 0.012 and 0.025.
fn is_rounded(inertial: &Inertial, excess: f64, most: f64) -> bool {
    /// Numbers of one digit leave nearly everything open.
    const OPEN: f64 = 0.05;
    let [xx, _, _, yy, _, zz] = &inertial.inertia;
    let digits = [xx, yy, zz].map(|text| Some(last_digit(&text.as_ref()?.value)));
    let open: Option<f64> = digits.into_iter().sum();
    excess <= OPEN * most && open.is_some_and(|open| excess <= open / 2.0)
}

/// What one stands for in the last digit of a decimal number.
fn last_digit(number: &str) -> f64 {
    let number = number.trim().to_ascii_lowercase();
    let (digits, exponent) = number.split_once('e').unwrap_or((&number, "0"));
    let behind_point = digits.split_once('.').map_or(0, |(_, digits)| digits.len());
    let behind_point = i32::try_from(behind_point).unwrap_or(i32::MAX);
    let exponent: i32 = exponent.parse().unwrap_or_default();
    10f64.powi(exponent.saturating_sub(behind_point))
}

/// The matrix in the axes of the link.
fn in_link(inertial: &Inertial) -> Option<Matrix3<f64>> {
    let [xx, xy, xz, yy, yz, zz] = inertial.entries()?;
    let turned = transform(inertial.origin.as_ref())?
        .rotation
        .to_rotation_matrix();
    let own = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    Some(turned * own * turned.transpose())
}

fn same_numbers(inertial: &Inertial) -> EcoString {
    let entries = inertial.entries().unwrap_or_default();
    // in hexadecimal: writing them as people read them takes longer than all else that is done here
    let bits = entries.map(|entry| format!("{:x}", entry.to_bits()));
    bits.join(" ").into()
}

/// Judge `ixx ixy ixz iyy iyz izz`.
pub(super) fn verdict(entries: [f64; 6]) -> InertiaClass {
    let entries = without_noise(entries);
    let [xx, _, _, yy, _, zz] = entries;
    if entries == [0.0; 6] {
        return InertiaClass::Zero;
    }
    let moments = principal(entries);
    let [least, _, most] = moments;
    let magnitude = most.abs().max(least.abs());
    if least < -ROUNDING * magnitude || [xx, yy, zz].iter().any(|&entry| entry < 0.0) {
        InertiaClass::Negative
    } else if least.abs() <= ZERO * magnitude {
        InertiaClass::Singular
    } else {
        InertiaClass::Definite(moments)
    }
}

/// The principal moments of `ixx ixy ixz iyy iyz izz` in rising order.
pub(in super::super) fn principal(entries: [f64; 6]) -> [f64; 3] {
    let size = entries
        .into_iter()
        .fold(f64::MIN_POSITIVE, |size: f64, entry| size.max(entry.abs()));
    // products of very small or large numbers would leave the range of floats
    let [xx, xy, xz, yy, yz, zz] = entries.map(|entry| entry / size);
    let matrix = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let mut moments: [f64; 3] = SymmetricEigen::new(matrix).eigenvalues.into();
    moments.sort_by(f64::total_cmp);
    moments.map(|moment| moment * size)
}

/// The entries with what is only rounding of the program that computed them taken for zero.
fn without_noise(entries: [f64; 6]) -> [f64; 6] {
    let [xx, _, _, yy, _, zz] = entries;
    let product = NOISE.max(NOISE_OF_TRACE * (xx + yy + zz).abs());
    let least = [NOISE, product, product, NOISE, product, NOISE];
    std::array::from_fn(|i| match (entries.get(i), least.get(i)) {
        (Some(&entry), Some(&least)) if entry.abs() >= least => entry,
        _ => 0.0,
    })
}

/// The links that have an inertial, with it.
pub(super) fn inertials<'a>(
    cx: &'a DocumentCx<'_>,
) -> impl Iterator<Item = (&'a Link, &'a Inertial)> {
    let links = cx.robot.into_iter().flat_map(|robot| &robot.links);
    links.filter_map(|link| Some((link, link.inertial.as_ref()?)))
}

/// The start tag of `inertia`, or that of `inertial` without one.
pub(super) fn inertia_tag(expansion: &Expansion, inertial: &Inertial) -> Origin {
    tag_start(
        expansion,
        inertial.inertia_element.unwrap_or(inertial.element),
    )
}

/// Whether the three moments are equal and the products nothing beside them, as in numbers that were made up.
pub(super) fn is_same_about_all_axes([xx, xy, xz, yy, yz, zz]: [f64; 6]) -> bool {
    /// The part of a moment up to which a product is nothing.
    const NOTHING: f64 = 1e-2;
    /// The part of a moment by which two are the same.
    const SAME: f64 = 1e-6;
    let is_same = |other: f64| (other - xx).abs() <= SAME * xx;
    is_same(yy)
        && is_same(zz)
        && [xy, xz, yz]
            .iter()
            .all(|product| product.abs() <= NOTHING * xx)
}

/// A number for people: four digits, as short as it goes.
pub(super) fn short(number: f64) -> String {
    let text = format!("{number:.3e}");
    let plain = format!("{}", text.parse::<f64>().unwrap_or(number));
    if plain.len() <= text.len() {
        plain
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::{InertiaClass, short, verdict};

    #[test]
    fn verdicts() {
        let is_definite = |entries| matches!(verdict(entries), InertiaClass::Definite(_));
        assert_eq!(verdict([0.0; 6]), InertiaClass::Zero);
        assert_eq!(
            verdict([9e-16, 1e-22, -3e-18, 0.0, 0.0, -1e-19]),
            InertiaClass::Zero
        );
        assert_eq!(
            verdict([0.0, 1e-3, 0.0, 0.0, 0.0, 0.0]),
            InertiaClass::Negative
        );
        assert_eq!(
            verdict([1.0, 0.0, 0.0, 1.0, 0.0, 0.0]),
            InertiaClass::Singular
        );
        assert_eq!(
            verdict([1.0, 9e-13, 0.0, 1.0, 0.0, -9e-16]),
            InertiaClass::Singular
        );
        assert_eq!(
            verdict([1.0, 0.0, 0.0, 1.0, 0.0, -1e-9]),
            InertiaClass::Negative
        );
        assert_eq!(
            verdict([1.0, 1.1, 0.0, 1.0, 0.0, 1.0]),
            InertiaClass::Negative
        );
        // eigenvalues 2, 1 and -1e-6: an export with six digits
        assert!(is_definite([1.0, 1.000_001, 0.0, 1.0, 0.0, 1.0]));
        assert!(is_definite([1e-14, 0.0, 0.0, 1e-14, 0.0, 1e-14]));
        assert!(is_definite([1e200, 0.0, 0.0, 2e200, 0.0, 2e200]));
        let InertiaClass::Definite(moments) = verdict([2.0, 0.0, 0.0, 3.0, 1.0, 3.0]) else {
            panic!()
        };
        assert!(
            moments
                .iter()
                .zip([2.0, 2.0, 4.0])
                .all(|(a, b)| (a - b).abs() < 1e-12)
        );
    }

    #[test]
    fn numbers_for_people() {
        assert_eq!(
            [0.25, 1234.5678, 1e-7, 0.0123456].map(short),
            ["0.25", "1235", "1.000e-7", "0.01235"]
        );
    }
}
