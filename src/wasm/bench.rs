//! Files in memory, and answers about them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use serde_json::{Map, Value, json};

use super::calls::{Call, CheckCall, RobotParams};
use analysis::{AnalysisHost, FixOptions, RootConfig, Session};
use base::{CancelFlag, Encoding, IdVec};
use expand::{Expansion, FileIdx, FileRange, Problem, Request};
use packages::{PackageOptions, Packages};
use preview::{LocationFormat, Views};
use rules::{Safety, Severity};
use vfs::{Environment, Vfs, shown_path};
use workspace::config::Config;
use workspace::is_ignored_by_git;

/// The folder of all files. Paths outside are possible; nothing is searched there.
pub(crate) const FOLDER: &str = "/workspace";
/// Time that looking for robots may take.
const PATIENCE: Duration = Duration::from_secs(10);

/// Files, and what was made of them.
pub struct Bench {
    env: Environment,
    vfs: Arc<Vfs>,
    host: AnalysisHost,
    /// Files that were put or taken since the host saw them.
    changed: BTreeSet<PathBuf>,
    views: Views,
    /// The view of the robot that is shown.
    shown: Option<(u32, RobotParams)>,
}

impl Default for Bench {
    fn default() -> Self {
        let cwd = PathBuf::from(FOLDER);
        let env = Environment {
            vars: BTreeMap::new(),
            cwd: cwd.clone(),
            ..Environment::default()
        };
        let vfs = Arc::new(Vfs::in_memory(
            Config::default().limits.file_bytes(),
            cwd.clone(),
        ));
        let host = AnalysisHost::over(vfs.clone(), env.clone(), vec![cwd]);
        let (views, changed) = (Views::default(), BTreeSet::new());
        Self {
            env,
            vfs,
            host,
            changed,
            views,
            shown: None,
        }
    }
}

impl Bench {
    /// Put a file there, or take it away.
    pub fn put(&mut self, path: &str, bytes: Option<Vec<u8>>) {
        let path = self.vfs.absolute(Path::new(path));
        self.vfs.put(&path, bytes);
        self.changed.insert(path);
    }

    /// Answer a question, both as JSON.
    ///
    /// # Errors
    /// What is wrong with the question.
    pub fn call(&mut self, question: &str) -> Result<String, String> {
        let call: Call = serde_json::from_str(question).map_err(|error| error.to_string())?;
        let answer = match call {
            Call::Check(options) => return self.check(&options),
            Call::Fix(options) => self.fix(&options)?,
            Call::Expand(robot) => self.expand(&robot)?,
            Call::Robots => self.robots(),
            Call::Files => json!(self.files()),
            Call::Model(robot) => self.model(robot),
            Call::Select {
                link,
                joint,
                location,
            } => {
                let Some((id, _)) = self.shown else {
                    return Ok("null".to_owned());
                };
                json!(match location {
                    Some(place) if link.is_none() && joint.is_none() =>
                        self.views.made_by(id, &place, &names()),
                    _ => self.views.place_of(id, link, joint, &names()),
                })
            }
            Call::Version => json!(env!("CARGO_PKG_VERSION")),
        };
        Ok(answer.to_string())
    }

    /// The bytes of a file that the last model names.
    ///
    /// # Errors
    /// When it names none of this id.
    pub fn mesh(&self, id: &str) -> Result<Vec<u8>, String> {
        self.views.mesh(&self.host, id).map(|mesh| mesh.bytes)
    }

    fn session(&self, call: &CheckCall) -> Result<(Session, analysis::CheckOptions), String> {
        let options = call.options()?;
        let setup = call.setup(&options, &self.env.cwd);
        Ok((Session::over(self.vfs.clone(), &self.env, setup), options))
    }

    fn check(&self, call: &CheckCall) -> Result<String, String> {
        let (session, options) = self.session(call)?;
        let report = analysis::check(&session, &options);
        if let Some(unreadable) = report.unreadable.first() {
            let path = shown_path(&unreadable.path, &self.env.cwd);
            return Err(format!("{path}: {}", unreadable.error.reason()));
        }
        let report = if call.no_group {
            report
        } else {
            analysis::grouped(report)
        };
        Ok(analysis::to_json(&report, &self.env.cwd))
    }

    fn fix(&self, call: &CheckCall) -> Result<Value, String> {
        let (session, options) = self.session(call)?;
        let most = if call.unsafe_fixes {
            Safety::Unsafe
        } else {
            Safety::Safe
        };
        let fixed = analysis::fix(
            &session,
            &options,
            FixOptions {
                most,
                shown: Severity::Warning,
            },
        );
        let files = fixed
            .files
            .iter()
            .map(|file| (shown_path(&file.path, &self.env.cwd), json!(file.after)));
        Ok(json!({ "count": fixed.count, "files": files.collect::<Map<_, _>>() }))
    }

    fn expand(&self, robot: &RobotParams) -> Result<Value, String> {
        let config = Config::for_file(&self.vfs, &self.env.cwd.join(&robot.file)).config;
        let explicit = robot
            .package_path
            .iter()
            .map(|folder| self.env.cwd.join(folder))
            .collect();
        let found = PackageOptions {
            explicit,
            environment_first: true,
            ignored_by_git: is_ignored_by_git,
            ..PackageOptions::default()
        };
        let packages = Packages::new(self.vfs.clone(), &self.env, found);
        let request = Request {
            file: robot.file.clone(),
            args: robot.args.clone().into_iter().collect(),
            limits: config.limits.expansion(),
            keep: true,
            ..Request::default()
        };
        let sources = expand::Sources {
            vfs: &self.vfs,
            packages: &packages,
            env: &self.env,
        };
        let expansion = expand::expand(sources, &request);
        if let Some(error) = &expansion.root_error {
            return Err(format!("{}: {}", robot.file, error.reason()));
        }
        let name = |path: &Path| shown_path(path, &self.env.cwd);
        let files: IdVec<FileIdx, String> = expansion
            .files
            .iter()
            .map(|file| name(&file.source.path))
            .collect();
        let arguments = expansion.arguments.iter();
        let mapped = (!expansion.has_errors()).then(|| {
            let written = expand::write_mapped(&expansion.tree, &robot.file);
            let map = ide::source_map(&expansion, &written, Encoding::Utf16, |file| {
                name(&file.source.path)
            });
            (written.text, map)
        });
        let (text, map) = mapped.unzip();
        Ok(json!({
            "text": text,
            "map": map,
            "problems": problems(&expansion, &files),
            "arguments": arguments.map(|(name, value)| (name.to_string(), json!(value.as_str()))).collect::<Map<_, _>>(),
            "files": files.as_slice(),
        }))
    }

    fn files(&self) -> Vec<String> {
        let files = self.vfs.files_in_memory(&self.env.cwd).unwrap_or_default();
        files
            .iter()
            .map(|path| shown_path(path, &self.env.cwd))
            .collect()
    }

    /// Have the host see what changed.
    fn catch_up(&mut self) {
        let changed: Vec<PathBuf> = std::mem::take(&mut self.changed).into_iter().collect();
        if !changed.is_empty() {
            self.host.changed_on_disk(&changed);
        }
        self.host.scan_within(PATIENCE);
    }

    fn robots(&mut self) -> Value {
        self.catch_up();
        let robots: BTreeSet<PathBuf> = analysis::known_robots(&self.host)
            .into_iter()
            .map(|root| root.file)
            .collect();
        robots
            .iter()
            .map(|file| Value::from(shown_path(file, &self.env.cwd)))
            .collect()
    }

    fn model(&mut self, robot: RobotParams) -> Value {
        self.catch_up();
        let id = match &self.shown {
            Some((id, shown)) if *shown == robot => *id,
            shown => {
                let args = robot.args.clone().into_iter().collect();
                let root = RootConfig {
                    file: self.vfs.absolute(Path::new(&robot.file)),
                    args,
                    preset: None,
                };
                let id = match shown {
                    Some((id, _)) if self.views.show(*id, root.clone(), None) => *id,
                    _ => self.views.open(root),
                };
                self.shown = Some((id, robot));
                id
            }
        };
        let wanted = |one: u32| one == id;
        let (messages, _) =
            self.views
                .update(&mut self.host, &names(), &wanted, &CancelFlag::default());
        json!(messages.into_iter().next())
    }
}

/// How places are named: files by their paths, columns in the units of JavaScript.
const fn names() -> LocationFormat<'static> {
    LocationFormat {
        uri: &|path| Some(shown_path(path, Path::new(FOLDER))),
        path: &|name| Some(Path::new(FOLDER).join(name)),
        encoding: Encoding::Utf16,
    }
}

/// The problems of an expansion, as findings name their places.
fn problems(expansion: &Expansion, files: &IdVec<FileIdx, String>) -> Vec<Value> {
    let problem = |problem: &Problem| {
        let Problem {
            place,
            message,
            help,
            ..
        } = problem;
        json!({
            "severity": problem.severity.name(),
            "message": message,
            "help": help,
            "filename": files.get(place.file),
            "location": position(expansion, *place, place.range.start),
            "end_location": position(expansion, *place, place.range.end),
        })
    };
    expansion.problems.iter().map(problem).collect()
}

/// An offset in the file of a place, in lines and columns from 1.
fn position(expansion: &Expansion, place: FileRange, offset: u32) -> Option<Value> {
    let source = &expansion.files.get(place.file)?.source;
    let at = source.document.line_col(offset, Encoding::Utf32);
    Some(json!({ "row": at.line + 1, "column": at.col + 1 }))
}
