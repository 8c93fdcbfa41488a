//! Elementary functions, with the bits of the reference as far as they can be had.
//!
//! The reference calls the C library, and that of Linux (glibc) is what its results are compared with: there it is
//! called as well. Other C libraries differ in the last digit, some for one argument in ten. Their place is taken by
//! functions that round correctly, as glibc does but for about one argument in a thousand, and by the formulas of
//! glibc for those that it computes from others.

/// Whether the C library is that of the reference.
const IS_REFERENCE: bool = cfg!(all(target_os = "linux", target_env = "gnu"));

/// Functions of one float: with glibc the first one, elsewhere the second one.
macro_rules! elementary {
    ($($name:ident, $system:expr, $portable:expr, $doc:literal;)*) => {$(
        #[doc = $doc]
        pub fn $name(x: f64) -> f64 {
            if IS_REFERENCE { $system(x) } else { $portable(x) }
        }
    )*

        /// Name, function of the C library, and what takes its place.
        #[cfg(test)]
        type Pair = (&'static str, fn(f64) -> f64, fn(f64) -> f64);
        #[cfg(test)]
        const PAIRS: &[Pair] = &[$((stringify!($name), $system, $portable)),*];
    };
}

elementary! {
    sin, f64::sin, pxfm::f_sin, "The sine.";
    cos, f64::cos, pxfm::f_cos, "The cosine.";
    tan, f64::tan, pxfm::f_tan, "The tangent.";
    asin, f64::asin, pxfm::f_asin, "The inverse sine.";
    acos, f64::acos, pxfm::f_acos, "The inverse cosine.";
    atan, f64::atan, pxfm::f_atan, "The inverse tangent.";
    exp, f64::exp, pxfm::f_exp, "The exponential function.";
    exp2, f64::exp2, pxfm::f_exp2, "A power of two.";
    expm1, f64::exp_m1, libm::expm1, "The exponential function minus one.";
    ln, f64::ln, pxfm::f_log, "The natural logarithm.";
    ln_1p, f64::ln_1p, libm::log1p, "The natural logarithm of one more.";
    log2, f64::log2, pxfm::f_log2, "The logarithm to base 2.";
    log10, f64::log10, portable_log10, "The logarithm to base 10.";
    sinh, f64::sinh, libm::sinh, "The hyperbolic sine.";
    cosh, f64::cosh, portable_cosh, "The hyperbolic cosine.";
    tanh, f64::tanh, portable_tanh, "The hyperbolic tangent.";
}

/// `x` to the power of `y`.
pub fn pow(x: f64, y: f64) -> f64 {
    if IS_REFERENCE {
        x.powf(y)
    } else {
        portable_pow(x, y)
    }
}

/// The angle of the point (`x`, `y`).
pub fn atan2(y: f64, x: f64) -> f64 {
    if IS_REFERENCE {
        y.atan2(x)
    } else {
        pxfm::f_atan2(y, x)
    }
}

/// The length of a vector.
pub fn hypot(x: f64, y: f64) -> f64 {
    if IS_REFERENCE {
        x.hypot(y)
    } else {
        pxfm::f_hypot(x, y)
    }
}

fn portable_pow(x: f64, y: f64) -> f64 {
    // one to any power is one, and so is anything to the power of zero, NaN included
    if x == 1.0 || y == 0.0 {
        1.0
    } else {
        pxfm::f_pow(x, y)
    }
}

/// From the natural logarithm of the mantissa and the exponent, for which the logarithm of two has two parts.
fn portable_log10(x: f64) -> f64 {
    const TWO_HIGH: f64 = 0.30102999566361177;
    const TWO_LOW: f64 = 3.694239077158931e-13;
    if !x.is_normal() || x < 0.0 {
        return pxfm::f_log10(x);
    }
    let (bits, bias) = (x.to_bits(), 1023_i64);
    let exponent = (bits >> 52).cast_signed() - bias;
    // below one the mantissa is taken from one half on, so that both terms have the same sign
    let is_small = i64::from(exponent < 0);
    let mantissa =
        f64::from_bits((bits & ((1 << 52) - 1)) | ((bias - is_small).cast_unsigned() << 52));
    let whole = (exponent + is_small) as f64;
    let low = whole * TWO_LOW + std::f64::consts::LOG10_E * pxfm::f_log(mantissa);
    low + whole * TWO_HIGH
}

fn portable_cosh(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude < 0.5 * std::f64::consts::LN_2 {
        let grown = libm::expm1(magnitude);
        let power = 1.0 + grown;
        1.0 + (grown * grown) / (power + power)
    } else if magnitude < 22.0 {
        let power = pxfm::f_exp(magnitude);
        0.5 * power + 0.5 / power
    } else if magnitude < 709.0 {
        0.5 * pxfm::f_exp(magnitude)
    } else {
        let root = pxfm::f_exp(0.5 * magnitude);
        (0.5 * root) * root
    }
}

fn portable_tanh(x: f64) -> f64 {
    let magnitude = x.abs();
    let result = if magnitude < 2f64.powi(-55) || x.is_nan() {
        return x;
    } else if magnitude >= 22.0 {
        1.0
    } else if magnitude >= 1.0 {
        1.0 - 2.0 / (libm::expm1(2.0 * magnitude) + 2.0)
    } else {
        let fallen = libm::expm1(-2.0 * magnitude);
        -fallen / (fallen + 2.0)
    };
    result.copysign(x)
}

#[cfg(test)]
mod tests {
    use super::{PAIRS, atan2, portable_pow, pow};

    /// Numbers from 0 up to 1 that are the same in every run; some of them with few digits, as people write them.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let number = (self.0 >> 11) as f64 / (1u64 << 53) as f64;
            if self.0.is_multiple_of(3) {
                (number * 1000.0).round() / 1000.0
            } else {
                number
            }
        }

        fn between(&mut self, low: f64, high: f64) -> f64 {
            low + (high - low) * self.next()
        }
    }

    fn interval(name: &str) -> (f64, f64) {
        match name {
            "asin" | "acos" => (-1.0, 1.0),
            "ln" | "log2" | "log10" => (0.0, 100.0),
            "ln_1p" => (-0.9, 100.0),
            _ => (-10.0, 10.0),
        }
    }

    /// Whether two floats are equal or next to each other.
    fn are_near(a: f64, b: f64) -> bool {
        a.to_bits()
            .cast_signed()
            .abs_diff(b.to_bits().cast_signed())
            <= 1
            || a.is_nan() && b.is_nan()
    }

    const COUNT: usize = 20_000;
    /// How many arguments of 100,000 may give another last bit.
    const MOST_DIFFERENT: usize = 600;

    #[test]
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    fn few_last_bits_differ_from_the_reference() {
        let mut numbers = Numbers(1);
        for (name, system, portable) in PAIRS {
            let (low, high) = interval(name);
            let mut different = 0;
            for _ in 0..COUNT {
                let x = numbers.between(low, high);
                let (a, b) = (system(x), portable(x));
                assert!(are_near(a, b), "{name}({x}): {a} and {b}");
                different += usize::from(a.to_bits() != b.to_bits());
            }
            assert!(
                different * 100_000 <= MOST_DIFFERENT * COUNT,
                "{name}: {different} of {COUNT}"
            );
        }
        let mut different = [0; 2];
        for _ in 0..COUNT {
            let (x, y) = (numbers.between(0.0, 10.0), numbers.between(-4.0, 4.0));
            different[0] += usize::from(x.powf(y).to_bits() != portable_pow(x, y).to_bits());
            different[1] += usize::from(y.atan2(x).to_bits() != pxfm::f_atan2(y, x).to_bits());
        }
        assert!(
            different
                .iter()
                .all(|count| count * 100_000 <= MOST_DIFFERENT * COUNT),
            "{different:?}"
        );
    }

    #[test]
    fn ends_of_the_range() {
        let ends = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            5e-324,
            1e-310,
            f64::MAX,
            f64::MIN,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ];
        let also = [
            f64::NAN,
            700.0,
            709.7,
            710.4,
            -745.0,
            1e300,
            1e-300,
            22.0,
            0.5,
        ];
        let all: Vec<f64> = ends.into_iter().chain(also).collect();
        for (name, system, portable) in PAIRS {
            for &x in &all {
                let (a, b) = (system(x), portable(x));
                assert!(
                    are_near(a, b) && a.is_sign_negative() == b.is_sign_negative()
                        || a.is_nan() && b.is_nan(),
                    "{name}({x:e}): {a:e} and {b:e}"
                );
            }
        }
        for &x in &all {
            for &y in &all {
                let (a, b) = (x.powf(y), portable_pow(x, y));
                assert!(are_near(a, b), "{x:e} ** {y:e}: {a:e} and {b:e}");
                let (a, b) = (x.atan2(y), pxfm::f_atan2(x, y));
                assert!(are_near(a, b), "atan2({x:e}, {y:e}): {a:e} and {b:e}");
            }
        }
    }

    #[test]
    fn numbers_that_robots_have() {
        for (found, expected) in [
            (pow(10.0, -2.0), 0.01),
            (pow(10.0, -3.0), 0.001),
            (pow(0.5, 2.0), 0.25),
            (pow(2.0, 0.5), std::f64::consts::SQRT_2),
            (portable_pow(10.0, -2.0), 0.01),
            (atan2(1.0, 1.0), std::f64::consts::FRAC_PI_4),
        ] {
            assert_eq!(found.to_bits(), expected.to_bits(), "{found}");
        }
    }
}
