//! The calls of robots below a folder: those of each launch file by itself, and those under the arguments that other launch
//! files include it with.

use std::path::{Path, PathBuf};

use base::limits::{CALLER_CALLS, LAUNCH_CALLS, LAUNCH_INCLUDES};
use base::{FastMap, FastSet, TextRange};

use super::choices::{Excluded, excluded};
use super::uses::{Uses, search};
use super::{Callers, GivenArg};
use crate::launch::{
    self, LaunchCall, LaunchContext, LaunchFile, SpawnedController, StaticTransform, calls_in,
    forget_defaults, included, loads_in, opened_in, spawned_in, transforms_in,
};
use packages::Packages;
use std::sync::Arc;

/// A call, or a description that is loaded as it is, and the file that is named.
#[derive(Clone, Debug)]
pub struct RobotCall {
    /// What the launch file says.
    pub call: LaunchCall,
    /// The description, whether or not it is there; none where the name or the package is not known, and where the build
    /// makes it from a template.
    pub target: Option<PathBuf>,
}

/// A transform that a launch file publishes.
#[derive(Clone, Debug)]
pub struct PublishedTransform {
    /// The launch file.
    pub file: PathBuf,
    /// What it publishes.
    pub transform: StaticTransform,
    /// The launch file, and those that are always started with it.
    pub started: Vec<PathBuf>,
}

/// The controllers that a launch file starts.
#[derive(Clone, Debug)]
pub struct SpawnedControllers {
    /// The launch file.
    pub file: PathBuf,
    /// What it starts.
    pub controllers: Vec<SpawnedController>,
    /// The launch file, and those that are always started with it.
    pub started: Vec<PathBuf>,
    /// The launch file, and all those that it may start; none where not all are known.
    pub reached: Option<Vec<PathBuf>>,
}

/// A node that loads the hardware of a robot, whenever its launch file is started.
#[derive(Clone, Debug)]
pub struct ControlNode {
    /// The launch file.
    pub file: PathBuf,
    /// Where it is started.
    pub range: TextRange,
    /// The launch file, and those that it includes.
    pub started: Vec<PathBuf>,
}

/// What the launch files below a folder say.
pub(super) struct LaunchCalls {
    pub calls: Arc<Vec<RobotCall>>,
    /// The descriptions that they load without xacro.
    pub loads: Arc<Vec<RobotCall>>,
    /// The other files that they name.
    pub opened: Arc<Vec<RobotCall>>,
    /// The transforms that they publish themselves.
    pub transforms: Arc<Vec<PublishedTransform>>,
    /// The controllers that they start.
    pub spawned: Arc<Vec<SpawnedControllers>>,
    /// The nodes that load hardware.
    pub control_nodes: Arc<Vec<ControlNode>>,
    /// The values that choices rule out.
    pub excluded: Arc<Vec<Excluded>>,
}

impl Callers {
    /// All calls in the sources around a file, in the order of the paths of the files that call.
    pub fn calls(&self, file: &Path) -> Arc<Vec<RobotCall>> {
        let Some(top) = self.packages.sources_around(file) else {
            return Arc::default();
        };
        self.calls_below(&top)
    }

    /// All calls below a folder.
    pub fn calls_below(&self, top: &Path) -> Arc<Vec<RobotCall>> {
        self.called_below(top).calls.clone()
    }

    /// The descriptions that launch files below a folder load as they are, without xacro, in the order of the paths of the files.
    pub fn loads_below(&self, top: &Path) -> Arc<Vec<RobotCall>> {
        self.called_below(top).loads.clone()
    }

    /// Other files that launch files below a folder name, in the order of the paths of the launch files.
    pub fn opened_below(&self, top: &Path) -> Arc<Vec<RobotCall>> {
        self.called_below(top).opened.clone()
    }

    /// The transforms that launch files below a folder publish themselves, in the order of the paths of the files.
    pub fn transforms_below(&self, top: &Path) -> Arc<Vec<PublishedTransform>> {
        self.called_below(top).transforms.clone()
    }

    /// The controllers that launch files below a folder start, in the order of the paths of the files.
    pub fn spawned_below(&self, top: &Path) -> Arc<Vec<SpawnedControllers>> {
        self.called_below(top).spawned.clone()
    }

    /// The nodes that load hardware in launch files below a folder, in the order of the paths of the files.
    pub fn control_nodes_below(&self, top: &Path) -> Arc<Vec<ControlNode>> {
        self.called_below(top).control_nodes.clone()
    }

    /// What the launch files below a folder say.
    pub(super) fn called_below(&self, top: &Path) -> Arc<LaunchCalls> {
        let uses = self.below.get(top.to_owned(), || {
            Arc::new(search(self.packages.vfs(), top))
        });
        self.called
            .get(top.to_owned(), || Arc::new(all(&uses, &self.packages)))
    }
}

impl Callers {
    /// The arguments of each call of the description `file` whose launch file names it somehow, also through other launch files.
    pub fn given(&self, file: &Path) -> Vec<Vec<GivenArg>> {
        let all = self.calls(file);
        let calls = all
            .iter()
            .filter(|call| call.target.as_deref() == Some(file));
        let given = |RobotCall { call, .. }: &RobotCall| {
            let args = call.args.iter().map(|argument| GivenArg {
                name: argument.name.clone(),
                value: argument.given(&self.packages, &call.caller),
            });
            args.collect()
        };
        calls.map(given).collect()
    }
}

/// The calls of all launch files, and of those again that others include with further arguments.
fn all(uses: &Uses, packages: &Packages) -> LaunchCalls {
    let read = |path: &PathBuf| launch::read(path, &packages.vfs().text(path).ok()?.text);
    let files: Vec<LaunchFile> = uses.scripts.iter().filter_map(read).collect();
    let by_path: FastMap<&Path, &LaunchFile> = files
        .iter()
        .map(|file| (file.path.as_path(), file))
        .collect();
    let mut found = FoundCalls::default();
    for file in &files {
        found
            .calls
            .extend(calls_in(file, &LaunchContext::default()));
        found
            .loads
            .extend(loads_in(file, &LaunchContext::default()));
        found
            .opened
            .extend(opened_in(file, &LaunchContext::default()));
    }
    for file in &files {
        through(
            file,
            &LaunchContext::default(),
            &by_path,
            packages,
            &mut found,
        );
    }
    let all = found.calls.iter().chain(&found.loads);
    let with_robots: FastSet<&Path> = all.map(|call| call.caller.as_path()).collect();
    let started = started_with(&files, &with_robots, &by_path, packages);
    let package = |path: &Path| packages.containing(path).map(|package| package.folder);
    let of_robots: FastSet<PathBuf> = with_robots
        .iter()
        .filter_map(|path| package(path))
        .collect();
    found.opened.retain(|one| {
        let is_beside = || package(&one.caller).is_some_and(|folder| of_robots.contains(&folder));
        started.contains(one.caller.as_path()) || is_beside()
    });
    let transforms = files.iter().flat_map(|file| {
        let all = transforms_in(file).into_iter();
        all.map(|transform| PublishedTransform {
            file: file.path.clone(),
            transform,
            started: started_by(file, &by_path, packages),
        })
    });
    let spawned = files.iter().filter_map(|file| {
        let controllers = spawned_in(file);
        (!controllers.is_empty()).then(|| SpawnedControllers {
            file: file.path.clone(),
            controllers,
            started: started_by(file, &by_path, packages),
            reached: reached_from(file, &by_path, packages),
        })
    });
    let control_nodes = files.iter().flat_map(|file| {
        let always = file.control_nodes.iter();
        let always = always.filter(|command| command.assumed.is_empty());
        always.map(|command| ControlNode {
            file: file.path.clone(),
            range: command.range,
            started: started_by(file, &by_path, packages),
        })
    });
    LaunchCalls {
        control_nodes: Arc::new(control_nodes.collect()),
        calls: with_targets(found.calls, packages),
        loads: with_targets(found.loads, packages),
        opened: with_targets(found.opened, packages),
        transforms: Arc::new(transforms.collect()),
        spawned: Arc::new(spawned.collect()),
        excluded: Arc::new(excluded(&files, &by_path, packages)),
    }
}

/// A launch file, and those that it includes whatever its arguments are.
fn started_by(
    file: &LaunchFile,
    by_path: &FastMap<&Path, &LaunchFile>,
    packages: &Packages,
) -> Vec<PathBuf> {
    let mut started = vec![file.path.clone()];
    let mut open = vec![file];
    while let Some(file) = open.pop() {
        let all = included(file, &LaunchContext::default());
        let always = file.includes.iter().zip(all);
        for (_, (name, _)) in always.filter(|(include, _)| include.assumed.is_empty()) {
            let path = name.path(packages, &file.path);
            let path = path.map(|path| packages.present(&path).into_owned());
            let Some(inner) = path.and_then(|path| by_path.get(path.as_path()).copied()) else {
                continue;
            };
            if started.len() <= LAUNCH_INCLUDES && !started.contains(&inner.path) {
                started.push(inner.path.clone());
                open.push(inner);
            }
        }
    }
    started
}

/// A launch file, and all that it may include, but for those of packages that start a simulator; none where not all are known.
fn reached_from(
    file: &LaunchFile,
    by_path: &FastMap<&Path, &LaunchFile>,
    packages: &Packages,
) -> Option<Vec<PathBuf>> {
    /// Packages of others whose launch files are known.
    const KNOWN: [&str; 5] = [
        "gazebo_ros",
        "nav2_bringup",
        "ros_gz_sim",
        "ros_ign_gazebo",
        "slam_toolbox",
    ];
    let mut reached = vec![file.path.clone()];
    let mut next = 0;
    while let Some(path) = reached.get(next).cloned() {
        next += 1;
        let Some(file) = by_path.get(path.as_path()) else {
            continue;
        };
        for (name, _) in included(file, &LaunchContext::default()) {
            let of_others = name.in_package().map(|(package, _)| package);
            if of_others.is_some_and(|package| KNOWN.contains(&package)) {
                continue;
            }
            let path = name.path(packages, &file.path)?;
            let path = packages.present(&path).into_owned();
            if !packages.vfs().is_file(&path) || reached.len() > LAUNCH_CALLS {
                return None;
            }
            if !reached.contains(&path) {
                reached.push(path);
            }
        }
    }
    Some(reached)
}

/// The launch files that start one of some launch files, and all that those start.
fn started_with<'f>(
    files: &'f [LaunchFile],
    some: &FastSet<&Path>,
    by_path: &FastMap<&Path, &'f LaunchFile>,
    packages: &Packages,
) -> FastSet<&'f Path> {
    let includes = |file: &'f LaunchFile| {
        let all = included(file, &LaunchContext::default()).into_iter();
        let paths = all.filter_map(|(name, _)| name.path(packages, &file.path));
        let inner = paths.filter_map(|path| by_path.get(&*packages.present(&path)).copied());
        inner.map(|inner| inner.path.as_path()).collect()
    };
    let includes: FastMap<&Path, Vec<&Path>> = files
        .iter()
        .map(|file| (file.path.as_path(), includes(file)))
        .collect();
    let mut found: FastSet<&Path> = FastSet::default();
    for file in files {
        let mut started = vec![file.path.as_path()];
        let mut next = 0;
        while let Some(inner) = started.get(next).and_then(|path| includes.get(path)) {
            for path in inner {
                if !started.contains(path) {
                    started.push(path);
                }
            }
            next += 1;
        }
        if started.iter().any(|path| some.contains(path)) {
            found.extend(started);
        }
    }
    found
}

/// What launch files call and load.
#[derive(Default)]
struct FoundCalls {
    calls: Vec<LaunchCall>,
    loads: Vec<LaunchCall>,
    opened: Vec<LaunchCall>,
}

/// Put what is not known yet behind other calls.
fn add(all: &mut Vec<LaunchCall>, calls: Vec<LaunchCall>) {
    for call in calls {
        let is_it = |known: &LaunchCall| known.caller == call.caller && known.is_same(&call);
        if !all.iter().any(is_it) {
            all.push(call);
        }
    }
}

/// Calls in the order of their places, each with the file that it names.
fn with_targets(mut calls: Vec<LaunchCall>, packages: &Packages) -> Arc<Vec<RobotCall>> {
    calls.truncate(CALLER_CALLS);
    calls.sort_by(|a, b| {
        (&a.caller, a.range.start, &a.through).cmp(&(&b.caller, b.range.start, &b.through))
    });
    let with_target = |call: LaunchCall| RobotCall {
        target: target(&call, packages),
        call,
    };
    Arc::new(calls.into_iter().map(with_target).collect())
}

/// The calls of the files that a launch file includes.
fn through(
    file: &LaunchFile,
    context: &LaunchContext,
    by_path: &FastMap<&Path, &LaunchFile>,
    packages: &Packages,
    found: &mut FoundCalls,
) {
    let kinds = [&found.calls, &found.loads, &found.opened];
    let is_full = kinds.into_iter().any(|calls| calls.len() > CALLER_CALLS);
    if context.through.len() >= LAUNCH_INCLUDES || is_full {
        return;
    }
    let included: Vec<(Option<&LaunchFile>, LaunchContext)> = included(file, context)
        .into_iter()
        .map(|(name, context)| {
            let path = name.path(packages, &file.path);
            let path = path.map(|path| packages.present(&path).into_owned());
            let inner = path.and_then(|path| by_path.get(path.as_path()).copied());
            (inner, context)
        })
        .collect();
    for (number, (inner, context)) in included.iter().enumerate() {
        let Some(inner) = inner.filter(|inner| !context.through.contains(&inner.path)) else {
            continue;
        };
        let mut context = context.clone();
        if file.shares {
            let others = included
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != number);
            forget_defaults(
                &mut context,
                inner,
                others.filter_map(|(_, (other, _))| *other),
            );
        }
        add(&mut found.calls, calls_in(inner, &context));
        add(&mut found.loads, loads_in(inner, &context));
        add(&mut found.opened, opened_in(inner, &context));
        through(inner, &context, by_path, packages, found);
    }
}

/// The description that a call names, as it is in the source tree; none for one that the build makes from a template.
pub(super) fn target(call: &LaunchCall, packages: &Packages) -> Option<PathBuf> {
    let path = call.file.path(packages, &call.caller)?;
    // what the build does is only read for what is not there without it
    if packages.vfs().exists(&path) {
        return Some(path);
    }
    match packages.built(&path) {
        Some(built) if built.is_template => None,
        Some(built) => Some(built.path),
        None => Some(path),
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::callers_in;
    use vfs::testing::Tree;

    const INNER: &str = "DeclareLaunchArgument('side', default_value='left')\n\
                         Command(['xacro ', '/r/a.xacro', ' side:=', LaunchConfiguration('side')])\n";

    /// Check the values that a launch file gives `side` of the robot of another one.
    fn check_sides(outer: &str, expected: &[&str]) {
        let tree = Tree::new();
        tree.write("package.xml", "<package><name>p</name></package>");
        tree.write("launch/inner.launch.py", INNER);
        let other = "DeclareLaunchArgument('side', default_value='none')\nCommand(['xacro ', '/r/b.xacro'])\n";
        tree.write("launch/other.launch.py", other);
        let path = "inner = os.path.join(os.path.dirname(__file__), 'inner.launch.py')\n";
        tree.write("launch/outer.launch.py", &format!("{path}{outer}"));
        let calls = callers_in(&tree).calls_below(tree.root());
        let through = calls.iter().filter(|call| !call.call.through.is_empty());
        let sides: Vec<String> = through
            .flat_map(|call| &call.call.args)
            .map(|argument| argument.value.shown())
            .collect();
        assert_eq!(sides, expected, "{outer}");
    }

    #[test]
    fn includes_beside_each_other_share_what_they_are_given() {
        let right = "IncludeLaunchDescription(inner, launch_arguments={'side': 'right'}.items())\n";
        check_sides(right, &["right"]);
        let plain = "IncludeLaunchDescription(inner)\n";
        // the second one sees `right`, unless a group is around the first
        check_sides(&format!("{right}{plain}"), &["right", "?"]);
        let own = "DeclareLaunchArgument('side', default_value='middle')\n";
        check_sides(&format!("{own}{plain}"), &["middle"]);
        check_sides(&format!("{own}{right}{plain}"), &["right", "?"]);
        let same = "IncludeLaunchDescription(inner, launch_arguments={'side': LaunchConfiguration('side')}.items())\n";
        check_sides(&format!("{own}{same}{plain}"), &["middle"]);
        // the default of another file may come first
        let other = "IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'other.launch.py'))\n";
        check_sides(&format!("{other}{plain}"), &["?"]);
    }
}
