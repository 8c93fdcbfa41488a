//! What may be assigned to, and how CPython calls what may not.

use super::Parser;
use crate::ast::{CompKind, Const, Expr, ExprKind};
use crate::report::ErrorStage;

impl Expr {
    /// CPython's noun for the expression in messages such as "cannot assign to …".
    pub(super) fn kind_name(&self) -> &'static str {
        match &self.kind {
            ExprKind::Name(_) | ExprKind::Missing => "name",
            ExprKind::Const(Const::None) => "None",
            ExprKind::Const(Const::Bool(true)) => "True",
            ExprKind::Const(Const::Bool(false)) => "False",
            ExprKind::Const(Const::Ellipsis) => "ellipsis",
            ExprKind::Const(_) => "literal",
            ExprKind::FString(_) => "f-string expression",
            ExprKind::Unary(..) | ExprKind::Binary(..) | ExprKind::And(_) | ExprKind::Or(_) => {
                "expression"
            }
            ExprKind::Compare(..) => "comparison",
            ExprKind::IfElse { .. } => "conditional expression",
            ExprKind::Lambda(_) => "lambda",
            ExprKind::List(_) => "list",
            ExprKind::Tuple(_) => "tuple",
            ExprKind::Set(_) => "set display",
            ExprKind::Dict(_) => "dict literal",
            ExprKind::Starred(_) => "starred",
            ExprKind::Comprehension(comp) => match comp.kind {
                CompKind::List => "list comprehension",
                CompKind::Set => "set comprehension",
                CompKind::Dict => "dict comprehension",
                CompKind::Generator => "generator expression",
            },
            ExprKind::Attribute { .. } => "attribute",
            ExprKind::Subscript { .. } | ExprKind::Slice { .. } => "subscript",
            ExprKind::Call { .. } => "function call",
            ExprKind::NamedExpr { .. } => "named expression",
        }
    }

    /// Whether CPython's grammar calls it a `bitwise_or` (parentheses around it are not considered).
    pub(super) fn is_bitwise_or(&self) -> bool {
        !matches!(
            self.kind,
            ExprKind::Compare(..)
                | ExprKind::And(_)
                | ExprKind::Or(_)
                | ExprKind::IfElse { .. }
                | ExprKind::Lambda(_)
                | ExprKind::Unary(crate::ast::UnaryOp::Not, _)
        )
    }

    /// Whether `x = y` inside brackets blames `x`; for some kinds CPython only says "invalid syntax".
    pub(super) fn may_be_blamed(&self) -> bool {
        match &self.kind {
            ExprKind::List(_)
            | ExprKind::Tuple(_)
            | ExprKind::Const(Const::None | Const::Bool(_)) => false,
            ExprKind::Comprehension(comp) => comp.kind != CompKind::Generator,
            _ => true,
        }
    }
}

impl Parser<'_> {
    /// Report what cannot be the target of a `for`.
    pub(super) fn check_target(&mut self, target: &Expr) {
        let Some(wrong) = invalid_target(target) else {
            return self.check_stars(target);
        };
        let what = wrong.kind_name();
        let message = format!("cannot assign to this {what} in `for`");
        self.error(wrong.range, message, &format!("cannot assign to {what}"));
    }

    /// Whether [`Parser::check_target`] would report something.
    pub(super) fn is_invalid_target(&self, target: &Expr) -> bool {
        invalid_target(target).is_some()
    }

    /// One list of targets has at most one `*`.
    fn check_stars(&mut self, target: &Expr) {
        let (ExprKind::List(items) | ExprKind::Tuple(items)) = &target.kind else {
            return;
        };
        let mut starred = items
            .iter()
            .filter(|item| matches!(item.kind, ExprKind::Starred(_)));
        if let Some(second) = starred.nth(1) {
            let reference = "multiple starred expressions in assignment";
            self.report.add(
                ErrorStage::Tree,
                second.range,
                "only one target can have a `*`",
                reference,
            );
        }
        items.iter().for_each(|item| self.check_stars(item));
    }
}

fn invalid_target(target: &Expr) -> Option<&Expr> {
    match &target.kind {
        ExprKind::List(items) | ExprKind::Tuple(items) => items.iter().find_map(invalid_target),
        ExprKind::Starred(inner) => invalid_target(inner),
        ExprKind::Name(_)
        | ExprKind::Attribute { .. }
        | ExprKind::Subscript { .. }
        | ExprKind::Missing => None,
        _ => Some(target),
    }
}
