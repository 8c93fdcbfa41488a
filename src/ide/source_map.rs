//! From the expanded text to the source and back.
//!
//! The map is like that of JavaScript, but its nodes have a call stack: a frame is an include, a macro call or an
//! inserted block.

use serde::Serialize;

use base::{Encoding, FastMap, FastSet, TextRange};
use expand::{BindingKind, Expansion, FrameId, FrameKind, MapEntry, MapKind, Origin, Written, XId};
use xml::Document;

/// The map as it is written: `files` are named by the caller.
#[derive(Clone, Debug, Serialize)]
pub struct SourceMap {
    /// Version of the format.
    pub version: u32,
    /// The root file.
    pub root: String,
    /// The files.
    pub files: Vec<String>,
    /// Parent frame, file, start line and column, end line and column of the tag, name; the first is the root.
    pub frames: Vec<(u32, u32, u32, u32, u32, u32, String)>,
    /// Start and end in the expanded text, file, start and end in the source, frame, kind. Sorted by start.
    pub map: Vec<[u32; 11]>,
}

/// The map of an expansion; `name` gives the name of each file. Columns are counted in `encoding`.
pub fn source_map(
    expansion: &Expansion,
    written: &Written,
    encoding: Encoding,
    name: impl Fn(&expand::FileUse) -> String,
) -> SourceMap {
    let files: Vec<String> = expansion.files.iter().map(&name).collect();
    let places = SourcePositions {
        expansion,
        encoding,
    };
    let frames = expansion.frames.iter().map(|frame| {
        let [file, sl, sc, el, ec] = places.of(frame.call).unwrap_or_default();
        (
            frame.call.frame.0,
            file,
            sl,
            sc,
            el,
            ec,
            frame.name.to_string(),
        )
    });
    let out = TextLines::of(&written.text, encoding);
    let row = |entry: &MapEntry| {
        let origin = origin_of(expansion, entry);
        let [file, sl, sc, el, ec] = places.of(origin)?;
        let ([gl, gc], [gel, gec]) = (out.position(entry.out.start), out.position(entry.out.end));
        Some([
            gl,
            gc,
            gel,
            gec,
            file,
            sl,
            sc,
            el,
            ec,
            origin.frame.0,
            entry.kind as u32,
        ])
    };
    let mut map: Vec<[u32; 11]> = written.map.iter().filter_map(row).collect();
    map.sort_by_key(|row| (row[0], row[1], std::cmp::Reverse((row[2], row[3]))));
    let root = files.first().cloned().unwrap_or_default();
    SourceMap {
        version: 1,
        root,
        files,
        frames: frames.collect(),
        map,
    }
}

/// The text that made an entry. An attribute is more than its value, so that the way back tells it from the first
/// expression in it. What an expression took from a macro's parameter as it is was made by the call.
pub fn origin_of(expansion: &Expansion, entry: &MapEntry) -> Origin {
    if entry.kind == MapKind::Attribute {
        return whole_attribute(expansion, entry).unwrap_or(entry.origin);
    }
    let mut origin = entry.origin;
    let mut reads = entry.reads;
    // a value is handed down through calls as often as calls are nested
    for _ in 0..64 {
        let [read] = expansion.index.read_in(reads) else {
            break;
        };
        let Some(binding) = expansion.index.bindings.get(*read) else {
            break;
        };
        let is_name = whole_name(expansion, origin);
        let Some(given) = binding
            .origin
            .filter(|_| binding.kind == BindingKind::Parameter && is_name)
        else {
            break;
        };
        origin = given;
        reads = binding.reads;
    }
    origin
}

/// The attribute with name and quotes whose value made an entry; none when it was made in another way.
fn whole_attribute(expansion: &Expansion, entry: &MapEntry) -> Option<Origin> {
    let tag = expansion.tree.get(entry.node).origin;
    let source = expansion
        .sources
        .get(tag.src)
        .filter(|_| tag.src == entry.origin.src)?;
    let mut attrs = source.item.element_at(tag.range.start)?.attrs();
    let attr = attrs.find(|attr| attr.value_range() == entry.origin.range)?;
    Some(Origin {
        range: attr.range(),
        ..entry.origin
    })
}

/// Whether the text at an origin is `${name}` and nothing else.
fn whole_name(expansion: &Expansion, origin: Origin) -> bool {
    let Some(source) = expansion.sources.get(origin.src) else {
        return false;
    };
    let text = origin.range.slice(source.item.text()).trim();
    let name = text
        .strip_prefix("${")
        .and_then(|text| text.strip_suffix('}'));
    name.is_some_and(|name| expr::is_identifier(name.trim()))
}

/// The innermost entry of the expanded text at an offset.
pub fn entry_at(written: &Written, offset: u32) -> Option<&MapEntry> {
    let here = |entry: &&MapEntry| entry.out.start <= offset && offset < entry.out.end;
    written
        .map
        .iter()
        .filter(here)
        .min_by_key(|entry| (entry.out.len(), std::cmp::Reverse(entry.kind)))
}

/// What a source text made: the stretches of the expanded text whose origin holds or lies in `range` of `file`,
/// of those around it the innermost only; with the frames that led there.
pub fn instances(
    expansion: &Expansion,
    written: &Written,
    file: expand::FileIdx,
    offset: u32,
) -> Vec<(TextRange, FrameId)> {
    let found = written.map.iter().filter_map(|entry| {
        let by_itself = size_around(expansion, entry.origin, file, offset);
        // what a call gave to a macro stands in both; attributes are looked at in their own tag only
        let far = entry.kind == MapKind::Attribute && {
            let tag = expansion.tree.get(entry.node).origin;
            size_around(expansion, tag, file, offset).is_none()
        };
        let size = by_itself.or_else(|| {
            if far {
                None
            } else {
                size_around(expansion, origin_of(expansion, entry), file, offset)
            }
        })?;
        Some((entry, size))
    });
    let found: Vec<(&MapEntry, (bool, u32))> = found.collect();
    let least = found
        .iter()
        .map(|(_, size)| *size)
        .min()
        .unwrap_or_default();
    if let Some((length, made)) = made_by_calls(expansion, written, file, offset)
        && (found.is_empty() || length < least.1)
    {
        return made;
    }
    // an element and its start tag are one
    let mut seen: FastSet<(XId, Origin)> = FastSet::default();
    let innermost = found
        .into_iter()
        .filter(|(_, size)| *size == least)
        .map(|(entry, _)| entry);
    let mut found: Vec<(TextRange, FrameId)> = innermost
        .filter(|entry| entry.kind > MapKind::StartTag || seen.insert((entry.node, entry.origin)))
        .map(|entry| (entry.out, entry.origin.frame))
        .collect();
    found.sort_by_key(|(out, _)| out.start);
    found
}

/// How long a text around an offset is; of two texts side by side the one that begins there counts less.
fn size_around(
    expansion: &Expansion,
    origin: Origin,
    file: expand::FileIdx,
    offset: u32,
) -> Option<(bool, u32)> {
    let place = expansion.place(origin)?;
    let TextRange { start, end } = place.range;
    let is_around = place.file == file && place.range.touches(offset);
    is_around.then_some((offset == end && start < end, end - start))
}

/// What the macro call or include at an offset made, and how long its tag is: a call leaves nothing of itself
/// in the expanded text, so all that came through it counts. Each way there is a range of its own.
fn made_by_calls(
    expansion: &Expansion,
    written: &Written,
    file: expand::FileIdx,
    offset: u32,
) -> Option<(u32, Vec<(TextRange, FrameId)>)> {
    let calls: FastMap<FrameId, u32> = expansion
        .frames
        .iter_ids()
        .filter(|(_, frame)| frame.kind != FrameKind::Root)
        .filter_map(|(id, frame)| {
            let place = expansion.place(frame.call)?;
            let is_here = place.file == file && place.range.touches(offset);
            is_here.then(|| (id, place.range.len()))
        })
        .collect();
    let least = calls.values().copied().min()?;
    let mut made: FastMap<FrameId, TextRange> = FastMap::default();
    for entry in &written.map {
        let way = std::iter::successors(Some(entry.origin.frame), |id| {
            let frame = expansion.frames.get(*id)?;
            (frame.kind != FrameKind::Root).then_some(frame.call.frame)
        });
        for id in way.filter(|id| calls.get(id) == Some(&least)) {
            let all = made.entry(id).or_insert(entry.out);
            *all = TextRange::new(all.start.min(entry.out.start), all.end.max(entry.out.end));
        }
    }
    let mut made: Vec<(TextRange, FrameId)> = made.into_iter().map(|(id, out)| (out, id)).collect();
    made.sort_by_key(|(out, _)| out.start);
    (!made.is_empty()).then_some((least, made))
}

/// The steps that led to an origin, innermost first, without the root.
pub fn steps(expansion: &Expansion, origin: Origin) -> impl Iterator<Item = (FrameKind, Origin)> {
    expansion
        .frames_of(origin)
        .map(|frame| (frame.kind, frame.call))
}

/// Lines and columns in the sources.
struct SourcePositions<'a> {
    expansion: &'a Expansion,
    encoding: Encoding,
}

impl SourcePositions<'_> {
    /// File, start line and column, end line and column.
    fn of(&self, origin: Origin) -> Option<[u32; 5]> {
        let place = self.expansion.place(origin)?;
        let document: &Document = &self.expansion.files.get(place.file)?.source.document;
        let start = document.line_col(place.range.start, self.encoding);
        let end = document.line_col(place.range.end, self.encoding);
        Some([place.file.0, start.line, start.col, end.line, end.col])
    }
}

/// Lines of a text that is no document.
pub struct TextLines<'a> {
    text: &'a str,
    starts: Vec<u32>,
    encoding: Encoding,
}

impl<'a> TextLines<'a> {
    /// The lines of a text whose lines end with a line feed.
    pub fn of(text: &'a str, encoding: Encoding) -> Self {
        let ends = memchr::memchr_iter(b'\n', text.as_bytes()).map(|at| at as u32 + 1);
        Self {
            text,
            starts: std::iter::once(0).chain(ends).collect(),
            encoding,
        }
    }

    /// Line and column of an offset.
    pub fn position(&self, offset: u32) -> [u32; 2] {
        let line = self
            .starts
            .partition_point(|&start| start <= offset)
            .saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or(0) as usize;
        let before = self.text.get(start..offset as usize).unwrap_or("");
        [line as u32, self.encoding.width(before)]
    }

    /// The offset of a line and column; behind the end of a line: its end.
    pub fn offset(&self, line: u32, column: u32) -> u32 {
        let Some(&start) = self.starts.get(line as usize) else {
            return self.text.len() as u32;
        };
        let end = self
            .starts
            .get(line as usize + 1)
            .map_or(self.text.len(), |&next| next as usize - 1);
        let text = self.text.get(start as usize..end).unwrap_or("");
        start + self.encoding.locate(text, column).unwrap_or(text.len()) as u32
    }
}
