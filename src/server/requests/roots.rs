//! `xacro/roots`, `xacro/setRoot` and `xacro/tree`: contexts and the kinematic tree.
use std::collections::BTreeMap;

use lsp_types::{Location, TextDocumentIdentifier, Url};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::contexts::{ShownContext, context_changed, seen_as};
use crate::failure::RequestFailure;
use crate::locations::location;
use crate::requests::expansion::{ExpandError, errors};
use crate::requests::mapping::{named, shown_under};
use crate::root_param::{RootParam, active_root, chosen};
use crate::state::ServerState;
use analysis::{RootAnalysis, RootConfig};
use base::CancelFlag;
use expand::Origin;

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct RootsParams {
    pub text_document: TextDocumentIdentifier,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct FileRoots {
    pub active: Option<RootParam>,
    /// What the file is seen as, for a status line: as `xacro/contextChanged` says it.
    pub text: String,
    /// The call of a macro of the file that was selected, such as `leg @ robot.urdf.xacro:41`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub instance: Option<String>,
    pub reason: &'static str,
    pub candidates: Vec<CandidateRoot>,
    pub args: Vec<RootArgument>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct CandidateRoot {
    #[serde(flatten)]
    pub root: RootParam,
    pub distance: u32,
}

/// An argument of the active root and its value there.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct RootArgument {
    pub name: String,
    pub value: String,
    /// The text of its `default`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub default: Option<String>,
    /// The comment above its declaration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub doc: Option<String>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetRootParams {
    pub root: Option<RootParam>,
    pub text_document: Option<TextDocumentIdentifier>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SetArgsParams {
    pub text_document: TextDocumentIdentifier,
    /// Values by name, over those that hold; an empty table takes back what was set.
    pub args: Option<BTreeMap<String, String>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct TreeParams {
    pub root: Option<RootParam>,
    pub text_document: Option<TextDocumentIdentifier>,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct RobotTree {
    pub nodes: Vec<TreeNode>,
    /// The files that name its links and joints.
    pub beside: Vec<FileBeside>,
    pub problems: Vec<ExpandError>,
}

/// A file beside a robot.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct FileBeside {
    pub uri: Url,
    /// A word for what it is for: `srdf`, `controllers`, `joint-limits` and so on.
    pub kind: &'static str,
}

/// A link, and the joint that holds it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct TreeNode {
    pub link: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parent: Option<String>,
    pub location: Location,
    /// kg
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
}

pub fn roots(
    state: &mut ServerState,
    params: RootsParams,
    cancel: &CancelFlag,
) -> Result<FileRoots, RequestFailure> {
    let (path, _) = state.source(&params.text_document.uri)?;
    let context = analysis::context(&mut state.host, &path);
    let mut args = Vec::new();
    if let Some(root) = &context.root {
        let analyzed = state
            .host
            .analyzed(root, cancel)
            .ok_or(RequestFailure::Cancelled)?;
        let known = analyzed.declared_arguments().into_iter();
        args.extend(known.map(|(name, value)| {
            let declared = ide::declared_argument(&analyzed.expansion, name);
            let (default, doc) = declared.unwrap_or_default();
            RootArgument {
                name: name.to_string(),
                value: value.to_string(),
                default,
                doc,
            }
        }));
    }
    let ShownContext { text, instance } = seen_as(state, &path, &context, cancel);
    let candidates = with_calls(state, &context.candidates);
    let candidates = candidates.iter().filter_map(|(root, distance)| {
        Some(CandidateRoot {
            root: named(state, root).ok()?,
            distance: *distance,
        })
    });
    Ok(FileRoots {
        active: context
            .root
            .as_ref()
            .and_then(|root| named(state, root).ok()),
        text,
        instance,
        reason: context.reason.text(),
        candidates: candidates.collect(),
        args,
    })
}

/// Roots, those without arguments followed by the calls of launch files.
fn with_calls(state: &ServerState, candidates: &[(RootConfig, u32)]) -> Vec<(RootConfig, u32)> {
    let session = state.host.session();
    let mut found: Vec<(RootConfig, u32)> = Vec::new();
    for (root, distance) in candidates {
        found.push((root.clone(), *distance));
        if root == &RootConfig::plain(&root.file) {
            found.extend(
                analysis::launched_roots(session, &root.file)
                    .into_iter()
                    .map(|call| (call, *distance)),
            );
        }
    }
    found
}

pub fn set_root(
    state: &mut ServerState,
    params: SetRootParams,
    cancel: &CancelFlag,
) -> Result<Value, RequestFailure> {
    let root = params.root.map(|root| chosen(state, root)).transpose()?;
    match &params.text_document {
        Some(document) => {
            let path = state.path(&document.uri);
            state.host.select(&path, root);
        }
        None => state.host.select_all(root),
    }
    context_changed(state, cancel);
    Ok(Value::Null)
}

/// Run the active root of a file with other values of some arguments for as long as the server lives; none:
/// back to those of the configuration. Answers with what holds then.
pub fn set_args(
    state: &mut ServerState,
    params: SetArgsParams,
    cancel: &CancelFlag,
) -> Result<FileRoots, RequestFailure> {
    let (path, _) = state.source(&params.text_document.uri)?;
    if let Some(args) = params.args {
        let mut root = active_root(state, &path);
        let file = root.file.clone();
        root.args.retain(|(known, _)| !args.contains_key(known));
        let taken_back = args.is_empty();
        root.args.extend(args);
        // all files of the robot are seen with these values
        for open in state.documents.keys().chain([&path]) {
            if analysis::context(&mut state.host, open)
                .root
                .is_some_and(|other| other.file == file)
            {
                state.host.select(open, (!taken_back).then(|| root.clone()));
            }
        }
        context_changed(state, cancel);
    }
    let text_document = TextDocumentIdentifier {
        uri: params.text_document.uri,
    };
    roots(state, RootsParams { text_document }, cancel)
}

pub fn tree(
    state: &mut ServerState,
    params: TreeParams,
    cancel: &CancelFlag,
) -> Result<RobotTree, RequestFailure> {
    let asked = params.root.as_ref().map(|root| TextDocumentIdentifier {
        uri: root.uri.clone(),
    });
    let Some(document) = params.text_document.or(asked) else {
        return Err(RequestFailure::Invalid(
            "missing parameter: pass `root` or `textDocument`".to_owned(),
        ));
    };
    let (_, analyzed) = shown_under(state, &document, params.root, cancel)?;
    let beside = analysis::files_beside(state.host.session(), &analyzed.root.file).into_iter();
    let beside = beside
        .filter_map(|(path, kind)| {
            Some(FileBeside {
                uri: state.uri(&path)?,
                kind,
            })
        })
        .collect();
    Ok(RobotTree {
        nodes: nodes(state, &analyzed),
        beside,
        problems: errors(state, &analyzed.expansion),
    })
}

/// The links of a robot, each with its joint, roots first.
fn nodes(state: &ServerState, analyzed: &RootAnalysis) -> Vec<TreeNode> {
    let (Some(robot), Some(kinematics)) = (&analyzed.robot, analyzed.kinematics()) else {
        return Vec::new();
    };
    let mut nodes = Vec::new();
    let mut open: Vec<usize> = kinematics.roots(robot).into_iter().rev().collect();
    let mut seen = vec![false; robot.links.len()];
    while let Some(index) = open.pop() {
        let Some(link) = robot.links.get(index) else {
            continue;
        };
        if seen
            .get_mut(index)
            .is_none_or(|seen| std::mem::replace(seen, true))
        {
            continue;
        }
        let joint = kinematics
            .parent_joints(index)
            .first()
            .and_then(|&joint| robot.joints.get(joint));
        let parent = joint.and_then(|joint| joint.parent.as_ref());
        let origin = link.name.as_ref().map(|name| name.origin);
        let location = origin.and_then(|origin| origin_location(state, analyzed, origin));
        nodes.extend(location.map(|location| TreeNode {
            link: link.shown().to_owned(),
            joint: joint.map(|joint| joint.shown().to_owned()),
            parent: parent.map(|parent| parent.value.to_string()),
            location,
            mass: link.inertial.as_ref().and_then(|inertial| inertial.mass()),
        }));
        let below = kinematics.child_joints(index).iter().rev();
        open.extend(below.filter_map(|&joint| Some(kinematics.ends(joint)?.1)));
    }
    nodes
}

fn origin_location(
    state: &ServerState,
    analyzed: &RootAnalysis,
    origin: Origin,
) -> Option<Location> {
    let place = analyzed.expansion.place(origin)?;
    let file = analyzed.expansion.files.get(place.file)?.source.id;
    location(
        state,
        base::Span {
            file,
            range: place.range,
        },
    )
}
