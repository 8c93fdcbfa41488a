//! `xacro-lint config`.

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::args::{ConfigArgs, Plain};
use super::check::warn_about_config;
use super::io::Io;
use super::render::{shown_path, visible};
use analysis::{Overrides, Session, Setup};
use rules::THRESHOLDS;
use vfs::Environment;
use workspace::config::{Config, EffectiveSetting, schema};

/// Print the settings that hold for a file or folder, or the schema of the configuration file.
pub(super) fn run(args: &ConfigArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    if args.schema {
        io.out(&format!("{:#}\n", schema()));
        return 0;
    }
    let overrides = Overrides {
        config: args.config.clone(),
        ..Overrides::default()
    };
    let setup = Setup {
        about: args.path.clone(),
        overrides,
        ..Setup::default()
    };
    let session = match Session::new(env, setup) {
        Ok(session) => session,
        Err(error) => {
            io.line(&format!(
                "error: {}",
                visible(&format!(
                    "{}: {}",
                    vfs::slashed(&error.path),
                    error.reason()
                ))
            ));
            return 2;
        }
    };
    if !session.vfs.exists(&args.path) {
        io.line(&format!(
            "error: {}: No such file or directory",
            visible(&vfs::slashed(&args.path))
        ));
        return 2;
    }
    let path = session.vfs.absolute(&args.path);
    let file = if session.vfs.is_dir(&path) {
        path.join("_")
    } else {
        path
    };
    let settings = session.settings(&file);
    let all = with_thresholds(&settings.config);
    match args.format {
        Plain::Text => table(&settings.config, &all, &env.cwd, io),
        Plain::Json => io.out(&format!(
            "{:#}\n",
            as_json(&settings.config, &all, &env.cwd)
        )),
    }
    warn_about_config(&session, env, io)
}

/// The settings, with a line for each threshold.
fn with_thresholds(config: &Config) -> Vec<EffectiveSetting> {
    let mut all = Vec::new();
    for setting in config.settings() {
        if setting.key != "thresholds" {
            all.push(setting);
            continue;
        }
        for threshold in THRESHOLDS {
            let is_set = config.thresholds.contains_key(threshold.name);
            let origins = if is_set {
                setting.origins.clone()
            } else {
                Vec::new()
            };
            let value = json!(threshold.value(config));
            all.push(EffectiveSetting {
                key: format!("thresholds.{}", threshold.name),
                value,
                origins,
            });
        }
    }
    all
}

fn origin(origins: &[PathBuf], cwd: &Path) -> String {
    let names: Vec<String> = origins.iter().map(|path| shown_path(path, cwd)).collect();
    if names.is_empty() {
        "default".to_owned()
    } else {
        names.join(", ")
    }
}

/// As a configuration file, with the origin of each line behind it.
fn table(config: &Config, settings: &[EffectiveSetting], cwd: &Path, io: &mut Io<'_>) {
    let files: Vec<String> = config
        .files
        .iter()
        .map(|path| shown_path(path, cwd))
        .collect();
    let files = if files.is_empty() {
        "no configuration file".to_owned()
    } else {
        files.join(", ")
    };
    let mut out = format!("# {files}\n");
    let lines: Vec<(String, String)> = settings
        .iter()
        .map(|setting| match &setting.value {
            Value::Null => (
                format!("# {} is not set", setting.key),
                origin(&setting.origins, cwd),
            ),
            value => (
                format!("{} = {}", setting.key, toml(value)),
                origin(&setting.origins, cwd),
            ),
        })
        .collect();
    const WIDEST: usize = 60;
    let fitting = lines
        .iter()
        .map(|(line, _)| line.chars().count())
        .filter(|&width| width <= WIDEST);
    let width = fitting.max().unwrap_or(0);
    for (line, origin) in lines {
        out.push_str(&format!("{line:width$}  # {origin}\n"));
    }
    io.out(&visible(&out));
}

/// A value as it is written in a configuration file.
fn toml(value: &Value) -> String {
    match value {
        Value::Array(items) => format!(
            "[{}]",
            items.iter().map(toml).collect::<Vec<_>>().join(", ")
        ),
        Value::Object(fields) if fields.is_empty() => "{}".to_owned(),
        Value::Object(fields) => {
            let field = |(key, value): (&String, &Value)| {
                let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
                let key = if !key.is_empty() && key.chars().all(is_bare) {
                    key.clone()
                } else {
                    json!(key).to_string()
                };
                format!("{key} = {}", toml(value))
            };
            format!(
                "{{ {} }}",
                fields.iter().map(field).collect::<Vec<_>>().join(", ")
            )
        }
        // strings, numbers and truth values are written as in JSON
        other => other.to_string(),
    }
}

fn as_json(config: &Config, settings: &[EffectiveSetting], cwd: &Path) -> Value {
    let entry = |setting: &EffectiveSetting| {
        let value = json!({"value": setting.value, "origins": names(&setting.origins, cwd)});
        (setting.key.clone(), value)
    };
    let settings: Map<String, Value> = settings.iter().map(entry).collect();
    json!({"files": names(&config.files, cwd), "settings": settings})
}

fn names(paths: &[PathBuf], cwd: &Path) -> Value {
    paths
        .iter()
        .map(|path| json!(shown_path(path, cwd)))
        .collect()
}
