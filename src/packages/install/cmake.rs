//! What a `CMakeLists.txt` installs. It is read, never run: both branches of a condition count, functions and macros
//! are passed over, and what cannot be worked out from the text is left out.

use std::path::{Path, PathBuf};

use super::commands::{CMakeArgument, CMakeCommand, commands};
use super::required;
use super::{Build, InstallSource, stem, tidy};
use base::limits::{BUILD_BYTES, BUILD_DEPTH, GLOB_ENTRIES};
use base::{FastMap, FastSet};
use vfs::Vfs;

/// Name of the build files of CMake.
pub(super) const CMAKE_LISTS: &str = "CMakeLists.txt";

/// In front of the folders that CMake builds in: a path that no file has.
const BUILD_TREE: &str = "\0build";

/// Words that end a list of files in `install` and `file(COPY)`.
pub(super) const KEYWORDS: [&str; 18] = [
    "DESTINATION",
    "TYPE",
    "PATTERN",
    "REGEX",
    "FILES_MATCHING",
    "USE_SOURCE_PERMISSIONS",
    "NO_SOURCE_PERMISSIONS",
    "FILE_PERMISSIONS",
    "DIRECTORY_PERMISSIONS",
    "PERMISSIONS",
    "OPTIONAL",
    "MESSAGE_NEVER",
    "CONFIGURATIONS",
    "COMPONENT",
    "EXCLUDE_FROM_ALL",
    "RENAME",
    "EXCLUDE",
    "FOLLOW_SYMLINK_CHAIN",
];

/// Read the build file of a folder into `build`.
pub(super) fn read(vfs: &Vfs, folder: &Path, build: &mut Build) {
    let (left, entries) = (BUILD_BYTES, GLOB_ENTRIES);
    let mut reader = CMakeReader {
        vfs,
        build,
        top: folder,
        conditions: 0,
        uncertain: FastSet::default(),
        variables: FastMap::default(),
        handed_up: Vec::new(),
        left,
        entries,
    };
    for (name, value) in [
        ("CMAKE_INSTALL_DATADIR", "share"),
        ("CMAKE_INSTALL_DATAROOTDIR", "share"),
        ("CMAKE_INSTALL_FULL_DATADIR", "share"),
        ("CATKIN_GLOBAL_SHARE_DESTINATION", "share"),
        ("SHARE_INSTALL_DIR", "share"),
        ("CMAKE_INSTALL_PREFIX", ""),
    ] {
        reader.set(name, value.to_owned());
    }
    for name in ["CMAKE_SOURCE_DIR", "PROJECT_SOURCE_DIR"] {
        reader.set(name, text(folder));
    }
    for name in ["CMAKE_BINARY_DIR", "PROJECT_BINARY_DIR"] {
        reader.set(name, text(&build_folder(folder)));
    }
    reader.folder(folder, 0);
}

/// The name that the build file of a folder gives its project.
pub(super) fn project(text: &str) -> Option<String> {
    let project = commands(text)
        .into_iter()
        .find(|command| command.name == "project")?;
    project
        .arguments
        .into_iter()
        .next()
        .map(|argument| argument.text)
}

/// An argument with its variables replaced; none when one of them is not known.
type CMakeWord = Option<String>;

pub(super) struct CMakeReader<'a> {
    vfs: &'a Vfs,
    pub(super) build: &'a mut Build,
    /// The folder of the package.
    pub(super) top: &'a Path,
    /// How many conditions are around the command.
    pub(super) conditions: u32,
    /// The variables that commands under a condition set.
    pub(super) uncertain: FastSet<String>,
    variables: FastMap<String, String>,
    /// The variables that the folder sets for the one around it; none: to what is not known.
    handed_up: Vec<(String, Option<String>)>,
    /// How much more is read, in bytes of arguments.
    left: u32,
    /// How many more entries of folders patterns may look at.
    entries: usize,
}

/// The file that is read.
#[derive(Clone, Copy)]
pub(super) struct CMakeFile<'a> {
    pub(super) path: &'a Path,
    /// The folder that its paths start from.
    pub(super) folder: &'a Path,
    depth: u32,
}

impl CMakeReader<'_> {
    fn set(&mut self, name: &str, value: String) {
        self.variables.insert(name.to_owned(), value);
    }

    /// The build file of a folder, which has variables of its own.
    fn folder(&mut self, folder: &Path, depth: u32) {
        let outer = self.variables.clone();
        let handed_up = std::mem::take(&mut self.handed_up);
        self.set("CMAKE_CURRENT_SOURCE_DIR", text(folder));
        self.set("CMAKE_CURRENT_LIST_DIR", text(folder));
        self.set("CMAKE_CURRENT_BINARY_DIR", text(&build_folder(folder)));
        self.file(&folder.join(CMAKE_LISTS), folder, depth);
        self.variables = outer;
        for (name, value) in std::mem::replace(&mut self.handed_up, handed_up) {
            self.assign_value(name, value);
        }
    }

    fn assign_value(&mut self, name: String, value: Option<String>) {
        match value {
            Some(value) => drop(self.variables.insert(name, value)),
            None => drop(self.variables.remove(&name)),
        }
    }

    fn add(&mut self, to: PathBuf, source: InstallSource) {
        /// Of so many bytes of arguments, one rule: what is installed is searched once for each missing file.
        const PRICE: u32 = 20;
        if self.left >= PRICE {
            self.left -= PRICE;
            self.build.add(to, source);
        }
    }

    fn file(&mut self, path: &Path, folder: &Path, depth: u32) {
        if depth > BUILD_DEPTH || self.build.files.len() > BUILD_DEPTH as usize * 10 {
            return;
        }
        self.build.files.push(path.to_owned());
        if let Ok(file) = self.vfs.text(path) {
            let here = CMakeFile {
                path,
                folder,
                depth,
            };
            self.run(&commands(&file.text), here);
        }
    }

    fn run(&mut self, commands: &[CMakeCommand], here: CMakeFile<'_>) {
        let mut rest = commands;
        while let Some((command, behind)) = rest.split_first() {
            rest = match command.name.as_str() {
                "foreach" => {
                    let (body, behind) = block(behind, "foreach", "endforeach");
                    self.repeat(command, body, here);
                    behind
                }
                "function" | "macro" => {
                    block(behind, &command.name, &format!("end{}", command.name)).1
                }
                _ => {
                    self.command(command, here);
                    behind
                }
            };
        }
    }

    fn repeat(&mut self, command: &CMakeCommand, body: &[CMakeCommand], here: CMakeFile<'_>) {
        required::note_loop(self, command);
        let words = self.words(&command.arguments);
        let here = CMakeFile {
            depth: here.depth + 1,
            ..here
        };
        let Some((Some(name), values)) = words.split_first().filter(|_| here.depth <= BUILD_DEPTH)
        else {
            return;
        };
        let is_in = values
            .first()
            .is_some_and(|word| word.as_deref() == Some("IN"));
        let mut lists = false;
        for value in values.iter().skip(usize::from(is_in)).flatten() {
            match value.as_str() {
                "LISTS" | "ITEMS" if is_in => lists = value == "LISTS",
                _ if lists => {
                    let list = self.variables.get(value).cloned().unwrap_or_default();
                    for item in list.split(';').filter(|item| !item.is_empty()) {
                        self.once(name, item, body, here);
                    }
                }
                item => self.once(name, item, body, here),
            }
        }
    }

    fn once(&mut self, name: &str, item: &str, body: &[CMakeCommand], here: CMakeFile<'_>) {
        if self.left > 0 {
            self.set(name, item.to_owned());
            self.run(body, here);
        }
    }

    fn command(&mut self, command: &CMakeCommand, here: CMakeFile<'_>) {
        if self.left == 0 {
            return;
        }
        self.names(command);
        required::note(self, command, here);
        let words = self.words(&command.arguments);
        match command.name.as_str() {
            "if" => self.conditions += 1,
            "endif" => self.conditions = self.conditions.saturating_sub(1),
            "project" => self.project(&words),
            "set" => self.assign(&words),
            "list" => self.append(&words),
            "file" => self.file_command(&words, here),
            "configure_file" => self.configured(&words, here),
            "xacro_add_files" => self.expanded(&words, here),
            "install" => match words.first() {
                Some(Some(kind)) if matches!(kind.as_str(), "DIRECTORY" | "FILES" | "PROGRAMS") => {
                    self.placed(words.get(1..).unwrap_or_default(), here, true);
                }
                _ => {}
            },
            "catkin_install_python" => self.placed(words.get(1..).unwrap_or_default(), here, true),
            "ament_auto_package" => self.auto_package(&words, here),
            "add_subdirectory" => {
                if let Some(Some(folder)) = words.first() {
                    self.folder(&tidy(&here.folder.join(folder)), here.depth + 1);
                }
            }
            "include" => {
                if let Some(Some(file)) = words
                    .first()
                    .filter(|w| matches!(w, Some(w) if w.ends_with(".cmake")))
                {
                    let path = tidy(&here.folder.join(file));
                    self.file(&path, here.folder, here.depth + 1);
                }
            }
            // what it installs is written elsewhere
            name if name.contains("install") && !name.contains("python") => {
                self.build.is_opaque = true
            }
            _ => {}
        }
    }

    /// Remember the files that a command names which may make them: it installs and tests nothing.
    fn names(&mut self, command: &CMakeCommand) {
        if ["install", "configure_file", "test"]
            .iter()
            .any(|word| command.name.contains(word))
        {
            return;
        }
        let files = command
            .arguments
            .iter()
            .map(|argument| argument.text.rsplit('/').next().unwrap_or(""));
        self.build.named.extend(files.filter_map(stem));
    }

    fn project(&mut self, words: &[CMakeWord]) {
        let Some(Some(name)) = words.first() else {
            return;
        };
        for place in ["SOURCE_DIR", "BINARY_DIR"] {
            let current = self.variables.get(&format!("CMAKE_CURRENT_{place}"));
            let value = current.cloned().unwrap_or_default();
            self.set(&format!("PROJECT_{place}"), value.clone());
            self.set(&format!("{name}_{place}"), value);
        }
        for variable in ["PROJECT_NAME", "CMAKE_PROJECT_NAME"] {
            self.set(variable, name.clone());
        }
        self.set("CATKIN_PACKAGE_SHARE_DESTINATION", format!("share/{name}"));
    }

    fn assign(&mut self, words: &[CMakeWord]) {
        let Some((Some(name), values)) = words.split_first() else {
            return;
        };
        let is_value =
            |word: &&CMakeWord| !matches!(word.as_deref(), Some("CACHE" | "PARENT_SCOPE"));
        let values: Option<Vec<String>> = values.iter().take_while(is_value).cloned().collect();
        let value = values.map(|values| values.join(";"));
        let has = |wanted: &str| words.iter().flatten().any(|word| word == wanted);
        if has("PARENT_SCOPE") {
            self.handed_up.push((name.clone(), value));
            return;
        }
        // all folders share the cache
        if has("CACHE") {
            self.handed_up.push((name.clone(), value.clone()));
        }
        self.assign_value(name.clone(), value);
    }

    fn append(&mut self, words: &[CMakeWord]) {
        let [Some(mode), Some(name), values @ ..] = words else {
            return;
        };
        let values: Vec<&str> = values.iter().flatten().map(String::as_str).collect();
        if mode == "APPEND" {
            let old = self.variables.get(name).filter(|old| !old.is_empty());
            let list: Vec<&str> = old.map(String::as_str).into_iter().chain(values).collect();
            let list = list.join(";");
            self.set(name, list);
        }
    }

    fn file_command(&mut self, words: &[CMakeWord], here: CMakeFile<'_>) {
        match words {
            [Some(mode), rest @ ..] if mode == "COPY" || mode == "INSTALL" => {
                self.placed(rest, here, false)
            }
            [Some(mode), Some(name), rest @ ..] if mode == "GLOB" => {
                let found = self.globbed(rest, here);
                self.set(name, found.join(";"));
            }
            _ => {}
        }
    }

    fn globbed(&mut self, words: &[CMakeWord], here: CMakeFile<'_>) -> Vec<String> {
        let mut words = words.iter().flatten();
        let (mut found, mut base) = (Vec::new(), None);
        while let Some(word) = words.next() {
            match word.as_str() {
                "RELATIVE" => base = words.next().map(PathBuf::from),
                "LIST_DIRECTORIES" => drop(words.next()),
                "CONFIGURE_DEPENDS" => {}
                pattern => {
                    let pattern = text(&here.folder.join(pattern));
                    found.extend(
                        self.vfs
                            .glob(&pattern, here.folder, &mut self.entries)
                            .unwrap_or_default(),
                    );
                }
            }
        }
        let relative = |path: PathBuf| match &base {
            Some(base) => path.strip_prefix(base).map_or_else(|_| text(&path), text),
            None => text(&path),
        };
        found.into_iter().map(relative).collect()
    }

    /// `configure_file(template target)`
    fn configured(&mut self, words: &[CMakeWord], here: CMakeFile<'_>) {
        let [Some(template), Some(target), ..] = words else {
            return;
        };
        let target = in_tree(&build_folder(here.folder), target);
        self.add(
            target,
            InstallSource::Template(in_tree(here.folder, template)),
        );
    }

    /// `xacro_add_files([TARGET t] a.urdf.xacro [OUTPUT name] [INSTALL [DESTINATION folder]])`
    fn expanded(&mut self, words: &[CMakeWord], here: CMakeFile<'_>) {
        let (mut sources, mut output, mut destination, mut is_installed) =
            (Vec::new(), None, None, false);
        let mut words = words.iter().flatten().map(String::as_str).peekable();
        while let Some(word) = words.next() {
            match word {
                "INORDER" => {}
                "INSTALL" => is_installed = true,
                "TARGET" => drop(words.next()),
                "OUTPUT" => output = words.next(),
                "DESTINATION" => destination = words.next(),
                // lists up to the next keyword, which is in capitals
                "REMAP" | "DEPENDENCIES" => {
                    while words.next_if(|word| word.contains(['.', ':'])).is_some() {}
                }
                source => sources.push(source),
            }
        }
        for source in sources {
            let output = PathBuf::from(
                output.unwrap_or_else(|| source.strip_suffix(".xacro").unwrap_or(source)),
            );
            let made = tidy(&build_folder(here.folder).join(&output));
            self.add(
                made.clone(),
                InstallSource::Template(in_tree(here.folder, source)),
            );
            let Some(project) = self.variables.get("PROJECT_NAME").filter(|_| is_installed) else {
                continue;
            };
            let folder = destination
                .map(Path::new)
                .or_else(|| output.parent())
                .unwrap_or(Path::new(""));
            let to = Path::new("share").join(project).join(folder);
            self.add(
                tidy(&to.join(output.file_name().unwrap_or_default())),
                InstallSource::Path(made),
            );
        }
    }

    /// `a b/ DESTINATION d`
    fn placed(&mut self, words: &[CMakeWord], here: CMakeFile<'_>, is_install: bool) {
        let Some(Some(destination)) = after(words, "DESTINATION") else {
            self.build.is_opaque |= after(words, "DESTINATION").is_some();
            return;
        };
        let to = if is_install {
            tidy(Path::new(destination.trim_start_matches('/')))
        } else {
            in_tree(&build_folder(here.folder), destination)
        };
        let renamed = after(words, "RENAME").cloned().flatten();
        let is_source =
            |word: &&CMakeWord| !word.as_deref().is_some_and(|word| KEYWORDS.contains(&word));
        for word in words.iter().take_while(is_source) {
            let Some(source) = word else {
                self.build.is_opaque = true;
                continue;
            };
            let path = in_tree(here.folder, source);
            let name = renamed.as_deref().map(PathBuf::from);
            let to = match name.or_else(|| path.file_name().map(PathBuf::from)) {
                Some(name) if !source.ends_with('/') && source != "." => to.join(name),
                _ => to.clone(),
            };
            self.add(to, InstallSource::Path(path));
        }
    }

    /// `ament_auto_package(INSTALL_TO_SHARE a b)`
    fn auto_package(&mut self, words: &[CMakeWord], here: CMakeFile<'_>) {
        let Some(project) = self.variables.get("PROJECT_NAME").cloned() else {
            return;
        };
        let mut is_share = false;
        for word in words {
            if let Some(list @ ("INSTALL_TO_SHARE" | "INSTALL_TO_PATH")) = word.as_deref() {
                is_share = list == "INSTALL_TO_SHARE";
                continue;
            }
            let Some(source) = word.as_ref().filter(|_| is_share) else {
                continue;
            };
            let path = in_tree(here.folder, source);
            let to = Path::new("share").join(&project);
            let to = path
                .file_name()
                .map_or_else(|| to.clone(), |name| to.join(name));
            self.add(to, InstallSource::Path(path));
        }
    }

    fn words(&mut self, arguments: &[CMakeArgument]) -> Vec<CMakeWord> {
        let mut words = Vec::new();
        for argument in arguments {
            let word = self.replaced(&argument.text);
            let length = word.as_ref().map_or(0, String::len) as u32 + 1;
            self.left = self.left.saturating_sub(length);
            match word {
                Some(list) if !argument.is_quoted && list.contains(';') => {
                    let items = list.split(';').filter(|item| !item.is_empty());
                    words.extend(items.map(|item| Some(item.to_owned())));
                }
                Some(empty) if !argument.is_quoted && empty.is_empty() => {}
                word => words.push(word),
            }
        }
        words
    }

    /// The text with its variables replaced, the innermost first.
    pub(super) fn replaced(&self, text: &str) -> CMakeWord {
        let mut text = text.to_owned();
        while let Some(start) = text.rfind("${") {
            let end = start + text.get(start..)?.find('}')?;
            let value = self.variables.get(text.get(start + 2..end)?)?;
            if text.len() + value.len() > self.left as usize {
                return None;
            }
            text.replace_range(start..=end, value);
        }
        (!text.contains("$<") && !text.contains("$ENV{")).then_some(text)
    }
}

/// The word behind a keyword.
fn after<'w>(words: &'w [CMakeWord], keyword: &str) -> Option<&'w CMakeWord> {
    let at = words
        .iter()
        .position(|word| word.as_deref() == Some(keyword))?;
    words.get(at + 1)
}

/// The commands up to the end of a block, and those behind it.
fn block<'c>(
    commands: &'c [CMakeCommand],
    start: &str,
    end: &str,
) -> (&'c [CMakeCommand], &'c [CMakeCommand]) {
    let mut depth = 0_u32;
    for (at, command) in commands.iter().enumerate() {
        if command.name == start {
            depth += 1;
        } else if command.name == end {
            if depth == 0 {
                let (body, behind) = commands.split_at(at);
                return (body, behind.get(1..).unwrap_or_default());
            }
            depth -= 1;
        }
    }
    (commands, &[])
}

/// The folder that CMake builds a folder of the sources in.
fn build_folder(source: &Path) -> PathBuf {
    let inside = source.strip_prefix("/").unwrap_or(source);
    Path::new(BUILD_TREE).join(inside)
}

/// A path of the sources or of the folder of the build.
pub(super) fn in_tree(folder: &Path, path: &str) -> PathBuf {
    let path = Path::new(path);
    tidy(&if path.starts_with(BUILD_TREE) {
        path.to_owned()
    } else {
        folder.join(path)
    })
}

fn text(path: &Path) -> String {
    vfs::slashed(path)
}
