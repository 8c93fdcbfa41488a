//! Walking an expression tree in the order Python evaluates it.

use ecow::EcoString;

use super::ast::{Comprehension, Expr, ExprKind, FPart, Lambda};
use super::syntax::NameUse;

/// Call `f` for each direct child of `expr`, in the order of evaluation.
pub fn children<'e>(expr: &'e Expr, f: &mut dyn FnMut(&'e Expr)) {
    match &expr.kind {
        ExprKind::Name(_) | ExprKind::Const(_) | ExprKind::Missing => {}
        ExprKind::FString(parts) => fields(parts, f),
        ExprKind::Unary(_, value) | ExprKind::Starred(value) => f(value),
        ExprKind::Attribute { value, .. } | ExprKind::NamedExpr { value, .. } => f(value),
        ExprKind::Binary(_, left, right) => {
            f(left);
            f(right);
        }
        ExprKind::And(items)
        | ExprKind::Or(items)
        | ExprKind::List(items)
        | ExprKind::Tuple(items)
        | ExprKind::Set(items) => items.iter().for_each(f),
        ExprKind::Compare(first, rest) => {
            f(first);
            rest.iter().for_each(|(_, right)| f(right));
        }
        ExprKind::IfElse { test, body, orelse } => {
            f(test);
            f(body);
            f(orelse);
        }
        ExprKind::Lambda(lambda) => {
            lambda
                .params
                .iter()
                .filter_map(|p| p.default.as_ref())
                .for_each(&mut *f);
            f(&lambda.body);
        }
        ExprKind::Dict(pairs) => pairs.iter().for_each(|(key, value)| {
            key.iter().for_each(&mut *f);
            f(value);
        }),
        ExprKind::Comprehension(comp) => comprehension(comp, f),
        ExprKind::Subscript { value, index } => {
            f(value);
            f(index);
        }
        ExprKind::Slice { lower, upper, step } => {
            [lower, upper, step]
                .into_iter()
                .flatten()
                .for_each(|bound| f(bound));
        }
        ExprKind::Call {
            func,
            args,
            keywords,
        } => {
            f(func);
            args.iter().for_each(&mut *f);
            keywords.iter().for_each(|k| f(&k.value));
        }
    }
}

fn fields<'e>(parts: &'e [FPart], f: &mut dyn FnMut(&'e Expr)) {
    for part in parts {
        if let FPart::Field { value, spec, .. } = part {
            f(value);
            fields(spec, f);
        }
    }
}

fn comprehension<'e>(comp: &'e Comprehension, f: &mut dyn FnMut(&'e Expr)) {
    for clause in &comp.clauses {
        f(&clause.iter);
        f(&clause.target);
        clause.conditions.iter().for_each(&mut *f);
    }
    f(&comp.element);
    comp.value.iter().for_each(f);
}

/// Collect the names that `expr` does not bind itself.
pub(super) fn free_names<'e>(expr: &'e Expr, found: &mut Vec<NameUse<'e>>) {
    BoundNames {
        bound: Vec::new(),
        found,
    }
    .visit(expr);
}

/// The names bound so far, innermost last; a scope ends by truncating to its mark.
struct BoundNames<'e, 'f> {
    bound: Vec<&'e str>,
    found: &'f mut Vec<NameUse<'e>>,
}

impl<'e> BoundNames<'e, '_> {
    fn visit(&mut self, expr: &'e Expr) {
        match &expr.kind {
            ExprKind::Name(name) => {
                if !self.bound.contains(&name.as_str()) {
                    self.found.push(NameUse {
                        name,
                        range: expr.range,
                    });
                }
            }
            ExprKind::Lambda(lambda) => self.lambda(lambda),
            ExprKind::Comprehension(comp) => self.comprehension(comp),
            ExprKind::NamedExpr { name, value, .. } => {
                self.visit(value);
                self.bound.push(name);
            }
            _ => children(expr, &mut |child| self.visit(child)),
        }
    }

    fn lambda(&mut self, lambda: &'e Lambda) {
        lambda
            .params
            .iter()
            .filter_map(|p| p.default.as_ref())
            .for_each(|d| self.visit(d));
        let mark = self.bound.len();
        self.bound.extend(
            lambda
                .params
                .iter()
                .map(|p| p.name.as_str())
                .filter(|n| !n.is_empty()),
        );
        self.visit(&lambda.body);
        self.bound.truncate(mark);
    }

    /// The first iterable is evaluated outside; every target is local to the whole comprehension.
    fn comprehension(&mut self, comp: &'e Comprehension) {
        let mut iters = comp.clauses.iter().map(|c| &c.iter);
        iters.next().into_iter().for_each(|first| self.visit(first));
        let mark = self.bound.len();
        comp.clauses
            .iter()
            .for_each(|c| self.bind_target(&c.target));
        for (i, clause) in comp.clauses.iter().enumerate() {
            if i > 0 {
                self.visit(&clause.iter);
            }
            self.visit_target(&clause.target);
            clause.conditions.iter().for_each(|c| self.visit(c));
        }
        self.visit(&comp.element);
        comp.value.iter().for_each(|v| self.visit(v));
        self.bound.truncate(mark);
    }

    fn bind_target(&mut self, target: &'e Expr) {
        target_names(target, &mut |name| self.bound.push(name));
    }

    /// Names used inside a target such as `a[i]`; plain targets are bound, not used.
    fn visit_target(&mut self, target: &'e Expr) {
        match &target.kind {
            ExprKind::Name(_) => {}
            ExprKind::Tuple(items) | ExprKind::List(items) => {
                items.iter().for_each(|t| self.visit_target(t))
            }
            ExprKind::Starred(inner) => self.visit_target(inner),
            _ => self.visit(target),
        }
    }
}

/// The names an assignment to `target` binds.
pub(super) fn target_names<'e>(target: &'e Expr, f: &mut dyn FnMut(&'e EcoString)) {
    match &target.kind {
        ExprKind::Name(name) => f(name),
        ExprKind::Tuple(items) | ExprKind::List(items) => {
            items.iter().for_each(|t| target_names(t, f))
        }
        ExprKind::Starred(inner) => target_names(inner, f),
        _ => {}
    }
}
