//! Upper and lower case, and the classes of characters.

use crate::interp::Interp;
use crate::numeric::decimal_digit;
use crate::quote;
use crate::stop::{Eval, Stop};
use crate::syntax::{is_name_continue, is_name_start};
use crate::value::Value;

/// Apply a mapping that may at most triple the text.
pub(super) fn mapped(interp: &mut Interp, text: &Value, map: fn(&str) -> String) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    interp
        .budget
        .text(text.len() as u128 * if text.is_ascii() { 1 } else { 3 })?;
    Ok(Value::from(map(text)))
}

pub(super) fn lower(text: &str) -> String {
    text.to_lowercase()
}

/// Lower case for comparison: some letters fall apart into several.
pub(super) fn casefold(text: &str) -> String {
    let fold = |c: char| match c {
        'ß' | 'ẞ' => "ss".to_owned(),
        'ς' => "σ".to_owned(),
        'µ' => "μ".to_owned(),
        'ſ' => "s".to_owned(),
        // Letters whose upper case has several characters fold like that.
        c if !c.is_ascii() && c.to_uppercase().count() > 1 => {
            c.to_uppercase().flat_map(char::to_lowercase).collect()
        }
        c => c.to_lowercase().collect(),
    };
    text.chars().map(fold).collect()
}

/// Title case of a letter: the four digraphs have a form of their own, the other long mappings keep only the first letter large.
fn to_title(c: char) -> String {
    match c {
        'Ǆ' | 'ǅ' | 'ǆ' => "ǅ".to_owned(),
        'Ǉ' | 'ǈ' | 'ǉ' => "ǈ".to_owned(),
        'Ǌ' | 'ǋ' | 'ǌ' => "ǋ".to_owned(),
        'Ǳ' | 'ǲ' | 'ǳ' => "ǲ".to_owned(),
        // Georgian letters have capitals, but no titles.
        '\u{10d0}'..='\u{10ff}' => c.to_string(),
        c if c.is_ascii() => c.to_ascii_uppercase().to_string(),
        c => {
            let mut done = false;
            let mut out = String::new();
            for part in c.to_uppercase() {
                if done {
                    out.extend(part.to_lowercase())
                } else {
                    out.push(part)
                }
                done |= is_cased(part);
            }
            out
        }
    }
}

pub(super) fn capitalize(text: &str) -> String {
    let mut chars = text.chars();
    let Some(first) = chars.next() else {
        return String::new();
    };
    // The whole text is lowered so that a final sigma is seen in its place.
    let lowered = text.to_lowercase();
    let skip: usize = first.to_lowercase().map(char::len_utf8).sum();
    to_title(first) + lowered.get(skip..).unwrap_or("")
}

pub(super) fn swapcase(text: &str) -> String {
    let swap = |c: char| -> String {
        if c.is_uppercase() {
            c.to_lowercase().collect()
        } else if c.is_lowercase() {
            c.to_uppercase().collect()
        } else {
            c.to_string()
        }
    };
    text.chars().map(swap).collect()
}

fn is_cased(c: char) -> bool {
    c.is_lowercase() || c.is_uppercase() || is_title(c)
}

pub(super) fn title(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut inside = false;
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        if inside && c == 'Σ' {
            out.push(if chars.peek().is_some_and(|&next| is_cased(next)) {
                'σ'
            } else {
                'ς'
            });
        } else if inside {
            out.extend(c.to_lowercase());
        } else {
            out.push_str(&to_title(c));
        }
        inside = is_cased(c);
    }
    out
}

/// Letters of category Lt.
pub(super) fn is_title(c: char) -> bool {
    matches!(c, 'ǅ' | 'ǈ' | 'ǋ' | 'ǲ' | '\u{1f88}'..='\u{1f8f}' | '\u{1f98}'..='\u{1f9f}'
        | '\u{1fa8}'..='\u{1faf}' | '\u{1fbc}' | '\u{1fcc}' | '\u{1ffc}')
}

/// Whether upper case letters only follow uncased characters, and lower case only cased ones.
pub(super) fn is_titlecased(text: &str) -> bool {
    let (mut inside, mut found) = (false, false);
    for c in text.chars() {
        if c.is_uppercase() || is_title(c) {
            if inside {
                return false;
            }
            (inside, found) = (true, true);
        } else if c.is_lowercase() {
            if !inside {
                return false;
            }
            found = true;
        } else {
            inside = false;
        }
    }
    found
}

/// Whether there are characters and all are of a class.
pub(super) fn all(text: &Value, class: impl Fn(char) -> bool) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    Ok(Value::Bool(!text.is_empty() && text.chars().all(class)))
}

/// Whether there is a letter of the case and none of the other.
pub(super) fn uniform(
    text: &Value,
    is: impl Fn(char) -> bool,
    other: impl Fn(char) -> bool,
) -> Eval {
    let text = text.as_str().ok_or(Stop::Unknown)?;
    Ok(Value::Bool(
        text.chars().any(is) && !text.chars().any(other),
    ))
}

/// Letters. (The property used also covers letter-like numbers, taken out here, and vowel signs of some scripts.)
pub(super) fn is_alpha(c: char) -> bool {
    c.is_alphabetic() && !c.is_numeric()
}

/// Decimal digits and those in superscript, subscript or circles.
pub(super) fn is_digit(c: char) -> bool {
    let circled = matches!(u32::from(c),
        0xb2 | 0xb3 | 0xb9 | 0x1369..=0x1371 | 0x19da | 0x2070 | 0x2074..=0x2079 | 0x2080..=0x2089
        | 0x2460..=0x2468 | 0x2474..=0x247c | 0x2488..=0x2490 | 0x24ea | 0x24f5..=0x24fd | 0x24ff
        | 0x2776..=0x277e | 0x2780..=0x2788 | 0x278a..=0x2792 | 0x10a40..=0x10a43 | 0x10e60..=0x10e68
        | 0x11052..=0x1105a | 0x1f100..=0x1f10a);
    circled || decimal_digit(c).is_some()
}

/// Anything with a numeric value, among it the Chinese numerals.
pub(super) fn is_numeric(c: char) -> bool {
    const IDEOGRAPHS: &str = "㐅㒃㠪㭍一七万三九二五亖亿什仟仨伍佰億兆兩八六十千卄卅卌叁参參叄四壱壹幺廾廿弌弍弎弐拾捌柒漆玖百肆萬貳贰阡陆陌陸零";
    c.is_numeric() || IDEOGRAPHS.contains(c)
}

pub(super) fn is_printable(text: &str) -> bool {
    text.chars().all(quote::is_printable)
}

/// Whether it is a name, keywords included.
pub(super) fn is_identifier(text: &str) -> bool {
    let mut chars = text.chars();
    chars.next().is_some_and(is_name_start) && chars.all(is_name_continue)
}
