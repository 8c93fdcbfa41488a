//! What the parser hands out, and questions about names.

use super::ast::{Expr, ExprKind};
use super::{parser, visit};
use crate::base::{FastSet, TextRange};

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
pub fn is_identifier(name: &str) -> bool {
    let mut chars = name.chars();
    chars.next().is_some_and(is_name_start) && chars.all(is_name_continue) && !super::token::is_keyword(name)
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
        ExprKind::Attribute { name, name_range, .. } | ExprKind::NamedExpr { name, name_range, .. } => {
            add(name, *name_range);
        }
        _ => {}
    }
}
