//! Integer arithmetic.

use num_bigint::{BigInt, Sign};
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::float;
use crate::Value;
use crate::ast::BinOp;
use crate::interp::Interp;
use crate::numeric::big_to_f64;
use crate::stop::{Eval, Stop};

/// The common operators on small operands with a small result.
#[inline]
pub(super) fn fast(op: BinOp, a: i64, b: i64) -> Option<Value> {
    let int = match op {
        BinOp::Add => a.checked_add(b),
        BinOp::Sub => a.checked_sub(b),
        BinOp::Mul => a.checked_mul(b),
        BinOp::FloorDiv => floor_div(a, b),
        BinOp::Mod => floor_mod(a, b),
        BinOp::Pow => a.checked_pow(u32::try_from(b).ok()?),
        BinOp::BitAnd => Some(a & b),
        BinOp::BitOr => Some(a | b),
        BinOp::BitXor => Some(a ^ b),
        BinOp::RShift if b >= 0 => Some(a >> b.min(63)),
        // Below 2**53 both operands are exact, so the float division rounds once, as it should.
        BinOp::Div if b != 0 && a.unsigned_abs() >> 53 == 0 && b.unsigned_abs() >> 53 == 0 => {
            return Some(Value::Float(a as f64 / b as f64));
        }
        _ => None,
    };
    int.map(Value::Int)
}

fn floor_div(a: i64, b: i64) -> Option<i64> {
    let (quotient, rest) = (a.checked_div(b)?, a.checked_rem(b)?);
    Some(if rest != 0 && (rest < 0) != (b < 0) {
        quotient - 1
    } else {
        quotient
    })
}

fn floor_mod(a: i64, b: i64) -> Option<i64> {
    let rest = a.checked_rem(b)?;
    Some(if rest != 0 && (rest < 0) != (b < 0) {
        rest + b
    } else {
        rest
    })
}

/// Quotient rounded down and the rest with the divisor's sign.
pub(crate) fn div_mod(a: &BigInt, b: &BigInt) -> (BigInt, BigInt) {
    let (quotient, rest) = (a / b, a % b);
    if !rest.is_zero() && rest.is_negative() != b.is_negative() {
        (quotient - 1, rest + b)
    } else {
        (quotient, rest)
    }
}

/// All operators on integers of any size; none if the operator does not apply.
pub(super) fn binary(
    interp: &mut Interp,
    op: BinOp,
    a: &BigInt,
    b: &BigInt,
) -> Eval<Option<Value>> {
    let bits = u128::from(a.bits().max(b.bits()));
    let value = match op {
        BinOp::Add | BinOp::Sub => {
            interp.budget.int_bits(bits + 1)?;
            Value::int(if op == BinOp::Add { a + b } else { a - b })
        }
        BinOp::Mul => Value::int(multiply(interp, a, b)?),
        BinOp::Div => Value::Float(true_divide(interp, a, b)?),
        BinOp::FloorDiv | BinOp::Mod => {
            if b.is_zero() {
                let message = if op == BinOp::Mod {
                    "integer modulo by zero"
                } else {
                    "integer division or modulo by zero"
                };
                return Err(Stop::zero(message));
            }
            charge_division(interp, a, b)?;
            let (quotient, rest) = div_mod(a, b);
            Value::int(if op == BinOp::Mod { rest } else { quotient })
        }
        BinOp::Pow => power(interp, a, b)?,
        BinOp::LShift | BinOp::RShift => shift(interp, op, a, b)?,
        BinOp::BitAnd => Value::int(a & b),
        BinOp::BitOr => Value::int(a | b),
        BinOp::BitXor => Value::int(a ^ b),
        BinOp::MatMul => return Ok(None),
    };
    Ok(Some(value))
}

/// The time a multiplication of such numbers takes; much less than their product thanks to divide and conquer.
fn charge_multiplication(interp: &mut Interp, bits: u64, other_bits: u64) -> Eval<()> {
    let (long, short) = (bits.max(other_bits) / 64 + 1, bits.min(other_bits) / 64 + 1);
    interp.budget.steps(long * short.isqrt() / 8)
}

/// The time a division of such numbers takes.
fn charge_division(interp: &mut Interp, a: &BigInt, b: &BigInt) -> Eval<()> {
    interp
        .budget
        .steps((a.bits() / 64 + 1).saturating_mul(b.bits() / 64 + 1) / 32)
}

/// `a * b` within the limits.
pub(crate) fn multiply(interp: &mut Interp, a: &BigInt, b: &BigInt) -> Eval<BigInt> {
    interp
        .budget
        .int_bits(u128::from(a.bits()) + u128::from(b.bits()))?;
    charge_multiplication(interp, a.bits(), b.bits())?;
    Ok(a * b)
}

/// `a ** b`
pub(crate) fn power(interp: &mut Interp, a: &BigInt, b: &BigInt) -> Eval {
    if b.is_negative() {
        return float::power(big_to_f64(a)?, big_to_f64(b)?);
    }
    if a.is_zero() || a.is_one() || b.is_zero() || (a.magnitude().is_one()) {
        let negative = a.is_negative() && b.bit(0);
        let one = a.magnitude().is_one() || b.is_zero();
        return Ok(Value::Int(match (one, negative) {
            (false, _) => 0,
            (true, false) => 1,
            (true, true) => -1,
        }));
    }
    let exponent = b.to_u64().map_or(u128::MAX >> 64, u128::from);
    // a has at least bits-1 binary digits, so this never refuses a result within the limit.
    interp
        .budget
        .int_bits((u128::from(a.bits()) - 1) * exponent)?;
    let exponent = u32::try_from(exponent).unwrap_or(u32::MAX);
    let bits = a.bits() * u64::from(exponent);
    charge_multiplication(interp, bits, bits)?;
    Ok(Value::int(a.pow(exponent)))
}

fn shift(interp: &mut Interp, op: BinOp, a: &BigInt, b: &BigInt) -> Eval {
    if b.is_negative() {
        return Err(Stop::value("negative shift count"));
    }
    if op == BinOp::RShift {
        return Ok(match b.to_u64() {
            Some(count) if count <= a.bits() => Value::int(a >> count),
            _ => Value::Int(if a.is_negative() { -1 } else { 0 }),
        });
    }
    if a.is_zero() {
        return Ok(Value::Int(0));
    }
    let count = b.to_u64().unwrap_or(u64::MAX);
    interp
        .budget
        .int_bits(u128::from(a.bits()) + u128::from(count))?;
    Ok(Value::int(a << count))
}

/// `a / b`, rounded once.
pub(crate) fn true_divide(interp: &mut Interp, a: &BigInt, b: &BigInt) -> Eval<f64> {
    if b.is_zero() {
        return Err(Stop::zero("division by zero"));
    }
    if a.is_zero() {
        return Ok(if b.is_negative() { -0.0 } else { 0.0 });
    }
    charge_division(interp, a, b)?;
    let scale =
        i64::try_from(a.bits()).unwrap_or(i64::MAX) - i64::try_from(b.bits()).unwrap_or(i64::MAX);
    let magnitude = match scale {
        1026.. => f64::INFINITY,
        ..-1100 => 0.0,
        _ => quotient(a, b, scale),
    };
    if magnitude.is_infinite() {
        return Err(Stop::overflow(
            "integer division result too large for a float",
        ));
    }
    let negative = (a.sign() == Sign::Minus) != (b.sign() == Sign::Minus);
    Ok(if negative { -magnitude } else { magnitude })
}

/// `|a / b|`; the quotient lies between 2**(scale-1) and 2**(scale+1).
fn quotient(a: &BigInt, b: &BigInt, scale: i64) -> f64 {
    // As many digits as the result can hold: fewer for a subnormal one.
    let digits = 55.min(scale + 1074 + 2);
    let up = digits - scale;
    let (mut a, mut b) = (a.magnitude().clone(), b.magnitude().clone());
    if up >= 0 {
        a <<= up
    } else {
        b <<= -up
    };
    let whole = &a / &b;
    let exact = (&whole * &b) == a;
    // The lowest bit records that something is missing, so that the next step rounds correctly.
    let sticky = (whole.to_u64().unwrap_or(0) << 1) | u64::from(!exact);
    scale_by(sticky, -up - 1)
}

/// `mantissa * 2**exponent`, rounded to nearest even once.
pub(crate) fn scale_by(mantissa: u64, exponent: i64) -> f64 {
    let bits = 64 - i64::from(mantissa.leading_zeros());
    let lowest = (bits + exponent - 53).max(-1074);
    let drop = lowest - exponent;
    if drop <= 0 {
        return times_power_of_two(mantissa as f64, exponent);
    }
    if drop > 64 {
        return 0.0;
    }
    let kept = if drop == 64 { 0 } else { mantissa >> drop };
    let rest = if drop == 64 {
        mantissa
    } else {
        mantissa & ((1 << drop) - 1)
    };
    let half = 1u64 << (drop - 1);
    let up = rest > half || (rest == half && kept & 1 == 1);
    times_power_of_two((kept + u64::from(up)) as f64, lowest)
}

/// `x * 2**exponent` where the result is exact or overflows.
fn times_power_of_two(x: f64, exponent: i64) -> f64 {
    let mut exponent = exponent.clamp(-4000, 4000);
    let mut x = x;
    while exponent > 1000 {
        x *= f64::from_bits(0x7e70_0000_0000_0000);
        exponent -= 1000;
    }
    while exponent < -1000 {
        x *= f64::from_bits(0x0170_0000_0000_0000);
        exponent += 1000;
    }
    x * 2f64.powi(i32::try_from(exponent).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_rounds_once() {
        assert_eq!(scale_by(1, -1074), 5e-324);
        assert_eq!(scale_by(3, -1075), 1e-323);
        assert_eq!(scale_by(1, -1075), 0.0);
        assert_eq!(scale_by(u64::MAX, 0), 18_446_744_073_709_551_616.0);
        assert_eq!(scale_by((1 << 54) + 1, -54), 1.0);
        assert_eq!(scale_by((1 << 54) + 3, -54), 1.0 + f64::EPSILON);
        assert_eq!(scale_by(1, 1023), 2f64.powi(1023));
        assert_eq!(scale_by(1, 1024), f64::INFINITY);
        assert_eq!(scale_by(1, 5000), f64::INFINITY);
    }
}
