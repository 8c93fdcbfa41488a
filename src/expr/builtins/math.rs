//! The `math` module: its table and the functions that are no plain float functions.

use std::f64::consts::PI;

use num_bigint::BigInt;
use num_traits::Signed;

use super::python::integer;
use super::{Function, math_exact as exact, math_float as float};
use crate::expr::args::{Args, Arity};
use crate::expr::float_repr;
use crate::expr::interp::Interp;
use crate::expr::numeric::{Num, decode, float_to_int, parse_float};
use crate::expr::ops::int::scale_by;
use crate::expr::stop::{Eval, Stop};
use crate::expr::value::Value;

/// Name, value and description of the constants.
pub(super) static CONSTANTS: &[(&str, f64, &str)] = &[
    ("e", std::f64::consts::E, "2.718281828459045, the base of natural logarithms."),
    ("inf", f64::INFINITY, "Infinity."),
    ("nan", f64::NAN, "Not a number."),
    ("pi", std::f64::consts::PI, "3.141592653589793, half a turn."),
    ("tau", std::f64::consts::TAU, "6.283185307179586, a full turn."),
];

/// The constant called `name`.
pub(super) fn constant(name: &str) -> Option<f64> {
    Some(match name {
        "pi" => std::f64::consts::PI,
        "e" => std::f64::consts::E,
        "tau" => std::f64::consts::TAU,
        "inf" => f64::INFINITY,
        "nan" => f64::NAN,
        _ => return None,
    })
}

const fn function(
    name: &'static str,
    params: &'static str,
    arity: Arity,
    run: super::Run,
    doc: &'static str,
) -> Function {
    Function { name, owner: "math", params, doc, arity, run }
}

/// A function of one float that cannot overflow.
macro_rules! one {
    ($name:literal, $f:expr, $doc:literal) => {
        function($name, "x", Arity::One, |_, _, args| float::one(args, false, $f), $doc)
    };
}

/// A function of one float whose result may be too large.
macro_rules! growing {
    ($name:literal, $f:expr, $doc:literal) => {
        function($name, "x", Arity::One, |_, _, args| float::one(args, true, $f), $doc)
    };
}

/// A test of one float.
macro_rules! test {
    ($name:literal, $f:expr, $doc:literal) => {
        function($name, "x", Arity::One, |_, _, args| Ok(Value::Bool($f(real(args.at(0))?))), $doc)
    };
}

/// Any function of fixed arity.
macro_rules! other {
    ($name:literal, $params:literal, $arity:expr, $run:expr, $doc:literal) => {
        function($name, $params, $arity, $run, $doc)
    };
}

const TWO: Arity = Arity::Range(2, 2);

/// Sorted by name.
pub(super) static FUNCTIONS: &[Function] = &[
    one!("acos", f64::acos, "The angle in radians with this cosine."),
    one!("acosh", float::acosh, "The inverse hyperbolic cosine."),
    one!("asin", f64::asin, "The angle in radians with this sine."),
    one!("asinh", float::asinh, "The inverse hyperbolic sine."),
    one!("atan", f64::atan, "The angle in radians with this tangent."),
    other!(
        "atan2",
        "y, x",
        TWO,
        |_, _, a| float::two(a, f64::atan2),
        "The angle in radians of the point (x, y)."
    ),
    one!("atanh", float::atanh, "The inverse hyperbolic tangent."),
    one!("cbrt", f64::cbrt, "The cube root."),
    other!(
        "ceil",
        "x",
        Arity::One,
        |_, _, a| rounded(a.at(0), f64::ceil),
        "The smallest whole number not below x."
    ),
    other!("comb", "n, k", TWO, exact::comb, "Ways to choose k of n things."),
    other!("copysign", "x, y", TWO, |_, _, a| float::two(a, f64::copysign), "x with the sign of y."),
    one!("cos", f64::cos, "The cosine of an angle in radians."),
    growing!("cosh", f64::cosh, "The hyperbolic cosine."),
    other!(
        "degrees",
        "x",
        Arity::One,
        |_, _, a| Ok((real(a.at(0))? * (180.0 / PI)).into()),
        "Radians to degrees."
    ),
    other!("dist", "p, q", TWO, float::dist, "The distance of two points given as sequences."),
    one!("erf", libm::erf, "The error function."),
    one!("erfc", libm::erfc, "The complementary error function."),
    growing!("exp", f64::exp, "e to the power of x."),
    growing!("exp2", f64::exp2, "2 to the power of x."),
    growing!("expm1", f64::exp_m1, "exp(x) - 1, exact for small x."),
    one!("fabs", f64::abs, "The absolute value as a float."),
    other!("factorial", "n", Arity::One, exact::factorial, "n! for a whole number."),
    other!(
        "floor",
        "x",
        Arity::One,
        |_, _, a| rounded(a.at(0), f64::floor),
        "The largest whole number not above x."
    ),
    other!("fmod", "x, y", TWO, float::fmod, "The remainder of x / y with the sign of x."),
    other!("frexp", "x", Arity::One, float::frexp, "Mantissa and exponent of x."),
    other!("fsum", "iterable", Arity::One, exact::fsum, "The sum of floats, rounded only once."),
    other!(
        "gamma",
        "x",
        Arity::One,
        |_, _, a| super::math_gamma::gamma(real(a.at(0))?),
        "The gamma function."
    ),
    other!("gcd", "*integers", Arity::Positional, exact::gcd, "The greatest common divisor."),
    other!("hypot", "*coordinates", Arity::Positional, float::hypot, "The length of a vector."),
    other!(
        "isclose",
        "a, b, *, rel_tol=1e-09, abs_tol=0.0",
        Arity::Any,
        float::isclose,
        "Whether two numbers are nearly equal."
    ),
    test!("isfinite", f64::is_finite, "Whether x is neither infinite nor NaN."),
    test!("isinf", f64::is_infinite, "Whether x is infinite."),
    test!("isnan", f64::is_nan, "Whether x is not a number."),
    other!("isqrt", "n", Arity::One, exact::isqrt, "The whole part of the square root."),
    other!("lcm", "*integers", Arity::Positional, exact::lcm, "The least common multiple."),
    other!("ldexp", "x, i", TWO, float::ldexp, "x times 2 to the power of i."),
    other!(
        "lgamma",
        "x",
        Arity::One,
        |_, _, a| super::math_gamma::lgamma(real(a.at(0))?),
        "The logarithm of the gamma function."
    ),
    other!("log", "x, base=e", Arity::Positional, log, "The logarithm, natural without a base."),
    other!(
        "log10",
        "x",
        Arity::One,
        |_, _, a| logarithm(a.at(0), f64::log10).map(Value::Float),
        "The logarithm to base 10."
    ),
    one!("log1p", f64::ln_1p, "log(1 + x), exact for small x."),
    other!(
        "log2",
        "x",
        Arity::One,
        |_, _, a| logarithm(a.at(0), f64::log2).map(Value::Float),
        "The logarithm to base 2."
    ),
    other!("modf", "x", Arity::One, float::modf, "Fraction and whole part of x."),
    other!(
        "nextafter",
        "x, y",
        TWO,
        |_, _, a| float::two(a, float::next_after),
        "The float after x towards y."
    ),
    other!("perm", "n, k=None", Arity::Range(1, 2), exact::perm, "Ways to arrange k of n things."),
    other!("pow", "x, y", TWO, float::pow, "x to the power of y as a float."),
    other!("prod", "iterable, *, start=1", Arity::Any, exact::prod, "The product of the items."),
    one!("radians", |x: f64| x * (PI / 180.0), "Degrees to radians."),
    other!("remainder", "x, y", TWO, float::remainder, "x minus the nearest multiple of y."),
    one!("sin", f64::sin, "The sine of an angle in radians."),
    growing!("sinh", f64::sinh, "The hyperbolic sine."),
    one!("sqrt", f64::sqrt, "The square root."),
    one!("tan", f64::tan, "The tangent of an angle in radians."),
    one!("tanh", f64::tanh, "The hyperbolic tangent."),
    other!("trunc", "x", Arity::One, trunc, "x without its fraction."),
    one!("ulp", float::ulp, "The distance to the next float."),
];

/// The float an argument stands for.
pub(super) fn real(value: &Value) -> Eval<f64> {
    match Num::of(value).map(Num::float).transpose()?.flatten() {
        Some(float) => Ok(float),
        None => Err(Stop::typ(format!("must be real number, not {}", value.type_name()))),
    }
}

/// `floor` and `ceil`
fn rounded(value: &Value, round: fn(f64) -> f64) -> Eval {
    match value {
        Value::Int(_) | Value::Big(_) => Ok(value.clone()),
        Value::Bool(b) => Ok(Value::Int(i64::from(*b))),
        other => float_to_int(round(real(other)?)),
    }
}

fn trunc(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    match args.at(0) {
        Value::Float(f) => float_to_int(*f),
        Value::Int(_) | Value::Big(_) | Value::Bool(_) => rounded(args.at(0), f64::trunc),
        other => Err(Stop::typ(format!("type {} doesn't define __trunc__ method", other.type_name()))),
    }
}

fn log(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    if !(1..=2).contains(&args.len()) {
        return Err(Stop::typ("math.log requires 1 to 2 arguments"));
    }
    let number = logarithm(args.at(0), f64::ln)?;
    let Some(base) = args.get(1) else { return Ok(Value::Float(number)) };
    let base = logarithm(base, f64::ln)?;
    if base == 0.0 {
        return Err(Stop::zero("float division by zero"));
    }
    Ok(Value::Float(number / base))
}

/// A logarithm, also of integers beyond the range of floats.
fn logarithm(value: &Value, log: fn(f64) -> f64) -> Eval<f64> {
    if let Value::Big(big) = value
        && big.is_positive()
    {
        let (mantissa, exponent) = split(big);
        let float = scale_by(mantissa, exponent);
        return Ok(if float.is_finite() {
            log(float)
        } else {
            let bits = exponent + 64;
            log(scale_by(mantissa, -64)) + log(2.0) * bits as f64
        });
    }
    let x = match value {
        Value::Big(_) => -1.0,
        other => real(other)?,
    };
    if x.is_nan() {
        return Ok(x);
    }
    if x <= 0.0 {
        return Err(Stop::value("math domain error"));
    }
    Ok(log(x))
}

/// The highest 64 bits of a big integer, the last one sticky, and the exponent of what was cut off.
fn split(big: &BigInt) -> (u64, i64) {
    let bits = big.bits();
    let cut = bits.saturating_sub(64);
    let high = (big >> cut).iter_u64_digits().next().unwrap_or(0);
    let exact = cut == 0 || big.trailing_zeros().is_some_and(|zeros| zeros >= cut);
    (high | u64::from(!exact), i64::try_from(cut).unwrap_or(i64::MAX))
}

/// `round(f, digits)`: the decimal text of `f` is exact, so it is rounded once.
pub(super) fn round_float(f: f64, digits: i128) -> Eval<f64> {
    // More digits change nothing, fewer leave nothing.
    if !f.is_finite() || f == 0.0 || digits > 323 {
        return Ok(f);
    }
    if digits < -308 {
        return Ok(0.0 * f);
    }
    let rounded = match usize::try_from(digits) {
        Ok(digits) => float_repr::fixed(f, digits).parse(),
        Err(_) => Ok(round_to_tens(f, usize::try_from(-digits).unwrap_or(0))),
    };
    match rounded {
        Ok(rounded) if rounded.is_infinite() => Err(Stop::overflow("rounded value too large to represent")),
        Ok(rounded) => Ok(rounded),
        Err(_) => Ok(f),
    }
}

/// `f` rounded to a multiple of ten to the power of `places`, halves to even.
fn round_to_tens(f: f64, places: usize) -> f64 {
    let (mantissa, exponent, negative) = decode(f);
    let unit = BigInt::from(10).pow(u32::try_from(places).unwrap_or(0));
    // Scaled by a power of two so that everything is whole.
    let down = u64::try_from(-exponent).unwrap_or(0);
    let up = u64::try_from(exponent).unwrap_or(0);
    let (value, unit) = (BigInt::from(mantissa) << up, unit << down);
    let (mut quotient, rest) = (&value / &unit, &value % &unit);
    let twice: BigInt = rest * 2;
    if twice > unit || (twice == unit && quotient.bit(0)) {
        quotient += 1;
    }
    let text = format!("{quotient}e{places}");
    let rounded: f64 = text.parse().unwrap_or(f64::NAN);
    if negative { -rounded } else { rounded }
}

/// `complex(real, imag)`
pub(super) fn complex(args: &Args) -> Eval {
    let (first, second) = (args.get(0), args.get(1));
    if let Some(Value::Str(text)) = first {
        if second.is_some() {
            return Err(Stop::typ("complex() can't take second arg if first is a string"));
        }
        let malformed = || Stop::value("complex() arg is a malformed string");
        return parse_complex(text).map(|(re, im)| Value::Complex(re, im)).ok_or_else(malformed);
    }
    if let Some(Value::Str(_)) = second {
        return Err(Stop::typ("complex() second arg can't be a string"));
    }
    let part = |value: Option<&Value>, place: &str| match value {
        None => Ok((0.0, 0.0)),
        Some(value) => match Num::of(value) {
            Some(number) => number.complex(),
            None => {
                let kind = value.type_name();
                let a = if place == "first" { "a string or a number" } else { "a number" };
                Err(Stop::typ(format!("complex() {place} argument must be {a}, not '{kind}'")))
            }
        },
    };
    let (re, im) = (part(first, "first")?, part(second, "second")?);
    // A complex argument brings along a part for the other side: x + (a + bj)j.
    let is_complex = |value| matches!(value, Some(&Value::Complex(..)));
    let real = if is_complex(second) { re.0 - im.1 } else { re.0 };
    let imaginary = if is_complex(first) { re.1 + im.0 } else { im.0 };
    Ok(Value::Complex(real, imaginary))
}

fn parse_complex(text: &str) -> Option<(f64, f64)> {
    let text = text.trim_matches(crate::expr::numeric::is_space);
    let text = match text.strip_prefix('(') {
        Some(inner) => inner.strip_suffix(')')?.trim_matches(crate::expr::numeric::is_space),
        None => text,
    };
    let Some(body) = text.strip_suffix(['j', 'J']) else { return parse_float(text).map(|re| (re, 0.0)) };
    let imaginary = |part: &str| match part {
        "" | "+" => Some(1.0),
        "-" => Some(-1.0),
        part => parse_float(part),
    };
    // The last sign that does not belong to an exponent separates the parts.
    let sign = body.char_indices().rev().find(|&(i, c)| {
        let exponent = body.get(..i).is_some_and(|before| before.ends_with(['e', 'E']));
        i > 0 && (c == '+' || c == '-') && !exponent
    });
    match sign {
        Some((at, _)) => Some((parse_float(body.get(..at)?)?, imaginary(body.get(at..)?)?)),
        None => Some((0.0, imaginary(body)?)),
    }
}

/// The whole number an argument of an integer function is.
pub(super) fn whole(value: &Value) -> Eval<BigInt> {
    integer(value)?;
    Ok(Num::of(value).and_then(Num::big).map(std::borrow::Cow::into_owned).unwrap_or_default())
}
