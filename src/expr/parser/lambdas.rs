//! Lambdas and their parameters.

use std::sync::Arc;

use super::Parser;
use crate::ast::{Expr, ExprKind, Lambda, Param, ParamKind};
use crate::report::ErrorStage;
use crate::token::{Bracket, Tok};
use base::{FastSet, TextRange};

/// How far the parameter list has got.
#[derive(Default)]
struct LambdaParams {
    params: Vec<Param>,
    slash: bool,
    star: bool,
    double_star: bool,
    defaults: bool,
}

impl Parser<'_> {
    /// `lambda params: body`
    pub(super) fn lambda(&mut self) -> Expr {
        let start = self.bump().range.start;
        let mut list = LambdaParams::default();
        while !self.at(Tok::Colon) && !self.at_close() {
            let before = self.pos;
            self.parameter(&mut list);
            if !self.eat(Tok::Comma) && !self.at(Tok::Colon) {
                if !self.at_close() || matches!(self.kind(), Tok::Newline) {
                    self.unexpected("expected `,` or `:`");
                }
                if self.pos == before
                    || !matches!(self.kind(), Tok::Name | Tok::Star | Tok::DoubleStar)
                {
                    break;
                }
            }
        }
        self.check_duplicates(&list.params);
        let body = if self.eat(Tok::Colon) {
            self.expression()
        } else {
            self.hole("`:` with a value")
        };
        self.grow();
        let range = self.range_from(start);
        Expr {
            kind: ExprKind::Lambda(Arc::new(Lambda {
                params: list.params,
                body,
            })),
            range,
        }
    }

    fn parameter(&mut self, list: &mut LambdaParams) {
        match self.kind() {
            Tok::Slash => self.slash(list),
            Tok::Star => self.star(list),
            Tok::DoubleStar => {
                self.bump();
                self.after_double_star(list);
                let name = self.parameter_name();
                self.no_default("var-keyword");
                list.double_star = true;
                list.params.push(Param {
                    name,
                    kind: ParamKind::VarKeywords,
                    default: None,
                });
            }
            Tok::Open(Bracket::Round) => {
                let range = self.token().range;
                let reference = if self.skip_names() {
                    "Lambda expression parameters cannot be parenthesized"
                } else {
                    "invalid syntax"
                };
                self.error(range, "parameters must not be in parentheses", reference);
            }
            _ => self.plain_parameter(list),
        }
    }

    /// Skip a bracket; true if it held nothing but names.
    fn skip_names(&mut self) -> bool {
        let start = self.pos + 1;
        self.skip();
        let names = (start..self.pos.saturating_sub(1))
            .step_by(2)
            .all(|i| self.token_at(i).kind == Tok::Name);
        let commas = (start + 1..self.pos.saturating_sub(1))
            .step_by(2)
            .all(|i| self.token_at(i).kind == Tok::Comma);
        names && commas && self.pos > start + 1
    }

    fn plain_parameter(&mut self, list: &mut LambdaParams) {
        self.after_double_star(list);
        let at = self.token().range;
        let name = self.parameter_name();
        let default = self.eat(Tok::Equal).then(|| self.default_value());
        let kind = if list.star {
            ParamKind::KeywordOnly
        } else {
            ParamKind::Normal
        };
        if kind == ParamKind::Normal && default.is_none() && list.defaults {
            let reference = "non-default argument follows default argument";
            self.error(
                at,
                "a parameter without a default follows one with a default",
                reference,
            );
        }
        list.defaults |= default.is_some();
        list.params.push(Param {
            name,
            kind,
            default,
        });
    }

    fn default_value(&mut self) -> Expr {
        if matches!(self.kind(), Tok::Comma | Tok::Close(Bracket::Round)) {
            let range = self.gap();
            self.error(
                range,
                "expected a default value",
                "expected default value expression",
            );
            return self.missing();
        }
        self.expression()
    }

    fn parameter_name(&mut self) -> ecow::EcoString {
        if self.at(Tok::Name) {
            let name = self.bump().range;
            self.identifier(name)
        } else {
            self.hole("the name of a parameter");
            ecow::EcoString::new()
        }
    }

    /// `/`: all parameters before it go by place only.
    fn slash(&mut self, list: &mut LambdaParams) {
        self.after_double_star(list);
        let at = self.bump().range;
        let problem = if list.slash {
            Some("/ may appear only once")
        } else if list.star {
            Some("/ must be ahead of *")
        } else if list.params.is_empty() {
            Some(if self.at(Tok::Comma) {
                "at least one argument must precede /"
            } else {
                "invalid syntax"
            })
        } else {
            None
        };
        if let Some(reference) = problem {
            self.error(at, "unexpected `/`", reference);
        }
        if std::mem::replace(&mut list.slash, true) {
            return;
        }
        for param in list
            .params
            .iter_mut()
            .filter(|p| p.kind == ParamKind::Normal)
        {
            param.kind = ParamKind::PositionalOnly;
        }
    }

    /// `*args`, or the bare `*` in front of keyword-only parameters.
    fn star(&mut self, list: &mut LambdaParams) {
        let at = self.bump().range;
        self.after_double_star(list);
        if list.star {
            self.error(
                at,
                "`*` is allowed only once",
                "* argument may appear only once",
            );
        }
        list.star = true;
        let name = if self.at(Tok::Name) {
            let name = self.bump().range;
            let name = self.identifier(name);
            self.no_default("var-positional");
            name
        } else {
            let last = self.at(Tok::Colon)
                || (self.at(Tok::Comma)
                    && matches!(self.next_kind(), Tok::Colon | Tok::DoubleStar));
            if last {
                self.error(
                    at,
                    "expected a parameter after `*`",
                    "named arguments must follow bare *",
                );
            } else if !self.at(Tok::Comma) {
                self.hole("the name of a parameter");
            }
            ecow::EcoString::new()
        };
        list.params.push(Param {
            name,
            kind: ParamKind::VarArgs,
            default: None,
        });
    }

    fn no_default(&mut self, kind: &str) {
        if self.at(Tok::Equal) {
            let at = self.bump().range;
            let reference = format!("{kind} argument cannot have default value");
            self.error(at, "this parameter must not have a default", &reference);
            self.expression();
        }
    }

    fn after_double_star(&mut self, list: &LambdaParams) {
        if list.double_star
            && matches!(
                self.kind(),
                Tok::Name | Tok::Star | Tok::DoubleStar | Tok::Slash
            )
        {
            let reference = "arguments cannot follow var-keyword argument";
            self.error(
                self.token().range,
                "parameters are not allowed after `**`",
                reference,
            );
        }
    }

    fn check_duplicates(&mut self, params: &[Param]) {
        let mut seen = FastSet::default();
        for param in params.iter().filter(|p| !p.name.is_empty()) {
            if !seen.insert(&param.name) {
                let reference =
                    format!("duplicate argument '{}' in function definition", param.name);
                let message = format!("duplicate parameter `{}`", param.name);
                self.report.add(
                    ErrorStage::Tree,
                    TextRange::empty(self.prev_end),
                    message,
                    &reference,
                );
            }
        }
    }
}
