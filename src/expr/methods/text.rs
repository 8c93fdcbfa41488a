//! Methods of strings: the table.

use super::{
    methods, optional, text_case as case, text_layout as layout, text_search as search,
    text_split as split, up_to,
};
use crate::args::Arity::{Any, One, Zero};
use crate::builtins::Function;
use crate::format;
use crate::value::Value;

/// Sorted by name.
pub(super) static METHODS: &[Function] = methods! { "str":
    "capitalize" Zero => |i, s, _| case::mapped(i, s, case::capitalize),
    "casefold" Zero => |i, s, _| case::mapped(i, s, case::casefold),
    "center" up_to(1, 2) => |i, s, a| layout::pad(i, s, a, layout::PaddingSide::Both),
    "count" Any => search::count,
    "encode" optional(&["encoding", "errors"]) => super::bytes::encode,
    "endswith" Any => |_, s, a| search::at_end(s, a, false),
    "expandtabs" optional(&["tabsize"]) => layout::expand_tabs,
    "find" Any => |i, s, a| search::find(i, s, a, "find"),
    "format" Any => format::str_format,
    "format_map" One => format::str_format_map,
    "index" Any => |i, s, a| search::find(i, s, a, "index"),
    "isalnum" Zero => |_, s, _| case::all(s, |c| case::is_alpha(c) || c.is_numeric()),
    "isalpha" Zero => |_, s, _| case::all(s, case::is_alpha),
    "isascii" Zero => |_, s, _| Ok(Value::Bool(s.as_str().is_some_and(str::is_ascii))),
    "isdecimal" Zero => |_, s, _| case::all(s, |c| crate::numeric::decimal_digit(c).is_some()),
    "isdigit" Zero => |_, s, _| case::all(s, case::is_digit),
    "isidentifier" Zero => |_, s, _| Ok(Value::Bool(s.as_str().is_some_and(case::is_identifier))),
    "islower" Zero => |_, s, _| case::uniform(s, char::is_lowercase, |c| c.is_uppercase() || case::is_title(c)),
    "isnumeric" Zero => |_, s, _| case::all(s, case::is_numeric),
    "isprintable" Zero => |_, s, _| Ok(Value::Bool(s.as_str().is_some_and(case::is_printable))),
    "isspace" Zero => |_, s, _| case::all(s, crate::numeric::is_space),
    "istitle" Zero => |_, s, _| Ok(Value::Bool(s.as_str().is_some_and(case::is_titlecased))),
    "isupper" Zero => |_, s, _| case::uniform(s, char::is_uppercase, |c| c.is_lowercase() || case::is_title(c)),
    "join" One => split::join,
    "ljust" up_to(1, 2) => |i, s, a| layout::pad(i, s, a, layout::PaddingSide::Right),
    "lower" Zero => |i, s, _| case::mapped(i, s, case::lower),
    "lstrip" up_to(0, 1) => |_, s, a| layout::strip(s, a, "lstrip"),
    "partition" One => |_, s, a| split::partition(s, a, false),
    "removeprefix" One => |_, s, a| layout::remove(s, a, true),
    "removesuffix" One => |_, s, a| layout::remove(s, a, false),
    "replace" up_to(2, 3) => search::replace,
    "rfind" Any => |i, s, a| search::find(i, s, a, "rfind"),
    "rindex" Any => |i, s, a| search::find(i, s, a, "rindex"),
    "rjust" up_to(1, 2) => |i, s, a| layout::pad(i, s, a, layout::PaddingSide::Left),
    "rpartition" One => |_, s, a| split::partition(s, a, true),
    "rsplit" optional(&["sep", "maxsplit"]) => |i, s, a| split::split(i, s, a, true),
    "rstrip" up_to(0, 1) => |_, s, a| layout::strip(s, a, "rstrip"),
    "split" optional(&["sep", "maxsplit"]) => |i, s, a| split::split(i, s, a, false),
    "splitlines" optional(&["keepends"]) => split::lines,
    "startswith" Any => |_, s, a| search::at_end(s, a, true),
    "strip" up_to(0, 1) => |_, s, a| layout::strip(s, a, "strip"),
    "swapcase" Zero => |i, s, _| case::mapped(i, s, case::swapcase),
    "title" Zero => |i, s, _| case::mapped(i, s, case::title),
    "translate" One => layout::translate,
    "upper" Zero => |i, s, _| case::mapped(i, s, |text| text.to_uppercase()),
    "zfill" One => layout::zfill,
};

/// Functions on the type.
pub(super) static CLASS: &[Function] = methods! { "str":
    "maketrans" up_to(1, 3) => layout::make_translation,
};
