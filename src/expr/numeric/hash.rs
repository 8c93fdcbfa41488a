//! Python's hash of numbers, which is equal for equal numbers of any type.

use num_bigint::Sign;
use num_traits::ToPrimitive;

use super::{Num, decode};

/// Sign and magnitude as Python's `sys.hash_info` prescribes: modulo the prime 2**61 - 1.
const HASH_MODULUS: u64 = (1 << 61) - 1;

/// Python's `hash()` of a number.
pub(crate) fn hash_num(number: Num<'_>) -> i64 {
    match number {
        Num::Int(i) => signed_hash(i.unsigned_abs() % HASH_MODULUS, i < 0),
        Num::Big(b) => {
            let rest = (b.magnitude() % HASH_MODULUS).to_u64().unwrap_or(0);
            signed_hash(rest, b.sign() == Sign::Minus)
        }
        Num::Float(f) => hash_float(f),
        Num::Complex(re, im) => {
            let sum = hash_float(re).wrapping_add(hash_float(im).wrapping_mul(1_000_003));
            if sum == -1 { -2 } else { sum }
        }
    }
}

fn hash_float(f: f64) -> i64 {
    if f.is_nan() {
        return 0;
    }
    if f.is_infinite() {
        return if f > 0.0 { 314_159 } else { -314_159 };
    }
    let (mantissa, exponent, negative) = decode(f);
    let shift = exponent.rem_euclid(61).unsigned_abs();
    let rest = (u128::from(mantissa) << shift) % u128::from(HASH_MODULUS);
    signed_hash(u64::try_from(rest).unwrap_or(0), negative)
}

fn signed_hash(rest: u64, negative: bool) -> i64 {
    let rest = i64::try_from(rest).unwrap_or(0);
    match if negative { -rest } else { rest } {
        -1 => -2,
        hash => hash,
    }
}
