//! `gamma` and `lgamma` by the Lanczos approximation with 13 terms.
#![allow(clippy::excessive_precision)] // coefficients as they are published

use std::f64::consts::PI;

use crate::elementary;
use crate::stop::{Eval, Stop};
use crate::value::Value;

const G: f64 = 6.024_680_040_776_73;
const G_MINUS_HALF: f64 = 5.524_680_040_776_73;

/// Numerator of the rational function, lowest power first (Boost's `lanczos13m53`).
const NUMERATOR: [f64; 13] = [
    23_531_376_880.410_76,
    42_919_803_642.649_1,
    35_711_959_237.355_67,
    17_921_034_426.037_21,
    6_039_542_586.352_028,
    1_439_720_407.311_721_6,
    248_874_557.862_054_17,
    31_426_415.585_400_194,
    2_876_370.628_935_372_5,
    186_056.265_395_223_48,
    8_071.672_002_365_816,
    210.824_277_751_579_36,
    2.506_628_274_631_000_2,
];

/// Its denominator: x(x+1)...(x+11).
const DENOMINATOR: [f64; 13] = [
    0.0,
    39916800.0,
    120543840.0,
    150917976.0,
    105258076.0,
    45995730.0,
    13339535.0,
    2637558.0,
    357423.0,
    32670.0,
    1925.0,
    66.0,
    1.0,
];

/// Factorials that floats hold exactly, from 0! on.
const FACTORIALS: [f64; 23] = [
    1.0,
    1.0,
    2.0,
    6.0,
    24.0,
    120.0,
    720.0,
    5040.0,
    40320.0,
    362880.0,
    3628800.0,
    39916800.0,
    479001600.0,
    6227020800.0,
    87178291200.0,
    1307674368000.0,
    20922789888000.0,
    355687428096000.0,
    6402373705728000.0,
    121645100408832000.0,
    2432902008176640000.0,
    51090942171709440000.0,
    1124000727777607680000.0,
];

fn lanczos(x: f64) -> f64 {
    let pairs = NUMERATOR.iter().zip(&DENOMINATOR);
    // Powers of x for small x, of 1/x for large: neither overflows.
    let step = |(n, d): (f64, f64), (a, b): (&f64, &f64)| {
        if x < 5.0 {
            (n * x + a, d * x + b)
        } else {
            (n / x + a, d / x + b)
        }
    };
    let (n, d) = if x < 5.0 {
        pairs.rev().fold((0.0, 0.0), step)
    } else {
        pairs.fold((0.0, 0.0), step)
    };
    n / d
}

/// sin(πx), exact at multiples of one half.
fn sin_pi(x: f64) -> f64 {
    let y = x.abs() % 2.0;
    let eighth = (2.0 * y).round();
    let sine = match eighth as u8 {
        0 => elementary::sin(PI * y),
        1 => elementary::cos(PI * (y - 0.5)),
        2 => elementary::sin(PI * (1.0 - y)),
        3 => -elementary::cos(PI * (y - 1.5)),
        _ => elementary::sin(PI * (y - 2.0)),
    };
    1f64.copysign(x) * sine
}

pub(super) fn gamma(x: f64) -> Eval {
    if x.is_nan() || x == f64::INFINITY {
        return Ok(Value::Float(x));
    }
    // also minus infinity
    if x == 0.0 || (x < 0.0 && x == x.floor()) {
        return Err(Stop::value("math domain error"));
    }
    if x == x.floor()
        && let Some(&exact) = FACTORIALS.get(x as usize - 1)
    {
        return Ok(Value::Float(exact));
    }
    let result = gamma_of(x);
    if result.is_infinite() {
        return Err(Stop::overflow("math range error"));
    }
    Ok(Value::Float(result))
}

fn gamma_of(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude < 1e-20 {
        return 1.0 / x;
    }
    if magnitude > 200.0 {
        return if x < 0.0 {
            0.0 / sin_pi(x)
        } else {
            f64::INFINITY
        };
    }
    let y = magnitude + G_MINUS_HALF;
    // What rounding took from y.
    let lost = if magnitude > G_MINUS_HALF {
        (y - magnitude) - G_MINUS_HALF
    } else {
        (y - G_MINUS_HALF) - magnitude
    };
    let correction = lost * G / y;
    // The power is taken in two steps where it would overflow.
    let root = magnitude < 140.0;
    let power = if root {
        elementary::pow(y, magnitude - 0.5)
    } else {
        elementary::pow(y, magnitude / 2.0 - 0.25)
    };
    if x < 0.0 {
        let base = -PI / sin_pi(magnitude) / magnitude * elementary::exp(y) / lanczos(magnitude);
        let result = (base - correction * base) / power;
        if root { result } else { result / power }
    } else {
        let base = lanczos(magnitude) / elementary::exp(y);
        let result = (base + correction * base) * power;
        if root { result } else { result * power }
    }
}

pub(super) fn lgamma(x: f64) -> Eval {
    if !x.is_finite() {
        return Ok(Value::Float(if x.is_nan() { x } else { f64::INFINITY }));
    }
    if x == x.floor() && x <= 2.0 {
        return if x <= 0.0 {
            Err(Stop::value("math domain error"))
        } else {
            Ok(Value::Float(0.0))
        };
    }
    let magnitude = x.abs();
    if magnitude < 1e-20 {
        return Ok(Value::Float(-elementary::ln(magnitude)));
    }
    let mut result = elementary::ln(lanczos(magnitude)) - G;
    result += (magnitude - 0.5) * (elementary::ln(magnitude + G - 0.5) - 1.0);
    if x < 0.0 {
        // Reflection.
        result = elementary::ln(PI)
            - elementary::ln(sin_pi(magnitude).abs())
            - elementary::ln(magnitude)
            - result;
    }
    if result.is_infinite() {
        return Err(Stop::overflow("math range error"));
    }
    Ok(Value::Float(result))
}
