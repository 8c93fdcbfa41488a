//! The names that expressions mention.

use ecow::EcoString;

use base::TextRange;
use expr::ast::{Expr, ExprKind};
use expr::{self, Code, Subst, Template, TemplateToken};
use xml::{Entities, decode_text, source_offset};

/// A text that holds expressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// The text, relative to the item; without quotes.
    pub range: TextRange,
    /// Whether it is the value of an attribute.
    pub is_attr: bool,
    /// The names in it, in reading order.
    pub mentions: Vec<Mention>,
}

/// A name in an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mention {
    /// What the name is looked up as.
    pub kind: MentionKind,
    /// The name.
    pub name: EcoString,
    /// Its text, relative to the item.
    pub range: TextRange,
}

/// What a mentioned name is looked up as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum MentionKind {
    /// A property, a parameter, a namespace or a symbol of Python.
    Name,
    /// A name behind a dot: of the name, or the member, in front of it.
    Member,
    /// `$(arg name)`
    Argument,
    /// `$(find package)`
    Package,
}

/// The expressions of a text; none when it holds none. `raw` stands at `range` of its item.
pub(super) fn site(raw: &str, range: TextRange, is_attr: bool) -> Option<Site> {
    let entities = Entities::default();
    let text = decode_text(raw, &entities, is_attr);
    let template = expr::split(&text);
    if template.is_verbatim() {
        return None;
    }
    let mut found = Vec::new();
    collect(&template, &text, &mut found);
    let same = text == raw;
    for mention in &mut found {
        let mut own = mention.range;
        if !same {
            let [start, end] = [own.start, own.end]
                .map(|offset| source_offset(raw, &entities, is_attr, offset as usize) as u32);
            own = TextRange::new(start, end);
        }
        mention.range = own.shift(range.start);
    }
    Some(Site {
        range,
        is_attr,
        mentions: found,
    })
}

fn collect(template: &Template, text: &str, found: &mut Vec<Mention>) {
    for token in &template.tokens {
        match token {
            TemplateToken::Expr {
                inner,
                code: Code::Dynamic(nested),
                ..
            } => {
                collect(nested, text, found);
                // what is replaced first mostly stands in quotes, and the rest is an expression as it is
                let parsed = expr::parse(inner.slice(text));
                if parsed.errors.is_empty() {
                    names(&parsed.expr, inner.start, MentionKind::Name, found);
                }
            }
            TemplateToken::Subst {
                nested: Some(nested),
                ..
            } => collect(nested, text, found),
            TemplateToken::Expr {
                inner,
                code: Code::Static(parsed),
                ..
            } => {
                names(&parsed.expr, inner.start, MentionKind::Name, found);
            }
            TemplateToken::Subst {
                inner,
                nested: None,
                ..
            } => substitution(inner.slice(text), inner.start, found),
            _ => {}
        }
    }
}

/// The free names of an expression that begins at `start`, and their members.
fn names(expr: &Expr, start: u32, kind: MentionKind, found: &mut Vec<Mention>) {
    let mention = |kind, name: &str, range: TextRange| Mention {
        kind,
        name: name.into(),
        range: range.shift(start),
    };
    let free = expr::names(expr);
    let first = found.len();
    found.extend(free.iter().map(|used| mention(kind, used.name, used.range)));
    if kind == MentionKind::Name {
        members(expr, &mut |root, name, range| {
            if free.iter().any(|used| used.range == root) {
                found.push(mention(MentionKind::Member, name, range));
            }
        });
    }
    if let Some(own) = found.get_mut(first..) {
        own.sort_by_key(|mention| mention.range.start);
    }
}

/// The members of names, `b` and `c` of `a.b.c`, with the place of the name in front.
fn members<'e>(expr: &'e Expr, found: &mut dyn FnMut(TextRange, &'e str, TextRange)) {
    if let (
        ExprKind::Attribute {
            name, name_range, ..
        },
        Some(root),
    ) = (&expr.kind, root_name(expr))
    {
        found(root, name, *name_range);
    }
    expr::visit::children(expr, &mut |child| members(child, found));
}

/// The name in front of all dots.
fn root_name(expr: &Expr) -> Option<TextRange> {
    match &expr.kind {
        ExprKind::Name(_) => Some(expr.range),
        ExprKind::Attribute { value, .. } => root_name(value),
        _ => None,
    }
}

fn substitution(inner: &str, start: u32, found: &mut Vec<Mention>) {
    let (kind, word) = match expr::parse_substitution(inner) {
        Subst::Arg(word) => (MentionKind::Argument, word),
        Subst::Find(word) => (MentionKind::Package, word),
        Subst::Eval { code } => {
            // arguments are the variables of `$(eval)`
            let parsed = expr::parse(code.slice(inner));
            return names(
                &parsed.expr,
                start + code.start,
                MentionKind::Argument,
                found,
            );
        }
        _ => return,
    };
    found.push(Mention {
        kind,
        name: word.text,
        range: word.range.shift(start),
    });
}
