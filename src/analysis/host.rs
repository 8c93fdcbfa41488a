//! The state of a language server: open files, roots, and expansions that are made again only when something
//! they read has changed.
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::beside::{said_to_others, sort};
use super::graph::Graph;
use super::proof::{AffectedRobots, Effort};
use super::root_analysis::{RootAnalysis, Work, task_of};
use super::root_config::RootConfig;
use super::run_task;
use super::scan::Scan;
use super::session::Session;
use super::walk::{self, Listing, is_launch};
use base::clock::Instant;
use base::{CancelFlag, FastMap, TextRange};
use expand::Forced;
use packages::BUILD_FILES;
use vfs::{Environment, SourceFile, Vfs};
use workspace::config::{self, Config};

/// The state of a language server.
pub struct AnalysisHost {
    session: Session,
    env: Environment,
    folders: Vec<PathBuf>,
    /// Open files with the number of their last edit.
    open: BTreeMap<PathBuf, u64>,
    edits: u64,
    pub(super) graph: Graph,
    /// Files that the graph has not seen since they were edited.
    unseen: BTreeSet<PathBuf>,
    scan: Scan,
    /// Roots selected by the user, by the file they were selected for.
    selections: FastMap<PathBuf, RootConfig>,
    cache: FastMap<RootConfig, Arc<RootAnalysis>>,
    /// The last expansions without errors.
    good: FastMap<RootConfig, Arc<RootAnalysis>>,
    /// What was done so far.
    work: Work,
    /// Counts what no record tells of: packages, meshes, configuration.
    epoch: u64,
    /// Whether every configured root is checked with each preset, not only what files are shown under.
    all_contexts: bool,
    /// Settings of the editor, and the folders they belong to.
    editor: Vec<(serde_json::Value, PathBuf)>,
    /// The meshes that descriptions named so far, as they were then.
    pub(super) named: BTreeMap<PathBuf, u64>,
}

impl AnalysisHost {
    /// Robots with fewer nodes are expanded in no time.
    const LARGE: usize = 300;
    /// Most expansions kept.
    const MOST_CACHED: usize = 64;

    /// A host that sees `folders`; without any, single files are shown by themselves.
    pub fn new(env: Environment, folders: Vec<PathBuf>) -> Self {
        let vfs = Arc::new(Vfs::of(&env, config::Limits::default().file_bytes()));
        Self::over(vfs, env, folders)
    }

    /// The same over files that others use too.
    pub fn over(vfs: Arc<Vfs>, env: Environment, folders: Vec<PathBuf>) -> Self {
        let session = Session::of_editor(&vfs, &env, &folders, Vec::new());
        Self {
            session,
            env,
            folders,
            open: BTreeMap::new(),
            edits: 0,
            unseen: BTreeSet::new(),
            graph: Graph::default(),
            scan: Scan::default(),
            selections: FastMap::default(),
            cache: FastMap::default(),
            good: FastMap::default(),
            work: Work::default(),
            epoch: 0,
            all_contexts: false,
            editor: Vec::new(),
            named: BTreeMap::new(),
        }
    }

    /// A host with the same folders and settings that sees the files on the disk, whatever is open.
    pub fn on_disk(&self) -> Self {
        let (env, folders) = (self.env.clone(), self.folders.clone());
        let mut host = match self.session.vfs.uncovered() {
            Some(files) => Self::over(Arc::new(files), env, folders),
            None => Self::new(env, folders),
        };
        let editor = self.editor.iter().cloned();
        host.set_folder_settings(editor.map(|(own, folder)| (own, Some(folder))).collect());
        host
    }

    /// How much may be done to prove something about edits of a file: for the robots that are known to read it.
    pub fn effort(&self, path: &Path, expansions: usize, cancel: &CancelFlag) -> Effort {
        let mut roots: Vec<PathBuf> = self
            .graph
            .roots_of(path)
            .into_iter()
            .map(|(root, _)| root)
            .collect();
        roots.push(path.to_owned());
        Effort {
            expansions,
            roots: AffectedRobots::Known(roots),
            cancel: cancel.clone(),
        }
    }

    /// What was done so far, because something that a robot reads had changed.
    pub fn work(&self) -> Work {
        self.work
    }

    /// Files, packages and configuration.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The workspace folders.
    pub fn folders(&self) -> &[PathBuf] {
        &self.folders
    }

    /// Show other folders.
    pub fn set_folders(&mut self, folders: Vec<PathBuf>) {
        self.folders = folders;
        self.scan.restart();
        self.graph = Graph::default();
        self.unseen.extend(self.open.keys().cloned());
        self.reload();
    }

    /// Forget what no record tells of: packages, configuration, meshes.
    pub fn reload(&mut self) {
        self.epoch += 1;
        self.named.clear();
        self.session = Session::of_editor(
            &self.session.vfs,
            &self.env,
            &self.folders,
            self.editor.clone(),
        );
    }

    /// Lay the settings of an editor (what stands below `xacro.`) over every configuration; returns what in
    /// them has no effect.
    pub fn set_editor_settings(&mut self, settings: serde_json::Value) -> Vec<String> {
        self.set_folder_settings(vec![(settings, None)])
    }

    /// The same with settings for each folder; for none, they belong to the first one.
    pub fn set_folder_settings(
        &mut self,
        settings: Vec<(serde_json::Value, Option<PathBuf>)>,
    ) -> Vec<String> {
        let first = self.folders.first().unwrap_or(&self.env.cwd).clone();
        let settings: Vec<_> = settings
            .into_iter()
            .map(|(own, folder)| (own, folder.unwrap_or(first.clone())))
            .collect();
        let apply = |(own, folder): &(_, PathBuf)| Config::default().apply_settings(own, folder);
        let warnings: Vec<_> = settings.iter().flat_map(apply).collect();
        if settings != self.editor {
            self.editor = settings;
            self.reload();
        }
        warnings.iter().map(ToString::to_string).collect()
    }

    /// Check every configured root with each preset, or only the one that each file is shown under.
    pub fn set_all_contexts(&mut self, all: bool) {
        self.all_contexts = all;
    }

    /// Whether every configured root is checked with each preset.
    pub(super) fn has_all_contexts(&self) -> bool {
        self.all_contexts
    }

    /// Whether a file is open.
    pub(super) fn is_open(&self, path: &Path) -> bool {
        self.open.contains_key(path)
    }

    /// The files that are open.
    pub fn open_files(&self) -> impl Iterator<Item = &PathBuf> {
        self.open.keys()
    }

    /// A file was opened, or its whole text replaced.
    pub fn set_text(&mut self, path: &Path, text: String) {
        self.session.vfs.set_buffer(path, Some(text));
        self.touch(path, true);
    }

    /// A range of bytes of an open file was replaced.
    pub fn edit(&mut self, path: &Path, range: TextRange, text: &str) {
        let before = said_to_others(&self.session, path);
        self.session.vfs.edit_buffer(path, range, text);
        self.touch(path, said_to_others(&self.session, path) != before);
    }

    /// A file was closed: the disk counts again.
    pub fn close(&mut self, path: &Path) {
        self.session.vfs.set_buffer(path, None);
        self.rest_on(path, true);
        self.open.remove(path);
        self.refresh(path);
    }

    fn touch(&mut self, path: &Path, is_news: bool) {
        self.edits += 1;
        self.open.insert(path.to_path_buf(), self.edits);
        self.unseen.insert(path.to_path_buf());
        self.rest_on(path, is_news);
    }

    /// Forget what rests on a file that was changed; `is_news` when it says something else to other files.
    fn rest_on(&mut self, path: &Path, is_news: bool) {
        if is_news {
            self.session.forget_pairings();
        }
        match path.file_name().and_then(|name| name.to_str()) {
            Some(name) if config::CONFIG_NAMES.contains(&name) => self.reload(),
            // robots may be expanded with the arguments that they give
            _ if is_launch(path) => self.epoch += u64::from(is_news),
            // what an expansion reads of them is in its record
            _ if walk::is_description(path) => self.session.edit_description(path),
            _ if sort(path).is_some() => {}
            // manifests are read by rules, which no record tells of
            _ => {
                self.epoch += 1;
                self.session.packages.forget_dependencies();
                self.session.forget_pairings();
            }
        }
        if is_launch(path) {
            self.session.forget_uses();
        }
    }

    /// An open or readable file.
    pub fn document(&self, path: &Path) -> Option<Arc<SourceFile>> {
        self.session.vfs.document(path).ok()
    }

    /// The number of the last edit of a file; zero when it was never edited.
    pub(super) fn last_edit(&self, path: &Path) -> u64 {
        self.open.get(path).copied().unwrap_or(0)
    }

    /// Bring the include graph up to date: the file, and all that were edited.
    pub(super) fn refresh(&mut self, path: &Path) {
        let edited = std::mem::take(&mut self.unseen);
        for file in edited.iter().map(PathBuf::as_path).chain([path]) {
            if walk::is_description(file) || self.open.contains_key(file) {
                let is_new = !self.graph.knows(file);
                self.graph
                    .update(&self.session.vfs, &self.session.packages, file);
                // the scan leaves out installed and ignored files, and those outside of the workspace
                if is_new && self.is_scanned() {
                    self.scan_beside(file);
                }
            }
        }
        if !self.is_scanned() {
            self.scan_beside(path);
        }
    }

    /// The files in the folder of an open file stand for a workspace that is not known.
    fn scan_beside(&mut self, path: &Path) {
        let Some(folder) = path.parent() else { return };
        let names = self.session.vfs.list_dir(folder);
        let files = names
            .iter()
            .filter(|entry| !entry.is_dir)
            .map(|entry| folder.join(&entry.name));
        for file in files.filter(|file| walk::is_description(file)).take(200) {
            if !self.graph.knows(&file) {
                self.graph
                    .update(&self.session.vfs, &self.session.packages, &file);
            }
        }
    }

    /// Look at more files of the workspace, until `stop` says so; returns how many are done and how many there
    /// are. When all are done: none.
    pub fn scan(&mut self, stop: impl Fn() -> bool) -> Option<(usize, usize)> {
        let (folders, session) = (&self.folders, &self.session);
        let listing = || Listing::of(folders, &session.vfs, &self.env);
        if !self.scan.list(listing, session, &stop) {
            return Some((0, 0));
        }
        let total = self.scan.waiting.len();
        let mut done = 0;
        while let Some(path) = self.scan.waiting.pop() {
            self.graph.update(&session.vfs, &session.packages, &path);
            done += 1;
            if stop() {
                break;
            }
        }
        (!self.scan.waiting.is_empty()).then_some((done, total))
    }

    /// The same for at most so long; whether all are done.
    pub fn scan_within(&mut self, patience: Duration) -> bool {
        let end = Instant::now() + patience;
        self.scan(|| Instant::now() >= end).is_none()
    }

    /// The descriptions that were looked at.
    pub fn known_files(&self) -> Vec<PathBuf> {
        self.graph.files().cloned().collect()
    }

    /// The files that may include a description by a name that is computed.
    pub fn computed_includers(&self, path: &Path) -> Vec<PathBuf> {
        self.graph.computed_includers(path)
    }

    /// Whether all files of the workspace were looked at.
    pub fn is_scanned(&self) -> bool {
        self.scan.is_done()
    }

    /// Files changed on the disk.
    pub fn changed_on_disk(&mut self, paths: &[PathBuf]) {
        self.epoch += 1;
        self.named.retain(|path, _| !paths.contains(path));
        self.session.forget_uses();
        let about_packages = |path: &PathBuf| {
            let name = path
                .file_name()
                .and_then(|name| name.to_str())
                .unwrap_or("");
            ["package.xml", "COLCON_IGNORE"].contains(&name)
                || config::CONFIG_NAMES.contains(&name)
                || BUILD_FILES.contains(&name)
        };
        if paths.iter().any(about_packages) {
            self.reload();
        }
        for path in paths.iter().filter(|path| walk::is_description(path)) {
            self.graph
                .update(&self.session.vfs, &self.session.packages, path);
        }
    }

    /// Select the root that a file is shown under; none: back to automatic.
    pub fn select(&mut self, path: &Path, root: Option<RootConfig>) {
        match root {
            Some(root) => self.selections.insert(path.to_path_buf(), root),
            None => self.selections.remove(path),
        };
    }

    /// Select for all files; none: back to automatic.
    pub fn select_all(&mut self, root: Option<RootConfig>) {
        self.selections.clear();
        if let Some(root) = root {
            self.selections.insert(PathBuf::new(), root);
        }
    }

    pub(super) fn selected(&self, path: &Path) -> Option<RootConfig> {
        let reaches = |root: &&RootConfig| {
            root.file == path
                || self
                    .graph
                    .roots_of(path)
                    .iter()
                    .any(|(file, _)| *file == root.file)
        };
        let anywhere = || self.selections.get(Path::new("")).filter(reaches);
        self.selections.get(path).or_else(anywhere).cloned()
    }

    pub(super) fn same_package(&self, a: &Path, b: &Path) -> bool {
        let package = |path: &Path| {
            self.session
                .packages
                .containing(path)
                .map(|package| package.folder)
        };
        package(a).is_some_and(|folder| Some(folder) == package(b))
    }

    /// A root expanded; from the cache when nothing it read has changed. `None` when cancelled.
    pub fn analyzed(
        &mut self,
        root: &RootConfig,
        cancel: &CancelFlag,
    ) -> Option<Arc<RootAnalysis>> {
        if let Some(known) = self.cache.get(root)
            && self.is_valid(known)
        {
            return Some(known.clone());
        }
        // what no record tells of is the same in the same epoch
        let before = self
            .cache
            .get(root)
            .filter(|known| known.epoch == self.epoch);
        let expansion = run_task::expansion(
            &self.session,
            cancel,
            &task_of(root),
            before.map(|known| &known.expansion),
        );
        if cancel.is_cancelled() {
            return None;
        }
        self.work.add(&expansion);
        let before = before.map(Arc::as_ref);
        let made = RootAnalysis::new(root.clone(), expansion, self.epoch, before);
        let made = Arc::new(made);
        if self.cache.len() >= Self::MOST_CACHED {
            self.cache.clear();
        }
        if made.expansion.complete && !made.expansion.has_errors() {
            self.good.insert(root.clone(), made.clone());
        }
        self.cache.insert(root.clone(), made.clone());
        Some(made)
    }

    /// The expansion of a root with the outcome of conditions given. `None` when cancelled.
    pub fn forced(
        &self,
        root: &RootConfig,
        forced: Vec<Forced>,
        cancel: &CancelFlag,
    ) -> Option<Arc<RootAnalysis>> {
        let expansion = run_task::forced(&self.session, cancel, &task_of(root), forced);
        (!cancel.is_cancelled())
            .then(|| Arc::new(RootAnalysis::new(root.clone(), expansion, self.epoch, None)))
    }

    /// Expansions to take names from while somebody types in the file at `path`, the newest first. None is made
    /// again for what stands in that file, nor while a text is broken, unless there is none at all: what comes out
    /// of half-typed text is worth little, and the next letter is waited for.
    pub fn while_typing(
        &mut self,
        root: &RootConfig,
        path: &Path,
        cancel: &CancelFlag,
    ) -> Vec<Arc<RootAnalysis>> {
        let known = self.cache.get(root).cloned();
        let is_fresh = known
            .as_ref()
            .is_some_and(|known| self.is_current_beside(known, path));
        let any = known.is_some() || self.good.contains_key(root);
        if !any || !is_fresh && known.is_none_or(|known| self.is_unbroken(&known)) {
            let _ = self.analyzed(root, cancel);
        }
        let newest = self.cache.get(root).cloned();
        let good = self
            .good
            .get(root)
            .filter(|good| newest.as_ref().is_none_or(|new| !Arc::ptr_eq(new, good)));
        let finished = newest
            .as_ref()
            .is_some_and(|new| new.expansion.complete && self.is_current(new));
        newest
            .iter()
            .chain(good.filter(|_| !finished))
            .cloned()
            .collect()
    }

    /// Whether all texts of a robot are whole XML as they are now.
    fn is_unbroken(&self, known: &RootAnalysis) -> bool {
        let files = known.expansion.files.iter();
        let mut files = files.filter_map(|file| self.document(&file.source.path));
        files.all(|source| source.document.errors().is_empty())
    }

    /// The last expansion of the robot of an open file, when the robot is large and nothing but this file was edited
    /// since: what it says of other places still holds, as far as that rests on nothing edited.
    pub fn before_typing(&self, root: &RootConfig, path: &Path) -> Option<Arc<RootAnalysis>> {
        let last = self
            .cache
            .get(root)
            .filter(|last| last.expansion.tree.len() >= Self::LARGE)?
            .clone();
        let is_sound = self.document(path)?.document.errors().is_empty();
        (is_sound && !self.is_valid(&last) && self.is_valid_beside(&last, path)).then_some(last)
    }

    /// The last expansion of a root that had no errors.
    pub fn last_good(&self, root: &RootConfig) -> Option<Arc<RootAnalysis>> {
        self.good.get(root).cloned()
    }

    /// Whether an expansion still holds.
    pub(super) fn is_valid(&self, known: &RootAnalysis) -> bool {
        known.epoch == self.epoch && self.is_current(known)
    }

    /// The same without a look at one file.
    pub(super) fn is_valid_beside(&self, known: &RootAnalysis, except: &Path) -> bool {
        known.epoch == self.epoch && self.is_current_beside(known, except)
    }

    /// Whether everything that an expansion read is as it was.
    fn is_current(&self, known: &RootAnalysis) -> bool {
        self.is_current_beside(known, Path::new(""))
    }

    /// The same without a look at one file.
    fn is_current_beside(&self, known: &RootAnalysis, except: &Path) -> bool {
        known.is_current_beside(&self.session.vfs, &self.env.cwd, except)
    }
}
