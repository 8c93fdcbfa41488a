//! What to write instead, where it can be said without asking anybody: fixes of what consumers reject or change.
//!
//! A fix is only offered when all consumers that the user names accept what it writes. It is safe when the robot stays
//! what it is: the same numbers with other white space, the same shape in another format.
use super::super::context::DocumentCx;
use super::super::conventions::{NamedElement, names, rename};
use super::super::edits::{is_called, removal, source_text, with_blanks};
use super::super::finding::Edit;
use super::super::inertia::{ADD_ROOT, massless_root};
use super::super::rule::Safety;
use super::super::sink::span;
use super::consumer::Consumer;
use super::fix::Remedy;
use super::met::Met;
use super::other_mesh::other_mesh;
use base::TextRange;
use expand::{FileRange, XId};
use model::{Link, attr_range, element_range, tag_start};

/// The fix of one of the constructs in a robot, for the consumers that the user names.
pub(super) fn remedy(
    cx: &DocumentCx<'_>,
    all: &[Met],
    met: &Met,
    wanted: &[&'static Consumer],
) -> Option<Remedy> {
    let row = met.construct.name.as_str();
    if matches!(met.construct.fault.as_deref(), Some("space-after" | "tab")) {
        return plain_spaces(cx, met);
    }
    match row {
        "root-inertia" => other_root(cx, met),
        "dynamics-empty" => remove(cx, met, ("dynamics", Safety::Safe)),
        "mimic-in-fixed" => remove(cx, met, ("mimic", Safety::Unsafe)),
        "version-1.1" | "version-1.2" => without_version(cx, all),
        _ => other_name(cx, met).or_else(|| other_mesh(cx, met, wanted)),
    }
}

/// Single spaces between numbers, and none around them.
fn plain_spaces(cx: &DocumentCx<'_>, met: &Met) -> Option<Remedy> {
    let (file, range, text) = source_text(cx.expansion, met.origin)?;
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let content = words.join(" ");
    let is_other = content != text && !text.contains(['&', '$']);
    let edit = Edit {
        span: span(cx.expansion, FileRange { file, range })?,
        content,
    };
    let message = "replace whitespace with single spaces".to_owned();
    is_other.then(|| Remedy {
        safety: Safety::Safe,
        message,
        edits: vec![edit],
    })
}

/// Without the element that begins where the construct is.
fn remove(cx: &DocumentCx<'_>, met: &Met, (name, safety): (&str, Safety)) -> Option<Remedy> {
    let tree = &cx.expansion.tree;
    let joints = cx
        .joints()
        .iter()
        .flat_map(|joint| tree.elements(joint.element));
    let is_it = |&id: &XId| tree.get(id).text == name && tag_start(cx.expansion, id) == met.origin;
    let element = joints
        .filter(|_| !is_called(cx.expansion, met.origin))
        .find(is_it)?;
    let (file, range) = removal(cx.expansion, element_range(cx.expansion, element))?;
    let edit = Edit {
        span: span(cx.expansion, FileRange { file, range })?,
        content: String::new(),
    };
    Some(Remedy {
        safety,
        message: format!("remove `{name}`"),
        edits: vec![edit],
    })
}

/// A root link without inertia, fixed to the one that has it.
fn other_root(cx: &DocumentCx<'_>, met: &Met) -> Option<Remedy> {
    let robot = cx.robot?;
    let has_it = |link: &&Link| {
        link.inertial
            .as_ref()
            .is_some_and(|inertial| tag_start(cx.expansion, inertial.element) == met.origin)
    };
    let link = robot.links.iter().find(has_it)?;
    let (place, content) = massless_root(cx.expansion, robot, link)?;
    let range = TextRange::empty(place.range.start);
    let edit = Edit {
        span: span(cx.expansion, FileRange { range, ..place })?,
        content,
    };
    Some(Remedy {
        safety: Safety::Unsafe,
        message: ADD_ROOT.to_owned(),
        edits: vec![edit],
    })
}

/// Without the version, where nothing of it is used.
fn without_version(cx: &DocumentCx<'_>, all: &[Met]) -> Option<Remedy> {
    let needs = |met: &Met| {
        let name = met.construct.name.as_str();
        name.contains("capsule")
            || name.contains("quaternion")
            || name.contains("rotations")
            || name == "limit-1.2"
    };
    let root = cx.robot.filter(|_| !all.iter().any(needs))?;
    let place = cx
        .expansion
        .place(attr_range(cx.expansion, root.element, "version")?)?;
    let range = with_blanks(cx.expansion, place.file, place.range);
    let edit = Edit {
        span: span(cx.expansion, FileRange { range, ..place })?,
        content: String::new(),
    };
    Some(Remedy {
        safety: Safety::Unsafe,
        message: "remove `version`".to_owned(),
        edits: vec![edit],
    })
}

/// Another name for a link or joint, wherever the description has it. Other files may name it: that is never safe.
fn other_name(cx: &DocumentCx<'_>, met: &Met) -> Option<Remedy> {
    let robot = cx.robot?;
    let (named, name) = names(robot).find(|(_, name)| name.origin == met.origin)?;
    let old = name.value.as_str();
    let new = match met.construct.name.as_str() {
        "link-universe"
        | "joint-universe"
        | "joint-world"
        | "link-world"
        | "link-world-fixed"
        | "root-world-with-body" => format!("{old}_{}", named.word()),
        "link-name-reserved-in-sdf" | "joint-name-reserved-in-sdf" => {
            old.trim_matches('_').to_owned()
        }
        "name-with-quote" => old.replace('"', "_"),
        // extensions for Gazebo may mean the one or the other
        "link-and-joint-of-one-name" if !is_referred_to(cx, old) => {
            format!("{old}_{}", NamedElement::Joint.word())
        }
        _ => return None,
    };
    let edits = rename(cx, named, old, &new).filter(|_| !new.is_empty())?;
    Some(Remedy {
        safety: Safety::Unsafe,
        message: format!("rename to `{new}` everywhere"),
        edits,
    })
}

/// Whether a `<gazebo>` is about a name.
fn is_referred_to(cx: &DocumentCx<'_>, name: &str) -> bool {
    let mut blocks = cx.robot.into_iter().flat_map(|robot| &robot.gazebo);
    blocks.any(|block| {
        block
            .reference
            .as_ref()
            .is_some_and(|reference| reference.value == name)
    })
}
