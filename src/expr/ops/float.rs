//! Float arithmetic.

use super::complex;
use crate::Value;
use crate::ast::BinOp;
use crate::elementary;
use crate::stop::{Eval, Stop};

/// `a op b`
pub(super) fn binary(op: BinOp, a: f64, b: f64) -> Eval {
    Ok(Value::Float(match op {
        BinOp::Add => a + b,
        BinOp::Sub => a - b,
        BinOp::Mul => a * b,
        BinOp::Div if b == 0.0 => return Err(Stop::zero("float division by zero")),
        BinOp::Div => a / b,
        BinOp::FloorDiv if b == 0.0 => return Err(Stop::zero("float floor division by zero")),
        BinOp::FloorDiv => div_mod(a, b).0,
        BinOp::Mod if b == 0.0 => return Err(Stop::zero("float modulo")),
        BinOp::Mod => div_mod(a, b).1,
        BinOp::Pow => return power(a, b),
        _ => return Err(super::unsupported(op, &Value::Float(a), &Value::Float(b))),
    }))
}

/// Quotient rounded down and the rest with the divisor's sign; `b` is not zero.
pub(crate) fn div_mod(a: f64, b: f64) -> (f64, f64) {
    let mut rest = a % b;
    let mut quotient = (a - rest) / b;
    if rest == 0.0 {
        rest = 0f64.copysign(b);
    } else if (b < 0.0) != (rest < 0.0) {
        rest += b;
        quotient -= 1.0;
    }
    if quotient == 0.0 {
        return (0f64.copysign(a / b), rest);
    }
    let floor = quotient.floor();
    (
        if quotient - floor > 0.5 {
            floor + 1.0
        } else {
            floor
        },
        rest,
    )
}

/// `a ** b`; a negative base with a fractional exponent gives a complex number.
pub(crate) fn power(a: f64, b: f64) -> Eval {
    if a == 0.0 && b < 0.0 {
        return Err(Stop::zero("0.0 cannot be raised to a negative power"));
    }
    if a < 0.0 && a.is_finite() && b.is_finite() && b != b.floor() {
        let (re, im) = complex::power((a, 0.0), (b, 0.0))?;
        return Ok(Value::Complex(re, im));
    }
    let result = elementary::pow(a, b);
    if result.is_infinite() && a.is_finite() && b.is_finite() {
        return Err(Stop::overflow("(34, 'Numerical result out of range')"));
    }
    Ok(Value::Float(result))
}
