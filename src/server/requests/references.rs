//! All uses of a name: in the robot that the file is shown under, in the others that share it, and in YAML files.
use std::path::Path;

use lsp_types::{Location, ReferenceParams};

use crate::failure::RequestFailure;
use crate::locations::places;
use crate::requests::asked::Asked;
use crate::requests::branches::inside;
use crate::requests::launch::{in_launch_files, launched};
use crate::requests::navigation::asked_for_name;
use crate::scanning::scan_all;
use crate::state::ServerState;
use analysis::RootAnalysis;
use base::limits::RENAME_ROBOTS;
use base::{CancelFlag, Span, TextRange};
use expand::Read;
use ide::{self, Cx, NameOccurrence, RobotThing, TextNames};
use vfs::SourceFile;
use yaml::{YamlKind, YamlNode};

pub fn references(
    state: &mut ServerState,
    params: ReferenceParams,
    cancel: &CancelFlag,
) -> Result<Option<Vec<Location>>, RequestFailure> {
    // a robot that nobody has seen yet may use the name too
    scan_all(state, cancel)?;
    let at = &params.text_document_position;
    let mut asked = match launched(state, at, cancel)? {
        Some(found) => found.asked,
        None => match asked_for_name(state, at, cancel)? {
            Some(asked) => asked,
            None => return Ok(None),
        },
    };
    if ide::kind_at(&asked.cx(), &asked.names(state), asked.offset).is_none()
        && ide::robot_name_at(&asked.cx(), asked.offset).is_none()
    {
        asked = inside(state, &asked, cancel)?.unwrap_or(asked);
    }
    let with_definition = params.context.include_declaration;
    let mut uses = ide::occurrences(&asked.cx(), &asked.names(state), asked.offset);
    let is_symbol = ide::kind_at(&asked.cx(), &asked.names(state), asked.offset).is_some();
    let thing = ide::robot_name_at(&asked.cx(), asked.offset).filter(|_| !is_symbol);
    let mut robots = vec![asked.analyzed.clone()];
    robots.extend(sharing(state, &asked, &mut uses, thing.as_ref(), cancel)?);
    let uses = uses
        .into_iter()
        .filter(|used| with_definition || !used.is_definition);
    let mut spans: Vec<Span> = uses.map(|used| used.span).collect();
    if let Some(thing) = &thing {
        for place in robots.iter().flat_map(|robot| in_yaml(state, robot, thing)) {
            if !spans.contains(&place) {
                spans.push(place);
            }
        }
    }
    spans.extend(in_launch_files(state, &asked).0);
    let mut places = places(state);
    Ok(Some(
        spans
            .into_iter()
            .filter_map(|span| places.location(span))
            .collect(),
    ))
}

/// The other robots that read the text which gives a name; their uses are added.
fn sharing(
    state: &mut ServerState,
    asked: &Asked,
    uses: &mut Vec<NameOccurrence>,
    thing: Option<&RobotThing>,
    cancel: &CancelFlag,
) -> Result<Vec<std::sync::Arc<RootAnalysis>>, RequestFailure> {
    let given: Vec<Span> = uses
        .iter()
        .filter(|used| used.is_definition)
        .map(|used| used.span)
        .collect();
    let mut roots = Vec::new();
    for span in &given {
        let path = state.host.session().vfs.path(span.file);
        for (root, _) in analysis::context(&mut state.host, &path).candidates {
            if root != asked.analyzed.root && !roots.contains(&root) {
                roots.push(root);
            }
        }
    }
    let mut robots = Vec::new();
    for root in roots.into_iter().take(RENAME_ROBOTS) {
        let analyzed = state
            .host
            .analyzed(&root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        let found = in_robot(state, &analyzed, &given, thing);
        if !found.is_empty() {
            robots.push(analyzed);
        }
        for used in found {
            if !uses.iter().any(|known| known.span == used.span) {
                uses.push(used);
            }
        }
    }
    Ok(robots)
}

/// The values of the YAML files that a robot reads which are the name.
fn in_yaml(state: &ServerState, robot: &RootAnalysis, thing: &RobotThing) -> Vec<Span> {
    let vfs = &state.host.session().vfs;
    let mut found = Vec::new();
    for read in robot.expansion.record.iter() {
        let Read::File(path, _) = read else { continue };
        let Some(file) = Some(path)
            .filter(|path| is_yaml(path))
            .and_then(|path| vfs.yaml(path, "").ok())
        else {
            continue;
        };
        let mut places = Vec::new();
        if let Ok(root) = &file.value {
            values(root, &thing.name, &mut places);
        }
        let id = vfs.file_id(path);
        found.extend(places.into_iter().map(|range| Span { file: id, range }));
    }
    found
}

/// Whether a file is YAML, by its name.
fn is_yaml(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending == "yaml" || ending == "yml")
}

/// The uses of a name in another robot, when the text that gives it gives it there too.
fn in_robot(
    state: &ServerState,
    analyzed: &RootAnalysis,
    given: &[Span],
    thing: Option<&RobotThing>,
) -> Vec<NameOccurrence> {
    let expansion = &analyzed.expansion;
    let session = state.host.session();
    let settings = session.settings(&analyzed.root.file);
    let names = TextNames::of(expansion, session.rule_env(&settings.config));
    let source = |span: &Span| -> Option<&SourceFile> {
        let file = expansion
            .files
            .iter()
            .find(|file| file.source.id == span.file)?;
        Some(&file.source)
    };
    for span in given {
        let Some(source) = source(span) else { continue };
        let (kinematics, robot) = (analyzed.kinematics(), analyzed.robot.as_ref());
        let cx = Cx {
            source,
            expansion,
            robot,
            kinematics,
            beside: &[],
            selected_frame: None,
        };
        let found = match thing {
            Some(thing) => ide::uses_of(&cx, thing),
            None => ide::occurrences(&cx, &names, span.range.start),
        };
        if found
            .iter()
            .any(|used| used.is_definition && used.span == *span)
        {
            return found;
        }
    }
    Vec::new()
}

/// The places of the texts of a YAML value that are a name; keys are none.
fn values(node: &YamlNode, name: &str, found: &mut Vec<TextRange>) {
    match &node.kind {
        YamlKind::Str(text) if *text == name => found.push(node.range),
        YamlKind::List(items) => items.iter().for_each(|item| values(item, name, found)),
        YamlKind::Map(entries) => entries
            .iter()
            .for_each(|(_, value)| values(value, name, found)),
        _ => {}
    }
}
