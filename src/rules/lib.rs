//! Rules: what can be wrong with a description, one file a rule.
//!
//! A rule is a file here, a line in the list of its category and a page in `docs/rules/`. What expansion finds on its
//! way becomes a finding in `problems`; rules about it that need nothing else are lines of `xacro/found.rs`.

mod arms;
mod beside;
mod catalogue;
mod check_beside;
mod chosen;
pub mod consumers;
mod context;
mod control;
mod conventions;
mod edits;
mod finding;
mod frames;
mod geometry;
mod grouping;
mod inertia;
mod joint;
mod kept_finding;
mod linter;
mod moveit;
pub mod named;
mod names;
mod numbers;
mod package;
mod place;
mod problem_cx;
mod problems;
mod registry;
mod rule;
mod run;
pub mod schema;
mod selection;
mod semantic;
mod settled;
mod sink;
mod srdf;
mod structure;
mod style;
mod thresholds;
mod traits;
mod visit;
mod vocabulary;
mod watch;
mod xacro;
mod xml;

pub use beside::{BesideContent, BesideCx, PairedRobot};
pub use catalogue::{catalogue, catalogue_of};
pub use check_beside::check_beside;
pub use chosen::Chosen;
pub use context::{DocumentCx, FileCx, RobotCx, RootKind, RuleEnv, is_plain_urdf, is_whole};
pub use finding::{CallSite, Edit, Finding, Fix, Help, Related};
pub use geometry::{FileTarget, factors, link_bounds, resolve_file};
pub use grouping::Group;
pub use linter::{
    Directive, Malformed, Selector, Suppression, Suppressions, invalid_config, unused_suppression,
};
pub use moveit::{
    setup_assistant_file_not_found, setup_assistant_robot_fails, setup_assistant_unknown_argument,
};
pub use names::{JointConnection, OfferedInterface, RobotNames};
pub use package::{
    Lacking, Manifests, YamlReader, argument_never_set, description_read_as_yaml,
    generated_urdf_out_of_date, launched_file_not_found, launched_file_not_installed,
    launched_without_xacro, looping_transform, missing_controller_manager, missing_launch_argument,
    missing_packages, missing_sensors_system, own_instead, repeated_transform,
    spawned_controller_not_found, unknown_launch_argument, unloadable_hardware,
    value_never_compared, value_outside_choices,
};
pub use problems::{rejections, rule_of};
pub use registry::{all, by_code, find, nearest_selector, unknown_selector};
pub use rule::{Activation, Category, Check, Rule, Safety, Severity};
pub use run::{
    check_expansion, check_files, check_recovered, has_ignored_tags, losses, needs_names,
    needs_whole, unknown_names,
};
pub use selection::{RuleSelection, SelectionOptions};
pub use semantic::{holds_for_semantic, is_semantic, is_semantic_file, is_semantic_name};
pub use settled::Settled;
pub use sink::{Sink, calls, span_of};
pub use thresholds::{THRESHOLDS, Threshold};
pub use traits::Trait;
pub use xacro::include_tags;
pub use xml::missing_robot_name;
