//! Formatting: the mini-language of `format()`, `%`, `str.format` and f-strings.

mod float;
mod int;
mod percent;
mod spec;
mod template;
mod value;

pub(crate) use percent::percent;
#[cfg(test)]
pub(crate) use template::ascii;
pub(crate) use template::{fstring, str_format, str_format_map};
