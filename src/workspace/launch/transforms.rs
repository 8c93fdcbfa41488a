//! Transforms that a launch file publishes itself: `static_transform_publisher` of tf and tf2_ros.

use base::TextRange;

use super::LaunchFile;
use super::resolve::{CommandWord, LaunchContext, Resolver};

/// A transform that does not change.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticTransform {
    /// The frame that it starts from.
    pub parent: String,
    /// The frame that it places.
    pub child: String,
    /// Where it places it, in meters.
    pub translation: [f64; 3],
    /// Roll, pitch and yaw in radians; none of a quaternion.
    pub angles: Option<[f64; 3]>,
    /// Where the child is written.
    pub range: TextRange,
}

/// The transforms that a file publishes whenever it is started.
pub(crate) fn transforms_in(file: &LaunchFile) -> Vec<StaticTransform> {
    let context = LaunchContext::default();
    let always = file
        .transforms
        .iter()
        .filter(|command| command.assumed.is_empty());
    let read = |command| {
        let words = Resolver::new(file, &context, &[]).words(command)?;
        transform(&words, command.range)
    };
    always.filter_map(read).collect()
}

/// What the words of a publisher say; none where one that counts is not known.
fn transform(words: &[CommandWord], whole: TextRange) -> Option<StaticTransform> {
    let texts: Vec<String> = words
        .iter()
        .map(CommandWord::literal)
        .collect::<Option<_>>()?;
    let at = |flag: &str| {
        texts
            .iter()
            .position(|text| text == flag)
            .map(|place| place + 1)
    };
    let (parent, child) = match (at("--frame-id"), at("--child-frame-id")) {
        (Some(parent), Some(child)) => (parent, child),
        _ => frames_by_place(&texts)?,
    };
    let frame = |at: usize| Some(texts.get(at)?.trim_start_matches('/').to_owned());
    let (translation, angles) = if texts.first()?.starts_with("--") {
        by_flag(&texts)?
    } else {
        by_place(&texts, parent)?
    };
    Some(StaticTransform {
        parent: frame(parent)?,
        child: frame(child)?,
        translation,
        angles,
        range: words.get(child)?.place().unwrap_or(whole),
    })
}

/// Where the frames stand behind three numbers for the place and three or four for the rotation.
fn frames_by_place(texts: &[String]) -> Option<(usize, usize)> {
    let is_number = |text: &&String| text.parse::<f64>().is_ok();
    let numbers = texts.iter().take_while(is_number).count();
    matches!(numbers, 6 | 7).then_some((numbers, numbers + 1))
}

/// `x y z yaw pitch roll` or `x y z qx qy qz qw` in front of the frames.
fn by_place(texts: &[String], frames: usize) -> Option<([f64; 3], Option<[f64; 3]>)> {
    let numbers: Vec<f64> = texts
        .get(..frames)?
        .iter()
        .map(|text| text.parse().ok())
        .collect::<Option<_>>()?;
    match *numbers.as_slice() {
        [x, y, z, yaw, pitch, roll] => Some(([x, y, z], Some([roll, pitch, yaw]))),
        [x, y, z, ..] => Some(([x, y, z], None)),
        _ => None,
    }
}

/// `--x 1 --yaw 2`; what is not given is zero.
fn by_flag(texts: &[String]) -> Option<([f64; 3], Option<[f64; 3]>)> {
    let value = |flag: &str| match texts.iter().position(|text| text == flag) {
        Some(at) => texts.get(at + 1)?.parse::<f64>().ok(),
        None => Some(0.0),
    };
    let vector = |flags: [&str; 3]| -> Option<[f64; 3]> {
        let [a, b, c] = flags.map(value);
        Some([a?, b?, c?])
    };
    let is_quaternion = texts.iter().any(|text| text.starts_with("--q"));
    let angles = vector(["--roll", "--pitch", "--yaw"])?;
    Some((
        vector(["--x", "--y", "--z"])?,
        (!is_quaternion).then_some(angles),
    ))
}

#[cfg(test)]
mod tests {
    use super::super::read;
    use super::transforms_in;
    use std::path::Path;

    /// Check what a file publishes: the frames, the place, and the angles where they are known.
    fn check_transforms(name: &str, text: &str, expected: &[&str]) {
        let file = read(Path::new(name), text).unwrap_or_default();
        let all = transforms_in(&file);
        let shown = all.iter().map(|one| {
            let angles = one.angles.map(|angles| format!(" {angles:?}"));
            let (parent, child) = (&one.parent, &one.child);
            format!(
                "{parent} {child} {:?}{}",
                one.translation,
                angles.unwrap_or_default()
            )
        });
        assert_eq!(shown.collect::<Vec<_>>(), expected, "{text}");
    }

    #[test]
    fn xml() {
        let node = |args: &str, more: &str| {
            format!(
                "<launch><node pkg='tf' type='static_transform_publisher' args='{args}'{more}/></launch>"
            )
        };
        for (text, expected) in [
            (
                node("0.1 0 0.2 3 2 1 /base /laser 100", ""),
                &["base laser [0.1, 0.0, 0.2] [1.0, 2.0, 3.0]"][..],
            ),
            (
                node("0 0 1 0 0 0 1 base laser", ""),
                &["base laser [0.0, 0.0, 1.0]"],
            ),
            (node("0 0 1 0 0 0 base $(arg frame)", ""), &[]),
            (node("0 0 1 0 0 0 base laser", " if='$(arg own)'"), &[]),
            (node("base laser", ""), &[]),
        ] {
            check_transforms("/ws/a.launch", &text, expected);
        }
    }

    #[test]
    fn python() {
        let node = |arguments: &str| {
            format!(
                "Node(package='tf2_ros', executable='static_transform_publisher', arguments={arguments})"
            )
        };
        for (text, expected) in [
            (
                node("['0', '0', '0.1', '0', '0', '0', 'base', 'laser']"),
                &["base laser [0.0, 0.0, 0.1] [0.0, 0.0, 0.0]"][..],
            ),
            (
                node(
                    "['--x', '1', '--yaw', '2', '--frame-id', 'base', '--child-frame-id', 'laser']",
                ),
                &["base laser [1.0, 0.0, 0.0] [0.0, 0.0, 2.0]"],
            ),
            (
                node("['--qw', '1', '--frame-id', 'base', '--child-frame-id', 'laser']"),
                &["base laser [0.0, 0.0, 0.0]"],
            ),
            (node("['0', '0', '0', '0', '0', '0', 'base', frame]"), &[]),
        ] {
            check_transforms("/ws/a.launch.py", &text, expected);
        }
        let conditional =
            node("['0', '0', '0', '0', '0', '0', 'base', 'laser'], condition=IfCondition(own)");
        check_transforms("/ws/a.launch.py", &conditional, &[]);
        let publisher = node("['0', '0', '0', '0', '0', '0', 'base', 'laser']");
        let started = format!("tf = {publisher}\nreturn LaunchDescription([tf])\n");
        let left_out = format!("tf = {publisher}\nreturn LaunchDescription([\n  # tf,\n])\n");
        let expected = ["base laser [0.0, 0.0, 0.0] [0.0, 0.0, 0.0]"];
        check_transforms("/ws/a.launch.py", &started, &expected);
        check_transforms("/ws/a.launch.py", &left_out, &[]);
    }
}
