//! Complex arithmetic.

use crate::Value;
use crate::ast::BinOp;
use crate::elementary;
use crate::stop::{Eval, Stop};

type Complex = (f64, f64);

/// `a op b`
pub(super) fn binary(op: BinOp, a: Complex, b: Complex) -> Eval {
    let (re, im) = match op {
        BinOp::Add => (a.0 + b.0, a.1 + b.1),
        BinOp::Sub => (a.0 - b.0, a.1 - b.1),
        BinOp::Mul => multiply(a, b),
        BinOp::Div => divide(a, b)?,
        BinOp::Pow => power(a, b)?,
        _ => {
            let (x, y) = (Value::Complex(a.0, a.1), Value::Complex(b.0, b.1));
            return Err(super::unsupported(op, &x, &y));
        }
    };
    Ok(Value::Complex(re, im))
}

fn multiply(a: Complex, b: Complex) -> Complex {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

/// Division by the larger part of the divisor, which keeps intermediate results in range.
fn divide(a: Complex, b: Complex) -> Eval<Complex> {
    if b.0.abs() >= b.1.abs() {
        if b.0 == 0.0 {
            return Err(Stop::zero("complex division by zero"));
        }
        let ratio = b.1 / b.0;
        let denominator = b.0 + b.1 * ratio;
        Ok((
            (a.0 + a.1 * ratio) / denominator,
            (a.1 - a.0 * ratio) / denominator,
        ))
    } else if b.1.abs() >= b.0.abs() {
        let ratio = b.0 / b.1;
        let denominator = b.0 * ratio + b.1;
        Ok((
            (a.0 * ratio + a.1) / denominator,
            (a.1 * ratio - a.0) / denominator,
        ))
    } else {
        Ok((f64::NAN, f64::NAN))
    }
}

/// `a ** b`
pub(crate) fn power(a: Complex, b: Complex) -> Eval<Complex> {
    let result = if b.1 == 0.0 && b.0 == b.0.floor() && b.0.abs() <= 100.0 {
        whole_power(a, b.0 as i32)?
    } else {
        general_power(a, b)?
    };
    if (result.0.is_infinite() || result.1.is_infinite())
        && [a.0, a.1, b.0, b.1].iter().all(|x| x.is_finite())
    {
        return Err(Stop::overflow("complex exponentiation"));
    }
    Ok(result)
}

fn whole_power(a: Complex, exponent: i32) -> Eval<Complex> {
    if exponent < 0 {
        if a == (0.0, 0.0) {
            return Err(Stop::zero("0.0 to a negative or complex power"));
        }
        return divide((1.0, 0.0), whole_power(a, -exponent)?);
    }
    let (mut result, mut square, mut mask) = ((1.0, 0.0), a, 1);
    while mask > 0 && exponent >= mask {
        if exponent & mask != 0 {
            result = multiply(result, square);
        }
        mask <<= 1;
        square = multiply(square, square);
    }
    Ok(result)
}

fn general_power(a: Complex, b: Complex) -> Eval<Complex> {
    if b == (0.0, 0.0) {
        return Ok((1.0, 0.0));
    }
    if a == (0.0, 0.0) {
        if b.1 != 0.0 || b.0 < 0.0 {
            return Err(Stop::zero("0.0 to a negative or complex power"));
        }
        return Ok((0.0, 0.0));
    }
    let modulus = elementary::hypot(a.0, a.1);
    let argument = elementary::atan2(a.1, a.0);
    let (mut len, mut phase) = (elementary::pow(modulus, b.0), argument * b.0);
    if b.1 != 0.0 {
        len /= elementary::exp(argument * b.1);
        phase += b.1 * elementary::ln(modulus);
    }
    Ok((len * elementary::cos(phase), len * elementary::sin(phase)))
}
