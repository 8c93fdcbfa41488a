//! Changes to the source that several rules offer.
use super::rule::Safety;
use super::sink::Reported;
use base::TextRange;
use expand::{Expansion, FileIdx, FrameKind, Origin, XId};
use model::{AttrValue, attr_range, element_range};

/// The file and the absolute range of an origin, and the text there.
pub(super) fn source_text(
    expansion: &Expansion,
    origin: Origin,
) -> Option<(FileIdx, TextRange, String)> {
    let place = expansion.place(origin)?;
    let document = &expansion.files.get(place.file)?.source.document;
    Some((place.file, place.range, document.slice(place.range)))
}

/// Whether the file of an origin may hold `${}`.
pub(super) fn speaks_xacro(expansion: &Expansion, origin: Origin) -> bool {
    let file = expansion
        .place(origin)
        .and_then(|place| expansion.files.get(place.file));
    let root = file.and_then(|file| file.source.document.root());
    root.is_some_and(|root| root.attr("xmlns:xacro").is_some())
}

/// Whether a macro or block stands between an origin and its file.
pub(super) fn is_called(expansion: &Expansion, origin: Origin) -> bool {
    expansion
        .frames_of(origin)
        .any(|frame| frame.kind != FrameKind::Include)
}

/// With the fix to delete an element, and its line when it stands there alone.
pub(super) fn delete_element<'s, 'a>(
    report: Reported<'s, 'a>,
    expansion: &Expansion,
    element: XId,
    (safety, message): (Safety, &str),
) -> Reported<'s, 'a> {
    match removal(expansion, element_range(expansion, element)) {
        Some((file, range)) => report.fix(safety, message, file, [(range, String::new())]),
        None => report,
    }
}

/// With the fix to delete attributes of an element.
pub(super) fn delete_attrs<'s, 'a>(
    report: Reported<'s, 'a>,
    expansion: &Expansion,
    element: XId,
    names: &[&str],
) -> Reported<'s, 'a> {
    let attrs = names
        .iter()
        .filter_map(|name| attr_range(expansion, element, name));
    let places: Vec<_> = attrs
        .filter_map(|attr| source_text(expansion, attr))
        .collect();
    let Some(&(file, ..)) = places.first() else {
        return report;
    };
    let edits = places
        .into_iter()
        .map(|(file, range, _)| (with_blanks(expansion, file, range), String::new()));
    report.fix(
        Safety::Safe,
        format!("remove {}", names.join(" and ")),
        file,
        edits,
    )
}

/// With the fix to write another name, when the source holds the name itself. Inside of macros there is none:
/// what fits one call fits no other.
pub(super) fn rename<'s, 'a>(
    report: Reported<'s, 'a>,
    expansion: &Expansion,
    text: &AttrValue,
    new: &str,
) -> Reported<'s, 'a> {
    if text.is_literal() && !is_called(expansion, text.origin) {
        report.replace_with(Safety::Unsafe, format!("rename to `{new}`"), new)
    } else {
        report
    }
}

/// What to remove of a file so that nothing is left of an origin: its line, when it stands there alone.
pub(super) fn removal(expansion: &Expansion, origin: Origin) -> Option<(FileIdx, TextRange)> {
    let (file, range, _) = source_text(expansion, origin)?;
    let document = &expansion.files.get(file)?.source.document;
    let wide = with_blanks(expansion, file, range);
    let before = document.slice(TextRange::new(wide.start, range.start));
    let behind = document.slice(TextRange::new(
        range.end,
        (range.end + 2).min(document.len()),
    ));
    let alone = before.contains('\n') && behind.starts_with(['\n', '\r']);
    let line = before.rfind('\n').map_or(0, |at| at as u32);
    Some((
        file,
        if alone {
            TextRange::new(wide.start + line, range.end)
        } else {
            range
        },
    ))
}

/// A line break and the indentation of the line where a range begins; nothing when something stands in front.
pub(super) fn indent(expansion: &Expansion, file: FileIdx, range: TextRange) -> String {
    let wide = with_blanks(expansion, file, range);
    let files = expansion.files.get(file);
    let blanks = files.map(|used| {
        used.source
            .document
            .slice(TextRange::new(wide.start, range.start))
    });
    blanks
        .and_then(|blanks| {
            blanks
                .rfind('\n')
                .and_then(|at| blanks.get(at..).map(str::to_owned))
        })
        .unwrap_or_default()
}

/// A range with the blanks in front of it.
pub(super) fn with_blanks(expansion: &Expansion, file: FileIdx, range: TextRange) -> TextRange {
    let Some(used) = expansion.files.get(file) else {
        return range;
    };
    let before = used
        .source
        .document
        .slice(TextRange::new(range.start.saturating_sub(200), range.start));
    let blanks = before.len() - before.trim_end().len();
    TextRange::new(range.start - blanks as u32, range.end)
}
