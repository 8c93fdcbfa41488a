//! Functions of integers, and sums and products.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::math::{real, whole};
use super::python::integer;
use crate::args::{Args, bind_named};
use crate::ast::BinOp;
use crate::interp::Interp;
use crate::ops;
use crate::stop::{Eval, Stop};
use crate::value::Value;

/// Product of `first..=last`, charged for its size before it is computed.
fn product(interp: &mut Interp, first: u64, last: u64) -> Eval<BigInt> {
    if first > last {
        return Ok(BigInt::one());
    }
    let count = u128::from(last - first) + 1;
    let bits = u128::from(64 - last.leading_zeros());
    interp.budget.int_bits(count * (bits.max(2) - 1))?;
    let words = u64::try_from(count * bits / 64 + 1).unwrap_or(u64::MAX);
    interp.budget.steps(
        u64::try_from(count)
            .unwrap_or(u64::MAX)
            .saturating_add(words * words.isqrt() / 8),
    )?;
    Ok(multiply_range(first, last))
}

/// Halving keeps the factors of similar size, which is much faster than one after the other.
fn multiply_range(first: u64, last: u64) -> BigInt {
    if last - first < 8 {
        return (first..=last).map(BigInt::from).product();
    }
    let middle = first + (last - first) / 2;
    multiply_range(first, middle) * multiply_range(middle + 1, last)
}

pub(super) fn factorial(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let n = integer(args.at(0))?;
    if n < 0 {
        return Err(Stop::value("factorial() not defined for negative values"));
    }
    match i64::try_from(n) {
        Ok(n) => Ok(Value::int(product(interp, 2, n.unsigned_abs())?)),
        Err(_) => {
            let limit = i64::MAX;
            Err(Stop::overflow(format!(
                "factorial() argument should not exceed {limit}"
            )))
        }
    }
}

/// The arguments of `comb` and `perm`, and whether there is anything to compute.
fn choices(args: &Args) -> Eval<(BigInt, BigInt)> {
    let (n, k) = (whole(args.at(0))?, whole(args.at(1))?);
    if n.is_negative() {
        return Err(Stop::value("n must be a non-negative integer"));
    }
    if k.is_negative() {
        return Err(Stop::value("k must be a non-negative integer"));
    }
    Ok((n, k))
}

pub(super) fn perm(interp: &mut Interp, receiver: &Value, args: &Args) -> Eval {
    if matches!(args.get(1), None | Some(Value::None)) {
        return factorial(interp, receiver, args);
    }
    let (n, k) = choices(args)?;
    if k > n {
        return Ok(Value::Int(0));
    }
    falling(interp, &n, &k).map(Value::int)
}

/// `n * (n-1) * ...` with `k` factors.
fn falling(interp: &mut Interp, n: &BigInt, k: &BigInt) -> Eval<BigInt> {
    let Some(k) = k.to_u64() else {
        return Err(Stop::overflow(format!("k must not exceed {}", u64::MAX)));
    };
    if let Some(n) = n.to_u64() {
        return product(interp, n - k + 1, n);
    }
    interp
        .budget
        .int_bits(u128::from(n.bits() - 1) * u128::from(k))?;
    let mut result = BigInt::one();
    for i in 0..k {
        result = ops::int::multiply(interp, &result, &(n - i))?;
        interp.budget.step()?;
    }
    Ok(result)
}

pub(super) fn comb(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let (n, k) = choices(args)?;
    if k > n {
        return Ok(Value::Int(0));
    }
    let rest = &n - &k;
    let k = if rest < k { rest } else { k };
    let top = falling(interp, &n, &k)?;
    let bottom = product(interp, 2, k.to_u64().unwrap_or(1))?;
    Ok(Value::int(top / bottom))
}

pub(super) fn gcd(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let mut result = BigInt::zero();
    for value in &args.pos {
        result = greatest(interp, result, whole(value)?.abs())?;
    }
    Ok(Value::int(result))
}

fn greatest(interp: &mut Interp, mut a: BigInt, mut b: BigInt) -> Eval<BigInt> {
    while !b.is_zero() {
        interp.budget.steps(1 + b.bits() / 64)?;
        let rest = &a % &b;
        a = std::mem::replace(&mut b, rest);
    }
    Ok(a)
}

pub(super) fn lcm(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let mut result = BigInt::one();
    for value in &args.pos {
        let value = whole(value)?.abs();
        if value.is_zero() {
            result = BigInt::zero();
        } else if !result.is_zero() {
            let divisor = greatest(interp, result.clone(), value.clone())?;
            result = ops::int::multiply(interp, &(result / divisor), &value)?;
        }
    }
    Ok(Value::int(result))
}

pub(super) fn isqrt(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let n = whole(args.at(0))?;
    if n.is_negative() {
        return Err(Stop::value("isqrt() argument must be nonnegative"));
    }
    let words = n.bits() / 64 + 1;
    interp.budget.steps(words.saturating_mul(words) / 256)?;
    Ok(Value::int(n.sqrt()))
}

/// The sum of floats, kept as parts that do not overlap and rounded once at the end.
pub(super) fn fsum(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let mut sum = ExactSum::default();
    let mut cursor = interp.iter(args.at(0))?;
    while let Some(item) = interp.next(&mut cursor)? {
        sum.add(real(&item.known()?)?)?;
    }
    sum.result().map(Value::Float)
}

#[derive(Default)]
struct ExactSum {
    /// In increasing magnitude.
    parts: Vec<f64>,
    special: f64,
    infinite: f64,
}

impl ExactSum {
    fn add(&mut self, value: f64) -> Eval<()> {
        let mut x = value;
        let mut kept = Vec::with_capacity(self.parts.len() + 1);
        for &part in &self.parts {
            let (large, small) = if x.abs() < part.abs() {
                (part, x)
            } else {
                (x, part)
            };
            let high = large + small;
            let low = small - (high - large);
            if low != 0.0 {
                kept.push(low);
            }
            x = high;
        }
        if x.is_finite() {
            if x != 0.0 {
                kept.push(x);
            }
            self.parts = kept;
            return Ok(());
        }
        if value.is_finite() {
            return Err(Stop::overflow("intermediate overflow in fsum"));
        }
        if value.is_infinite() {
            self.infinite += value;
        }
        self.special += value;
        self.parts.clear();
        Ok(())
    }

    fn result(mut self) -> Eval<f64> {
        if self.special != 0.0 {
            return if self.infinite.is_nan() {
                Err(Stop::value("-inf + inf in fsum"))
            } else {
                Ok(self.special)
            };
        }
        let Some(mut high) = self.parts.pop() else {
            return Ok(0.0);
        };
        let mut low = 0.0;
        while let Some(part) = self.parts.pop() {
            let sum = high + part;
            low = part - (sum - high);
            high = sum;
            if low != 0.0 {
                break;
            }
        }
        // A tie was rounded to even, though what is left shows on which side the sum lies.
        if let Some(&next) = self.parts.last()
            && ((low < 0.0 && next < 0.0) || (low > 0.0 && next > 0.0))
        {
            let twice = low * 2.0;
            let moved = high + twice;
            if twice == moved - high {
                high = moved;
            }
        }
        Ok(high)
    }
}

pub(super) fn prod(interp: &mut Interp, _: &Value, args: &Args) -> Eval {
    let args = Args {
        pos: args.pos.clone(),
        named: args.named.clone(),
    };
    let args = bind_named("prod", &["", "start"], 1, 1, args)?;
    let mut total = args.get(1).cloned().unwrap_or(Value::Int(1));
    let mut cursor = interp.iter(args.at(0))?;
    while let Some(item) = interp.next(&mut cursor)? {
        total = ops::binary(interp, BinOp::Mul, &total, &item)?;
    }
    Ok(total)
}
