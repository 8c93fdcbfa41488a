//! Checks of whole workspaces: which files are robots, expanding them, running rules, merging what is found.
//!
//! What the command line and the language server share.

mod admission;
mod argument_places;
mod baseline;
mod beside;
mod called_robots;
mod calls;
mod candidates;
mod change;
mod check;
mod check_task;
mod config_choices;
mod config_findings;
mod configs;
mod context;
mod contexts;
mod coverage;
mod cut;
mod declared;
mod drift;
mod expect;
mod fix;
mod generated;
mod graph;
mod group;
mod guard;
mod host;
mod includers;
mod includes;
mod json;
mod kept;
mod launch_findings;
mod launch_names;
mod launch_values;
mod launched;
mod launched_controllers;
mod launched_descriptions;
mod launched_files;
mod launched_hardware;
mod launched_managers;
mod launched_transforms;
mod launched_worlds;
mod left_over;
mod lock;
mod lowered;
mod made_elsewhere;
mod merge;
mod named;
mod options;
mod outside_packages;
mod parts;
mod placing;
mod plan;
mod progress;
mod proof;
mod read_as_yaml;
mod renaming;
mod report;
mod report_on;
mod roles;
mod root_analysis;
mod root_config;
mod root_result;
mod roots;
mod run_cache;
mod run_task;
mod runs;
mod scan;
mod series;
mod session;
mod set_aside;
mod suppress;
mod task_list;
mod texts;
mod threads;
mod unused;
mod uses;
mod walk;

#[cfg(test)]
mod beside_tests;
#[cfg(test)]
mod generated_tests;
#[cfg(test)]
mod launch_findings_tests;
#[cfg(test)]
mod launched_otherwise_tests;
#[cfg(test)]
mod left_over_tests;
#[cfg(test)]
mod made_elsewhere_tests;
#[cfg(test)]
mod outside_packages_tests;
#[cfg(test)]
mod package_tests;
#[cfg(test)]
mod pairing_tests;
#[cfg(test)]
mod purpose_tests;
#[cfg(test)]
mod set_aside_tests;
#[cfg(test)]
mod shown_tests;
#[cfg(test)]
mod unused_parts_tests;
#[cfg(test)]
mod unused_settings_tests;
#[cfg(test)]
mod unused_tests;
#[cfg(test)]
mod used_names_tests;
#[cfg(test)]
mod uses_tests;

pub use baseline::{Baseline, fingerprint};
pub use beside::{
    Beside, files_beside, is_settings, read_file_beside, read_files_beside, robots_beside,
    robots_to_name,
};
pub use candidates::Candidates;
pub use check::check;
pub use config_choices::{
    ConfigChoice, ConfigChoiceKind, ConfigChoices, config_choices_at, config_key_at, is_config,
};
pub use configs::{Overrides, Settings};
pub use context::{commented_argument, context, known_robots};
pub use cut::{Cut, CutBy};
pub use expect::{TestCase, TestOptions, Tests, Update, test, test_name};
pub use fix::{FixOptions, Fixed, FixedFile, fix, fixable, is_installed, is_said_safe, safe_fixes};
pub use group::{grouped, mark_cuts, mark_groups};
pub use host::AnalysisHost;
pub use json::{finding_to_json, to_json};
pub use launch_findings::{launch_values, undeclared_arguments};
pub use launch_names::{
    LaunchChoices, LaunchName, gives_to_another, launch_choices_at, launch_name_at, launch_places,
};
pub use launched::launched_roots;
pub use options::CheckOptions;
pub use parts::robots_of_parts;
pub use plan::{Plan, apply};
pub use progress::Progress;
pub use proof::{AffectedRobots, Effort, expansion_unchanged};
pub use renaming::{NewName, Obstacle, Replaced, changed_robot};
pub use report::{Position, Report, SkipReason, Skipped, Unreadable};
pub use report_on::report_on;
pub use root_analysis::{RootAnalysis, Work};
pub use root_config::{Context, RootConfig, RootReason};
pub use session::{Session, Setup};
pub use task_list::files_to_check;
pub use walk::is_launch;
