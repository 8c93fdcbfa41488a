//! The views that are open, and what they show.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use super::choices::choices;
use super::files::ModelFiles;
use super::locations::{Location, LocationFormat, LocationMapper};
use super::messages::{Argument, ModelError, ModelMessage, ModelSource, RootName, Selection, Side};
use super::model::{Model, model};
use super::programs::programs;
use super::select;
use super::shapes::Shapes;
use analysis::{AnalysisHost, RootAnalysis, RootConfig, Session};
use base::limits::{SENT_BYTES, SENT_ERRORS};
use base::{CancelFlag, Encoding, FastSet};
use expand::{Expansion, Read, Severity};
use model::Robot;

/// All views.
#[derive(Default)]
pub struct Views {
    last_id: u32,
    views: BTreeMap<u32, OpenView>,
    files: Arc<ModelFiles>,
}

/// One view: a robot, or two side by side.
struct OpenView {
    revision: u64,
    sides: BTreeMap<Side, Shown>,
}

/// What one side shows.
struct Shown {
    root: RootConfig,
    /// What was sent last.
    sent: Option<Arc<RootAnalysis>>,
    /// What was sent last without errors, with its revision.
    good: Option<(Arc<Model>, Option<u64>)>,
    /// The model that was sent last.
    current: Option<Arc<Model>>,
    /// What else could be shown, and how many files were known then.
    choices: Option<(usize, Vec<RootName>)>,
}

/// A file of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshBytes {
    /// Its name without folders.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl Shown {
    fn new(root: RootConfig) -> Self {
        Self {
            root,
            sent: None,
            good: None,
            current: None,
            choices: None,
        }
    }
}

impl Views {
    /// Whether nobody looks.
    pub fn is_empty(&self) -> bool {
        self.views.is_empty()
    }

    /// The files that may be asked for.
    pub fn files(&self) -> &Arc<ModelFiles> {
        &self.files
    }

    /// Open a view; its number.
    pub fn open(&mut self, root: RootConfig) -> u32 {
        self.last_id += 1;
        let sides = BTreeMap::from([(Side::Main, Shown::new(root))]);
        self.views
            .insert(self.last_id, OpenView { revision: 0, sides });
        self.last_id
    }

    /// Close a view; whether there was one.
    pub fn close(&mut self, id: u32) -> bool {
        let closed = self.views.remove(&id).is_some();
        self.forget_files();
        closed
    }

    /// Show something else; whether there is such a view.
    pub fn show(&mut self, id: u32, root: RootConfig, compare: Option<RootConfig>) -> bool {
        let Some(view) = self.views.get_mut(&id) else {
            return false;
        };
        for (side, root) in [(Side::Main, Some(root)), (Side::Compare, compare)] {
            match root {
                Some(root)
                    if view
                        .sides
                        .get(&side)
                        .is_some_and(|shown| shown.root == root) => {}
                Some(root) => drop(view.sides.insert(side, Shown::new(root))),
                None => drop(view.sides.remove(&side)),
            }
        }
        true
    }

    /// Whether a view shows two robots; none when there is no such view.
    pub fn compares(&self, id: u32) -> Option<bool> {
        self.views
            .get(&id)
            .map(|view| view.sides.contains_key(&Side::Compare))
    }

    /// What a view shows.
    pub fn root(&self, id: u32) -> Option<&RootConfig> {
        self.views
            .get(&id)?
            .sides
            .get(&Side::Main)
            .map(|shown| &shown.root)
    }

    /// The views that are open.
    pub fn ids(&self) -> Vec<u32> {
        self.views.keys().copied().collect()
    }

    /// Have a view sent again whole.
    pub fn forget(&mut self, id: u32) {
        let sides = self
            .views
            .get_mut(&id)
            .into_iter()
            .flat_map(|view| view.sides.values_mut());
        sides.for_each(|shown| (shown.sent, shown.choices) = (None, None));
    }

    /// What changed in the views that somebody looks at. False when it was cancelled: the rest comes the next time.
    pub fn update(
        &mut self,
        host: &mut AnalysisHost,
        names: &LocationFormat<'_>,
        wanted: &dyn Fn(u32) -> bool,
        cancel: &CancelFlag,
    ) -> (Vec<ModelMessage>, bool) {
        let mut messages = Vec::new();
        let files = self.files.clone();
        let mut finished = true;
        for (&id, view) in self.views.iter_mut().filter(|(id, _)| wanted(**id)) {
            for (&side, shown) in &mut view.sides {
                let Some(analyzed) = host.analyzed(&shown.root, cancel) else {
                    finished = false;
                    continue;
                };
                if shown
                    .sent
                    .as_ref()
                    .is_some_and(|sent| Arc::ptr_eq(sent, &analyzed))
                {
                    continue;
                }
                view.revision += 1;
                let made = shown.message(host, names, &files, analyzed);
                messages.extend(made.map(|message| ModelMessage {
                    id,
                    side,
                    revision: view.revision,
                    ..message
                }));
                shown.numbered(view.revision);
            }
        }
        if !messages.is_empty() {
            self.forget_files();
        }
        (messages, finished)
    }

    /// The files that the robots shown depend on.
    pub fn reads(&self) -> BTreeSet<PathBuf> {
        let sides = self.views.values().flat_map(|view| view.sides.values());
        let analyzed = sides.filter_map(|shown| shown.sent.as_ref());
        let reads = analyzed.flat_map(|analyzed| analyzed.expansion.record.iter());
        let files = reads.filter_map(|read| match read {
            Read::File(path, _) | Read::Missing(path) => Some(path.clone()),
            _ => None,
        });
        files.chain(self.files.paths()).collect()
    }

    /// The bytes of a file that a model names.
    pub fn mesh(&self, host: &AnalysisHost, id: &str) -> Result<MeshBytes, String> {
        let path = self
            .files
            .path(id)
            .ok_or("no open preview uses this file")?;
        let bytes = host.session().vfs.bytes(&path, SENT_BYTES);
        let bytes = bytes.map_err(|error| format!("it cannot be read: {}", error.reason()))?;
        Ok(MeshBytes {
            name: path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
            bytes,
        })
    }

    /// The robot of a view as URDF.
    ///
    /// # Errors
    /// When the view shows none, or one with errors.
    pub fn urdf(&self, id: u32) -> Result<String, String> {
        let shown = self.analyzed(id).ok_or("no robot is shown")?;
        ModelSource(shown.clone()).urdf()
    }

    /// The links and joints that the text at a place makes.
    pub fn made_by(
        &self,
        id: u32,
        location: &Location,
        names: &LocationFormat<'_>,
    ) -> Option<Selection> {
        let analyzed = self.analyzed(id)?;
        let places = LocationMapper {
            names,
            expansion: &analyzed.expansion,
        };
        let robot = analyzed.robot.as_ref()?;
        Some(Selection {
            id,
            ..select::made_by(robot, &places, location)
        })
    }

    /// Where a link or a joint stands.
    pub fn place_of(
        &self,
        id: u32,
        link: Option<String>,
        joint: Option<String>,
        names: &LocationFormat<'_>,
    ) -> Option<Selection> {
        let analyzed = self.analyzed(id)?;
        let places = LocationMapper {
            names,
            expansion: &analyzed.expansion,
        };
        let robot = analyzed.robot.as_ref()?;
        let location = select::location_of(robot, &places, link.as_deref(), joint.as_deref());
        let (links, joints) = (
            link.clone().into_iter().collect(),
            joint.clone().into_iter().collect(),
        );
        Some(Selection {
            id,
            link,
            joint,
            links,
            joints,
            location,
        })
    }

    fn analyzed(&self, id: u32) -> Option<&Arc<RootAnalysis>> {
        self.views.get(&id)?.sides.get(&Side::Main)?.sent.as_ref()
    }

    /// Files that no model names any more can no longer be asked for.
    fn forget_files(&mut self) {
        let sides = self.views.values().flat_map(|view| view.sides.values());
        let models = sides.flat_map(|shown| {
            shown
                .current
                .iter()
                .chain(shown.good.iter().map(|good| &good.0))
        });
        let named: FastSet<&str> = models
            .flat_map(|model| model.meshes.keys().map(String::as_str))
            .collect();
        self.files.keep(&named);
    }
}

impl Shown {
    /// The message about an expansion; its numbers are still to be given.
    fn message(
        &mut self,
        host: &mut AnalysisHost,
        names: &LocationFormat<'_>,
        files: &ModelFiles,
        analyzed: Arc<RootAnalysis>,
    ) -> Option<ModelMessage> {
        let expansion = &analyzed.expansion;
        let ok = !expansion.has_errors() && expansion.root_error.is_none();
        self.current = Some(Arc::new(drawn(host, names, files, &analyzed)));
        if ok {
            self.good = self.current.clone().map(|model| (model, None));
        } else if self.good.is_none() {
            let last = host.last_good(&self.root);
            self.good = last.map(|last| (Arc::new(drawn(host, names, files, &last)), None));
        }
        let good = self.good.clone().filter(|_| !ok);
        let arguments = analyzed.declared_arguments().into_iter();
        let message = ModelMessage {
            id: 0,
            side: Side::Main,
            revision: 0,
            ok,
            model: self.current.clone().filter(|_| good.is_none()),
            errors: errors(names, &analyzed, &self.root),
            good_revision: good.as_ref().and_then(|(_, revision)| *revision),
            last_good: good.map(|(model, _)| model),
            root: RootName::of(&self.root, (names.uri)(&self.root.file)?),
            args: arguments
                .map(|(name, value)| Argument {
                    name: name.to_owned(),
                    value: value.to_owned(),
                })
                .collect(),
            choices: self.choices(host, names),
            programs: programs(
                host.session(),
                &analyzed,
                &LocationMapper { names, expansion },
            ),
            source: ModelSource(analyzed.clone()),
        };
        self.sent = Some(analyzed);
        Some(message)
    }

    /// What else could be shown; looked for again when files came or went.
    fn choices(&mut self, host: &mut AnalysisHost, names: &LocationFormat<'_>) -> Vec<RootName> {
        let count = host.known_files().len();
        match &self.choices {
            Some((known, choices)) if *known == count => choices.clone(),
            _ => {
                let found = choices(host, &self.root, names);
                self.choices = Some((host.known_files().len(), found.clone()));
                found
            }
        }
    }

    /// What was just made went out with a number.
    fn numbered(&mut self, revision: u64) {
        let ok = self
            .sent
            .as_ref()
            .is_some_and(|sent| !sent.expansion.has_errors());
        if let Some((_, number)) = self.good.as_mut().filter(|_| ok) {
            *number = Some(revision);
        }
    }
}

/// The model of an expansion.
fn drawn(
    host: &AnalysisHost,
    names: &LocationFormat<'_>,
    files: &ModelFiles,
    analyzed: &RootAnalysis,
) -> Model {
    let places = LocationMapper {
        names,
        expansion: &analyzed.expansion,
    };
    match &analyzed.robot {
        Some(robot) => of_robot(host.session(), robot, &places, files),
        None => Model::default(),
    }
}

/// The model of a robot, and the files of its meshes; without places.
pub fn still(session: &Session, expansion: &Expansion, robot: &Robot) -> (Model, ModelFiles) {
    let files = ModelFiles::default();
    let names = LocationFormat {
        uri: &|_| None,
        path: &|_| None,
        encoding: Encoding::Utf8,
    };
    let model = of_robot(
        session,
        robot,
        &LocationMapper {
            names: &names,
            expansion,
        },
        &files,
    );
    (model, files)
}

fn of_robot(
    session: &Session,
    robot: &Robot,
    places: &LocationMapper<'_>,
    files: &ModelFiles,
) -> Model {
    let mut shapes = Shapes::new(session, places.expansion, robot, files);
    shapes.read_meshes(robot);
    model(robot, places, &mut shapes)
}

fn errors(
    names: &LocationFormat<'_>,
    analyzed: &RootAnalysis,
    root: &RootConfig,
) -> Vec<ModelError> {
    let expansion = &analyzed.expansion;
    let places = LocationMapper { names, expansion };
    let problems = expansion
        .problems
        .iter()
        .filter(|p| p.severity == Severity::Error && !p.probed);
    let listed = problems.filter_map(|problem| {
        let code = rules::rule_of(problem.kind).name;
        let location = places.place(problem.place)?;
        Some(ModelError {
            message: problem.message.clone(),
            code: code.to_owned(),
            location,
        })
    });
    let unreadable = expansion.root_error.as_ref().and_then(|error| {
        let message = format!("cannot read the file: {}", error.reason());
        let location = Location::start((names.uri)(&root.file)?);
        Some(ModelError {
            message,
            code: "unreadable-file".to_owned(),
            location,
        })
    });
    unreadable
        .into_iter()
        .chain(listed)
        .take(SENT_ERRORS)
        .collect()
}
