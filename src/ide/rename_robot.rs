//! Renaming links, joints and materials, whose names macros put together: the part of a name that is written somewhere
//! is renamed there, and wherever else that part of the same names is written.

use std::collections::BTreeMap;

use super::context::Cx;
use super::robot_names::{NameKind, RobotName, all_names};
use base::{Encoding, FastMap, FastSet, FileId, Span, TextRange};
use expand::{FrameKind, Origin, Piece, SourceRange, argument};
use expr::Token;
use model::Text;
use vfs::SourceFile;

/// A part of a name and where it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct NamePart {
    /// Bytes of the name.
    of: TextRange,
    /// The text that says so.
    written: Span,
}

/// The parts of a name that are written as they are: its own text between expressions, and what a call passes for
/// a parameter.
fn parts(cx: &Cx<'_>, text: &Text) -> Vec<NamePart> {
    let mut found = Vec::new();
    let content = content_pieces(cx, text);
    let (origin, pieces) = match &content {
        Some((origin, pieces)) => (*origin, pieces.as_slice()),
        None => (text.origin, &*text.pieces),
    };
    let mut at = (0, origin.range.start);
    let end = (text.value.len() as u32, origin.range.end);
    let own = |range: TextRange| Origin { range, ..origin };
    for piece in pieces {
        let source = piece.source;
        if source.src != origin.src || source.range.start < at.1 || source.range.end > end.1 {
            return found;
        }
        let before = TextRange::new(at.0, piece.out.start.max(at.0));
        found.extend(part(cx, text, before, own(TextRange::new(at.1, source.range.start))));
        found.extend(argument(cx.expansion, source).and_then(|given| part(cx, text, piece.out, given)));
        at = (piece.out.end, source.range.end);
    }
    if at.0 <= end.0 && at.1 <= end.1 {
        found.extend(part(cx, text, TextRange::new(at.0, end.0), own(TextRange::new(at.1, end.1))));
    }
    found
}

/// The pieces of an element's content, of which the expansion knows only as a whole that expressions made it: the texts
/// between the expressions tell them apart, when each stands in the value once.
fn content_pieces(cx: &Cx<'_>, text: &Text) -> Option<(Origin, Vec<Piece>)> {
    let [whole] = &*text.pieces else { return None };
    let source = cx.expansion.sources.get(text.origin.src.0 as usize)?;
    let all = text.origin.range.slice(source.item.text());
    if whole.source != text.origin || all.contains('&') {
        return None;
    }
    let raw = all.trim();
    let start = text.origin.range.start + (all.len() - all.trim_start().len()) as u32;
    let range = TextRange::new(start, start + raw.len() as u32);
    let tokens = expr::split(raw).tokens;
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut at, mut open) = (0, None);
    for (number, token) in tokens.iter().enumerate() {
        match token {
            Token::Text(literal) => {
                let (literal, rest) = (literal.slice(raw), text.value.get(at as usize..)?);
                let is_last = number + 1 == tokens.len();
                let found = if is_last { rest.strip_suffix(literal)?.len() } else { rest.find(literal)? };
                let is_first = open.is_none() && found != 0;
                if is_first || !is_last && rest.rfind(literal) != Some(found) {
                    return None;
                }
                let from = at;
                at += found as u32;
                pieces.extend(open.take().map(|source| piece(whole, from, at, source)));
                at += literal.len() as u32;
            }
            // where one expression follows another, nothing says where it begins
            Token::Expr { .. } | Token::Subst { .. } if open.is_none() => {
                open = Some(token.range().shift(start))
            }
            _ => return None,
        }
    }
    pieces.extend(open.map(|source| piece(whole, at, text.value.len() as u32, source)));
    Some((Origin { range, ..text.origin }, pieces))
}

/// What an expression at `source` put into a value.
fn piece(whole: &Piece, from: u32, to: u32, source: TextRange) -> Piece {
    let source = Origin { range: source, ..whole.source };
    Piece { out: TextRange::new(from, to), source, ..whole.clone() }
}

/// A part that is not empty, when the text says it letter by letter.
fn part(cx: &Cx<'_>, text: &Text, of: TextRange, origin: Origin) -> Option<NamePart> {
    let source = cx.expansion.sources.get(origin.src.0 as usize)?;
    let same = source.item.text().get(origin.range.start as usize..origin.range.end as usize)
        == text.value.get(of.start as usize..of.end as usize);
    let written = cx.span(SourceRange::from(origin))?;
    (same && !of.is_empty()).then_some(NamePart { of, written })
}

/// The part of a name at an offset of the file, with the names it is part of.
fn asked(cx: &Cx<'_>, all: &[(RobotName, Vec<NamePart>)], offset: u32) -> Option<Span> {
    let here = |part: &&NamePart| {
        let range = part.written.range;
        part.written.file == cx.source.id && range.start <= offset && offset <= range.end
    };
    let mut found = all.iter().flat_map(|(_, parts)| parts.iter().filter(here));
    found.next().map(|part| part.written)
}

fn with_parts(cx: &Cx<'_>) -> Vec<(RobotName, Vec<NamePart>)> {
    let known = all_names(cx).into_iter().filter(|name| name.text.is_known());
    known
        .map(|name| {
            let parts = parts(cx, &name.text);
            (name, parts)
        })
        .collect()
}

/// The text at an offset that is a name of a link, joint or material, or a part of such names.
pub fn renameable(cx: &Cx<'_>, offset: u32) -> Option<(TextRange, String)> {
    let span = asked(cx, &with_parts(cx), offset)?;
    Some((span.range, cx.source.document.slice(span.range)))
}

/// The texts to be replaced when the part of names of links, joints or materials at an offset is to read `new`.
///
/// # Errors
/// Why it cannot be renamed, for the user.
pub fn rename(cx: &Cx<'_>, offset: u32, new: &str) -> Result<Vec<Span>, String> {
    let is_plain = |c: char| !c.is_whitespace() && !matches!(c, '<' | '&' | '"' | '\'' | '$' | '{' | '}');
    if new.is_empty() || !new.chars().all(is_plain) {
        return Err(format!("invalid link or joint name `{new}`"));
    }
    let all = with_parts(cx);
    let nowhere = || "nothing to rename here".to_owned();
    let first = asked(cx, &all, offset).ok_or_else(nowhere)?;
    let mut work = Work {
        cx,
        all: &all,
        changed: BTreeMap::new(),
        spans: vec![first],
        seen: [first].into_iter().collect(),
    };
    work.spread()?;
    work.admit(new)?;
    Ok(work.spans)
}

/// Names that change, and the texts that make them change.
struct Work<'a, 'b> {
    cx: &'b Cx<'a>,
    all: &'b [(RobotName, Vec<NamePart>)],
    /// Which bytes change, by the number of the name.
    changed: BTreeMap<usize, Vec<TextRange>>,
    spans: Vec<Span>,
    seen: FastSet<Span>,
}

/// Where parts of names are written. Texts are divided at their expressions: two places are the same or apart.
struct Written {
    places: Vec<(Span, Vec<(usize, NamePart)>)>,
}

impl Written {
    fn of(all: &[(RobotName, Vec<NamePart>)]) -> Self {
        let mut places: BTreeMap<(FileId, u32, u32), Vec<(usize, NamePart)>> = BTreeMap::new();
        for (number, (_, parts)) in all.iter().enumerate() {
            for part in parts {
                let Span { file, range } = part.written;
                places.entry((file, range.start, range.end)).or_default().push((number, *part));
            }
        }
        let span = |(file, start, end)| Span { file, range: TextRange::new(start, end) };
        Self { places: places.into_iter().map(|(place, parts)| (span(place), parts)).collect() }
    }

    /// The parts whose text a span is, or is in.
    fn around(&self, span: Span) -> &[(usize, NamePart)] {
        let key = |place: &Span| (place.file, place.range.start);
        let after = self.places.partition_point(|(place, _)| key(place) <= key(&span));
        let place = after.checked_sub(1).and_then(|index| self.places.get(index));
        let holds = |place: &Span| place.file == span.file && place.range.contains_range(span.range);
        place.filter(|(place, _)| holds(place)).map_or(&[], |(_, parts)| parts)
    }
}

impl Work<'_, '_> {
    /// From texts to the names they are part of, from names to all that name the same, and to the texts of these.
    fn spread(&mut self) -> Result<(), String> {
        let mut by_value: FastMap<&str, Vec<usize>> = FastMap::default();
        for (number, (name, _)) in self.all.iter().enumerate() {
            by_value.entry(&name.text.value).or_default().push(number);
        }
        let written = Written::of(self.all);
        let mut next = 0;
        while let Some(&span) = self.spans.get(next) {
            next += 1;
            for &(number, part) in written.around(span) {
                let Some((name, _)) = self.all.get(number) else { continue };
                let start = part.of.start + (span.range.start - part.written.range.start);
                let range = TextRange::new(start, start + span.range.len());
                for &other in by_value.get(name.text.value.as_str()).into_iter().flatten() {
                    if self.all.get(other).is_some_and(|(other, _)| other.kind.is(name.kind)) {
                        self.change(other, range)?;
                    }
                }
            }
        }
        let mut sorted = self.spans.clone();
        sorted.sort_unstable_by_key(|span| (span.file, span.range.start));
        let overlap =
            |pair: &[Span]| matches!(pair, [a, b] if a.file == b.file && b.range.start < a.range.end);
        match sorted.windows(2).any(overlap) {
            true => Err("cannot rename: parts of this name overlap in the source".to_owned()),
            false => Ok(()),
        }
    }

    /// Some bytes of a name change: where they are written.
    fn change(&mut self, number: usize, range: TextRange) -> Result<(), String> {
        let known = self.changed.entry(number).or_default();
        if known.contains(&range) {
            return Ok(());
        }
        if known.iter().any(|known| known.start < range.end && range.start < known.end) {
            return Err(self.refusal(number));
        }
        known.push(range);
        let Some((_, parts)) = self.all.get(number) else { return Ok(()) };
        let whole = parts.iter().find(|part| part.of.contains_range(range));
        let Some(part) = whole else { return Err(self.refusal(number)) };
        let start = part.written.range.start + (range.start - part.of.start);
        let span = Span { range: TextRange::new(start, start + range.len()), ..part.written };
        if self.seen.insert(span) {
            self.spans.push(span);
        }
        Ok(())
    }

    /// Why a name cannot be changed there.
    fn refusal(&self, number: usize) -> String {
        let Some((name, _)) = self.all.get(number) else {
            return "this name no longer exists".to_owned();
        };
        let (cx, text) = (self.cx, &name.text);
        let mut calls = cx.expansion.frames_of(text.origin).filter(|frame| frame.kind == FrameKind::Macro);
        let span = cx.span(SourceRange::from(text.origin));
        let file = span.and_then(|span| Some((span, cx.file_of(span.file)?)));
        let line = |(span, file): (Span, &SourceFile)| {
            file.document.line_col(span.range.start, Encoding::Utf8).line + 1
        };
        let raw = |(span, file): (Span, &SourceFile)| file.document.slice(span.range);
        let maker = calls.next().map(|frame| frame.name.to_string()).or_else(|| file.map(raw));
        format!(
            "`{}` comes from `{}` on line {}: rename the suffix there or change the argument",
            text.value,
            maker.unwrap_or_default(),
            file.map_or(0, line),
        )
    }

    /// Whether the new names are free.
    fn admit(&self, new: &str) -> Result<(), String> {
        let defined = self.all.iter().enumerate().filter(|(_, (name, _))| name.is_definition);
        let staying: FastMap<&str, NameKind> = defined
            .filter(|(number, _)| !self.changed.contains_key(number))
            .map(|(_, (name, _))| (name.text.value.as_str(), name.kind))
            .collect();
        for (number, ranges) in &self.changed {
            let Some((name, _)) = self.all.get(*number) else { continue };
            let mut changed = name.text.value.to_string();
            let mut ranges = ranges.clone();
            ranges.sort_unstable_by_key(|range| std::cmp::Reverse(range.start));
            let fits =
                |range: &TextRange| name.text.value.get(range.start as usize..range.end as usize).is_some();
            for range in ranges.into_iter().filter(fits) {
                changed.replace_range(range.start as usize..range.end as usize, new);
            }
            if staying.get(changed.as_str()).is_some_and(|kind| kind.is(name.kind)) {
                return Err(format!("`{changed}` is already defined"));
            }
        }
        Ok(())
    }
}
