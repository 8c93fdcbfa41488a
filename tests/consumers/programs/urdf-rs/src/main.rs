//! What `urdf-rs` makes of a robot, as JSON.

use serde_json::{Map, Value, json};

fn main() {
    let path = std::env::args().nth(1).expect("a file");
    let robot = match urdf_rs::read_file(path) {
        Ok(robot) => robot,
        Err(error) => {
            eprintln!("{error}");
            std::process::exit(1);
        }
    };
    let links: Map<String, Value> =
        robot.links.iter().map(|link| (link.name.clone(), json!(link.inertial.mass.value))).collect();
    let joints: Map<String, Value> = robot
        .joints
        .iter()
        .map(|joint| {
            let kind = format!("{:?}", joint.joint_type).to_lowercase();
            (joint.name.clone(), json!([kind, joint.limit.lower, joint.limit.upper]))
        })
        .collect();
    let bodies: usize = robot.links.iter().map(|link| link.visual.len() + link.collision.len()).sum();
    println!("{}", json!({"links": links, "joints": joints, "bodies": bodies}));
}
