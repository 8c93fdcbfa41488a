//! What the parser hands out, and questions about names.

use std::borrow::Cow;

use unicode_normalization::{UnicodeNormalization, is_nfkc};

use super::ast::{Expr, ExprKind};
use super::{parser, visit};
use base::{FastSet, TextRange};

/// A parsed expression: always a tree, and what is wrong with its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// The tree; holes in broken text are [`ExprKind::Missing`].
    pub expr: Expr,
    /// What is wrong; the first one is the error the reference stops at.
    pub errors: Vec<ExprError>,
}

/// Something wrong with the text of an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExprError {
    /// Our words for it.
    pub message: String,
    /// What CPython 3.11 prints; exact for the first error of an expression, a guess for later ones.
    pub reference: String,
    /// Where it is, in the text given to [`parse`].
    pub range: TextRange,
    /// What sort of error it is.
    pub kind: ExprErrorKind,
}

/// The sorts of [`ExprError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExprErrorKind {
    /// Not a Python expression.
    Syntax,
    /// A name or an attribute that starts with `__`.
    ForbiddenName,
    /// Python, but nothing that can be evaluated here.
    NotSupported,
}

/// Parse one Python expression (the grammar of CPython 3.11, `eval` mode).
///
/// Blanks around it are ignored as `str.strip()` does; ranges refer to `text` as given.
/// Never fails: broken text gives a tree with holes.
pub fn parse(text: &str) -> Parsed {
    parser::parse(text)
}

/// Whether `c` is white space for Python's `str.strip()`.
pub fn is_python_space(c: char) -> bool {
    c.is_whitespace() || ('\x1c'..='\x1f').contains(&c)
}

/// Whether `name` is a Python identifier and not a keyword: what a property may be called.
///
/// Python compares identifiers in their NFKC form, so a name of another form can never be looked up.
pub fn is_identifier(name: &str) -> bool {
    let mut chars = name.chars();
    chars.next().is_some_and(is_name_start)
        && chars.all(is_name_continue)
        && !super::token::is_keyword(name)
        && normalized(name) == name
}

/// The NFKC form of a name: the one under which Python looks it up.
pub fn normalized(name: &str) -> Cow<'_, str> {
    if name.is_ascii() || is_nfkc(name) {
        Cow::Borrowed(name)
    } else {
        Cow::Owned(name.nfkc().collect())
    }
}

/// Whether an identifier may start with `c`.
pub(super) fn is_name_start(c: char) -> bool {
    c == '_' || unicode_ident::is_xid_start(c)
}

/// Whether an identifier may go on with `c`.
pub(super) fn is_name_continue(c: char) -> bool {
    unicode_ident::is_xid_continue(c)
}

/// A name that an expression takes from its surroundings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NameUse<'e> {
    /// The name.
    pub name: &'e str,
    /// Where it stands.
    pub range: TextRange,
}

/// The free names of an expression in the order of evaluation: without parameters of lambdas,
/// targets of comprehensions and what `:=` binds before.
pub fn names(expr: &Expr) -> Vec<NameUse<'_>> {
    let mut found = Vec::new();
    visit::free_names(expr, &mut found);
    found
}

/// The names and attributes that start with `__`, each once, in the order of evaluation.
pub(super) fn forbidden_names(expr: &Expr) -> Vec<(&str, TextRange)> {
    let mut found = Vec::new();
    let mut seen = FastSet::default();
    collect_forbidden(expr, &mut |name, range| {
        if name.starts_with("__") && seen.insert(name) {
            found.push((name, range));
        }
    });
    found
}

fn collect_forbidden<'e>(expr: &'e Expr, add: &mut dyn FnMut(&'e str, TextRange)) {
    visit::children(expr, &mut |child| collect_forbidden(child, add));
    match &expr.kind {
        ExprKind::Name(name) => add(name, expr.range),
        ExprKind::Attribute {
            name, name_range, ..
        }
        | ExprKind::NamedExpr {
            name, name_range, ..
        } => {
            add(name, *name_range);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers() {
        for name in [
            "a", "_", "_1", "été", "名", "match", "case", "type", "print", "__x", "grö", "a٣",
        ] {
            assert!(is_identifier(name), "{name}");
        }
        for name in [
            "",
            "1a",
            "a-b",
            "a.b",
            "a b",
            " a",
            "True",
            "None",
            "if",
            "lambda",
            "async",
            "€",
            "a²",
            "ᵃ",
            "gro\u{308}",
        ] {
            assert!(!is_identifier(name), "{name}");
        }
    }

    fn free(text: &str) -> String {
        let parsed = parse(text);
        let found = names(&parsed.expr);
        for name in &found {
            assert_eq!(name.range.slice(text), name.name);
        }
        found.iter().map(|n| n.name).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn free_names() {
        for (text, want) in [
            ("a + b.c * f(d, k=e)", "a b f d e"),
            ("a if b else c", "b a c"),
            ("lambda x, y=z: x + y + w", "z w"),
            ("(lambda x: x)(x)", "x"),
            ("[x for x in x]", "x"),
            ("[x + y for x in a if x > b for z in x if z]", "a b y"),
            ("{k: v for k, (v, *w) in d.items() if w}", "d"),
            ("[i for a[i] in b]", "b a i i"),
            ("[(lambda q: q + i)(j) for i in r]", "r j"),
            ("[y := a, y]", "a"),
            ("f'{a:{b}} {[c for c in d]}'", "a b d"),
            ("a + ", "a"),
            ("'a'", ""),
        ] {
            assert_eq!(free(text), want, "{text}");
        }
    }

    /// Order and number are those of `co_names`, which also holds for lambdas and comprehensions with us.
    #[test]
    fn forbidden_names_are_listed_once() {
        for (text, want) in [
            ("__a", "__a"),
            ("a.__class__", "__class__"),
            ("__b + __a + __b", "__b, __a"),
            ("__x.__y", "__x, __y"),
            ("__f(__a.__b, k=__c)", "__f, __a, __b, __c"),
            ("__a if __t else __b", "__t, __a, __b"),
            ("lambda: ''.__class__", "__class__"),
            ("[__x.__y for i in __z]", "__z, __x, __y"),
            ("f'{__a}'", "__a"),
            ("(__a := 1)", "__a"),
        ] {
            let [error] = &*parse(text).errors else {
                panic!("{text}")
            };
            assert_eq!(error.kind, ExprErrorKind::ForbiddenName);
            assert_eq!(
                error.reference,
                format!("Use of invalid name(s):  {want}"),
                "{text}"
            );
        }
        for text in ["'__a'", "f(__k=1)", "a__b", "_a", "a._b"] {
            assert_eq!(parse(text).errors, [], "{text}");
        }
        // A broken expression comes first.
        let errors = parse("__a +").errors;
        assert_eq!(errors.first().map(|e| e.kind), Some(ExprErrorKind::Syntax));
    }
}
