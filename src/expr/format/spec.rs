//! The format specification `[[fill]align][sign][z][#][0][width][grouping][.precision][type]`.

use crate::numeric::decimal_digit;
use crate::stop::{Eval, Stop};

/// A parsed format specification.
#[derive(Clone, Debug)]
pub(super) struct Spec {
    pub(super) fill: char,
    /// `<`, `>`, `^`, `=`; none for the type's own way.
    pub(super) align: Option<char>,
    pub(super) sign: Option<char>,
    /// Negative zero becomes zero.
    pub(super) no_negative_zero: bool,
    pub(super) alternate: bool,
    pub(super) width: usize,
    /// `,` or `_`
    pub(super) grouping: Option<char>,
    pub(super) precision: Option<usize>,
    /// The presentation type.
    pub(super) kind: Option<char>,
}

struct Chars<'a> {
    rest: &'a [char],
}

impl Chars<'_> {
    fn take_if(&mut self, test: impl Fn(char) -> bool) -> Option<char> {
        let (&first, rest) = self.rest.split_first()?;
        if !test(first) {
            return None;
        }
        self.rest = rest;
        Some(first)
    }

    fn number(&mut self) -> Eval<Option<usize>> {
        let mut number = None::<usize>;
        while let Some(digit) = self.rest.first().and_then(|&c| decimal_digit(c)) {
            let next = number
                .unwrap_or(0)
                .checked_mul(10)
                .and_then(|n| n.checked_add(digit as usize));
            let fits = next.filter(|&next| i64::try_from(next).is_ok());
            number =
                Some(fits.ok_or_else(|| Stop::value("Too many decimal digits in format string"))?);
            self.rest = self.rest.get(1..).unwrap_or(&[]);
        }
        Ok(number)
    }
}

fn is_align(c: char) -> bool {
    matches!(c, '<' | '>' | '=' | '^')
}

/// Parse `text`, which formats a value of the type `kind`; `numeric` ones are padded with zeros behind the sign.
pub(super) fn parse(text: &str, kind: &str, numeric: bool) -> Eval<Spec> {
    let all: Vec<char> = text.chars().collect();
    let mut chars = Chars { rest: &all };
    let (fill, align) = match chars.rest {
        [fill, align, rest @ ..] if is_align(*align) => {
            chars.rest = rest;
            (Some(*fill), Some(*align))
        }
        _ => (None, chars.take_if(is_align)),
    };
    let sign = chars.take_if(|c| matches!(c, ' ' | '+' | '-'));
    let no_negative_zero = chars.take_if(|c| c == 'z').is_some();
    let alternate = chars.take_if(|c| c == '#').is_some();
    // A leading zero means padding with zeros behind the sign, unless a fill was given.
    let zero = fill.is_none() && chars.take_if(|c| c == '0').is_some();
    let (fill, align) = if zero {
        (Some('0'), align.or(numeric.then_some('=')))
    } else {
        (fill, align)
    };
    let width = chars.number()?.unwrap_or(0);
    let grouping = grouping(&mut chars)?;
    let precision = match chars.take_if(|c| c == '.') {
        None => None,
        Some(_) => Some(
            chars
                .number()?
                .ok_or_else(|| Stop::value("Format specifier missing precision"))?,
        ),
    };
    let (presentation, rest) = match chars.rest {
        [] => (None, false),
        [one] => (Some(*one), false),
        _ => (None, true),
    };
    if rest {
        return Err(Stop::value(format!(
            "Invalid format specifier '{text}' for object of type '{kind}'"
        )));
    }
    let fill = fill.unwrap_or(' ');
    let spec = Spec {
        fill,
        align,
        sign,
        no_negative_zero,
        alternate,
        width,
        grouping,
        precision,
        kind: presentation,
    };
    check_grouping(&spec, numeric)?;
    Ok(spec)
}

fn grouping(chars: &mut Chars<'_>) -> Eval<Option<char>> {
    let comma = chars.take_if(|c| c == ',');
    let underscore = chars.take_if(|c| c == '_');
    match (comma, underscore) {
        (Some(_), Some(_)) => Err(Stop::value("Cannot specify both ',' and '_'.")),
        (Some(_), None) if chars.rest.first() == Some(&',') => {
            Err(Stop::value("Cannot specify ',' with ','."))
        }
        (None, Some(_)) if chars.rest.first() == Some(&'_') => {
            Err(Stop::value("Cannot specify '_' with '_'."))
        }
        (None, Some(_)) if chars.rest.first() == Some(&',') => {
            Err(Stop::value("Cannot specify both ',' and '_'."))
        }
        (comma, underscore) => Ok(comma.or(underscore)),
    }
}

fn check_grouping(spec: &Spec, numeric: bool) -> Eval<()> {
    let Some(grouping) = spec.grouping else {
        return Ok(());
    };
    let allowed = match spec.kind {
        None => numeric,
        Some('d' | 'e' | 'f' | 'g' | 'E' | 'G' | '%' | 'F') => true,
        Some('b' | 'o' | 'x' | 'X') => grouping == '_',
        Some(_) => false,
    };
    if allowed {
        return Ok(());
    }
    let kind = spec.kind.unwrap_or('s');
    Err(Stop::value(if (' '..='\u{7f}').contains(&kind) {
        format!("Cannot specify '{grouping}' with '{kind}'.")
    } else {
        format!(
            "Cannot specify '{grouping}' with '\\x{:x}'.",
            u32::from(kind)
        )
    }))
}

/// `Unknown format code 'x' for object of type 'str'`
pub(super) fn unknown_code(code: char, kind: &str) -> Stop {
    let code = if (' '..='\u{7f}').contains(&code) {
        code.to_string()
    } else {
        format!("\\x{:x}", u32::from(code))
    };
    Stop::value(format!(
        "Unknown format code '{code}' for object of type '{kind}'"
    ))
}
