//! Descriptions that launch files call or load, and that are not there, or are not to be loaded as they are.
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use super::session::Session;
use base::Span;
use packages::nearest;
use rules::{
    Finding, Group, Severity, launched_file_not_found, launched_without_xacro, own_instead,
};
use workspace::{RobotCall, is_ignored_by_git};
use xml::Document;

/// Looks for descriptions that launch files name and that are not there.
pub(super) struct LaunchedDescriptions<'s>(pub &'s Session);

impl LaunchedDescriptions<'_> {
    /// A description that is loaded without xacro, under none of the arguments of which there is a file, and that nothing makes.
    pub fn missing_load(&self, group: &[RobotCall]) -> Option<Finding> {
        let missing = self.missing_in(group)?;
        let may_appear = |load: &RobotCall| {
            let target = load.target.as_ref();
            target.is_some_and(|path| self.0.packages.may_be_made(path))
        };
        // by the program itself, or by another one that has the name
        let caller = &group.first()?.call.caller;
        let writes = |load: &RobotCall| {
            let writes = |by: &Path| self.writes_descriptions(by);
            let target = load.target.as_ref();
            target.is_some_and(|path| self.0.callers.name_where(path, writes))
        };
        let is_made = group.iter().any(may_appear)
            || self.writes_descriptions(caller)
            || group.iter().any(writes);
        (!is_made).then_some(missing)
    }

    /// A file for xacro that is loaded as it is, in a text that does not run xacro.
    pub fn unexpanded_load(&self, group: &[RobotCall]) -> Option<Finding> {
        let load = group
            .iter()
            .find(|load| self.is_unexpanded(load) && !self.is_expanded_too(load))?;
        let place = load.call.file.written().unwrap_or(load.call.range);
        let span = Span {
            file: self.0.vfs.file_id(&load.call.caller),
            range: place,
        };
        // what XML loads goes nowhere else; a program may expand or only read it
        let caller = &load.call.caller;
        let is_of_xml = |ending: &OsStr| ending == "launch" || ending == "xml";
        let is_xml = caller.extension().is_some_and(is_of_xml);
        let is_loaded = is_xml
            || self.0.packages.is_text(caller, |text| {
                text.contains("LaunchDescription") && !runs_xacro(text)
            });
        is_loaded.then(|| launched_without_xacro(span, &load.call.file.shown(), is_xml))
    }

    /// Whether the file of a call has the ending of xacro, and something for it.
    fn is_unexpanded(&self, load: &RobotCall) -> bool {
        let is_named = |path: &&PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.to_ascii_lowercase().contains(".xacro")
        };
        let source = load.target.as_ref().filter(is_named);
        let source = source.and_then(|path| self.0.vfs.document(path).ok());
        source.is_some_and(|source| needs_xacro(&source.document))
    }

    /// Whether the same launch file also runs xacro on the file of a call.
    fn is_expanded_too(&self, load: &RobotCall) -> bool {
        let calls = self.0.callers.calls(&load.call.caller);
        calls.iter().any(|call| {
            call.call.caller == load.call.caller
                && call.target.is_some()
                && call.target == load.target
        })
    }

    /// Whether a program looks whether files exist, or writes some itself or by xacro.
    fn writes_descriptions(&self, program: &Path) -> bool {
        const SIGNS: [&str; 8] = [
            "exists(",
            "isfile(",
            "'w'",
            "\"w\"",
            "write_text(",
            "xacro -o",
            "'-o'",
            "\"-o\"",
        ];
        self.0
            .packages
            .is_text(program, |text| SIGNS.iter().any(|sign| text.contains(sign)))
    }

    /// A description that a call names, under none of the arguments of which there is a file.
    pub fn missing_in(&self, group: &[RobotCall]) -> Option<Finding> {
        let mut targets = group.iter().filter_map(|call| call.target.as_ref());
        if targets.any(|path| self.0.vfs.is_file(path)) {
            return None;
        }
        let missing = group.iter().find(|call| self.is_missing(call))?;
        let span = self.place(missing);
        let near = self.similar_description(missing);
        let mut finding =
            launched_file_not_found(span, &missing.call.file.shown(), near.as_deref());
        // a launch file that names it again, as the default of an argument, is right once the path is
        let (caller, path) = (&missing.call.caller, missing.call.file.shown());
        finding.group = Some(Group::Thing(format!("{}: {path}", caller.display()).into()));
        // they separate folders on Windows, where the file may be found
        let is_for_windows = missing.call.file.shown().contains('\\');
        // whoever uses the package makes it
        let is_made = |path: &PathBuf| is_ignored_by_git(&self.0.packages, path);
        if is_for_windows || missing.target.as_ref().is_some_and(is_made) {
            finding.severity = Severity::Info;
        }
        Some(finding)
    }

    /// A description of a package that is not known, where the package of the launch file has it at the same path.
    pub fn of_other_package(&self, group: &[RobotCall]) -> Option<Finding> {
        let call = group.first()?;
        let (name, path) = call.call.file.in_package()?;
        let caller = &call.call.caller;
        if !call.call.file.is_known() || self.0.packages.find(name, caller).is_ok() {
            return None;
        }
        let path = path.trim_start_matches('/');
        let settings = self.0.settings(caller);
        let own = own_instead(self.0.rule_env(&settings.config), name, path, caller)?;
        let near = format!("`{path}` in package `{own}`");
        let shown = call.call.file.shown();
        let mut finding = launched_file_not_found(self.place(call), &shown, Some(&near));
        // the name of the package is wrong everywhere
        finding.group = Some(Group::Thing(format!("package {name}").into()));
        Some(finding)
    }

    /// Where a call names its file.
    fn place(&self, call: &RobotCall) -> Span {
        Span {
            file: self.0.vfs.file_id(&call.call.caller),
            range: call.call.file.written().unwrap_or(call.call.range),
        }
    }

    /// A description that a call may mean: one of the same name elsewhere, or one of a similar name beside it.
    fn similar_description(&self, call: &RobotCall) -> Option<String> {
        let missing = call.target.as_ref()?;
        let package = self.0.packages.containing(missing)?;
        let namesake = self
            .0
            .packages
            .namesake(missing, Some(&package.folder), &call.call.caller);
        let beside = || {
            let folder = missing.parent()?;
            let entries = self.0.vfs.list_dir(folder);
            let names = entries.iter().map(|entry| entry.name.as_str());
            let near = nearest(missing.file_name()?.to_str()?, names)?;
            Some(folder.join(near))
        };
        let found = namesake.or_else(beside)?;
        let owner = self.0.packages.containing(&found)?;
        let inside = vfs::slashed(found.strip_prefix(&owner.folder).ok()?);
        Some(if owner.folder == package.folder {
            format!("`{inside}`")
        } else {
            format!("`{inside}` in package `{}`", owner.name)
        })
    }

    /// Whether a call names a file in the tree that is not there.
    fn is_missing(&self, call: &RobotCall) -> bool {
        let Some(path) = call.target.as_ref().filter(|path| !self.0.vfs.exists(path)) else {
            return false;
        };
        // `$(arg robot).urdf` where the argument is empty by default, and somebody else gives it
        if path
            .file_name()
            .is_some_and(|name| name.to_string_lossy().starts_with('.'))
        {
            return false;
        }
        // of a path by itself, where it starts is not known
        let is_in_package = call.call.file.in_package().is_some();
        let package = self.0.packages.containing(path).filter(|_| is_in_package);
        package.is_some_and(|package| !self.is_named_by_build(&package.folder, path))
    }

    /// Whether the build of a package names a file that its folder does not have: it installs one from elsewhere, or makes it.
    fn is_named_by_build(&self, package: &Path, file: &Path) -> bool {
        let Some(name) = file.file_name().and_then(OsStr::to_str) else {
            return false;
        };
        let mut builds = ["setup.py", "CMakeLists.txt"].into_iter();
        builds.any(|build| {
            let build = self.0.vfs.text(&package.join(build));
            build.is_ok_and(|build| {
                let mut code = build
                    .text
                    .lines()
                    .filter(|line| !line.trim().starts_with('#'));
                code.any(|line| line.contains(name))
            })
        })
    }
}

/// Whether a text runs xacro, or hands a description on to what does: it has the word by itself or as a call, not only in names.
fn runs_xacro(text: &str) -> bool {
    const EXPANDS: [&str; 4] = [
        "MoveItConfigs",
        "ParameterBuilder",
        "load_robot_description",
        "urdf_launch",
    ];
    let is_run = |(at, word): (usize, &str)| {
        let before = text.get(..at).unwrap_or("");
        let after = text.get(at + word.len()..).unwrap_or("");
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let is_word = !before.ends_with(is_part) && !after.starts_with(is_part);
        !before.ends_with('.') && (is_word || after.starts_with('('))
    };
    text.match_indices("xacro").any(is_run)
        || EXPANDS.iter().any(|name| text.contains(name))
        || runs_own_program(text)
}

/// Whether a launch file takes what a program other than `cat` prints: it may run xacro.
fn runs_own_program(text: &str) -> bool {
    text.match_indices("Command(").any(|(at, word)| {
        let after = text.get(at + word.len()..).unwrap_or("");
        let is_open = |c: char| c.is_whitespace() || matches!(c, '[' | '(' | '"' | '\'');
        let program = after.trim_start_matches(is_open);
        !program.starts_with("cat") && !program.starts_with(')')
    })
}

/// Whether a description has elements of xacro that change it, or expressions: values alone do not, and neither does a block that
/// is inserted outside of a macro.
fn needs_xacro(document: &Document) -> bool {
    document.parts().any(|(_, item)| {
        item.all_nodes().any(|node| {
            let name = node.name();
            let is_value = ["xacro:property", "xacro:arg", "xacro:insert_block"].contains(&name);
            let mut values = node.attrs();
            let is_computed = |text: &str| text.contains("${") || text.contains("$(");
            !is_value && (name.starts_with("xacro:") || values.any(|attr| is_computed(attr.raw())))
        })
    })
}
