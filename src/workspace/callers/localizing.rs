//! Whether a robot is localized in the world, or is meant to be.

use std::path::Path;

use super::Callers;
use super::file_names;
use super::read::{self, has_any};
use super::walk::walk;

/// Words of programs that publish the frames around a robot, and of their settings.
const WORDS: [&str; 12] = [
    "amcl",
    "cartographer",
    "diff_drive",
    "gmapping",
    "localization",
    "map_server",
    "move_base",
    "nav2",
    "odometry",
    "rtabmap",
    "slam",
    "SLAM",
];

/// What publishes transforms that do not change.
const PLACES: [&str; 2] = ["static_transform", "StaticTransform"];

impl Callers {
    /// Whether a launch file, program, setting or page around a description names a program that localizes robots; also where not all
    /// of them are known, or nothing runs.
    pub fn localize_any(&self, file: &Path) -> bool {
        let is_run = self
            .mentions(file)
            .is_some_and(|mentions| mentions.is_whole && mentions.runs);
        !is_run || self.any_text(file, |text| has_any(text, &WORDS))
    }

    /// Whether a launch file, program, setting or page around a description has a name, such as that of a frame that it publishes; also
    /// where not all of them are known.
    pub fn say_name(&self, file: &Path, name: &str) -> bool {
        self.any_text(file, |text| read::has_name(text, name))
    }

    /// Whether a launch file, program, setting or page around a description publishes transforms that do not change; also where not all
    /// of them are known.
    pub fn place_frames(&self, file: &Path) -> bool {
        self.any_text(file, |text| has_any(text, &PLACES))
    }

    /// Whether something holds for a text around a description that may start programs, without its comments; also where not all of
    /// them are known.
    fn any_text(&self, file: &Path, holds: impl Fn(&str) -> bool) -> bool {
        let Some(top) = self.packages.sources_around(file) else {
            return true;
        };
        let vfs = self.packages.vfs();
        let mut is_any = false;
        let is_whole = walk(vfs, &top, &mut |path, name, is_small| {
            let is_read = !is_any && file_names::may_call(name) && is_small();
            let text = is_read.then(|| vfs.text(path).ok()).flatten();
            is_any |= text.is_some_and(|text| holds(&read::without_comments(name, &text.text)));
        });
        is_any || !is_whole
    }
}
