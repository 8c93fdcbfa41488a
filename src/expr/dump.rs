//! Trees as text, in the format of `tests/oracle/expr_table.py`.

use std::fmt::Write;

use super::ast::*;
use base::TextRange;

/// The tree of `expr`, and the ranges of its nodes in the same order.
pub(super) fn dump(expr: &Expr) -> (String, Vec<TextRange>) {
    let mut dumper = Dumper::default();
    dumper.node(expr);
    (dumper.out, dumper.ranges)
}

#[derive(Default)]
struct Dumper {
    out: String,
    ranges: Vec<TextRange>,
}

impl Dumper {
    fn put(&mut self, text: &str) {
        self.out.push_str(text);
    }

    fn all<'e>(&mut self, head: &str, nodes: impl IntoIterator<Item = &'e Expr>) {
        self.put(head);
        for node in nodes {
            self.put(" ");
            self.node(node);
        }
        self.put(")");
    }

    fn node(&mut self, expr: &Expr) {
        if !matches!(expr.kind, ExprKind::FString(_)) {
            self.ranges.push(expr.range);
        }
        match &expr.kind {
            ExprKind::Name(name) => self.put(name),
            ExprKind::Const(value) => self.constant(value),
            ExprKind::FString(parts) => {
                self.put("(f");
                self.parts(parts);
                self.put(")");
            }
            ExprKind::Unary(op, value) => {
                let op = match op {
                    UnaryOp::Neg => "(neg",
                    UnaryOp::Pos => "(pos",
                    UnaryOp::Invert => "(~",
                    UnaryOp::Not => "(not",
                };
                self.all(op, [&**value]);
            }
            ExprKind::Binary(op, left, right) => self.all(binary(*op), [&**left, &**right]),
            ExprKind::And(items) => self.all("(and", items),
            ExprKind::Or(items) => self.all("(or", items),
            ExprKind::Compare(first, rest) => {
                self.put("(cmp ");
                self.node(first);
                for (op, right) in rest {
                    let _ = write!(self.out, " {} ", compare(*op));
                    self.node(right);
                }
                self.put(")");
            }
            ExprKind::IfElse { test, body, orelse } => self.all("(if", [&**test, body, orelse]),
            ExprKind::Lambda(lambda) => self.lambda(lambda),
            ExprKind::List(items) => self.all("(list", items),
            ExprKind::Tuple(items) => self.all("(tuple", items),
            ExprKind::Set(items) => self.all("(set", items),
            ExprKind::Dict(pairs) => self.dict(pairs),
            ExprKind::Starred(value) => self.all("(*", [&**value]),
            ExprKind::Comprehension(comp) => self.comprehension(comp),
            ExprKind::Attribute { value, name, .. } => {
                self.put("(. ");
                self.node(value);
                let _ = write!(self.out, " {name})");
            }
            ExprKind::Subscript { value, index } => self.all("(index", [&**value, index]),
            ExprKind::Slice { lower, upper, step } => self.slice([lower, upper, step]),
            ExprKind::Call {
                func,
                args,
                keywords,
            } => self.call(func, args, keywords),
            ExprKind::NamedExpr { name, value, .. } => {
                let _ = write!(self.out, "(:= {name} ");
                self.node(value);
                self.put(")");
            }
            ExprKind::Missing => self.put("?"),
        }
    }

    fn constant(&mut self, value: &Const) {
        let _ = match value {
            Const::None => write!(self.out, "#None"),
            Const::Ellipsis => write!(self.out, "#Ellipsis"),
            Const::Bool(true) => write!(self.out, "#True"),
            Const::Bool(false) => write!(self.out, "#False"),
            Const::Int(value) => write!(self.out, "{value}"),
            Const::Big(value) => write!(self.out, "{value}"),
            Const::Float(value) => write!(self.out, "(float {:016x})", value.to_bits()),
            Const::Imaginary(value) => write!(self.out, "(imag {:016x})", value.to_bits()),
            Const::Str(value) => write!(self.out, "{}", quoted(value)),
            Const::Bytes(value) => {
                let hex: String = value.iter().map(|b| format!("{b:02x}")).collect();
                write!(self.out, "(bytes {hex})")
            }
        };
    }

    fn parts(&mut self, parts: &[FPart]) {
        for part in parts {
            self.put(" ");
            match part {
                FPart::Text(text) => self.put(&quoted(text)),
                FPart::Field {
                    value,
                    conversion,
                    spec,
                    debug,
                } => {
                    // CPython makes text of the `value=` in front of a field.
                    if let Some(debug) = debug {
                        let _ = write!(self.out, "{} ", quoted(debug));
                    }
                    self.put("{");
                    self.node(value);
                    if let Some(conversion) = conversion {
                        let _ = write!(self.out, " !{conversion}");
                    }
                    self.parts(spec);
                    self.put("}");
                }
            }
        }
    }

    fn lambda(&mut self, lambda: &Lambda) {
        self.put("(lambda (");
        for (i, param) in lambda.params.iter().enumerate() {
            let kind = match param.kind {
                ParamKind::PositionalOnly => "pos",
                ParamKind::Normal => "arg",
                ParamKind::VarArgs => "star",
                ParamKind::KeywordOnly => "kw",
                ParamKind::VarKeywords => "stars",
            };
            let _ = write!(
                self.out,
                "{}{kind}:{}",
                if i == 0 { "" } else { " " },
                param.name
            );
            if let Some(default) = &param.default {
                self.put("=");
                self.node(default);
            }
        }
        self.put(") ");
        self.node(&lambda.body);
        self.put(")");
    }

    fn dict(&mut self, pairs: &[(Option<Expr>, Expr)]) {
        self.put("(dict");
        for (key, value) in pairs {
            self.put(" ");
            match key {
                Some(key) => self.node(key),
                None => self.put("**"),
            }
            self.put(" ");
            self.node(value);
        }
        self.put(")");
    }

    fn comprehension(&mut self, comp: &Comprehension) {
        self.put(match comp.kind {
            CompKind::List => "(list-comp ",
            CompKind::Set => "(set-comp ",
            CompKind::Dict => "(dict-comp ",
            CompKind::Generator => "(gen-comp ",
        });
        self.node(&comp.element);
        if let Some(value) = &comp.value {
            self.put(" ");
            self.node(value);
        }
        for clause in &comp.clauses {
            self.put(" for ");
            self.node(&clause.target);
            self.put(" ");
            self.node(&clause.iter);
            for condition in &clause.conditions {
                self.put(" if ");
                self.node(condition);
            }
        }
        self.put(")");
    }

    fn slice(&mut self, bounds: [&Option<Box<Expr>>; 3]) {
        self.put("(slice");
        for bound in bounds {
            self.put(" ");
            match bound {
                Some(bound) => self.node(bound),
                None => self.put("_"),
            }
        }
        self.put(")");
    }

    fn call(&mut self, func: &Expr, args: &[Expr], keywords: &[Keyword]) {
        self.put("(call ");
        self.node(func);
        for arg in args {
            self.put(" ");
            self.node(arg);
        }
        for keyword in keywords {
            let _ = match &keyword.name {
                Some(name) => write!(self.out, " {name}="),
                None => write!(self.out, " **"),
            };
            self.node(&keyword.value);
        }
        self.put(")");
    }
}

fn quoted(text: &str) -> String {
    serde_json::to_string(text).unwrap()
}

fn binary(op: BinOp) -> &'static str {
    match op {
        BinOp::Add => "(+",
        BinOp::Sub => "(-",
        BinOp::Mul => "(*",
        BinOp::MatMul => "(@",
        BinOp::Div => "(/",
        BinOp::FloorDiv => "(//",
        BinOp::Mod => "(%",
        BinOp::Pow => "(**",
        BinOp::LShift => "(<<",
        BinOp::RShift => "(>>",
        BinOp::BitAnd => "(&",
        BinOp::BitOr => "(|",
        BinOp::BitXor => "(^",
    }
}

fn compare(op: CmpOp) -> &'static str {
    match op {
        CmpOp::Eq => "==",
        CmpOp::Ne => "!=",
        CmpOp::Lt => "<",
        CmpOp::Le => "<=",
        CmpOp::Gt => ">",
        CmpOp::Ge => ">=",
        CmpOp::In => "in",
        CmpOp::NotIn => "not-in",
        CmpOp::Is => "is",
        CmpOp::IsNot => "is-not",
    }
}
