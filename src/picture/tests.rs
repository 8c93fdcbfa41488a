//! Pictures of small robots.

use super::{
    Background, MOST_PIXELS, Scene, SceneOptions, ViewDirection, Viewport, picture_png, picture_svg,
};
use analysis::{Session, Setup};
use expand::{Request, Sources, expand};
use model::Robot;
use preview::still;
use vfs::testing::Tree;

const WHITE: Background = Background::Solid([255; 3]);

fn body(kind: &str, geometry: &str, more: &str) -> String {
    format!("<{kind}>{more}<geometry>{geometry}</geometry></{kind}>")
}

fn visual(geometry: &str, rgba: &str) -> String {
    let color = format!("<material name=\"m{rgba}\"><color rgba=\"{rgba}\"/></material>");
    body("visual", geometry, &color)
}

/// A link for each text, in a row along joints of one type about z with a meter between.
fn chain(links: &[String], joints: &str) -> String {
    let mut text = String::from("<robot name=\"bot\">");
    for (i, content) in links.iter().enumerate() {
        text.push_str(&format!("<link name=\"l{i}\">{content}</link>"));
    }
    for i in 1..links.len() {
        let parent = i - 1;
        text.push_str(&format!(
            "<joint name=\"j{i}\" {joints}<origin xyz=\"1 0 0\"/><axis xyz=\"0 0 2\"/>\
             <parent link=\"l{parent}\"/><child link=\"l{i}\"/></joint>"
        ));
    }
    text + "</robot>"
}

fn scene(tree: &Tree, robot: &str, content: &SceneOptions) -> Scene {
    tree.write("bot/package.xml", "<package><name>bot</name></package>");
    tree.write("bot/robot.urdf", robot);
    let file = tree.path("bot/robot.urdf");
    let setup = Setup {
        about: file.clone(),
        ..Setup::default()
    };
    let session = Session::new(&tree.environment(&[]), setup).unwrap();
    let sources = Sources {
        vfs: &session.vfs,
        packages: &session.packages,
        env: &session.env,
    };
    let expansion = expand(
        sources,
        &Request {
            file: file.to_str().unwrap().to_owned(),
            ..Request::default()
        },
    );
    let robot = Robot::of(&expansion).unwrap();
    let (model, files) = still(&session, &expansion, &robot);
    Scene::of(&model, &files, &session.vfs, content).unwrap()
}

fn shot(view: ViewDirection) -> Viewport {
    Viewport {
        view,
        size: [60, 40],
        background: WHITE,
    }
}

/// Pixels of a PNG file, row by row.
fn decoded(file: &[u8]) -> Vec<Vec<Vec<u8>>> {
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(file))
        .read_info()
        .unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    let row = |row: &[u8]| {
        row.chunks(info.color_type.samples())
            .map(<[u8]>::to_vec)
            .collect()
    };
    bytes.chunks(info.line_size).map(row).collect()
}

fn drawn(scene: &Scene, shot: &Viewport) -> Vec<Vec<Vec<u8>>> {
    decoded(&picture_png(scene, shot).unwrap())
}

/// Columns and rows in which there is something.
fn extent(pixels: &[Vec<Vec<u8>>]) -> ([usize; 2], [usize; 2]) {
    let mut found = pixels.iter().enumerate().flat_map(|(y, row)| {
        row.iter()
            .enumerate()
            .filter(|(_, pixel)| pixel.iter().any(|c| *c < 250))
            .map(move |(x, _)| (x, y))
    });
    let first = found.next().unwrap();
    found.fold(
        ([first.0; 2], [first.1; 2]),
        |([x0, x1], [y0, y1]), (x, y)| ([x0.min(x), x1.max(x)], [y0.min(y), y1.max(y)]),
    )
}

#[test]
fn a_box_fills_the_picture_up_to_the_margin() {
    let tree = Tree::new();
    let scene = scene(
        &tree,
        &chain(&[visual("<box size=\"1 2 1\"/>", "1 0 0 1")], ""),
        &SceneOptions::default(),
    );
    let pixels = drawn(&scene, &shot(ViewDirection::Front));
    let ([x0, x1], [y0, y1]) = extent(&pixels);
    // as wide as the picture without the margins, and half as high
    assert!(
        (3..=5).contains(&x0) && (55..=56).contains(&x1),
        "{x0} {x1}"
    );
    assert!((26..=28).contains(&(y1 + 1 - y0)), "{y0} {y1}");
    let [r, g, b] = pixels[20][30][..] else {
        panic!("no RGB")
    };
    assert!(r > 150 && g < 40 && b < 40, "{r} {g} {b}");
}

#[test]
fn what_is_nearer_hides_what_is_farther() {
    let small = body(
        "visual",
        "<box size=\"0.5 1 1\"/>",
        "<origin xyz=\"1 0 0\"/><material name=\"m\"><color rgba=\"0 1 0 1\"/></material>",
    );
    let tree = Tree::new();
    let robot = chain(
        &[format!(
            "{}{small}",
            visual("<box size=\"1 2 1\"/>", "1 0 0 1")
        )],
        "",
    );
    let scene = scene(&tree, &robot, &SceneOptions::default());
    let front = drawn(&scene, &shot(ViewDirection::Front));
    assert!(
        front[20][30][1] > 120 && front[20][30][0] < 60,
        "{:?}",
        front[20][30]
    );
    assert!(
        front[20][8][0] > 120 && front[20][8][1] < 60,
        "{:?}",
        front[20][8]
    );
}

#[test]
fn joints_move_links_and_mimic_follows() {
    let sphere = || visual("<sphere radius=\"0.1\"/>", "0 0 1 1");
    let links = [sphere(), sphere(), sphere()];
    let mut robot = chain(
        &links,
        "type=\"revolute\"><limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"1\"/>",
    );
    robot = robot.replace(
        "<child link=\"l2\"/>",
        "<child link=\"l2\"/><mimic joint=\"j1\" multiplier=\"-1\"/>",
    );
    let tree = Tree::new();
    let half_pi = std::f64::consts::FRAC_PI_2;
    let content = SceneOptions {
        positions: [("j1".to_owned(), half_pi)].into_iter().collect(),
        ..SceneOptions::default()
    };
    let at = |scene: &Scene| -> Vec<[f64; 3]> {
        scene
            .frames
            .iter()
            .map(|f| <[f64; 3]>::from(f.at.translation.vector).map(|n| n.round()))
            .collect()
    };
    assert_eq!(
        at(&scene(&tree, &robot, &SceneOptions::default())),
        [[0., 0., 0.], [1., 0., 0.], [2., 0., 0.]]
    );
    let moved = scene(&tree, &robot, &content);
    assert_eq!(at(&moved), [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]]);
    let turned = moved.frames[2].at.rotation.angle();
    assert!(turned < 1e-9, "the second joint turns back: {turned}");
}

#[test]
fn a_joint_rests_where_its_limits_let_it() {
    let robot = chain(
        &[String::new(), String::new()],
        "type=\"prismatic\"><limit lower=\"0.25\" upper=\"1\" effort=\"1\" velocity=\"1\"/>",
    );
    let scene = scene(&Tree::new(), &robot, &SceneOptions::default());
    assert!((scene.frames[1].at.translation.z - 0.25).abs() < 1e-12);
}

#[test]
fn links_in_a_circle_and_alone_are_placed() {
    let robot = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\
        <joint name=\"ab\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\
        <joint name=\"ba\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint></robot>";
    let scene = scene(&Tree::new(), robot, &SceneOptions::default());
    assert_eq!(scene.frames.len(), 3);
    // frames are drawn when there is nothing else
    assert!(!scene.skeleton.is_empty());
    assert!(
        !extent(&drawn(&scene, &shot(ViewDirection::Iso)))
            .0
            .is_empty()
    );
}

#[test]
fn a_mesh_that_is_missing_is_a_magenta_box() {
    let tree = Tree::new();
    let robot = chain(
        &[visual(
            "<mesh filename=\"package://bot/gone.stl\"/>",
            "0 1 0 1",
        )],
        "",
    );
    let scene = scene(&tree, &robot, &SceneOptions::default());
    assert_eq!(scene.problems.len(), 1);
    let problem = &scene.problems[0];
    assert!(
        problem.starts_with("link `l0`: mesh `package://bot/gone.stl`: ")
            && problem.ends_with("not found")
    );
    let pixel = &drawn(&scene, &shot(ViewDirection::Front))[20][30];
    assert!(
        pixel[0] > 150 && pixel[1] < 40 && pixel[2] > 150,
        "{pixel:?}"
    );
    let size = model::Bounds::around(scene.points().copied())
        .unwrap()
        .size();
    assert!(size.iter().all(|side| (side - 0.1).abs() < 1e-12));
}

#[test]
fn meshes_are_drawn_scaled_and_placed() {
    let tree = Tree::new();
    tree.write(
        "bot/a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    );
    let robot = chain(
        &[body(
            "visual",
            "<mesh filename=\"package://bot/a.obj\" scale=\"2 3 -4\"/>",
            "<origin xyz=\"0 0 1\"/>",
        )],
        "",
    );
    let scene = scene(&tree, &robot, &SceneOptions::default());
    assert_eq!(scene.problems, Vec::<String>::new());
    let bounds = model::Bounds::around(scene.points().copied()).unwrap();
    assert_eq!(
        (bounds.min, bounds.max),
        ([0.0, 0.0, -3.0], [2.0, 3.0, 1.0])
    );
}

#[test]
fn collisions_instead_of_visuals() {
    let both = format!(
        "{}{}",
        visual("<sphere radius=\"1\"/>", "1 0 0 1"),
        body("collision", "<cylinder radius=\"1\" length=\"4\"/>", "")
    );
    let content = SceneOptions {
        collisions: true,
        ..SceneOptions::default()
    };
    let scene = scene(&Tree::new(), &chain(&[both], ""), &content);
    let size = model::Bounds::around(scene.points().copied())
        .unwrap()
        .size();
    assert_eq!((scene.parts.len(), size[2]), (1, 4.0));
}

#[test]
fn pictures_are_the_same_each_time_and_may_be_transparent() {
    let tree = Tree::new();
    let robot = chain(
        &[
            visual("<sphere radius=\"1\"/>", "1 0 0 1"),
            visual("<box size=\"1 1 1\"/>", "0 0 1 0.5"),
        ],
        "type=\"fixed\">",
    );
    let scene = scene(&tree, &robot, &SceneOptions::default());
    let shot = Viewport {
        background: Background::Transparent,
        ..shot(ViewDirection::Iso)
    };
    let first = picture_png(&scene, &shot).unwrap();
    assert_eq!(first, picture_png(&scene, &shot).unwrap());
    let pixels = decoded(&first);
    assert_eq!(pixels[0][0], [0, 0, 0, 0]);
    let alphas = || pixels.iter().flatten().map(|pixel| pixel[3]);
    assert!(
        alphas().any(|alpha| alpha == 255) && alphas().any(|alpha| (120..136).contains(&alpha))
    );
}

#[test]
fn round_shapes_are_light_and_edges_sharp() {
    let tree = Tree::new();
    let scene = scene(
        &tree,
        &chain(
            &[visual("<cylinder radius=\"1\" length=\"1\"/>", "1 1 1 1")],
            "",
        ),
        &SceneOptions::default(),
    );
    let normals = super::normals::normals(&scene.parts[0].solid);
    let caps = normals
        .iter()
        .flatten()
        .filter(|normal| normal.z.abs() > 0.999)
        .count();
    let sides = normals
        .iter()
        .flatten()
        .filter(|normal| normal.z.abs() < 1e-9)
        .count();
    assert_eq!((caps, sides), (2 * 64 * 3, 2 * 64 * 3));
    // a point at the rim: its directions are those of the cap and of the side, not between
    let [a, b, c] = normals[0];
    assert!((a - b).norm() > 0.01 && (a.norm() - 1.0).abs() < 1e-12 && c.z == 0.0);
}

#[test]
fn outlines_frames_and_names_in_svg() {
    let tree = Tree::new();
    let robot = chain(
        &[
            visual("<box size=\"1 1 1\"/>", "1 0 0 1"),
            String::new(),
            String::new(),
        ],
        "type=\"fixed\">",
    );
    let robot = robot.replace("name=\"bot\"", "name=\"a &lt; b\"");
    let scene = scene(&tree, &robot, &SceneOptions::default());
    let svg = picture_svg(
        &scene,
        "a < b",
        &Viewport {
            size: [400, 300],
            ..shot(ViewDirection::Iso)
        },
    );
    let document = roxmltree::Document::parse(&svg).unwrap();
    let count = |name: &str| {
        document
            .descendants()
            .filter(|node| node.tag_name().name() == name)
            .count()
    };
    // a box is seen as six corners; two lines between frames, three axes each; the title of the robot and of lines
    assert_eq!(
        (count("path"), count("line"), count("text"), count("title")),
        (1, 2 + 9, 3, 3)
    );
    let path = document
        .descendants()
        .find_map(|node| node.attribute("d"))
        .unwrap();
    assert_eq!(path.matches('L').count(), 5, "{path}");
    let names: Vec<_> = document
        .descendants()
        .filter(|n| n.tag_name().name() == "text")
        .map(|n| n.text().unwrap())
        .collect();
    assert!(
        ["l0", "l1", "l2"].iter().all(|name| names.contains(name)),
        "{names:?}"
    );
}

#[test]
fn names_do_not_lie_over_each_other() {
    let tree = Tree::new();
    let links: Vec<String> = vec![String::new(); 12];
    let robot = chain(&links, "type=\"fixed\">").replace("xyz=\"1 0 0\"", "xyz=\"0.2 0 0.1\"");
    let scene = scene(&tree, &robot, &SceneOptions::default());
    let svg = picture_svg(
        &scene,
        "bot",
        &Viewport {
            size: [600, 400],
            ..shot(ViewDirection::Top)
        },
    );
    let document = roxmltree::Document::parse(&svg).unwrap();
    let texts = document
        .descendants()
        .filter(|node| node.tag_name().name() == "text");
    let at = |node: &roxmltree::Node<'_, '_>, name: &str| -> f64 {
        node.attribute(name).unwrap().parse().unwrap()
    };
    let places: Vec<_> = texts
        .map(|node| {
            (
                at(&node, "x"),
                at(&node, "y"),
                node.text().unwrap().len() as f64 * 6.5,
            )
        })
        .collect();
    assert_eq!(places.len(), 12);
    for (i, (x, y, long)) in places.iter().enumerate() {
        for (u, v, _) in &places[..i] {
            assert!(
                (y - v).abs() >= 13.0 || u + long <= *x || x + long <= *u,
                "{x} {y} {u} {v}"
            );
        }
    }
}

#[test]
fn what_would_take_too_long_is_refused() {
    let tree = Tree::new();
    // a heap of large triangles in front of each other
    let mesh = format!("v 0 -1 -1\nv 0 1 -1\nv 0 0 1\n{}", "f 1 2 3\n".repeat(6000));
    tree.write("bot/heap.obj", &mesh);
    let scene = scene(
        &tree,
        &chain(
            &[visual(
                "<mesh filename=\"package://bot/heap.obj\"/>",
                "1 1 1 1",
            )],
            "",
        ),
        &SceneOptions::default(),
    );
    let large = Viewport {
        size: [2000, 2000],
        ..shot(ViewDirection::Front)
    };
    assert!(
        picture_png(&scene, &large)
            .unwrap_err()
            .contains("choose a smaller size")
    );
    assert!(picture_png(&scene, &shot(ViewDirection::Front)).is_ok());
}

#[test]
fn colors_of_meshes_count() {
    let tree = Tree::new();
    tree.write(
        "bot/two.mtl",
        "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nd 0.5\n",
    );
    let points = "v 0 -2 -1\nv 0 0 -1\nv 0 0 1\nv 0 -2 1\nv 0 2 -1\nv 0 2 1\n";
    let faces = "mtllib two.mtl\nusemtl red\nf 1 2 3 4\nusemtl green\nf 2 5 6 3\n";
    tree.write("bot/two.obj", &format!("{points}{faces}"));
    let robot = chain(
        &[visual(
            "<mesh filename=\"package://bot/two.obj\"/>",
            "0 0 1 1",
        )],
        "",
    );
    let scene = scene(&tree, &robot, &SceneOptions::default());
    let pixels = drawn(&scene, &shot(ViewDirection::Front));
    let (left, right) = (&pixels[20][15], &pixels[20][45]);
    assert!(left[0] > 150 && left[1] < 60 && left[2] < 60, "{left:?}");
    assert!(
        right[1] > 150 && (60..220).contains(&right[0]),
        "half of it is the background: {right:?}"
    );
}

#[test]
fn backgrounds() {
    assert_eq!(
        Background::of("#fa0"),
        Some(Background::Solid([0xff, 0xaa, 0]))
    );
    assert_eq!(
        Background::of("#0f1020"),
        Some(Background::Solid([0x0f, 0x10, 0x20]))
    );
    assert_eq!(Background::of("transparent"), Some(Background::Transparent));
    assert!(
        ["", "#", "#ffff", "#ggg", "grey", "ffffff", "#ffé"]
            .iter()
            .all(|text| Background::of(text).is_none())
    );
    assert!(MOST_PIXELS < u64::from(u32::MAX));
}

#[test]
fn a_capsule_is_a_cylinder_with_half_spheres() {
    let capsule = visual("<capsule radius=\"1\" length=\"3\"/>", "1 1 1 1");
    let drawn = scene(
        &Tree::new(),
        &chain(&[capsule], ""),
        &SceneOptions::default(),
    );
    assert_eq!(drawn.problems, [""; 0]);
    let bounds = model::Bounds::around(drawn.points().copied()).unwrap();
    assert_eq!(bounds.size(), [2.0, 2.0, 5.0]);
    let points = &drawn.parts[0].solid.points;
    let off = |[x, y, z]: &[f64; 3]| (x.hypot(*y).hypot((z.abs() - 1.5).max(0.0)) - 1.0).abs();
    assert!(points.iter().all(|point| off(point) < 1e-12));
    // the straight part is there, and all sides look outwards
    let rims = [-1.5, 1.5].map(|z| {
        points
            .iter()
            .filter(|point| (point[2] - z).abs() < 1e-12)
            .count()
    });
    assert_eq!(rims, [64, 64]);
    let solid = &drawn.parts[0].solid;
    let volume: f64 = solid
        .triangles
        .iter()
        .map(|&triangle| signed(solid.corners(triangle)))
        .sum();
    let exact = std::f64::consts::PI * (3.0 + 4.0 / 3.0);
    assert!((volume / exact - 1.0).abs() < 0.01, "{volume} {exact}");
}

/// The volume between a triangle and the origin.
fn signed([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(nalgebra::Vector3::from);
    a.dot(&b.cross(&c)) / 6.0
}

#[test]
fn a_quaternion_turns_like_the_angles() {
    let links = |version: &str, origin: &str| {
        format!(
            "<robot name=\"bot\" {version}><link name=\"a\"><visual><origin xyz=\"1 2 3\" {origin}/><geometry>\
             <capsule radius=\"1\" length=\"3\"/></geometry></visual></link></robot>"
        )
    };
    let points = |text: &str| -> Vec<[f64; 3]> {
        scene(&Tree::new(), text, &SceneOptions::default())
            .points()
            .copied()
            .collect()
    };
    let turned = points(&links("version=\"1.1\"", "quat_xyzw=\"1 1 0 2\""));
    let angles =
        nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(2.0, 1.0, 1.0, 0.0));
    let (roll, pitch, yaw) = angles.euler_angles();
    let expected = points(&links("", &format!("rpy=\"{roll} {pitch} {yaw}\"")));
    let near = |(a, b): (&[f64; 3], &[f64; 3])| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(turned.len() == expected.len() && turned.iter().zip(&expected).all(near));
    assert_ne!(points(&links("", "quat_xyzw=\"1 1 0 2\"")), turned);
}
