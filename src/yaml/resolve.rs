//! Which type a scalar without tag and quotes has: matchers for the patterns of YAML 1.1 as PyYAML has
//! them, which is not quite as the YAML type repository has them.

/// Prefix of the tags of YAML itself.
pub(super) const YAML: &str = "tag:yaml.org,2002:";
pub(super) const NULL: &str = "tag:yaml.org,2002:null";
pub(super) const BOOL: &str = "tag:yaml.org,2002:bool";
pub(super) const INT: &str = "tag:yaml.org,2002:int";
pub(super) const FLOAT: &str = "tag:yaml.org,2002:float";
pub(super) const TIMESTAMP: &str = "tag:yaml.org,2002:timestamp";
pub(super) const MERGE: &str = "tag:yaml.org,2002:merge";
pub(super) const VALUE: &str = "tag:yaml.org,2002:value";
pub(super) const STR: &str = "tag:yaml.org,2002:str";
pub(super) const SEQ: &str = "tag:yaml.org,2002:seq";
pub(super) const MAP: &str = "tag:yaml.org,2002:map";

/// The tag of a plain scalar.
pub(super) fn resolve(text: &str) -> &'static str {
    match text {
        "" | "~" | "null" | "Null" | "NULL" => NULL,
        "=" => VALUE,
        "<<" => MERGE,
        _ if is_bool(text) => BOOL,
        _ if !text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) => STR,
        _ if is_float(text) => FLOAT,
        _ if is_int(text) => INT,
        _ if is_timestamp(text) => TIMESTAMP,
        _ => STR,
    }
}

fn is_bool(text: &str) -> bool {
    let lower = text.to_ascii_lowercase();
    let known = matches!(
        lower.as_str(),
        "yes" | "no" | "true" | "false" | "on" | "off"
    );
    let mut behind_first = text.chars().skip(1);
    let capitalised = text == lower || behind_first.clone().all(|c| c.is_ascii_lowercase());
    known && (capitalised || behind_first.all(|c| c.is_ascii_uppercase()) && is_upper_start(text))
}

fn is_upper_start(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_uppercase())
}

fn unsigned(text: &str) -> &str {
    text.strip_prefix(['-', '+']).unwrap_or(text)
}

fn is_digit(c: char) -> bool {
    c.is_ascii_digit()
}

fn is_digit_or_bar(c: char) -> bool {
    c.is_ascii_digit() || c == '_'
}

fn is_int(text: &str) -> bool {
    let text = unsigned(text);
    if let Some(bits) = text.strip_prefix("0b") {
        return !bits.is_empty() && bits.chars().all(|c| matches!(c, '0' | '1' | '_'));
    }
    if let Some(digits) = text.strip_prefix("0x") {
        return !digits.is_empty() && digits.chars().all(|c| c.is_ascii_hexdigit() || c == '_');
    }
    if let Some(octal) = text.strip_prefix('0') {
        return octal.chars().all(|c| matches!(c, '0'..='7' | '_'));
    }
    let (first, sixtieths) = text
        .split_once(':')
        .map_or((text, None), |(first, rest)| (first, Some(rest)));
    first.starts_with(is_digit)
        && first.chars().all(is_digit_or_bar)
        && sixtieths.is_none_or(|rest| rest.split(':').all(is_sixtieth))
}

/// `0` to `59`, perhaps with a leading zero.
fn is_sixtieth(text: &str) -> bool {
    match text.as_bytes() {
        [b'0'..=b'9'] => true,
        [first, second] => matches!(first, b'0'..=b'5') && second.is_ascii_digit(),
        _ => false,
    }
}

fn is_float(text: &str) -> bool {
    let number = unsigned(text);
    if matches!(number, ".inf" | ".Inf" | ".INF") || matches!(text, ".nan" | ".NaN" | ".NAN") {
        return true;
    }
    let Some((whole, rest)) = number.split_once('.') else {
        return false;
    };
    if let Some((first, sixtieths)) = whole.split_once(':') {
        return first.starts_with(is_digit)
            && first.chars().all(is_digit_or_bar)
            && sixtieths.split(':').all(is_sixtieth)
            && rest.chars().all(is_digit_or_bar);
    }
    let (fraction, exponent) = match rest.split_once(['e', 'E']) {
        Some((fraction, exponent)) => (fraction, Some(exponent)),
        None => (rest, None),
    };
    let fraction_fits = fraction.chars().all(is_digit_or_bar);
    let exponent_fits = exponent.is_none_or(|exponent| {
        let digits = exponent.strip_prefix(['-', '+']).unwrap_or("");
        !digits.is_empty() && digits.chars().all(is_digit)
    });
    // Without a digit before the point there must be one behind it, and no sign.
    let whole_fits = if whole.is_empty() {
        number == text && fraction.starts_with(is_digit)
    } else {
        whole.starts_with(is_digit) && whole.chars().all(is_digit_or_bar)
    };
    whole_fits && fraction_fits && exponent_fits
}

/// A date, or a date and a time; a date alone has two digits in each part.
fn is_timestamp(text: &str) -> bool {
    super::timestamp::parse(text).is_some_and(|found| found.time.is_some() || text.len() == 10)
}
