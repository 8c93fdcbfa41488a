//! From the arguments of `check` to what is to be checked.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::check_args::{CheckArgs, OutputFormat};
use super::io::all_of;
use super::options::mappings;
use super::watch::WatchedFiles;
use analysis::{Baseline, CheckOptions, Overrides, Session, Setup};
use serde_json::Value;
use vfs::Environment;
use workspace::config::{CONFIG_NAMES, Config, unknown_settings};

/// Everything a check needs.
pub(super) struct Prepared {
    pub(super) session: Session,
    pub(super) options: CheckOptions,
    /// Findings that are known, and the folder that their files are named from.
    pub(super) baseline: Option<(Baseline, PathBuf)>,
    /// What in `--settings` has no effect.
    pub(super) warnings: Vec<String>,
}

impl Prepared {
    /// The state of files that were read, of those that would be checked now, and of those that would be read if they
    /// came to be: what was named, and configurations.
    pub(super) fn state(&self, mut files: BTreeSet<PathBuf>) -> WatchedFiles {
        let vfs = &self.session.vfs;
        files.extend(analysis::files_to_check(&self.session, &self.options));
        let named = self
            .options
            .paths
            .iter()
            .chain(&self.options.entries)
            .map(|path| vfs.absolute(path));
        let named: Vec<PathBuf> = named.collect();
        let folders: BTreeSet<&Path> = files
            .iter()
            .filter_map(|file| file.parent())
            .chain(named.iter().flat_map(|path| path.ancestors()))
            .collect();
        let configs: Vec<PathBuf> = folders
            .into_iter()
            .flat_map(|folder| CONFIG_NAMES.map(|name| folder.join(name)))
            .collect();
        // a folder changes with every file in it
        files.extend(named.into_iter().filter(|path| !vfs.is_dir(path)));
        files.extend(configs);
        files
            .into_iter()
            .map(|path| (path.clone(), vfs.state_on_disk(&path)))
            .collect()
    }
}

/// Read the arguments, the configuration, the baseline and, where asked for, standard input.
///
/// # Errors
/// What is wrong with the arguments, or cannot be read.
pub(super) fn prepare(
    args: &CheckArgs,
    env: &Environment,
    stdin: &mut dyn Read,
) -> Result<Prepared, String> {
    let options = options(args)?;
    let settings = editor_settings(args.settings.as_deref())?;
    let warnings = settings
        .iter()
        .flat_map(|settings| settings_without_effect(settings, &env.cwd))
        .collect();
    let setup = Setup {
        about: options
            .paths
            .iter()
            .chain(&options.entries)
            .next()
            .cloned()
            .unwrap_or_default(),
        package_path: args.package_path.iter().map(PathBuf::from).collect(),
        overrides: Overrides {
            editor: settings
                .map(|settings| (settings, env.cwd.clone()))
                .into_iter()
                .collect(),
            ..overrides(args)
        },
        // who checks a folder means the packages in it
        folders: options
            .paths
            .iter()
            .map(|path| env.cwd.join(path))
            .collect(),
    };
    let session = Session::new(env, setup)
        .map_err(|error| format!("{}: {}", vfs::slashed(&error.path), error.reason()))?;
    if let Some(name) = stdin_name(args) {
        let read = read_stdin(&name, &session, stdin);
        read.map_err(|error| format!("cannot read standard input: {error}"))?;
    }
    let baseline = args
        .baseline
        .as_deref()
        .map(|path| read_baseline(path, &session))
        .transpose()?;
    Ok(Prepared {
        session,
        options,
        baseline,
        warnings,
    })
}

fn read_baseline(path: &Path, session: &Session) -> Result<(Baseline, PathBuf), String> {
    let shown = vfs::slashed(path);
    let file = session
        .vfs
        .text(path)
        .map_err(|error| format!("{shown}: {}", error.reason()))?;
    let baseline = Baseline::from_json(&file.text).map_err(|why| format!("{shown}: {why}"))?;
    let folder = file.path.parent().map(Path::to_owned).unwrap_or_default();
    Ok((baseline, folder))
}

/// The name that standard input is checked under.
fn stdin_name(args: &CheckArgs) -> Option<PathBuf> {
    let dash = args
        .paths
        .iter()
        .any(|path| path == "-")
        .then(|| PathBuf::from("-"));
    args.stdin_filename.clone().or(dash)
}

/// Put standard input in the place of a file.
fn read_stdin(name: &Path, session: &Session, stdin: &mut dyn Read) -> std::io::Result<()> {
    session.vfs.set_buffer(name, Some(all_of(stdin)?));
    Ok(())
}

fn options(args: &CheckArgs) -> Result<CheckOptions, String> {
    let (mapped, paths): (Vec<&String>, Vec<&String>) =
        args.paths.iter().partition(|path| path.contains(":="));
    let paths = paths.into_iter().filter(|path| *path != "-");
    let mut paths: Vec<PathBuf> = paths.map(PathBuf::from).collect();
    paths.extend(stdin_name(args));
    if paths
        .iter()
        .chain(&args.entry)
        .any(|path| path.as_os_str().is_empty())
    {
        return Err("empty path".to_owned());
    }
    if paths.is_empty() && args.entry.is_empty() {
        paths.push(".".into());
    }
    let arguments =
        mappings(mapped.into_iter().map(String::as_str)).map_err(|error| error.message())?;
    contradictions(args)?;
    let selectors = [&args.select, &args.extend_select, &args.ignore]
        .into_iter()
        .flatten();
    let mut unknown =
        selectors.filter(|selector| *selector != "ALL" && rules::find(selector).next().is_none());
    // a change is judged by everything around it
    let changed = if args.changed {
        std::mem::replace(&mut paths, vec![".".into()])
    } else {
        Vec::new()
    };
    match unknown.next() {
        Some(unknown) => Err(rules::unknown_selector(unknown)),
        None => Ok(CheckOptions {
            paths,
            changed,
            entries: args.entry.clone(),
            args: arguments,
            count_consumers: args.format == OutputFormat::Text && !args.statistics && !args.changed,
            ..CheckOptions::default()
        }),
    }
}

/// Options that do not go together.
fn contradictions(args: &CheckArgs) -> Result<(), String> {
    let for_people = matches!(args.format, OutputFormat::Text | OutputFormat::Concise);
    let message = if args.watch && stdin_name(args).is_some() {
        "--watch cannot be used with standard input"
    } else if args.statistics && !for_people {
        "--statistics requires --format text or concise"
    } else if args.diff && !for_people {
        "--diff cannot be used with --format"
    } else if args.unsafe_fixes && !args.fix && !args.diff {
        "--unsafe-fixes requires --fix or --diff"
    } else if args.changed && stdin_name(args).is_some() {
        "--changed requires file names and cannot be used with standard input"
    } else if args.fix && !args.diff && stdin_name(args).is_some() {
        "cannot fix standard input in place: use --diff"
    } else {
        return Ok(());
    };
    Err(message.to_owned())
}

fn overrides(args: &CheckArgs) -> Overrides {
    Overrides {
        config: args.config.clone(),
        select: named(&args.select),
        extend_select: named(&args.extend_select),
        ignore: named(&args.ignore),
        profiles: named(&args.profile),
        consumers: named(&args.consumers),
        ..Overrides::default()
    }
}

/// The settings of an editor, as `--settings` gives them.
fn editor_settings(json: Option<&str>) -> Result<Option<Value>, String> {
    let Some(json) = json else {
        return Ok(None);
    };
    match serde_json::from_str::<Value>(json) {
        Ok(settings) if settings.is_object() => Ok(Some(settings)),
        Ok(_) => Err("--settings requires a JSON object".to_owned()),
        Err(error) => Err(format!("--settings requires a JSON object: {error}")),
    }
}

/// Wrong types, and keys that nobody knows.
fn settings_without_effect(settings: &Value, folder: &Path) -> Vec<String> {
    let wrong = Config::default().apply_settings(settings, folder);
    let mut warnings: Vec<String> = wrong.iter().map(ToString::to_string).collect();
    warnings.extend(unknown_settings(settings));
    warnings
}

/// What a repeatable option names; none when it is not given.
fn named(list: &[String]) -> Option<Vec<String>> {
    (!list.is_empty()).then(|| list.to_vec())
}
