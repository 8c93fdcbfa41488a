//! The kinds of tokens, and the words and characters they are made of.

use base::TextRange;

/// The three kinds of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bracket {
    Round,
    Square,
    Curly,
}

impl Bracket {
    pub(super) fn open(self) -> char {
        match self {
            Bracket::Round => '(',
            Bracket::Square => '[',
            Bracket::Curly => '{',
        }
    }

    pub(super) fn close(self) -> char {
        match self {
            Bracket::Round => ')',
            Bracket::Square => ']',
            Bracket::Curly => '}',
        }
    }
}

/// The kinds of tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tok {
    End,
    Newline,
    /// White space before the first token of a later line, outside of brackets.
    Indent,
    Name,
    /// A number; `BadNumber` was reported already.
    Number,
    BadNumber,
    Str,
    /// A string whose closing quote is missing; reported already.
    OpenStr,
    Open(Bracket),
    Close(Bracket),
    // keywords with a meaning in expressions
    None,
    True,
    False,
    And,
    Or,
    Not,
    In,
    Is,
    If,
    Else,
    For,
    Lambda,
    Async,
    Await,
    Yield,
    /// A keyword of statements.
    Keyword,
    Plus,
    Minus,
    Star,
    DoubleStar,
    Slash,
    DoubleSlash,
    Percent,
    At,
    LShift,
    RShift,
    Amp,
    Pipe,
    Caret,
    Tilde,
    Lt,
    Gt,
    Le,
    Ge,
    EqEq,
    NotEq,
    Comma,
    Colon,
    Dot,
    Equal,
    Walrus,
    Ellipsis,
    /// An operator of statements, or a character that means nothing.
    Other,
}

impl Tok {
    /// Whether an operand may start with it, other than with a bracket that would be a call or an index.
    pub(super) fn starts_operand(self) -> bool {
        use Tok::*;
        matches!(
            self,
            Name | Number
                | BadNumber
                | Str
                | OpenStr
                | None
                | True
                | False
                | Not
                | Lambda
                | Tilde
                | Ellipsis
        ) || self == Open(Bracket::Curly)
    }

    pub(super) fn is_close(self) -> bool {
        matches!(self, Tok::Close(_))
    }
}

/// A token and where it stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token {
    pub(super) kind: Tok,
    pub(super) range: TextRange,
}

/// The operator or delimiter that starts with these characters, and its length.
pub(super) fn operator(first: u8, second: Option<u8>, third: Option<u8>) -> (Tok, usize) {
    use Tok::*;
    match (first, second, third) {
        (b'*', Some(b'*'), Some(b'=')) | (b'/', Some(b'/'), Some(b'=')) => (Other, 3),
        (b'<', Some(b'<'), Some(b'=')) | (b'>', Some(b'>'), Some(b'=')) => (Other, 3),
        (b'.', Some(b'.'), Some(b'.')) => (Ellipsis, 3),
        (b'*', Some(b'*'), _) => (DoubleStar, 2),
        (b'/', Some(b'/'), _) => (DoubleSlash, 2),
        (b'<', Some(b'<'), _) => (LShift, 2),
        (b'>', Some(b'>'), _) => (RShift, 2),
        (b'<', Some(b'='), _) => (Le, 2),
        (b'>', Some(b'='), _) => (Ge, 2),
        (b'=', Some(b'='), _) => (EqEq, 2),
        (b'!', Some(b'='), _) => (NotEq, 2),
        (b':', Some(b'='), _) => (Walrus, 2),
        (b'<', Some(b'>'), _) | (b'-', Some(b'>'), _) => (Other, 2),
        (b'+' | b'-' | b'*' | b'/' | b'%' | b'@' | b'&' | b'|' | b'^', Some(b'='), _) => (Other, 2),
        (b'+', ..) => (Plus, 1),
        (b'-', ..) => (Minus, 1),
        (b'*', ..) => (Star, 1),
        (b'/', ..) => (Slash, 1),
        (b'%', ..) => (Percent, 1),
        (b'@', ..) => (At, 1),
        (b'&', ..) => (Amp, 1),
        (b'|', ..) => (Pipe, 1),
        (b'^', ..) => (Caret, 1),
        (b'~', ..) => (Tilde, 1),
        (b'<', ..) => (Lt, 1),
        (b'>', ..) => (Gt, 1),
        (b',', ..) => (Comma, 1),
        (b':', ..) => (Colon, 1),
        (b'.', ..) => (Dot, 1),
        (b'=', ..) => (Equal, 1),
        _ => (Other, 1),
    }
}

/// Whether `name` is one of Python's reserved words.
pub(super) fn is_keyword(name: &str) -> bool {
    keyword(name).is_some()
}

/// The token of a reserved word.
pub(super) fn keyword(name: &str) -> Option<Tok> {
    if !(2..=8).contains(&name.len()) {
        return None;
    }
    Some(match name {
        "None" => Tok::None,
        "True" => Tok::True,
        "False" => Tok::False,
        "and" => Tok::And,
        "or" => Tok::Or,
        "not" => Tok::Not,
        "in" => Tok::In,
        "is" => Tok::Is,
        "if" => Tok::If,
        "else" => Tok::Else,
        "for" => Tok::For,
        "lambda" => Tok::Lambda,
        "async" => Tok::Async,
        "await" => Tok::Await,
        "yield" => Tok::Yield,
        "as" | "assert" | "break" | "class" | "continue" | "def" | "del" | "elif" | "except"
        | "finally" | "from" | "global" | "import" | "nonlocal" | "pass" | "raise" | "return"
        | "try" | "while" | "with" => Tok::Keyword,
        _ => return None,
    })
}

/// Whether a quote behind `name` belongs to it.
pub(super) fn is_string_prefix(name: &str) -> bool {
    let mut lower = [0; 2];
    let Some(lower) = lower.get_mut(..name.len()) else {
        return false;
    };
    lower.copy_from_slice(name.as_bytes());
    lower.make_ascii_lowercase();
    matches!(
        &*lower,
        b"r" | b"u" | b"b" | b"f" | b"br" | b"rb" | b"fr" | b"rf"
    )
}
