//! Whose fault a text is: its own, that of the call of the macro around it, or that of an argument.
use ecow::EcoString;

use super::binding_info::{BindingId, BindingKind};
use super::expansion::Expansion;
use super::node::Piece;
use super::origin::{FrameId, FrameKind, Origin};
use super::symbols::SourceRange;
use base::{FastSet, TextRange};
use expr::{self, TemplateToken, Value, is_identifier};

/// Calls that hand a value down, at most.
const MOST_CALLS: usize = 64;

/// The text that a call passes, when the text at `origin` is a parameter of the macro around it and nothing else;
/// of a value that is handed down through several calls, the outermost.
pub fn blamed_argument(expansion: &Expansion, origin: Origin) -> Option<Origin> {
    let mut found = None;
    let mut at = origin;
    for _ in 0..MOST_CALLS {
        let Some(given) = passed(expansion, at) else {
            break;
        };
        found = Some(given);
        at = given;
    }
    found
}

/// What the innermost call passes for the text at an origin.
fn passed(expansion: &Expansion, origin: Origin) -> Option<Origin> {
    let token = the_name(expansion, origin)?;
    let evaluations = &expansion.index.evaluations;
    let evaluation = evaluations.in_frame(
        SourceRange {
            src: origin.src,
            range: token,
        },
        origin.frame,
    )?;
    let [read] = expansion.index.read_in(evaluation.reads) else {
        return None;
    };
    let binding = expansion.index.bindings.get(*read)?;
    let given = binding
        .origin
        .filter(|_| binding.kind == BindingKind::Parameter)?;
    // a default belongs to the macro, not to the call
    let calls = expansion
        .frames_of(origin)
        .filter(|frame| frame.kind == FrameKind::Macro);
    let mut calls = calls.map(|frame| frame.call);
    calls
        .any(|call| call.frame == given.frame && call.src == given.src)
        .then_some(given)
}

/// The range of the `${name}` that the text at an origin consists of.
fn the_name(expansion: &Expansion, origin: Origin) -> Option<TextRange> {
    let text = source_text(expansion, origin)?;
    let name = text.trim().strip_prefix("${")?.strip_suffix('}')?;
    is_identifier(name.trim()).then(|| {
        let start = origin.range.start + (text.len() - text.trim_start().len()) as u32;
        TextRange::new(start, start + text.trim().len() as u32)
    })
}

fn source_text(expansion: &Expansion, origin: Origin) -> Option<&str> {
    let source = expansion.sources.get(origin.src)?;
    Some(origin.range.slice(source.item.text()))
}

/// Whether a text that reads differently from call to call is wrong in some calls only; `instances` are those in
/// which it is.
pub fn depends_on_parameter(expansion: &Expansion, instances: &[Origin]) -> bool {
    let Some(first) = instances.first() else {
        return false;
    };
    let wrong: FastSet<FrameId> = instances.iter().map(|origin| origin.frame).collect();
    let Some(text) = source_text(expansion, *first).filter(|text| text.contains('$')) else {
        return false;
    };
    let template = expr::split(text);
    let tokens = template.tokens.iter().filter(|token| {
        matches!(
            token,
            TemplateToken::Expr { .. } | TemplateToken::Subst { .. }
        )
    });
    let mut all: FastSet<FrameId> = FastSet::default();
    for token in tokens {
        let range = token.range().shift(first.range.start);
        let place = SourceRange {
            src: first.src,
            range,
        };
        all.extend(
            expansion
                .index
                .evaluations
                .at(place)
                .map(|evaluation| evaluation.at.frame),
        );
    }
    wrong.len() < all.len()
}

/// Bindings that are followed at most.
const MOST_READS: usize = 200;

impl Expansion {
    /// An argument that is empty by default and that the value of an attribute was made from: whoever expands the file is to
    /// give it.
    pub fn empty_argument(&self, pieces: &[Piece]) -> Option<EcoString> {
        pieces.iter().find_map(|piece| {
            let Origin { src, range, frame } = piece.source;
            let evaluation = self
                .index
                .evaluations
                .in_frame(SourceRange { src, range }, frame)?;
            self.empty_argument_of(self.index.read_in(evaluation.reads))
        })
    }

    /// The same for what was read.
    pub(super) fn empty_argument_of(&self, reads: &[BindingId]) -> Option<EcoString> {
        let mut seen = FastSet::default();
        let mut open: Vec<BindingId> = reads.iter().rev().copied().take(MOST_READS).collect();
        while let Some(id) = open.pop() {
            if seen.len() > MOST_READS || !seen.insert(id) {
                continue;
            }
            let info = self.index.bindings.get(id)?;
            let is_empty = matches!(&info.value, Some(Value::Str(text)) if text.is_empty());
            if info.kind == BindingKind::Argument && is_empty && info.origin.is_some() {
                return Some(info.name.clone());
            }
            open.extend_from_slice(self.index.read_in(info.reads));
        }
        None
    }
}
