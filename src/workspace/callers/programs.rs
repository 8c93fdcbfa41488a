//! What programs and pages do with a description, beyond naming it.

use std::path::Path;

use super::Callers;
use super::file_names::{self, name_of};
use super::read::{self, has_any};
use super::walk::walk;
use packages::Packages;

/// Words of programs that download something.
const DOWNLOADS: [&str; 7] = [
    "wget ",
    "curl ",
    "urlretrieve",
    "gdown",
    "ExternalProject_Add",
    "FetchContent_Declare",
    "file(DOWNLOAD",
];

/// Endings of files that hold many others.
const ARCHIVES: [&str; 4] = [".tgz", ".tar", ".zip", ".tbz"];

impl Callers {
    /// Whether a page names the description `file` to be used: not only in a table of files, unless that says how xacro is run.
    pub fn tell_to_use(&self, file: &Path) -> bool {
        let name = name_of(file);
        let is_use = |line: &str| {
            line.contains(name) && (!line.trim_start().starts_with('|') || runs_xacro(line))
        };
        self.of(file)
            .iter()
            .filter(|caller| caller.is_page())
            .any(|page| {
                self.packages
                    .is_text(&page.path, |text| text.lines().any(is_use))
            })
    }

    /// Whether all that names the description `file` are programs in Python that write it, whatever they read of it again.
    pub fn only_write(&self, file: &Path) -> bool {
        let name = name_of(file);
        let writes = |line: &str| {
            line.contains(name)
                && (line.contains(".write(")
                    || line.contains("open(") && (line.contains("\"w\"") || line.contains("'w'")))
        };
        let all = self.of(file);
        let mut named = all.iter().filter(|caller| caller.says(file)).peekable();
        named.peek().is_some()
            && named.all(|caller| {
                caller.path.extension().is_some_and(|ending| ending == "py")
                    && !caller.is_launch()
                    && self
                        .packages
                        .is_text(&caller.path, |text| text.lines().any(writes))
            })
    }

    /// Whether a text around the description `file` that may load it holds its name, letter for letter: names with blanks and
    /// brackets are no words.
    pub fn spell_out(&self, file: &Path) -> bool {
        let Some(top) = self.packages.sources_around(file) else {
            return false;
        };
        let own = name_of(file);
        let mut found = false;
        walk(self.packages.vfs(), &top, &mut |path, name, is_small| {
            found = found
                || file_names::may_call(name)
                    && is_small()
                    && self.packages.is_text(path, |text| text.contains(own));
        });
        found
    }

    /// Whether a program around the description `file` downloads what has this name.
    pub fn download(&self, file: &Path, name: &str) -> bool {
        let mentions = self.mentions(file);
        let name = Path::new(name);
        mentions.is_some_and(|mentions| {
            let mut programs = mentions.of(name).filter(|by| file_names::is_program(by));
            programs.any(|by| self.packages.is_text(by, |text| has_any(text, &DOWNLOADS)))
        })
    }

    /// Whether a program in Python or a shell that names the description `file` holds `text`, letter for letter: neither knows
    /// `$(find ...)`, so it puts something else for it.
    pub fn rewrite(&self, file: &Path, text: &str) -> bool {
        self.of(file)
            .iter()
            .map(|caller| &caller.path)
            .filter(|path| {
                path.extension()
                    .is_some_and(|ending| ending == "py" || ending == "sh")
            })
            .any(|path| self.packages.is_text(path, |said| said.contains(text)))
    }
}

/// Whether a program or build file of the package around a file downloads an archive.
pub fn downloads_data(packages: &Packages, file: &Path) -> bool {
    let Some(package) = packages.containing(file) else {
        return false;
    };
    let mut found = false;
    walk(
        packages.vfs(),
        &package.folder,
        &mut |path, name, is_small| {
            let may_run =
                !name.contains('.') || name == "CMakeLists.txt" || file_names::is_program(path);
            if found || !may_run || !is_small() {
                return;
            }
            found = packages.is_text(path, |text| {
                has_any(text, &DOWNLOADS) && has_any(text, &ARCHIVES)
            });
        },
    );
    found
}

/// Whether a line of a page runs xacro, which is also how the names of its files end.
fn runs_xacro(line: &str) -> bool {
    line.match_indices("xacro ").any(|(at, _)| {
        !line
            .get(..at)
            .is_some_and(|before| before.ends_with(read::is_name))
    })
}
