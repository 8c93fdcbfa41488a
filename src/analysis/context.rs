//! Under which root a file is shown, and with which arguments.
//!
//! A macro file has no meaning alone. The root is chosen by what the user selected, a comment in the file, the
//! configuration, and else by the includes of the workspace.
use std::path::{Path, PathBuf};

use indexmap::IndexSet;

use super::host::AnalysisHost;
use super::root_config::{Context, RootConfig, RootReason};
use super::roots::variants;
use super::session::Session;
use base::{Span, TextRange};
use vfs::SourceFile;
use workspace::config::Variant;

/// The runs of a file that the configuration lists.
pub(super) fn configured_variants(session: &Session, file: &Path) -> Vec<RootConfig> {
    let settings = session.settings(file);
    let roots = settings.config.roots.iter().filter(|root| {
        root.files(&session.vfs)
            .iter()
            .any(|listed| session.vfs.absolute(listed) == file)
    });
    let variant = |variant: workspace::config::Variant| RootConfig {
        file: file.to_path_buf(),
        args: variant.args,
        preset: variant.preset,
    };
    roots
        .flat_map(|root| variants(&session.callers, root, file))
        .map(variant)
        .collect()
}

/// Whether the configuration lists a run of a file.
pub(super) fn is_configured(session: &Session, root: &RootConfig) -> bool {
    configured_variants(session, &root.file).contains(root)
}

/// The context of a file.
pub fn context(host: &mut AnalysisHost, path: &Path) -> Context {
    host.refresh(path);
    let mut candidates = candidates(host, path);
    // the sort is stable: the runs of a file stay as the configuration lists them, the one without a preset first
    candidates.sort_by_cached_key(|(choice, near)| {
        let file = choice.file.clone();
        let edited = std::cmp::Reverse(host.last_edit(&file));
        (edited, *near, !host.same_package(&file, path), file)
    });
    let selected = host.selected(path).map(|root| (root, RootReason::Selected));
    let commented = || commented_root(host.session(), path).map(|root| (root, RootReason::Comment));
    let chosen = selected
        .or_else(commented)
        .or_else(|| preferred(host.session(), &candidates, path));
    let (root, reason) = chosen.map_or((None, RootReason::None), |(root, reason)| {
        (Some(root), reason)
    });
    Context {
        root,
        reason,
        candidates,
    }
}

/// Of the roots that reach a file, the first that is configured; else the file itself; else the first of all.
fn preferred(
    session: &Session,
    candidates: &[(RootConfig, u32)],
    path: &Path,
) -> Option<(RootConfig, RootReason)> {
    let is_configured = |(root, _): &&(RootConfig, u32)| is_configured(session, root);
    let is_itself = |(root, near): &&(RootConfig, u32)| *near == 0 && root.file == path;
    let ((root, _), reason) = if let Some(found) = candidates.iter().find(is_configured) {
        (found, RootReason::Configured)
    } else if let Some(found) = candidates.iter().find(is_itself) {
        (found, RootReason::Itself)
    } else {
        (candidates.first()?, RootReason::Includes)
    };
    Some((root.clone(), reason))
}

/// The roots that reach a file: configured ones with all their presets, then all others.
fn candidates(host: &AnalysisHost, path: &Path) -> Vec<(RootConfig, u32)> {
    let mut reached: Vec<(PathBuf, u32)> = host.graph.roots_of(path);
    if host.graph.is_root(path) {
        reached.insert(0, (path.to_path_buf(), 0));
    }
    let mut candidates = Vec::new();
    for (file, near) in reached {
        let variants = configured_variants(host.session(), &file);
        if variants.is_empty() {
            candidates.push((RootConfig::plain(&file), near));
        } else {
            candidates.extend(variants.into_iter().map(|choice| (choice, near)));
        }
    }
    for choice in configured_variants(host.session(), path) {
        if candidates.iter().all(|(known, _)| *known != choice) {
            candidates.push((choice, 0));
        }
    }
    candidates
}

/// `<!-- xacro-root: ../robot.urdf.xacro side:=right -->` in the first ten lines.
fn commented_root(session: &Session, path: &Path) -> Option<RootConfig> {
    let source = session.vfs.document(path).ok()?;
    let (name, args) = root_comment(&source)?;
    let file = session.vfs.absolute(&path.parent()?.join(name));
    let file = vfs::without_parents(&file);
    session.vfs.is_file(&file).then_some(RootConfig {
        file,
        args,
        preset: None,
    })
}

/// Where the comment at the top of a file that names its root gives an argument a value, with the root.
pub fn commented_argument(session: &Session, path: &Path, name: &str) -> Option<(PathBuf, Span)> {
    let root = commented_root(session, path)?.file;
    let source = session.vfs.document(path).ok()?;
    let text = source.document.text();
    let start = text.find(ROOT_COMMENT)?;
    let comment = text.get(start..)?.split("-->").next()?;
    let at = (start + comment.find(&format!(" {name}:="))? + 1) as u32;
    Some((
        root,
        Span {
            file: source.id,
            range: TextRange::new(at, at + name.len() as u32),
        },
    ))
}

/// What the comment begins with.
const ROOT_COMMENT: &str = "<!-- xacro-root:";

/// The file and the arguments that a comment at the top of a file names.
fn root_comment(source: &SourceFile) -> Option<(String, Vec<(String, String)>)> {
    const LINES: u32 = 10;
    let lines =
        (0..LINES.min(source.document.line_count())).map(|line| source.document.line_text(line));
    let comment = lines.filter_map(|line| {
        let (_, rest) = line.split_once(ROOT_COMMENT)?;
        Some(rest.split_once("-->")?.0.trim().to_owned())
    });
    let comment = comment.into_iter().next()?;
    let mut words = comment.split_whitespace();
    let name = words.next()?.to_owned();
    let args = words
        .filter_map(|word| word.split_once(":="))
        .map(|(n, v)| (n.to_owned(), v.to_owned()));
    Some((name, args.collect()))
}

/// The files that look like robots, with each preset that the configuration lists for them.
pub fn known_robots(host: &AnalysisHost) -> Vec<RootConfig> {
    let robots = host.graph.files().filter(|file| host.graph.is_root(file));
    let variants = |file: &PathBuf| {
        let variants = configured_variants(host.session(), file);
        if variants.is_empty() {
            vec![RootConfig::plain(file)]
        } else {
            variants
        }
    };
    robots.flat_map(variants).collect()
}

/// Every configured root with each of its presets, by the configurations that hold for files and for the folders.
pub(super) fn configured_contexts(host: &AnalysisHost, paths: &[&PathBuf]) -> Vec<RootConfig> {
    let session = host.session();
    let of_folders = host
        .folders()
        .iter()
        .map(|folder| session.folder_settings(folder));
    let mut found: IndexSet<RootConfig> = IndexSet::new();
    for settings in of_folders.chain(paths.iter().map(|path| session.settings(path))) {
        for root in &settings.config.roots {
            for file in root.files(&session.vfs) {
                let file = session.vfs.absolute(&file);
                let choice = |Variant { preset, args }| RootConfig {
                    file: file.clone(),
                    args,
                    preset,
                };
                found.extend(
                    variants(&session.callers, root, &file)
                        .into_iter()
                        .map(choice),
                );
            }
        }
    }
    found.into_iter().collect()
}
