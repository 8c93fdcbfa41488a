//! Names of links, joints and materials in branches that are not taken: seen in the expansion that takes them.
use std::sync::Arc;

use crate::failure::RequestFailure;
use crate::requests::asked::Asked;
use crate::requests::beside::names_beside;
use crate::state::ServerState;
use analysis::{RootAnalysis, RootConfig};
use base::limits::RENAME_ROBOTS;
use base::{CancelFlag, FileId, Span, TextRange};
use expand::Forced;
use ide::{self, BesideName, Cx, TextNames};

/// Ways to texts that are looked at in one robot.
const MOST_WAYS: usize = 400;
/// Branches of one robot that are expanded.
const MOST_BRANCHES: usize = 24;
/// Rounds in which names of one robot lead to further texts in others.
const MOST_ROUNDS: usize = 4;

/// A place in the expansion that takes the conditions on the way to it; none when there are no conditions.
pub fn inside(
    state: &ServerState,
    asked: &Asked,
    cancel: &CancelFlag,
) -> Result<Option<Asked>, RequestFailure> {
    let at = Span {
        file: asked.source.id,
        range: TextRange::new(asked.offset, asked.offset),
    };
    let around = &asked.around;
    let Some(forced) = Ways::of(state, around).and_then(|ways| ways.to(at)) else {
        return Ok(None);
    };
    let analyzed = state
        .host
        .forced(&around.root, forced, cancel)
        .ok_or(RequestFailure::Cancelled)?;
    if !analyzed.includes(&asked.source.path) {
        return Ok(None);
    }
    let (source, offset, beside) = (asked.source.clone(), asked.offset, asked.beside.clone());
    Ok(Some(Asked {
        source,
        offset,
        around: analyzed.clone(),
        analyzed,
        beside,
        selected_frame: None,
    }))
}

/// How one robot comes to its texts.
struct Ways<'a> {
    vfs: &'a vfs::Vfs,
    names: TextNames,
    root: FileId,
}

impl<'a> Ways<'a> {
    fn of(state: &'a ServerState, analyzed: &RootAnalysis) -> Option<Self> {
        let session = state.host.session();
        let settings = session.settings(&analyzed.root.file);
        let names = TextNames::of(&analyzed.expansion, session.rule_env(&settings.config));
        let root = analyzed.expansion.files.first()?.source.id;
        Some(Self {
            vfs: &session.vfs,
            names,
            root,
        })
    }

    fn document(&self, file: FileId) -> Option<Arc<vfs::SourceFile>> {
        self.vfs.document(&self.vfs.path(file)).ok()
    }

    /// The conditions on the way to a text, all taken; none when there are none.
    fn to(&self, at: Span) -> Option<Vec<Forced>> {
        let way = self.names.way(&|file| self.document(file), self.root, at)?;
        let taken = |span: &Span| Forced {
            file: self.vfs.path(span.file).to_path_buf(),
            at: span.range.start,
            taken: true,
        };
        (!way.is_empty()).then(|| way.iter().map(taken).collect())
    }

    /// The branches with values that hold a text and stand at none of the known places.
    fn branches(&self, text: &str, known: &[Span]) -> Vec<Vec<Forced>> {
        let mut found: Vec<Vec<Forced>> = Vec::new();
        let places = ide::further_places(&self.names, &|file| self.document(file), text, known);
        for forced in places
            .into_iter()
            .take(MOST_WAYS)
            .filter_map(|place| self.to(place))
        {
            if !found.contains(&forced) && found.len() < MOST_BRANCHES {
                found.push(forced);
            }
        }
        found
    }
}

/// Add the texts that say the same part of names in all robots that read these texts, in their branches too.
pub fn in_all_robots(
    state: &mut ServerState,
    asked: &Asked,
    (old, new): (&str, &str),
    spans: &mut Vec<Span>,
    cancel: &CancelFlag,
) -> Result<(), RequestFailure> {
    let mut tried: Vec<(RootConfig, Vec<Forced>)> = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let before = spans.len();
        for root in roots(state, asked, spans) {
            let analyzed = state
                .host
                .analyzed(&root, cancel)
                .ok_or(RequestFailure::Cancelled)?;
            let beside = names_beside(state, &root, cancel)?;
            spread(&analyzed, &beside, new, spans).map_err(RequestFailure::Refused)?;
            let branches = Ways::of(state, &analyzed).map(|ways| ways.branches(old, spans));
            for forced in branches.unwrap_or_default() {
                let key = (root.clone(), forced);
                if tried.contains(&key) {
                    continue;
                }
                let branch = state
                    .host
                    .forced(&root, key.1.clone(), cancel)
                    .ok_or(RequestFailure::Cancelled)?;
                tried.push(key);
                // conditions that exclude each other make robots that nobody means: what stands in the way there counts for nothing
                let _ = spread(&branch, &[], new, spans);
            }
        }
        if spans.len() == before {
            break;
        }
    }
    Ok(())
}

/// The robots that read one of the files, the one that was asked about first.
fn roots(state: &mut ServerState, asked: &Asked, spans: &[Span]) -> Vec<RootConfig> {
    let mut files: Vec<FileId> = spans.iter().map(|span| span.file).collect();
    files.sort_unstable();
    files.dedup();
    let mut found = vec![asked.analyzed.root.clone()];
    for file in files {
        let path = state.host.session().vfs.path(file);
        for (root, _) in analysis::context(&mut state.host, &path).candidates {
            if !found.contains(&root) {
                found.push(root);
            }
        }
    }
    found.truncate(RENAME_ROBOTS);
    found
}

/// Add the texts of one expansion that belong to those.
fn spread(
    analyzed: &RootAnalysis,
    beside: &[BesideName],
    new: &str,
    spans: &mut Vec<Span>,
) -> Result<(), String> {
    let expansion = &analyzed.expansion;
    let (robot, kinematics) = (analyzed.robot.as_ref(), analyzed.kinematics());
    let mut covered: Vec<Span> = Vec::new();
    for span in spans.clone() {
        let file = expansion
            .files
            .iter()
            .find(|file| file.source.id == span.file);
        let Some(source) = file
            .map(|file| &*file.source)
            .filter(|_| !covered.contains(&span))
        else {
            continue;
        };
        let cx = Cx {
            source,
            expansion,
            robot,
            kinematics,
            beside,
            selected_frame: None,
        };
        if ide::renameable_part(&cx, span.range.start).is_some_and(|(range, _)| range == span.range)
        {
            covered.extend(ide::rename_part(&cx, span.range.start, new)?);
        }
    }
    covered.retain(|span| !spans.contains(span));
    spans.extend(covered);
    Ok(())
}
