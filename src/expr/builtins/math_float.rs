//! Functions of floats.

use super::math::real;
use crate::args::{Args, check_count};
use crate::elementary;
use crate::interp::Interp;
use crate::ops::as_index;
use crate::ops::int::scale_by;
use crate::stop::{Eval, Stop};
use crate::value::Value;

fn domain() -> Stop {
    Stop::value("math domain error")
}

fn range() -> Stop {
    Stop::overflow("math range error")
}

/// A function of one float. A NaN that comes from no NaN is a domain error; an infinity from a finite
/// argument means the result is too large, or a pole when the function cannot overflow.
pub(super) fn one(args: &Args, can_overflow: bool, f: impl Fn(f64) -> f64) -> Eval {
    let x = real(args.at(0))?;
    let result = f(x);
    if result.is_nan() && !x.is_nan() {
        return Err(domain());
    }
    if result.is_infinite() && x.is_finite() {
        return Err(if can_overflow { range() } else { domain() });
    }
    Ok(Value::Float(result))
}

/// A function of two floats that is defined everywhere.
pub(super) fn two(args: &Args, f: impl Fn(f64, f64) -> f64) -> Eval {
    Ok(Value::Float(f(real(args.at(0))?, real(args.at(1))?)))
}

/// Inverse hyperbolic sine; the branches keep precision near zero and avoid overflow far from it.
pub(super) fn asinh(x: f64) -> f64 {
    let magnitude = x.abs();
    if !x.is_finite() || magnitude < 2f64.powi(-28) {
        return x;
    }
    let square = magnitude * magnitude;
    let result = if magnitude > 2f64.powi(28) {
        elementary::ln(magnitude) + std::f64::consts::LN_2
    } else if magnitude > 2.0 {
        elementary::ln(2.0 * magnitude + 1.0 / ((square + 1.0).sqrt() + magnitude))
    } else {
        elementary::ln_1p(magnitude + square / (1.0 + (1.0 + square).sqrt()))
    };
    result.copysign(x)
}

/// Inverse hyperbolic cosine; NaN below one.
pub(super) fn acosh(x: f64) -> f64 {
    if x < 1.0 {
        f64::NAN
    } else if x > 2f64.powi(28) {
        elementary::ln(x) + std::f64::consts::LN_2
    } else if x > 2.0 {
        elementary::ln(2.0 * x - 1.0 / (x + (x * x - 1.0).sqrt()))
    } else {
        let above = x - 1.0;
        elementary::ln_1p(above + (2.0 * above + above * above).sqrt())
    }
}

/// Inverse hyperbolic tangent; NaN outside of -1 to 1, infinite at the ends.
pub(super) fn atanh(x: f64) -> f64 {
    let magnitude = x.abs();
    if magnitude > 1.0 {
        return f64::NAN;
    }
    if magnitude < 2f64.powi(-28) {
        return x;
    }
    let twice = magnitude + magnitude;
    let result = if magnitude < 0.5 {
        0.5 * elementary::ln_1p(twice + twice * magnitude / (1.0 - magnitude))
    } else {
        0.5 * elementary::ln_1p(twice / (1.0 - magnitude))
    };
    result.copysign(x)
}

pub(super) fn pow(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (x, y) = (real(args.at(0))?, real(args.at(1))?);
    let result = elementary::pow(x, y);
    if x.is_finite() && y.is_finite() {
        if result.is_nan() || (result.is_infinite() && x == 0.0) {
            return Err(domain());
        }
        if result.is_infinite() {
            return Err(range());
        }
    }
    Ok(Value::Float(result))
}

pub(super) fn fmod(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (x, y) = (real(args.at(0))?, real(args.at(1))?);
    let result = x % y;
    if result.is_nan() && !x.is_nan() && !y.is_nan() {
        Err(domain())
    } else {
        Ok(Value::Float(result))
    }
}

/// The distance to the nearest multiple of `y`, halfway cases to the even multiple.
pub(super) fn remainder(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (x, y) = (real(args.at(0))?, real(args.at(1))?);
    if x.is_nan() || y.is_nan() {
        return Ok(Value::Float(x + y));
    }
    if x.is_infinite() || y == 0.0 {
        return Err(domain());
    }
    if y.is_infinite() {
        return Ok(Value::Float(x));
    }
    let (magnitude, unit) = (x.abs(), y.abs());
    let below = magnitude % unit;
    let above = unit - below;
    let rest = if below < above {
        below
    } else if below > above {
        -above
    } else {
        below - 2.0 * ((0.5 * (magnitude - below)) % unit)
    };
    Ok(Value::Float(1f64.copysign(x) * rest))
}

pub(super) fn ldexp(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let x = real(args.at(0))?;
    let Some(exponent) = as_index(args.at(1)) else {
        return Err(Stop::typ("Expected an int as second argument to ldexp."));
    };
    if x == 0.0 || !x.is_finite() {
        return Ok(Value::Float(x));
    }
    let (mantissa, low, negative) = crate::numeric::decode(x);
    let exponent = i64::try_from(exponent.clamp(-100_000, 100_000)).unwrap_or(0);
    let magnitude = scale_by(mantissa, exponent + i64::from(low));
    if magnitude.is_infinite() {
        return Err(range());
    }
    Ok(Value::Float(if negative { -magnitude } else { magnitude }))
}

pub(super) fn frexp(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let x = real(args.at(0))?;
    let (mantissa, exponent) = split(x);
    Ok(Value::tuple_from([
        Value::Float(mantissa),
        Value::Int(i64::from(exponent)),
    ]))
}

/// `x` as a mantissa of at least one half and an exponent.
pub(super) fn split(x: f64) -> (f64, i32) {
    if x == 0.0 || !x.is_finite() {
        return (x, 0);
    }
    let (mantissa, low, negative) = crate::numeric::decode(x);
    let bits = i32::try_from(64 - mantissa.leading_zeros()).unwrap_or(0);
    let fraction = scale_by(mantissa, i64::from(-bits));
    (if negative { -fraction } else { fraction }, low + bits)
}

pub(super) fn modf(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let x = real(args.at(0))?;
    let (fraction, whole) = if x.is_infinite() {
        (0f64.copysign(x), x)
    } else {
        ((x - x.trunc()).copysign(x), x.trunc())
    };
    Ok(Value::tuple_from([
        Value::Float(fraction),
        Value::Float(whole),
    ]))
}

pub(super) fn next_after(x: f64, y: f64) -> f64 {
    if x.is_nan() || y.is_nan() {
        x + y
    } else if x == y {
        y
    } else if x < y {
        x.next_up()
    } else {
        x.next_down()
    }
}

pub(super) fn ulp(x: f64) -> f64 {
    let x = x.abs();
    if !x.is_finite() {
        return x;
    }
    let next = x.next_up();
    if next.is_infinite() {
        x - x.next_down()
    } else {
        next - x
    }
}

pub(super) fn isclose(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let names = ["a", "b", "rel_tol", "abs_tol"];
    let args = Args {
        pos: args.pos.clone(),
        named: args.named.clone(),
    };
    let args = crate::args::bind_named("isclose", &names, 2, 2, args)?;
    let (a, b) = (real(args.at(0))?, real(args.at(1))?);
    let relative = args.get(2).map_or(Ok(1e-9), real)?;
    let absolute = args.get(3).map_or(Ok(0.0), real)?;
    if relative < 0.0 || absolute < 0.0 {
        return Err(Stop::value("tolerances must be non-negative"));
    }
    if a == b {
        return Ok(Value::Bool(true));
    }
    if a.is_infinite() || b.is_infinite() {
        return Ok(Value::Bool(false));
    }
    let distance = (b - a).abs();
    let close = distance <= (relative * b).abs()
        || distance <= (relative * a).abs()
        || distance <= absolute;
    Ok(Value::Bool(close))
}

pub(super) fn hypot(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    let vector = args
        .pos
        .iter()
        .map(|value| real(value).map(f64::abs))
        .collect::<Eval<Vec<_>>>()?;
    Ok(Value::Float(length(&vector)))
}

pub(super) fn dist(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (p, q) = (interp.collect(args.at(0))?, interp.collect(args.at(1))?);
    if p.len() != q.len() {
        return Err(Stop::value(
            "both points must have the same number of dimensions",
        ));
    }
    check_count("dist", args.len(), 2, 2)?;
    let distance = |(a, b): (&Value, &Value)| Ok((real(a)? - real(b)?).abs());
    let vector = p.iter().zip(&q).map(distance).collect::<Eval<Vec<_>>>()?;
    Ok(Value::Float(length(&vector)))
}

/// The length of a vector of magnitudes.
///
/// Scaled by a power of two, squared and summed without rounding errors that matter, and the root corrected by one
/// Newton step: the result is nearly always the correctly rounded one.
pub(super) fn length(vector: &[f64]) -> f64 {
    if vector.iter().any(|x| x.is_infinite()) {
        return f64::INFINITY;
    }
    if vector.iter().any(|x| x.is_nan()) {
        return f64::NAN;
    }
    let largest = vector.iter().copied().fold(0.0, f64::max);
    if largest == 0.0 || vector.len() == 1 {
        return largest;
    }
    let (_, exponent) = split(largest);
    if exponent < -1023 {
        // The scale itself would overflow: lift subnormal numbers first.
        let lifted: Vec<f64> = vector.iter().map(|x| x / f64::MIN_POSITIVE).collect();
        return f64::MIN_POSITIVE * length(&lifted);
    }
    let scale = scale_by(1, i64::from(-exponent));
    let mut sum = SquareSum {
        high: 1.0,
        square_errors: 0.0,
        sum_errors: 0.0,
    };
    vector.iter().for_each(|x| sum.add(x * scale, 1.0));
    let root = sum.value().sqrt();
    sum.add(root, -1.0);
    (root + sum.value() / (2.0 * root)) / scale
}

/// A sum of squares that keeps track of what rounding takes away.
struct SquareSum {
    /// The sum plus one, so that every addition has a fixed scale.
    high: f64,
    square_errors: f64,
    sum_errors: f64,
}

impl SquareSum {
    fn add(&mut self, x: f64, sign: f64) {
        let square = sign * x * x;
        let error = libm::fma(sign * x, x, -square);
        let sum = self.high + square;
        self.sum_errors += (self.high - sum) + square;
        self.high = sum;
        self.square_errors += error;
    }

    fn value(&self) -> f64 {
        self.high - 1.0 + (self.square_errors + self.sum_errors)
    }
}
