//! The programs that read URDF.
use packages::nearest;

/// A program or library that reads URDF.
#[derive(Debug)]
pub struct Consumer {
    /// What the command line and the configuration call it.
    pub name: &'static str,
    /// What people call it.
    pub title: &'static str,
    /// Other names of it, and of what reads robots through it.
    pub aliases: &'static [&'static str],
    /// What the table says was found with.
    pub measured: &'static str,
    /// The consumer of the table that it reads like, when it is not measured itself.
    like: Option<&'static str>,
}

const fn consumer(
    name: &'static str,
    title: &'static str,
    aliases: &'static [&'static str],
    measured: &'static str,
) -> Consumer {
    Consumer {
        name,
        title,
        aliases,
        measured,
        like: None,
    }
}

/// The consumers, in the order in which they are shown.
pub static CONSUMERS: &[Consumer] = &[
    consumer(
        "urdfdom",
        "urdfdom",
        &["ros", "rviz"],
        "urdfdom 6.0.0, `check_urdf`",
    ),
    consumer("urdfdom-3", "urdfdom 3", &[], "urdfdom 3.0.1"),
    consumer(
        "kdl",
        "KDL",
        &["kdl_parser", "robot_state_publisher"],
        "kdl_parser 1.14.2 with urdfdom 3.0.1",
    ),
    Consumer {
        like: Some("urdfdom"),
        ..consumer(
            "moveit",
            "MoveIt",
            &[],
            "not measured: it reads robots with urdfdom",
        )
    },
    consumer(
        "gazebo",
        "Gazebo",
        &["gz", "sdformat"],
        "libsdformat 12.3.0 with urdfdom 3.0.1",
    ),
    consumer(
        "mujoco",
        "MuJoCo",
        &[],
        "mujoco 4.0.0, `MjModel.from_xml_path`",
    ),
    consumer(
        "drake",
        "Drake",
        &[],
        "drake 1.51.1, `Parser.AddModels` with a scene graph",
    ),
    consumer(
        "pinocchio",
        "Pinocchio",
        &["pin"],
        "pin 4.1.0, `buildModelFromUrdf` and `buildGeomFromUrdf`",
    ),
    consumer(
        "pybullet",
        "PyBullet",
        &["bullet"],
        "pybullet 3.2.7, `loadURDF`",
    ),
    consumer("yourdfpy", "yourdfpy", &[], "yourdfpy 0.0.60, `URDF.load`"),
    consumer(
        "urchin",
        "urchin",
        &["urdfpy"],
        "urchin 0.0.30, `URDF.load`",
    ),
    consumer(
        "urdf_parser_py",
        "urdf_parser_py",
        &[],
        "urdf_parser_py 0.0.4, `URDF.from_xml_string`",
    ),
    consumer(
        "urdf-loader",
        "urdf-loader",
        &["three"],
        "urdf-loader 0.13.1 for three.js, without mesh files",
    ),
    consumer("urdf-rs", "urdf-rs", &["k"], "urdf-rs 0.10.0, `read_file`"),
    consumer(
        "isaac",
        "Isaac",
        &["usd", "urdf-usd-converter"],
        "urdf-usd-converter 0.3.4",
    ),
];

impl Consumer {
    /// The consumer of a name.
    pub fn named(name: &str) -> Option<&'static Self> {
        CONSUMERS
            .iter()
            .find(|consumer| consumer.name == name || consumer.aliases.contains(&name))
    }

    /// The name of a consumer that may be meant by one that is not known.
    pub fn nearest(name: &str) -> Option<&'static str> {
        nearest(name, CONSUMERS.iter().map(|consumer| consumer.name))
    }

    /// The name under which the table has it.
    pub(super) fn row_name(&self) -> &'static str {
        self.like.unwrap_or(self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::CONSUMERS;

    #[test]
    fn the_configuration_knows_the_same_names() {
        assert!(
            CONSUMERS
                .iter()
                .map(|consumer| &consumer.name)
                .eq(workspace::config::CONSUMERS)
        );
    }
}
