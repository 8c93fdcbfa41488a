//! A file in the expansion of its active root.

use super::beside::BesideName;
use base::{FastMap, FileId, Span, TextRange};
use expand::{DefinitionId, Expansion, FileIdx, FrameId, SourceItem, SourceRange, SrcId, Use};
use model::{Kinematics, Robot};
use vfs::SourceFile;

/// A file, and the expansion it is looked at in.
#[derive(Clone, Copy)]
pub struct Cx<'a> {
    /// The file as it is now.
    pub source: &'a SourceFile,
    /// The expansion of its active root.
    pub expansion: &'a Expansion,
    /// The robot; none when the root element is not `robot`.
    pub robot: Option<&'a Robot>,
    /// How its links hang together.
    pub kinematics: Option<&'a Kinematics>,
    /// The names in files beside the robot.
    pub beside: &'a [BesideName],
    /// The macro call that the user looks at: of values that differ by call, its own are shown.
    pub selected_frame: Option<FrameId>,
}

impl<'a> Cx<'a> {
    /// The file's number in the expansion; none when it takes no part.
    pub fn file(&self) -> Option<FileIdx> {
        let own = |file: &expand::FileUse| file.source.id == self.source.id;
        self.expansion.files.position(own)
    }

    /// The text of the expansion that stands at `range` of the file.
    pub fn source_range(&self, range: TextRange) -> Option<SourceRange> {
        let (first, sources) = self.own_sources()?;
        let after = sources.partition_point(|source| source.base <= range.start);
        let (index, source) = (after.checked_sub(1)?, sources.get(after.checked_sub(1)?)?);
        if range.end > source.base + source.item.len() {
            return None;
        }
        let src = SrcId(first + index as u32);
        Some(SourceRange {
            src,
            range: TextRange::new(range.start - source.base, range.end - source.base),
        })
    }

    /// Where a text of the expansion stands.
    pub fn span(&self, place: SourceRange) -> Option<Span> {
        let source = self.expansion.sources.get(place.src)?;
        let file = self.expansion.files.get(source.file)?.source.id;
        Some(Span {
            file,
            range: place.range.shift(source.base),
        })
    }

    /// The source texts of the file in order, and the number of the first.
    fn own_sources(&self) -> Option<(u32, &'a [SourceItem])> {
        let file = self.file()?;
        let first = self.expansion.files.get(file)?.first_source.0;
        let rest = self.expansion.sources.as_slice().get(first as usize..)?;
        let count = rest.iter().take_while(|source| source.file == file).count();
        Some((first, rest.get(..count)?))
    }

    /// Where the source texts of the file begin.
    pub fn bases(&self) -> FastMap<SrcId, u32> {
        let (first, sources) = self.own_sources().unwrap_or((0, &[]));
        (first..)
            .map(SrcId)
            .zip(sources.iter().map(|source| source.base))
            .collect()
    }

    /// Tells where a source text begins, if it is one of the file.
    pub fn base_of(&self) -> impl Fn(SrcId) -> Option<u32> + 'a {
        let (first, sources) = self.own_sources().unwrap_or((0, &[]));
        move |src| {
            let source = sources.get(src.0.checked_sub(first)? as usize)?;
            Some(source.base)
        }
    }

    /// The source texts of the file, with their numbers.
    fn sources(&self) -> impl Iterator<Item = SrcId> + 'a {
        let (first, sources) = self.own_sources().unwrap_or((0, &[]));
        (first..).map(SrcId).take(sources.len())
    }

    /// The definition that the name at an offset of the file gives or refers to, with the name's range there.
    pub fn symbol_at(&self, offset: u32) -> Option<(DefinitionId, TextRange)> {
        let symbols = &self.expansion.index.symbols;
        for src in self.sources() {
            let source = self.expansion.sources.get(src)?;
            let Some(inside) = offset
                .checked_sub(source.base)
                .filter(|&inside| inside <= source.item.len())
            else {
                continue;
            };
            let used = symbols
                .all_uses()
                .filter(|used| used.place.src == src && used.place.range.touches(inside))
                .min_by_key(|used| used.place.range.len());
            let given = symbols.iter().find(|(_, definition)| {
                definition.place.src == src && definition.place.range.touches(inside)
            });
            let found = match (used, given) {
                (_, Some((id, definition))) => Some((id, definition.place)),
                (
                    Some(Use {
                        place, definition, ..
                    }),
                    None,
                ) => Some((*definition, *place)),
                (None, None) => None,
            };
            if let Some((id, place)) = found {
                return Some((id, place.range.shift(source.base)));
            }
        }
        None
    }

    /// The file of the expansion with this number.
    pub fn file_of(&self, id: FileId) -> Option<&'a SourceFile> {
        let file = self
            .expansion
            .files
            .iter()
            .find(|file| file.source.id == id)?;
        Some(&file.source)
    }
}
