//! The tree of one Python expression, as xacro allows it between `${` and `}`.
//!
//! Ranges are byte offsets in the text handed to the parser (the text between the braces).

use std::sync::Arc;

use ecow::EcoString;
use num_bigint::BigInt;

use base::TextRange;

/// A node of the expression tree and the text it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands, without surrounding blanks or parentheses.
    pub range: TextRange,
}

/// The kinds of expression nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `name`
    Name(EcoString),
    /// A literal; adjacent string literals are one.
    Const(Const),
    /// An f-string: text and replacement fields in order.
    FString(Vec<FPart>),
    /// `-x`, `+x`, `~x`, `not x`
    Unary(UnaryOp, Box<Expr>),
    /// `a + b` and the other arithmetic, shift and bit operators
    Binary(BinOp, Box<Expr>, Box<Expr>),
    /// `a and b and c`
    And(Vec<Expr>),
    /// `a or b or c`
    Or(Vec<Expr>),
    /// `a < b <= c`
    Compare(Box<Expr>, Vec<(CmpOp, Expr)>),
    /// `body if test else orelse`
    IfElse {
        /// The condition.
        test: Box<Expr>,
        /// Its value when true.
        body: Box<Expr>,
        /// Its value when false.
        orelse: Box<Expr>,
    },
    /// `lambda params: body`
    Lambda(Arc<Lambda>),
    /// `[a, b]`
    List(Vec<Expr>),
    /// `(a, b)` or `a, b`
    Tuple(Vec<Expr>),
    /// `{a, b}`
    Set(Vec<Expr>),
    /// `{a: b, **c}`; no key for `**c`
    Dict(Vec<(Option<Expr>, Expr)>),
    /// `*x` inside a call, list, tuple or set
    Starred(Box<Expr>),
    /// `[x for x in y]` and its set, dict and generator forms
    Comprehension(Arc<Comprehension>),
    /// `value.name`
    Attribute {
        /// The object.
        value: Box<Expr>,
        /// The attribute.
        name: EcoString,
        /// Where the attribute's name stands.
        name_range: TextRange,
    },
    /// `value[index]`; the index may be a [`ExprKind::Slice`] or a tuple of them
    Subscript {
        /// The object.
        value: Box<Expr>,
        /// The index.
        index: Box<Expr>,
    },
    /// `lower:upper:step` inside a subscript
    Slice {
        /// First index.
        lower: Option<Box<Expr>>,
        /// Index behind the last.
        upper: Option<Box<Expr>>,
        /// Step.
        step: Option<Box<Expr>>,
    },
    /// `func(args, name=value, **mapping)`
    Call {
        /// What is called.
        func: Box<Expr>,
        /// Positional arguments, `*x` among them as [`ExprKind::Starred`].
        args: Vec<Expr>,
        /// Keyword arguments.
        keywords: Vec<Keyword>,
    },
    /// `name := value`
    NamedExpr {
        /// The name bound.
        name: EcoString,
        /// Where it stands.
        name_range: TextRange,
        /// The value.
        value: Box<Expr>,
    },
    /// A hole in half-typed text; the parser reported an error there.
    Missing,
}

/// A literal.
#[derive(Clone, Debug, PartialEq)]
pub enum Const {
    /// `None`
    None,
    /// `...`
    Ellipsis,
    /// `True`, `False`
    Bool(bool),
    /// An integer that fits.
    Int(i64),
    /// An integer that does not.
    Big(BigInt),
    /// `1.5`
    Float(f64),
    /// `2j`
    Imaginary(f64),
    /// `'text'`
    Str(EcoString),
    /// `b'bytes'`
    Bytes(Vec<u8>),
}

/// A part of an f-string.
#[derive(Clone, Debug, PartialEq)]
pub enum FPart {
    /// Verbatim text.
    Text(EcoString),
    /// `{value!conversion:spec}`
    Field {
        /// The value.
        value: Box<Expr>,
        /// `r`, `s` or `a` after `!`.
        conversion: Option<char>,
        /// The format specification, itself an f-string.
        spec: Vec<FPart>,
        /// The text of `value=` in the debugging form.
        debug: Option<EcoString>,
    },
}

/// Unary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum UnaryOp {
    Neg,
    Pos,
    Invert,
    Not,
}

/// Binary operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum BinOp {
    Add,
    Sub,
    Mul,
    MatMul,
    Div,
    FloorDiv,
    Mod,
    Pow,
    LShift,
    RShift,
    BitAnd,
    BitOr,
    BitXor,
}

/// Comparison operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum CmpOp {
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    In,
    NotIn,
    Is,
    IsNot,
}

/// A function literal.
#[derive(Clone, Debug, PartialEq)]
pub struct Lambda {
    /// Its parameters in order.
    pub params: Vec<Param>,
    /// What it returns.
    pub body: Expr,
}

/// A parameter of a lambda.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name; empty for a bare `*`.
    pub name: EcoString,
    /// How arguments bind to it.
    pub kind: ParamKind,
    /// Its default value.
    pub default: Option<Expr>,
}

/// How arguments bind to a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParamKind {
    /// Before a `/`.
    PositionalOnly,
    /// By place or by name.
    Normal,
    /// `*args`, or the bare `*`.
    VarArgs,
    /// Behind `*`.
    KeywordOnly,
    /// `**kwargs`
    VarKeywords,
}

/// A keyword argument of a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Keyword {
    /// `name` in `name=value`; none for `**mapping`.
    pub name: Option<EcoString>,
    /// Where the name, or the `**`, stands.
    pub name_range: TextRange,
    /// The value.
    pub value: Expr,
}

/// A comprehension or generator expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Comprehension {
    /// Which brackets.
    pub kind: CompKind,
    /// The element, or the key of a dict comprehension.
    pub element: Expr,
    /// The value of a dict comprehension.
    pub value: Option<Expr>,
    /// `for target in iter if cond ...`, outermost first.
    pub clauses: Vec<CompFor>,
}

/// The kinds of comprehensions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum CompKind {
    List,
    Set,
    Dict,
    Generator,
}

/// One `for` of a comprehension.
#[derive(Clone, Debug, PartialEq)]
pub struct CompFor {
    /// A name, or a tuple/list of targets (one may be starred).
    pub target: Expr,
    /// What is iterated.
    pub iter: Expr,
    /// The `if`s behind it.
    pub conditions: Vec<Expr>,
}
