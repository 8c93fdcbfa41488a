//! `xacro-lint render`.

use std::path::Path;

use clap::Parser;

use super::args::{Arguments, Command, RenderArgs, Viewpoint};
use super::io::Io;
use super::render::visible;
use super::svg;
use super::tree::{ExpandedRobot, explain, fails, good_tree, no_tree};
use analysis::Session;
use expand::Expansion;
use model::Robot;
use packages::nearest;
use picture::{
    Background, LONGEST_SIDE, MOST_PIXELS, Positions, Scene, SceneOptions, ViewDirection, Viewport,
    movable, picture_png, picture_svg,
};
use preview::{JointModel, Model, still};
use vfs::{Environment, write_atomically};

/// Forms of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Png,
    Svg,
}

/// Run `render`.
pub(super) fn run(args: &RenderArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    let written = draw(args, env, io).and_then(|(code, bytes)| match bytes {
        Some(bytes) => write(args, &bytes, env).map(|()| code),
        None => Ok(code),
    });
    match written {
        Ok(code) => code,
        Err(message) => fails(io, &message),
    }
}

/// Run a command line of `render` without writing its file: the exit code, and the picture.
pub(super) fn drawn(words: &[String], env: &Environment, io: &mut Io<'_>) -> (u8, Option<Vec<u8>>) {
    let name = std::iter::once("xacro-lint").chain(words.iter().map(String::as_str));
    let drawn = match Arguments::try_parse_from(name).map(|arguments| arguments.command) {
        Ok(Command::Render(args)) => draw(&args, env, io),
        Ok(_) => Err("not a command that draws".into()),
        Err(error) => Err(error.to_string()),
    };
    drawn.unwrap_or_else(|message| (fails(io, &message), None))
}

/// Draw the picture; the exit code, and its bytes unless there is nothing to draw.
fn draw(
    args: &RenderArgs,
    env: &Environment,
    io: &mut Io<'_>,
) -> Result<(u8, Option<Vec<u8>>), String> {
    let form = form(&args.output, args.tree)?;
    let shot = shot(args)?;
    let ExpandedRobot {
        file,
        arguments,
        session,
        expansion,
    } = ExpandedRobot::of(&args.file, &args.package_path, env, io)?;
    let robot = Robot::of(&expansion);
    let tree = robot
        .as_ref()
        .filter(|_| !expansion.has_errors())
        .and_then(good_tree);
    if tree.is_none() {
        explain(&session, &file, arguments, env, io);
    }
    match (args.tree, tree.as_ref(), robot.as_ref()) {
        (true, Some(tree), _) => Ok((0, Some(svg::draw(tree).into_bytes()))),
        (false, _, Some(robot)) => {
            let Some((bytes, whole)) =
                picture(args, form, &shot, (&session, &expansion, robot), io)?
            else {
                return Ok((1, None));
            };
            Ok((u8::from(tree.is_none() || !whole), Some(bytes)))
        }
        _ => {
            no_tree(&expansion, io);
            Ok((1, None))
        }
    }
}

/// The picture of a robot, and whether all of it could be drawn; none when there is nothing to draw.
fn picture(
    args: &RenderArgs,
    form: Form,
    shot: &Viewport,
    (session, expansion, robot): (&Session, &Expansion, &Robot),
    io: &mut Io<'_>,
) -> Result<Option<(Vec<u8>, bool)>, String> {
    let (model, files) = still(session, expansion, robot);
    let positions = positions(&args.joint, &model)?;
    let content = SceneOptions {
        collisions: args.collision,
        frames: args.frames,
        positions,
    };
    let scene = Scene::of(&model, &files, &session.vfs, &content)?;
    if scene.is_empty() {
        io.line("error: robot has no links, nothing to draw");
        return Ok(None);
    }
    for problem in &scene.problems {
        io.line(&format!("warning: {}", visible(problem)));
    }
    let bytes = match form {
        Form::Png => picture_png(&scene, shot)?,
        Form::Svg => picture_svg(&scene, &model.robot, shot).into_bytes(),
    };
    Ok(Some((bytes, scene.problems.is_empty())))
}

fn write(args: &RenderArgs, bytes: &[u8], env: &Environment) -> Result<(), String> {
    let written = write_atomically(&env.cwd.join(&args.output), bytes);
    written.map_err(|error| format!("{}: {error}", vfs::slashed(&args.output)))
}

/// The form that a file name asks for.
fn form(output: &Path, tree: bool) -> Result<Form, String> {
    let ending = output
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    match (ending.as_str(), tree) {
        ("svg", _) => Ok(Form::Svg),
        ("png", false) => Ok(Form::Png),
        (_, false) => Err(format!(
            "{}: file name must end in .png or .svg",
            vfs::slashed(output)
        )),
        (_, true) => Err(format!(
            "{}: a tree is drawn as SVG, so the file name must end in .svg",
            vfs::slashed(output)
        )),
    }
}

/// How the picture is taken.
fn shot(args: &RenderArgs) -> Result<Viewport, String> {
    let view = match args.view {
        Viewpoint::Iso => ViewDirection::Iso,
        Viewpoint::Front => ViewDirection::Front,
        Viewpoint::Side => ViewDirection::Side,
        Viewpoint::Top => ViewDirection::Top,
    };
    let background = Background::of(&args.background).ok_or_else(|| {
        format!(
            "invalid background `{}`: use `white`, `black`, `transparent` or a color such as `#f0f4ff`",
            args.background
        )
    })?;
    Ok(Viewport {
        view,
        size: size(&args.size)?,
        background,
    })
}

/// `800x600`
fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse::<u32>();
    let sides = text
        .split_once('x')
        .map(|(width, height)| (side(width), side(height)));
    let Some((Ok(width), Ok(height))) = sides else {
        return Err(format!("invalid size `{text}`: write it as `800x600`"));
    };
    let pixels = u64::from(width) * u64::from(height);
    if pixels == 0 || pixels > MOST_PIXELS || width.max(height) > LONGEST_SIDE {
        let millions = MOST_PIXELS / 1_000_000;
        return Err(format!(
            "invalid size `{text}`: the limit is {millions} million pixels and {LONGEST_SIDE} per side"
        ));
    }
    Ok([width, height])
}

/// The positions of joints that were asked for.
fn positions(wanted: &[String], model: &Model) -> Result<Positions, String> {
    let mut positions = Positions::default();
    for text in wanted {
        let (name, value) = text
            .split_once('=')
            .ok_or_else(|| format!("invalid joint position `{text}`: write it as `elbow=0.5`"))?;
        let joint = model
            .joints
            .iter()
            .find(|joint| joint.name == name)
            .ok_or_else(|| {
                let names = model
                    .joints
                    .iter()
                    .filter(|joint| movable(joint))
                    .map(|joint| joint.name.as_str());
                let near = nearest(name, names).map(|near| format!("; did you mean `{near}`?"));
                format!("unknown joint `{name}`{}", near.unwrap_or_default())
            })?;
        positions.insert(name.to_owned(), position(joint, value)?);
    }
    Ok(positions)
}

/// Radians, degrees as `90deg`, or meters.
fn position(joint: &JointModel, value: &str) -> Result<f64, String> {
    let name = &joint.name;
    if let Some(mimic) = &joint.mimic {
        return Err(format!(
            "joint `{name}` mimics joint `{}`: set the position of that joint",
            mimic.joint
        ));
    }
    if !movable(joint) {
        return Err(format!(
            "joint `{name}` has no position: its type is {}",
            joint.kind
        ));
    }
    let number = |text: &str| {
        text.trim()
            .parse()
            .ok()
            .filter(|number: &f64| number.is_finite())
    };
    let found = match value.strip_suffix("deg") {
        Some(degrees) if joint.kind != "prismatic" => number(degrees).map(f64::to_radians),
        Some(_) => {
            return Err(format!(
                "joint `{name}` is prismatic: its position is in meters"
            ));
        }
        None => number(value),
    };
    found.ok_or_else(|| {
        format!("invalid position `{value}` for joint `{name}`: write `0.5` or `30deg`")
    })
}
