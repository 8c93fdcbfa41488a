//! Positions in files beside robots, and the names that these files hold.

use std::path::Path;
use std::sync::Arc;

use super::navigation::Asked;
use crate::failure::Failure;
use crate::state::State;
use analysis::{Analyzed, Beside, RootChoice};
use base::CancelFlag;
use ide::{self, BesideName, Cx};
use vfs::SourceFile;

/// The names of the robot in the files beside it.
pub fn names_beside(
    state: &mut State,
    root: &RootChoice,
    cancel: &CancelFlag,
) -> Result<Vec<BesideName>, Failure> {
    let files = state.world.beside(&root.file, cancel).ok_or(Failure::Cancelled)?;
    Ok(files.iter().flat_map(|file| names_in(state, file)).collect())
}

/// The names in a file beside the robot.
fn names_in(state: &State, beside: &Beside) -> Vec<BesideName> {
    if let Some((analyzed, srdf)) = beside.srdf() {
        return own_cx(analyzed).map(|cx| ide::names_in_srdf(&cx, srdf)).unwrap_or_default();
    }
    let text = state.world.session().vfs.text(&beside.path);
    let names = |settings| Some(ide::names_in_settings(beside.file, &text.ok()?.text, settings));
    beside.settings().and_then(names).unwrap_or_default()
}

/// A file in its own expansion.
fn own_cx(analyzed: &Analyzed) -> Option<Cx<'_>> {
    let source = &analyzed.expansion.files.first()?.source;
    let (expansion, robot) = (&analyzed.expansion, analyzed.robot.as_ref());
    Some(Cx { source, expansion, robot, kinematics: analyzed.kinematics.as_ref(), beside: &[], pinned: None })
}

/// A position in a file beside a robot, under that robot; none where it is at a name of xacro, or at none at all.
pub fn asked_beside(
    state: &mut State,
    (path, source): (&Path, &Arc<SourceFile>),
    offset: u32,
    cancel: &CancelFlag,
) -> Result<Option<Asked>, Failure> {
    let roots = state.world.robots_beside(path);
    if roots.is_empty() {
        return Ok(None);
    }
    // most places of YAML are at no name: no robot is expanded for them
    let own = state.world.beside_itself(path, cancel).ok_or(Failure::Cancelled)?;
    let names = own.map(|own| names_in(state, &own)).unwrap_or_default();
    if !names.iter().any(|name| name.place.range.touches(offset)) {
        return Ok(None);
    }
    for root in roots {
        let beside = names_beside(state, &root, cancel)?;
        let range = |name: &BesideName| name.place.file == source.id && name.place.range.touches(offset);
        if !beside.iter().any(range) {
            continue;
        }
        let analyzed = state.world.analyzed(&root, cancel).ok_or(Failure::Cancelled)?;
        let around = analyzed.clone();
        return Ok(Some(Asked { source: source.clone(), analyzed, around, offset, beside, pinned: None }));
    }
    Ok(None)
}
