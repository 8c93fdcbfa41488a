//! The `math` module: its table and the functions that are no plain float functions.

use std::f64::consts::PI;

use num_bigint::BigInt;
use num_traits::Signed;

use super::python::integer;
use super::{Function, math_exact as exact, math_float as float};
use crate::args::{Args, Arity};
use crate::elementary;
use crate::interp::Interp;
use crate::numeric::{Num, float_to_int};
use crate::ops::int::scale_by;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// All names in the order in which the reference lists them.
pub(super) static NAMES: &[&str] = &[
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "cbrt",
    "ceil",
    "copysign",
    "cos",
    "cosh",
    "degrees",
    "dist",
    "erf",
    "erfc",
    "exp",
    "exp2",
    "expm1",
    "fabs",
    "factorial",
    "floor",
    "fmod",
    "frexp",
    "fsum",
    "gamma",
    "gcd",
    "hypot",
    "isclose",
    "isfinite",
    "isinf",
    "isnan",
    "isqrt",
    "lcm",
    "ldexp",
    "lgamma",
    "log",
    "log1p",
    "log10",
    "log2",
    "modf",
    "pow",
    "radians",
    "remainder",
    "sin",
    "sinh",
    "sqrt",
    "tan",
    "tanh",
    "trunc",
    "prod",
    "perm",
    "comb",
    "nextafter",
    "ulp",
    "pi",
    "e",
    "tau",
    "inf",
    "nan",
];

/// Name, value and description of the constants.
pub(super) static CONSTANTS: &[(&str, f64, &str)] = &[
    (
        "e",
        std::f64::consts::E,
        "2.718281828459045, the base of natural logarithms.",
    ),
    ("inf", f64::INFINITY, "Infinity."),
    ("nan", f64::NAN, "Not a number."),
    (
        "pi",
        std::f64::consts::PI,
        "3.141592653589793, half a turn.",
    ),
    (
        "tau",
        std::f64::consts::TAU,
        "6.283185307179586, a full turn.",
    ),
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
    run: super::BuiltinFn,
    doc: &'static str,
) -> Function {
    Function {
        name,
        owner: "math",
        params,
        doc,
        arity,
        run,
    }
}

/// A function of one float that cannot overflow.
macro_rules! one {
    ($name:literal, $f:expr, $doc:literal) => {
        function(
            $name,
            "x",
            Arity::One,
            |_, _, args| float::one(args, false, $f),
            $doc,
        )
    };
}

/// A function of one float whose result may be too large.
macro_rules! growing {
    ($name:literal, $f:expr, $doc:literal) => {
        function(
            $name,
            "x",
            Arity::One,
            |_, _, args| float::one(args, true, $f),
            $doc,
        )
    };
}

/// A test of one float.
macro_rules! test {
    ($name:literal, $f:expr, $doc:literal) => {
        function(
            $name,
            "x",
            Arity::One,
            |_, _, args| Ok(Value::Bool($f(real(args.at(0))?))),
            $doc,
        )
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
    one!(
        "acos",
        elementary::acos,
        "The angle in radians with this cosine."
    ),
    one!("acosh", float::acosh, "The inverse hyperbolic cosine."),
    one!(
        "asin",
        elementary::asin,
        "The angle in radians with this sine."
    ),
    one!("asinh", float::asinh, "The inverse hyperbolic sine."),
    one!(
        "atan",
        elementary::atan,
        "The angle in radians with this tangent."
    ),
    other!(
        "atan2",
        "y, x",
        TWO,
        |_, _, a| float::two(a, elementary::atan2),
        "The angle in radians of the point (x, y)."
    ),
    one!("atanh", float::atanh, "The inverse hyperbolic tangent."),
    one!("cbrt", libm::cbrt, "The cube root."),
    other!(
        "ceil",
        "x",
        Arity::One,
        |_, _, a| rounded(a.at(0), f64::ceil),
        "The smallest whole number not below x."
    ),
    other!(
        "comb",
        "n, k",
        TWO,
        exact::comb,
        "Ways to choose k of n things."
    ),
    other!(
        "copysign",
        "x, y",
        TWO,
        |_, _, a| float::two(a, f64::copysign),
        "x with the sign of y."
    ),
    one!("cos", elementary::cos, "The cosine of an angle in radians."),
    growing!("cosh", elementary::cosh, "The hyperbolic cosine."),
    other!(
        "degrees",
        "x",
        Arity::One,
        |_, _, a| Ok((real(a.at(0))? * (180.0 / PI)).into()),
        "Radians to degrees."
    ),
    other!(
        "dist",
        "p, q",
        TWO,
        float::dist,
        "The distance of two points given as sequences."
    ),
    one!("erf", libm::erf, "The error function."),
    one!("erfc", libm::erfc, "The complementary error function."),
    growing!("exp", elementary::exp, "e to the power of x."),
    growing!("exp2", elementary::exp2, "2 to the power of x."),
    growing!("expm1", elementary::expm1, "exp(x) - 1, exact for small x."),
    one!("fabs", f64::abs, "The absolute value as a float."),
    other!(
        "factorial",
        "n",
        Arity::One,
        exact::factorial,
        "n! for a whole number."
    ),
    other!(
        "floor",
        "x",
        Arity::One,
        |_, _, a| rounded(a.at(0), f64::floor),
        "The largest whole number not above x."
    ),
    other!(
        "fmod",
        "x, y",
        TWO,
        float::fmod,
        "The remainder of x / y with the sign of x."
    ),
    other!(
        "frexp",
        "x",
        Arity::One,
        float::frexp,
        "Mantissa and exponent of x."
    ),
    other!(
        "fsum",
        "iterable",
        Arity::One,
        exact::fsum,
        "The sum of floats, rounded only once."
    ),
    other!(
        "gamma",
        "x",
        Arity::One,
        |_, _, a| super::math_gamma::gamma(real(a.at(0))?),
        "The gamma function."
    ),
    other!(
        "gcd",
        "*integers",
        Arity::Positional,
        exact::gcd,
        "The greatest common divisor."
    ),
    other!(
        "hypot",
        "*coordinates",
        Arity::Positional,
        float::hypot,
        "The length of a vector."
    ),
    other!(
        "isclose",
        "a, b, *, rel_tol=1e-09, abs_tol=0.0",
        Arity::Any,
        float::isclose,
        "Whether two numbers are nearly equal."
    ),
    test!(
        "isfinite",
        f64::is_finite,
        "Whether x is neither infinite nor NaN."
    ),
    test!("isinf", f64::is_infinite, "Whether x is infinite."),
    test!("isnan", f64::is_nan, "Whether x is not a number."),
    other!(
        "isqrt",
        "n",
        Arity::One,
        exact::isqrt,
        "The whole part of the square root."
    ),
    other!(
        "lcm",
        "*integers",
        Arity::Positional,
        exact::lcm,
        "The least common multiple."
    ),
    other!(
        "ldexp",
        "x, i",
        TWO,
        float::ldexp,
        "x times 2 to the power of i."
    ),
    other!(
        "lgamma",
        "x",
        Arity::One,
        |_, _, a| super::math_gamma::lgamma(real(a.at(0))?),
        "The logarithm of the gamma function."
    ),
    // An older way of taking arguments: its messages name no module.
    Function {
        name: "log",
        owner: "",
        params: "x, base=e",
        doc: "The logarithm, natural without a base.",
        arity: Arity::Positional,
        run: log,
    },
    other!(
        "log10",
        "x",
        Arity::One,
        |_, _, a| logarithm(a.at(0), elementary::log10).map(Value::Float),
        "The logarithm to base 10."
    ),
    one!("log1p", elementary::ln_1p, "log(1 + x), exact for small x."),
    other!(
        "log2",
        "x",
        Arity::One,
        |_, _, a| logarithm(a.at(0), elementary::log2).map(Value::Float),
        "The logarithm to base 2."
    ),
    other!(
        "modf",
        "x",
        Arity::One,
        float::modf,
        "Fraction and whole part of x."
    ),
    other!(
        "nextafter",
        "x, y",
        TWO,
        |_, _, a| float::two(a, float::next_after),
        "The float after x towards y."
    ),
    other!(
        "perm",
        "n, k=None",
        Arity::Range(1, 2),
        exact::perm,
        "Ways to arrange k of n things."
    ),
    other!(
        "pow",
        "x, y",
        TWO,
        float::pow,
        "x to the power of y as a float."
    ),
    other!(
        "prod",
        "iterable, *, start=1",
        Arity::Any,
        exact::prod,
        "The product of the items."
    ),
    one!("radians", |x: f64| x * (PI / 180.0), "Degrees to radians."),
    other!(
        "remainder",
        "x, y",
        TWO,
        float::remainder,
        "x minus the nearest multiple of y."
    ),
    one!("sin", elementary::sin, "The sine of an angle in radians."),
    growing!("sinh", elementary::sinh, "The hyperbolic sine."),
    one!("sqrt", f64::sqrt, "The square root."),
    one!(
        "tan",
        elementary::tan,
        "The tangent of an angle in radians."
    ),
    one!("tanh", elementary::tanh, "The hyperbolic tangent."),
    other!("trunc", "x", Arity::One, trunc, "x without its fraction."),
    one!("ulp", float::ulp, "The distance to the next float."),
];

/// The float an argument stands for.
pub(super) fn real(value: &Value) -> Eval<f64> {
    match Num::of(value).map(Num::float).transpose()?.flatten() {
        Some(float) => Ok(float),
        None => Err(Stop::typ(format!(
            "must be real number, not {}",
            value.type_name()
        ))),
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
        other => Err(Stop::typ(format!(
            "type {} doesn't define __trunc__ method",
            other.type_name()
        ))),
    }
}

fn log(_: &mut Interp, _: &Value, args: &Args) -> Eval {
    if !(1..=2).contains(&args.len()) {
        return Err(Stop::typ("math.log requires 1 to 2 arguments"));
    }
    let number = logarithm(args.at(0), elementary::ln)?;
    let Some(base) = args.get(1) else {
        return Ok(Value::Float(number));
    };
    let base = logarithm(base, elementary::ln)?;
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
    (
        high | u64::from(!exact),
        i64::try_from(cut).unwrap_or(i64::MAX),
    )
}

/// The whole number an argument of an integer function is.
pub(super) fn whole(value: &Value) -> Eval<BigInt> {
    integer(value)?;
    Ok(Num::of(value)
        .and_then(Num::big)
        .map(std::borrow::Cow::into_owned)
        .unwrap_or_default())
}
