//! The words of an expression as they stand, for colors: half-typed text has words too.

use super::lexer::{LexerInput, lex};
use super::report::ExprErrors;
use super::token::Tok;
use base::TextRange;

/// The kinds of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordKind {
    /// A name.
    Name,
    /// `and`, `if`, `True` and the like.
    Keyword,
    /// A number.
    Number,
    /// A string with its quotes.
    String,
    /// A string without its closing quote.
    OpenString,
    /// Operators, brackets, commas, dots.
    Operator,
}

/// The words of an expression in order.
pub fn words(text: &str) -> Vec<(TextRange, WordKind)> {
    if u32::try_from(text.len()).is_err() {
        return Vec::new();
    }
    let mut report = ExprErrors::new(text, 0);
    let source = LexerInput {
        text,
        start: 0,
        end: text.len(),
        outer_end: text.len(),
        bracketed: true,
    };
    let tokens = lex(&source, &mut report)
        .into_iter()
        .filter(|token| !token.range.is_empty());
    tokens
        .filter_map(|token| Some((token.range, kind(token.kind)?)))
        .collect()
}

fn kind(token: Tok) -> Option<WordKind> {
    use Tok::*;
    Some(match token {
        End | Newline | Indent => return Option::None,
        Name => WordKind::Name,
        Number | BadNumber => WordKind::Number,
        Str => WordKind::String,
        OpenStr => WordKind::OpenString,
        None | True | False | And | Or | Not | In | Is | If | Else | For | Lambda | Async
        | Await | Yield | Keyword => WordKind::Keyword,
        _ => WordKind::Operator,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_typed_text_has_words() {
        let text = "a.b['k'] if x > 1.5 else (";
        let found: Vec<&str> = words(text)
            .iter()
            .map(|(range, _)| range.slice(text))
            .collect();
        assert_eq!(
            found,
            [
                "a", ".", "b", "[", "'k'", "]", "if", "x", ">", "1.5", "else", "("
            ]
        );
        assert_eq!(
            words("'open").first().map(|(_, kind)| *kind),
            Some(WordKind::OpenString)
        );
    }
}
