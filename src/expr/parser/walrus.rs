//! Where `:=` may not stand although the grammar lets it.

use crate::ast::{Comprehension, Expr, ExprKind};
use crate::report::{ErrorStage, ExprErrors};
use crate::visit::{children, target_names};
use base::TextRange;

/// Report every `:=` that clashes with a comprehension around it.
pub(super) fn check(expr: &Expr, report: &mut ExprErrors<'_>) {
    Checker {
        report,
        scopes: Vec::new(),
        in_iterable: false,
    }
    .visit(expr);
}

/// The names of one comprehension, as far as it was read.
#[derive(Default)]
struct ComprehensionScope<'e> {
    targets: Vec<&'e str>,
    assigned: Vec<&'e str>,
}

struct Checker<'e, 'r, 't> {
    report: &'r mut ExprErrors<'t>,
    /// The comprehensions around, up to the next lambda.
    scopes: Vec<ComprehensionScope<'e>>,
    in_iterable: bool,
}

impl<'e> Checker<'e, '_, '_> {
    fn error(&mut self, range: TextRange, message: &str, reference: &str) {
        self.report.add(ErrorStage::Tree, range, message, reference);
    }

    fn visit(&mut self, expr: &'e Expr) {
        match &expr.kind {
            ExprKind::NamedExpr {
                name,
                name_range,
                value,
            } => {
                self.assignment(name, *name_range);
                self.visit(value);
            }
            ExprKind::Comprehension(comp) => self.comprehension(comp),
            ExprKind::Lambda(lambda) => {
                lambda
                    .params
                    .iter()
                    .filter_map(|p| p.default.as_ref())
                    .for_each(|d| self.visit(d));
                let outer = std::mem::take(&mut self.scopes);
                self.visit(&lambda.body);
                self.scopes = outer;
            }
            _ => children(expr, &mut |child| self.visit(child)),
        }
    }

    fn assignment(&mut self, name: &'e str, range: TextRange) {
        if self.in_iterable {
            let reference =
                "assignment expression cannot be used in a comprehension iterable expression";
            self.error(
                range,
                "`:=` is not allowed in the iterable of a comprehension",
                reference,
            );
        } else if self
            .scopes
            .iter()
            .any(|scope| scope.targets.contains(&name))
        {
            let reference = format!(
                "assignment expression cannot rebind comprehension iteration variable '{name}'"
            );
            let message = format!("cannot assign to `{name}`, the variable of a comprehension");
            self.error(range, &message, &reference);
        } else if let Some(scope) = self.scopes.last_mut() {
            scope.assigned.push(name);
        }
    }

    fn comprehension(&mut self, comp: &'e Comprehension) {
        let mut clauses = comp.clauses.iter();
        let Some(first) = clauses.next() else { return };
        self.iterable(&first.iter);
        self.scopes.push(ComprehensionScope::default());
        self.target(&first.target);
        first.conditions.iter().for_each(|c| self.visit(c));
        for clause in clauses {
            self.target(&clause.target);
            self.iterable(&clause.iter);
            clause.conditions.iter().for_each(|c| self.visit(c));
        }
        self.visit(&comp.element);
        comp.value.iter().for_each(|v| self.visit(v));
        self.scopes.pop();
    }

    fn iterable(&mut self, iter: &'e Expr) {
        let outer = std::mem::replace(&mut self.in_iterable, true);
        self.visit(iter);
        self.in_iterable = outer;
    }

    fn target(&mut self, target: &'e Expr) {
        let Some(scope) = self.scopes.last_mut() else {
            return;
        };
        let mut clash = None;
        target_names(target, &mut |name| {
            if scope.assigned.contains(&name.as_str()) {
                clash = Some(name);
            }
            scope.targets.push(name);
        });
        if let Some(name) = clash {
            let reference = format!(
                "comprehension inner loop cannot rebind assignment expression target '{name}'"
            );
            let message = format!("`{name}` is already assigned with `:=`");
            self.error(target.range, &message, &reference);
        }
    }
}
