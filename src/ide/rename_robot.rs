//! Renaming links, joints and materials, whose names macros put together: the part of a name that is written somewhere
//! is renamed there, and wherever else that part of the same names is written.

use std::collections::BTreeMap;

use super::context::Cx;
use super::robot_names::{RobotNameKind, all_names};
use ecow::EcoString;

use base::{Encoding, FastMap, FastSet, FileId, Span, TextRange};
use expand::{FrameKind, Origin, SourceRange, blamed_argument};
use expr::TemplateToken;
use model::AttrValue;
use vfs::SourceFile;

/// A part of a name and where it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NamePart {
    /// Bytes of the name.
    pub of: TextRange,
    /// The text that says so.
    pub written: Span,
}

/// A name of the robot, in the robot or beside it.
struct Name {
    value: EcoString,
    kind: RobotNameKind,
    is_definition: bool,
    /// Where it came from in the expansion of the robot.
    origin: Option<Origin>,
}

/// The parts of a name that are written as they are: its own text between expressions, and what calls pass for
/// parameters, which may be put together in the same way.
pub(super) fn parts(cx: &Cx<'_>, text: &AttrValue) -> Vec<NamePart> {
    let whole = TextRange::new(0, text.value.len() as u32);
    let made_by_one = match &*text.pieces {
        [piece] if piece.source == text.origin => split(cx, &text.value, whole, text.origin),
        _ => None,
    };
    let (origin, pieces) = made_by_one.unwrap_or_else(|| {
        let pieces = text.pieces.iter().map(|piece| (piece.out, piece.source));
        (text.origin, pieces.collect())
    });
    let mut found = Vec::new();
    add_parts(
        cx,
        &text.value,
        (whole, origin),
        &pieces,
        MOST_CALLS,
        &mut found,
    );
    found
}

/// Calls that pass on what they were passed.
const MOST_CALLS: u32 = 8;

/// Pieces of a value with the expressions that made them.
type Pieces = Vec<(TextRange, Origin)>;

/// Add the parts of the slice `of` of a value that the text at `origin` gives, with the pieces that expressions made of it.
fn add_parts(
    cx: &Cx<'_>,
    value: &str,
    (of, origin): (TextRange, Origin),
    pieces: &Pieces,
    calls: u32,
    found: &mut Vec<NamePart>,
) {
    let mut at = (of.start, origin.range.start);
    let end = (of.end, origin.range.end);
    for &(out, source) in pieces {
        if source.src != origin.src || source.range.start < at.1 || source.range.end > end.1 {
            return;
        }
        let before = TextRange::new(at.0, out.start.max(at.0));
        let range = TextRange::new(at.1, source.range.start);
        found.extend(part(cx, value, before, Origin { range, ..origin }));
        if let Some(given) = blamed_argument(cx.expansion, source) {
            add_given(cx, value, out, given, calls, found);
        }
        at = (out.end, source.range.end);
    }
    if at.0 <= end.0 && at.1 <= end.1 {
        let (behind, range) = (TextRange::new(at.0, end.0), TextRange::new(at.1, end.1));
        found.extend(part(cx, value, behind, Origin { range, ..origin }));
    }
}

/// Add the parts of a slice of a value that a call passes.
fn add_given(
    cx: &Cx<'_>,
    value: &str,
    of: TextRange,
    given: Origin,
    calls: u32,
    found: &mut Vec<NamePart>,
) {
    if let Some(part) = part(cx, value, of, given) {
        found.push(part);
    } else if let (Some((origin, pieces)), Some(calls)) =
        (split(cx, value, of, given), calls.checked_sub(1))
    {
        add_parts(cx, value, (of, origin), &pieces, calls, found);
    }
}

/// The pieces of a slice of a value, of which nothing but the text at `origin` is known: the texts between the expressions
/// tell them apart, when each stands in the value once.
fn split(cx: &Cx<'_>, value: &str, of: TextRange, origin: Origin) -> Option<(Origin, Pieces)> {
    let source = cx.expansion.sources.get(origin.src)?;
    let all = origin.range.slice(source.item.text());
    let raw = all.trim();
    if all.contains('&') {
        return None;
    }
    let start = origin.range.start + (all.len() - all.trim_start().len()) as u32;
    let range = TextRange::new(start, start + raw.len() as u32);
    let value = value.get(..of.end as usize)?;
    let tokens = expr::split(raw).tokens;
    let mut pieces = Pieces::new();
    let (mut at, mut open) = (of.start, None);
    for (number, token) in tokens.iter().enumerate() {
        match token {
            TemplateToken::Text(literal) => {
                let (literal, rest) = (literal.slice(raw), value.get(at as usize..)?);
                let is_last = number + 1 == tokens.len();
                let found = if is_last {
                    rest.strip_suffix(literal)?.len()
                } else {
                    rest.find(literal)?
                };
                let is_first = open.is_none() && found != 0;
                if is_first || !is_last && rest.rfind(literal) != Some(found) {
                    return None;
                }
                let from = at;
                at += found as u32;
                let made = TextRange::new(from, at);
                pieces.extend(open.take().map(|range| (made, Origin { range, ..origin })));
                at += literal.len() as u32;
            }
            // where one expression follows another, nothing says where it begins
            TemplateToken::Expr { .. } | TemplateToken::Subst { .. } if open.is_none() => {
                open = Some(token.range().shift(start));
            }
            _ => return None,
        }
    }
    let made = TextRange::new(at, of.end);
    pieces.extend(open.map(|range| (made, Origin { range, ..origin })));
    Some((Origin { range, ..origin }, pieces))
}

/// A part that is not empty, when the text says it letter by letter.
fn part(cx: &Cx<'_>, value: &str, of: TextRange, origin: Origin) -> Option<NamePart> {
    let source = cx.expansion.sources.get(origin.src)?;
    let same = source
        .item
        .text()
        .get(origin.range.start as usize..origin.range.end as usize)
        == value.get(of.start as usize..of.end as usize);
    let written = cx.span(SourceRange::from(origin))?;
    (same && !of.is_empty()).then_some(NamePart { of, written })
}

/// The part of a name at an offset of the file.
fn asked(cx: &Cx<'_>, all: &[(Name, Vec<NamePart>)], offset: u32) -> Option<Span> {
    let here = |part: &&NamePart| {
        let range = part.written.range;
        part.written.file == cx.source.id && range.start <= offset && offset <= range.end
    };
    let mut found = all
        .iter()
        .filter_map(|(name, parts)| Some((name, parts.iter().find(here)?)));
    let (name, part) = found.next()?;
    let given = all.iter().find(|(other, _)| {
        other.is_definition
            && other.kind.is(name.kind)
            && other.value == name.value
            && name.origin.is_none()
    });
    Some(
        given
            .and_then(|(_, parts)| narrowed(part, parts, offset))
            .unwrap_or(part.written),
    )
}

/// The text beside the robot that stands for the same part of the name as where the name is given.
fn narrowed(part: &NamePart, given: &[NamePart], offset: u32) -> Option<Span> {
    let Span { file, range } = part.written;
    let at = part.of.start + (offset - range.start);
    let own = given
        .iter()
        .rfind(|own| part.of.contains_range(own.of) && own.of.touches(at))?;
    let start = range.start + (own.of.start - part.of.start);
    Some(Span {
        file,
        range: TextRange::new(start, start + own.of.len()),
    })
}

fn with_parts(cx: &Cx<'_>) -> Vec<(Name, Vec<NamePart>)> {
    let known = all_names(cx)
        .into_iter()
        .filter(|name| name.text.is_known());
    let own = known.map(|name| {
        let (value, origin) = (name.text.value.clone(), Some(name.text.origin));
        let parts = parts(cx, &name.text);
        (
            Name {
                value,
                kind: name.kind,
                is_definition: name.is_definition,
                origin,
            },
            parts,
        )
    });
    let beside = cx.beside.iter().map(|name| {
        let (value, kind, is_definition) = (name.value.clone(), name.kind, name.is_definition);
        (
            Name {
                value,
                kind,
                is_definition,
                origin: None,
            },
            name.parts.clone(),
        )
    });
    own.chain(beside).collect()
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
    let is_plain =
        |c: char| !c.is_whitespace() && !matches!(c, '<' | '&' | '"' | '\'' | '$' | '{' | '}');
    if new.is_empty() || !new.chars().all(is_plain) {
        return Err(format!("invalid link or joint name `{new}`"));
    }
    let all = with_parts(cx);
    let nowhere = || "nothing to rename here".to_owned();
    let first = asked(cx, &all, offset).ok_or_else(nowhere)?;
    let mut work = PendingRename {
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
struct PendingRename<'a, 'b> {
    cx: &'b Cx<'a>,
    all: &'b [(Name, Vec<NamePart>)],
    /// Which bytes change, by the number of the name.
    changed: BTreeMap<usize, Vec<TextRange>>,
    spans: Vec<Span>,
    seen: FastSet<Span>,
}

/// Where parts of names are written. Texts are divided at their expressions: two places are the same or apart.
struct NameLocations {
    places: Vec<(Span, Vec<(usize, NamePart)>)>,
}

impl NameLocations {
    fn of(all: &[(Name, Vec<NamePart>)]) -> Self {
        let mut places: BTreeMap<(FileId, u32, u32), Vec<(usize, NamePart)>> = BTreeMap::new();
        for (number, (_, parts)) in all.iter().enumerate() {
            for part in parts {
                let Span { file, range } = part.written;
                places
                    .entry((file, range.start, range.end))
                    .or_default()
                    .push((number, *part));
            }
        }
        let places = places.into_iter().map(|((file, start, end), parts)| {
            let range = TextRange::new(start, end);
            (Span { file, range }, parts)
        });
        Self {
            places: places.collect(),
        }
    }

    /// The parts whose text a span is, or is in.
    fn around(&self, span: Span) -> &[(usize, NamePart)] {
        let after = self.places.partition_point(|(place, _)| {
            (place.file, place.range.start) <= (span.file, span.range.start)
        });
        let place = after
            .checked_sub(1)
            .and_then(|index| self.places.get(index));
        place
            .filter(|(place, _)| place.file == span.file && place.range.contains_range(span.range))
            .map_or(&[], |(_, parts)| parts)
    }
}

impl PendingRename<'_, '_> {
    /// From texts to the names they are part of, from names to all that name the same, and to the texts of these.
    fn spread(&mut self) -> Result<(), String> {
        let mut by_value: FastMap<&str, Vec<usize>> = FastMap::default();
        for (number, (name, _)) in self.all.iter().enumerate() {
            by_value.entry(&name.value).or_default().push(number);
        }
        let written = NameLocations::of(self.all);
        let mut next = 0;
        while let Some(&span) = self.spans.get(next) {
            next += 1;
            for &(number, part) in written.around(span) {
                let Some((name, _)) = self.all.get(number) else {
                    continue;
                };
                let start = part.of.start + (span.range.start - part.written.range.start);
                let range = TextRange::new(start, start + span.range.len());
                for &other in by_value.get(name.value.as_str()).into_iter().flatten() {
                    if self
                        .all
                        .get(other)
                        .is_some_and(|(other, _)| other.kind.is(name.kind))
                    {
                        self.change(other, range)?;
                    }
                }
            }
        }
        let mut sorted = self.spans.clone();
        sorted.sort_unstable_by_key(|span| (span.file, span.range.start));
        let overlap = |pair: &[Span]| matches!(pair, [a, b] if a.file == b.file && b.range.start < a.range.end);
        if sorted.windows(2).any(overlap) {
            Err("cannot rename: parts of this name overlap in the source".to_owned())
        } else {
            Ok(())
        }
    }

    /// Some bytes of a name change: where they are written.
    fn change(&mut self, number: usize, range: TextRange) -> Result<(), String> {
        let known = self.changed.entry(number).or_default();
        if known.contains(&range) {
            return Ok(());
        }
        if known
            .iter()
            .any(|known| known.start < range.end && range.start < known.end)
        {
            return Err(self.refusal(number));
        }
        known.push(range);
        let Some((_, parts)) = self.all.get(number) else {
            return Ok(());
        };
        let whole = parts.iter().find(|part| part.of.contains_range(range));
        let Some(part) = whole else {
            return Err(self.refusal(number));
        };
        let start = part.written.range.start + (range.start - part.of.start);
        let span = Span {
            range: TextRange::new(start, start + range.len()),
            ..part.written
        };
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
        let cx = self.cx;
        let Some(origin) = name.origin else {
            return format!(
                "`{}` is put together in a file beside the robot",
                name.value
            );
        };
        let mut calls = cx
            .expansion
            .frames_of(origin)
            .filter(|frame| frame.kind == FrameKind::Macro);
        let span = cx.span(SourceRange::from(origin));
        let file = span.and_then(|span| Some((span, cx.file_of(span.file)?)));
        let line = |(span, file): (Span, &SourceFile)| {
            file.document
                .line_col(span.range.start, Encoding::Utf8)
                .line
                + 1
        };
        let raw = |(span, file): (Span, &SourceFile)| file.document.slice(span.range);
        let maker = calls
            .next()
            .map(|frame| frame.name.to_string())
            .or_else(|| file.map(raw));
        format!(
            "`{}` comes from `{}` on line {}: rename the suffix there or change the argument",
            name.value,
            maker.unwrap_or_default(),
            file.map_or(0, line),
        )
    }

    /// Whether the new names are free.
    fn admit(&self, new: &str) -> Result<(), String> {
        let defined = self
            .all
            .iter()
            .enumerate()
            .filter(|(_, (name, _))| name.is_definition);
        let staying: FastMap<&str, RobotNameKind> = defined
            .filter(|(number, _)| !self.changed.contains_key(number))
            .map(|(_, (name, _))| (name.value.as_str(), name.kind))
            .collect();
        for (number, ranges) in &self.changed {
            let Some((name, _)) = self.all.get(*number) else {
                continue;
            };
            let mut changed = name.value.to_string();
            let mut ranges = ranges.clone();
            ranges.sort_unstable_by_key(|range| std::cmp::Reverse(range.start));
            let fits = |range: &TextRange| {
                name.value
                    .get(range.start as usize..range.end as usize)
                    .is_some()
            };
            for range in ranges.into_iter().filter(fits) {
                changed.replace_range(range.start as usize..range.end as usize, new);
            }
            if staying
                .get(changed.as_str())
                .is_some_and(|kind| kind.is(name.kind))
            {
                return Err(format!("`{changed}` is already defined"));
            }
        }
        Ok(())
    }
}
