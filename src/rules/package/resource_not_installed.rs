//! A folder that is used and not installed.

use super::super::context::FileCx;
use super::super::registry::{Activation, Category, Check, Rule, Severity, page};
use super::super::sink::Sink;
use super::mentions;
use crate::base::{FastSet, TextRange};

pub(super) const RULE: Rule = Rule {
    code: "PKG003",
    name: "resource-not-installed",
    category: Category::Package,
    severity: Severity::Info,
    default: Activation::On,
    since: "0.1",
    fix: None,
    docs: page!("resource-not-installed"),
    check: Check::File(check),
};

fn check(cx: &FileCx<'_>, out: &mut Sink<'_>) {
    let mentions = mentions::packages(cx);
    let Some(package) = cx.world.packages.containing(&cx.source.path).filter(|_| !mentions.is_empty()) else {
        return;
    };
    let own = mentions.iter().filter(|mention| mention.name == package.name);
    let mut installed = None;
    let mut said: FastSet<&str> = FastSet::default();
    for (path, range) in own.filter_map(|mention| mention.path.as_ref()) {
        let Some((folder, _)) = path.rsplit_once('/').filter(|(folder, _)| !folder.is_empty()) else {
            continue;
        };
        let installed = installed.get_or_insert_with(|| Installed::by(cx, &package.folder));
        if said.insert(folder) && !installed.covers(folder) {
            let range = TextRange::new(range.start, range.start + folder.len() as u32);
            out.report_in(cx.file, range, format!("`{}` does not install `{folder}`", package.name))
                .help(format!("add it to the install rules of {}", installed.file))
                .done();
        }
    }
}

/// What the build of a package installs.
struct Installed {
    /// The file that says so.
    file: &'static str,
    /// Folders and files; none when that cannot be told.
    paths: Option<Vec<String>>,
}

impl Installed {
    fn by(cx: &FileCx<'_>, folder: &std::path::Path) -> Self {
        let read = |name: &str| cx.world.vfs.text(&folder.join(name)).ok();
        if let Some(file) = read("CMakeLists.txt") {
            return Self { file: "CMakeLists.txt", paths: cmake(&file.text) };
        }
        let python = read("setup.py").and_then(|file| python(&file.text));
        Self { file: "setup.py", paths: python }
    }

    fn covers(&self, folder: &str) -> bool {
        let inside = |path: &String| {
            path == "."
                || folder == path
                || folder.strip_prefix(path.as_str()).is_some_and(|rest| rest.starts_with('/'))
        };
        let Some(paths) = &self.paths else { return true };
        paths.iter().any(|path| inside(path) || path.starts_with(&format!("{folder}/")))
    }
}

/// The folders and files of the `install` commands; none when some of them are computed.
fn cmake(text: &str) -> Option<Vec<String>> {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let text = lines.collect::<Vec<_>>().join("\n");
    let mut paths = Vec::new();
    for word in ["ament_auto_package", "install_", "_install", "add_subdirectory"] {
        // the first installs common folders by itself, the others may install anything
        if text.contains(word) && !text.contains("ament_package_install") {
            return None;
        }
    }
    for (at, _) in text.match_indices("install") {
        let rest = text.get(at + "install".len()..)?.trim_start();
        let Some(arguments) = rest.strip_prefix('(').and_then(|rest| rest.split(')').next()) else {
            continue;
        };
        let mut words = arguments.split_whitespace().map(|word| word.trim_matches('"'));
        if !words.next().is_some_and(|kind| matches!(kind, "DIRECTORY" | "FILES" | "PROGRAMS")) {
            continue;
        }
        for word in words.take_while(|word| !is_keyword(word)) {
            let own = word.strip_prefix("${CMAKE_CURRENT_SOURCE_DIR}/");
            let own = own.or_else(|| word.strip_prefix("${PROJECT_SOURCE_DIR}/")).unwrap_or(word);
            if own.contains(['$', '*']) {
                return None;
            }
            let path = own.trim_start_matches("./").trim_end_matches('/');
            paths.push(if path.is_empty() { ".".to_owned() } else { path.to_owned() });
        }
    }
    Some(paths)
}

fn is_keyword(word: &str) -> bool {
    const WORDS: [&str; 9] = [
        "DESTINATION",
        "TYPE",
        "PATTERN",
        "REGEX",
        "FILES_MATCHING",
        "USE_SOURCE_PERMISSIONS",
        "OPTIONAL",
        "COMPONENT",
        "PERMISSIONS",
    ];
    WORDS.contains(&word)
}

/// The texts of a `setup.py` that look like paths; none when folders are walked.
fn python(text: &str) -> Option<Vec<String>> {
    if text.contains("walk(") || text.contains("rglob") || text.contains("for ") || text.contains("listdir") {
        return None;
    }
    let texts = text.split(['\'', '"']).skip(1).step_by(2);
    Some(texts.map(|text| text.split('*').next().unwrap_or(text).trim_matches('/').to_owned()).collect())
}

#[cfg(test)]
mod tests {
    use super::{Installed, cmake, python};

    fn covers(paths: Option<Vec<String>>, folder: &str) -> bool {
        Installed { file: "", paths }.covers(folder)
    }

    #[test]
    fn what_cmake_installs() {
        let text = "install(DIRECTORY urdf meshes/visual/ # meshes/collision\n  DESTINATION share/${PROJECT_NAME})\n\
                    install(TARGETS meshes/x)\ninstall( FILES \"config/a.yaml\" DESTINATION x)";
        let table = [("urdf", true), ("urdf/inc", true), ("meshes/visual", true), ("meshes", true)];
        for (folder, expected) in
            table.into_iter().chain([("meshes/collision", false), ("mesh", false), ("config", true)])
        {
            assert_eq!(covers(cmake(text), folder), expected, "{folder}");
        }
        for text in [
            "install(DIRECTORY . DESTINATION x)",
            "install(DIRECTORY ${dir} DESTINATION x)",
            "ament_auto_package()",
        ] {
            assert!(covers(cmake(text), "anything"), "{text}");
        }
        assert!(!covers(cmake("ament_package()"), "meshes"));
    }

    #[test]
    fn what_setup_py_installs() {
        let text = "data_files=[('share/' + name, ['package.xml']), ('share/x/urdf', glob('urdf/*.urdf'))]";
        assert!(covers(python(text), "urdf") && !covers(python(text), "meshes"));
        assert!(covers(python("for path in paths: pass"), "meshes"));
    }
}
