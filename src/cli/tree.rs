//! `xacro-lint tree`.

use std::path::PathBuf;

use serde_json::json;

use super::args::{TreeArgs, TreeFormat};
use super::check::warn_about_config;
use super::deps::beside;
use super::io::Io;
use super::options::{mappings, with_assignment};
use super::render::{visible, visible_name};
use super::{svg, text};
use analysis::{CheckOptions, Session, Setup};
use expand::{Expansion, Request, Sources, expand};
use model::{Joint, Kinematics, Robot};
use rules::{Category, Severity};
use vfs::Environment;

/// A robot whose links hang together as a tree.
pub(super) struct LinkTree<'a> {
    pub(super) robot: &'a Robot,
    pub(super) kinematics: Kinematics,
    /// The link at the top.
    pub(super) root: usize,
}

impl LinkTree<'_> {
    /// The name of a link.
    pub(super) fn link(&self, link: usize) -> &str {
        self.robot
            .links
            .get(link)
            .and_then(|link| link.name.as_ref())
            .map_or("", |name| name.value.as_str())
    }

    /// The joints below a link with the links they lead to, in the order of urdfdom.
    pub(super) fn children(&self, link: usize) -> impl DoubleEndedIterator<Item = (&Joint, usize)> {
        let joints = self.kinematics.child_joints(link).iter();
        joints.filter_map(|&joint| {
            Some((
                self.robot.joints.get(joint)?,
                self.kinematics.ends(joint)?.1,
            ))
        })
    }
}

/// The type of a joint, for people.
pub(super) fn kind(joint: &Joint) -> &str {
    joint.kind.as_ref().map_or("?", |kind| kind.value.as_str())
}

/// Run `tree`.
pub(super) fn run(args: &TreeArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let expanded = ExpandedRobot::of(&args.file, &args.package_path, env, io);
    let ExpandedRobot {
        file,
        arguments,
        session,
        expansion,
    } = match expanded {
        Ok(expanded) => expanded,
        Err(message) => return fails(io, &message),
    };
    let robot = Robot::of(&expansion);
    let Some(tree) = robot
        .as_ref()
        .filter(|_| !expansion.has_errors())
        .and_then(good_tree)
    else {
        explain(&session, &file, arguments, env, io);
        no_tree(&expansion, io);
        return 1;
    };
    match args.format {
        TreeFormat::Text => io.out(&text_tree(&tree, args.joints)),
        TreeFormat::Dot => io.out(&dot(&tree)),
        TreeFormat::Json => io.out(&format!("{:#}\n", as_json(&tree, beside(&session, &file)))),
        TreeFormat::Svg => io.out(&svg::draw(&tree)),
    }
    0
}

/// Say that the links make no tree, unless what was found before is why there are none to speak of.
pub(super) fn no_tree(expansion: &Expansion, io: &mut Io<'_>) {
    if expansion.has_errors() {
        io.line("error: cannot print the tree because of the errors above");
    } else {
        io.line("error: cannot print the tree: the links do not form one tree");
    }
}

pub(super) fn fails(io: &mut Io<'_>, message: &str) -> u8 {
    io.line(&format!("error: {}", visible(message)));
    2
}

/// The tree of a robot in which every link but one hangs on exactly one joint.
pub(super) fn good_tree(robot: &Robot) -> Option<LinkTree<'_>> {
    let kinematics = Kinematics::of(robot);
    robot.name.as_ref().filter(|name| !name.value.is_empty())?;
    let mut roots = kinematics.roots(robot).into_iter();
    let (root, None) = (roots.next()?, roots.next()) else {
        return None;
    };
    // n links in a tree hang on n - 1 joints; a cycle would need one more, a loose link one less
    let single = (0..robot.links.len())
        .all(|link| kinematics.parent_joints(link).len() == usize::from(link != root));
    let joined = (0..robot.joints.len()).all(|joint| kinematics.ends(joint).is_some());
    (single && joined && kinematics.cycles().is_empty()).then_some(LinkTree {
        robot,
        kinematics,
        root,
    })
}

/// Say what keeps a robot from being one.
pub(super) fn explain(
    session: &Session,
    file: &str,
    args: Vec<(String, String)>,
    env: &Environment,
    io: &mut Io<'_>,
) {
    let options = CheckOptions {
        entries: vec![file.into()],
        args,
        ..CheckOptions::default()
    };
    let mut report = analysis::check(session, &options);
    let categories = [
        Category::Xml,
        Category::Xacro,
        Category::Structure,
        Category::Package,
    ];
    report
        .findings
        .retain(|f| f.severity == Severity::Error && categories.contains(&f.rule.category));
    for line in text::drawings(
        report.findings.iter(),
        &report,
        &session.packages,
        &env.cwd,
        io.color,
    ) {
        io.line(&line);
    }
}

/// The robot that a command line names, expanded.
pub(super) struct ExpandedRobot {
    pub(super) file: String,
    pub(super) arguments: Vec<(String, String)>,
    pub(super) session: Session,
    pub(super) expansion: Expansion,
}

impl ExpandedRobot {
    /// Expand the one file among `names` with the arguments there; the message of an error when it cannot be read.
    pub(super) fn of(
        names: &[String],
        package_path: &[String],
        env: &Environment,
        io: &mut Io<'_>,
    ) -> Result<Self, String> {
        let (file, arguments) = file_and_arguments(names)?;
        let session = open(&file, package_path, env, io)?;
        let expansion = expand_in(&session, &file, arguments.clone());
        match &expansion.root_error {
            Some(error) => Err(format!("{file}: {}", error.reason())),
            None => Ok(Self {
                file,
                arguments,
                session,
                expansion,
            }),
        }
    }
}

/// A session about one file.
pub(super) fn open(
    file: &str,
    package_path: &[String],
    env: &Environment,
    io: &mut Io<'_>,
) -> Result<Session, String> {
    let package_path = package_path.iter().map(PathBuf::from).collect();
    let setup = Setup {
        about: file.into(),
        package_path,
        ..Setup::default()
    };
    let session = Session::new(env, setup).map_err(|error| error.to_string())?;
    warn_about_config(&session, env, io);
    Ok(session)
}

pub(super) fn expand_in(session: &Session, file: &str, args: Vec<(String, String)>) -> Expansion {
    let sources = Sources {
        vfs: &session.vfs,
        packages: &session.packages,
        env: &session.env,
    };
    expand(
        sources,
        &Request {
            file: file.to_owned(),
            args,
            ..Request::default()
        },
    )
}

/// The one file among `names`, and the arguments.
pub(super) fn file_and_arguments(
    names: &[String],
) -> Result<(String, Vec<(String, String)>), String> {
    let arguments = mappings(names.iter().map(String::as_str)).map_err(|error| error.message())?;
    let mut files = names.iter().filter(|name| !name.contains(":="));
    match (files.next(), files.next()) {
        (Some(file), None) => Ok((file.clone(), arguments)),
        (Some(_), Some(other)) => Err(with_assignment("expected exactly one file", other)),
        _ => Err("expected exactly one file".to_owned()),
    }
}

/// What `check_urdf` prints; `joints` adds names and types of joints.
fn text_tree(tree: &LinkTree<'_>, joints: bool) -> String {
    let name = tree
        .robot
        .name
        .as_ref()
        .map_or("", |name| name.value.as_str());
    let name = visible_name(name);
    let mut out =
        format!("robot name is: {name}\n---------- Successfully Parsed XML ---------------\n");
    let count = tree.children(tree.root).count();
    out.push_str(&format!(
        "root Link: {} has {count} child(ren)\n",
        visible_name(tree.link(tree.root))
    ));
    // links still to be printed: level, number among its siblings, joint
    let mut open: Vec<(usize, usize, &Joint, usize)> = Vec::new();
    open.extend(below(tree, tree.root, 1));
    while let Some((level, number, joint, link)) = open.pop() {
        let by = if joints {
            format!("  [{}: {}]", joint.shown(), kind(joint))
        } else {
            String::new()
        };
        let (indent, shown) = (
            "    ".repeat(level),
            visible_name(&format!("{}{by}", tree.link(link))),
        );
        out.push_str(&format!("{indent}child({number}):  {shown}\n"));
        open.extend(below(tree, link, level + 1));
    }
    out
}

/// The joints below a link, the last one first: level, number among its siblings, joint, link.
fn below<'t>(
    tree: &'t LinkTree<'_>,
    link: usize,
    level: usize,
) -> impl Iterator<Item = (usize, usize, &'t Joint, usize)> {
    let children: Vec<_> = tree.children(link).enumerate().collect();
    children
        .into_iter()
        .rev()
        .map(move |(i, (joint, child))| (level, i + 1, joint, child))
}

/// Links and joints in document order, as lists: trees may be deeper than JSON readers bear.
fn as_json(tree: &LinkTree<'_>, beside: serde_json::Value) -> serde_json::Value {
    let text = |text: &Option<model::AttrValue>| text.as_ref().map(|text| text.value.to_string());
    let links: Vec<_> = (0..tree.robot.links.len())
        .map(|link| tree.link(link))
        .collect();
    let joints: Vec<_> = tree
        .robot
        .joints
        .iter()
        .map(|j| {
            json!({
                "name": j.shown(),
                "type": kind(j),
                "parent": text(&j.parent),
                "child": text(&j.child),
            })
        })
        .collect();
    json!({
        "beside": beside,
        "robot": text(&tree.robot.name),
        "root": tree.link(tree.root),
        "links": links,
        "joints": joints,
    })
}

/// For Graphviz: boxes for links, ellipses for joints.
fn dot(tree: &LinkTree<'_>) -> String {
    let name = tree
        .robot
        .name
        .as_ref()
        .map_or("", |name| name.value.as_str());
    let mut out = format!("digraph {} {{\n  node [shape=box];\n", quoted(name));
    for link in 0..tree.robot.links.len() {
        out.push_str(&format!("  {};\n", quoted(tree.link(link))));
    }
    for joint in &tree.robot.joints {
        let Some((parent, child)) = joint.ends() else {
            continue;
        };
        let (name, kind) = (quoted(joint.shown()), quoted(kind(joint)));
        let label = format!(
            "{}\\n{}",
            name.trim_end_matches('"'),
            kind.trim_start_matches('"')
        );
        out.push_str(&format!(
            "  {} -> {} [label={label}];\n",
            quoted(parent),
            quoted(child)
        ));
    }
    out.push_str("}\n");
    out
}

/// A text as Graphviz takes it.
fn quoted(text: &str) -> String {
    let shown = visible_name(text)
        .replace('\\', "\\\\")
        .replace('"', "\\\"");
    format!("\"{shown}\"")
}
