//! What a text says of the programs that it runs, by the words in it.

/// What the words of a text say together, as bits.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
pub(super) struct TextWords(u32);

/// Something needs masses and inertia: a simulator, or a library for dynamics.
const MASSES: u32 = 1;
/// The same, unless there is a model in the format of the simulator.
const MASSES_UNLESS_OWN: u32 = 1 << 1;
/// Something computes with every triangle of a collision mesh. Bullet, MuJoCo and Isaac take the convex hull of it.
const TRIANGLES: u32 = 1 << 2;
/// Something simulates, plans or controls.
const SIMULATES: u32 = 1 << 3;
/// A simulator that refuses a robot with a tensor that no body has: Gazebo Sim, MuJoCo, Drake. Gazebo Classic takes it.
const REFUSES: u32 = 1 << 4;
/// A model for MuJoCo or Isaac, which they read instead of a description.
const OWN_MODEL: u32 = 1 << 5;
/// Something starts controllers by their names.
const STARTS: u32 = 1 << 6;
/// Something spawns in Gazebo: a file of SDF, or a description that is a parameter or a topic.
const SPAWNS: u32 = 1 << 7;
const SDF: u32 = 1 << 8;
const DESCRIPTION: u32 = 1 << 12;
/// The one file of SDF that is a model and no world.
const MODEL: u32 = 1 << 13;
/// An element for Gazebo, and a part of it that only Gazebo runs.
const GAZEBO_TAG: u32 = 1 << 9;
const GAZEBO_PART: u32 = 1 << 10;
/// A program builds the configuration of MoveIt.
const BUILDS_MOVEIT: u32 = 1 << 11;
/// Something runs controllers, which read transmissions and hardware.
const CONTROLS: u32 = 1 << 14;
/// Something starts Gazebo Classic.
const CLASSIC: u32 = 1 << 15;
/// Only the exporter of SolidWorks writes this, into the launch file for Gazebo beside each robot.
const EXPORTED: u32 = 1 << 16;
/// Something may publish the states of joints, or place links that move.
const STATES: u32 = 1 << 17;
/// Something other than Gazebo moves joints: another simulator, a planner, controllers.
const MOVES: u32 = 1 << 18;
/// Something navigates, or reads a sensor of a real robot.
const NAVIGATES: u32 = 1 << 19;
/// Something runs Gazebo, of any generation.
const GAZEBO: u32 = 1 << 20;

/// The words, also as parts of others, and what each of them says.
const WORDS: [(&str, u32); 74] = [
    ("gazebo", MASSES | TRIANGLES | SIMULATES | GAZEBO),
    ("gazebo_ros", CLASSIC),
    ("gzserver", CLASSIC),
    ("ros_gz", MASSES | TRIANGLES | SIMULATES | REFUSES | GAZEBO),
    ("ros_gz_sim", SPAWNS),
    ("ros_ign", MASSES | TRIANGLES | SIMULATES | REFUSES | GAZEBO),
    ("gz_sim", MASSES | TRIANGLES | REFUSES | GAZEBO),
    ("gz sim", MASSES | GAZEBO),
    ("gz-sim", REFUSES),
    ("gz_ros2_control", REFUSES),
    ("ign_ros2_control", REFUSES),
    ("ignition", REFUSES),
    ("spawn_model", MASSES | SPAWNS),
    ("spawn_entity", MASSES | SPAWNS),
    ("spawn_urdf", MASSES),
    ("-sdf", SDF | MODEL),
    ("model.sdf", MODEL),
    ("-param", DESCRIPTION),
    ("-string", DESCRIPTION),
    ("-topic", DESCRIPTION),
    ("-urdf", DESCRIPTION),
    (".sdf", SDF),
    ("webots", MASSES | TRIANGLES | SIMULATES | MOVES),
    ("coppelia", MASSES | TRIANGLES),
    ("vrep", MASSES | TRIANGLES),
    ("bullet", MASSES),
    ("pybullet", SIMULATES | MOVES),
    ("drake", MASSES | REFUSES),
    ("raisim", MASSES),
    ("genesis", MASSES),
    ("warp.sim", MASSES),
    ("wp.sim", MASSES),
    ("sapien", MASSES),
    ("dartsim", MASSES),
    ("pinocchio", MASSES),
    ("RigidBody", MASSES),
    ("rbdl", MASSES),
    ("RBDL", MASSES),
    ("dynamics", MASSES),
    ("Dynamics", MASSES),
    ("mujoco", MASSES_UNLESS_OWN | SIMULATES | REFUSES | MOVES),
    ("isaac", MASSES_UNLESS_OWN | SIMULATES | MOVES),
    ("<worldbody", OWN_MODEL),
    (".usd", OWN_MODEL),
    ("moveit", TRIANGLES | SIMULATES | MOVES),
    ("MoveItConfigs", BUILDS_MOVEIT),
    ("fcl", TRIANGLES),
    ("hpp-", TRIANGLES),
    ("controller_manager", SIMULATES | CONTROLS | MOVES),
    ("hardware_interface::", CONTROLS),
    ("ros_control", CONTROLS),
    ("transmission_interface", CONTROLS),
    // launch files of MoveIt that run a controller manager
    ("generate_demo_launch", CONTROLS),
    ("generate_spawn_controllers_launch", CONTROLS),
    ("spawner", STARTS),
    ("load_controller", STARTS),
    ("switch_controller", STARTS),
    ("<gazebo", GAZEBO_TAG),
    ("fake_joint_calibration", EXPORTED),
    ("<plugin", GAZEBO_PART),
    ("<sensor", GAZEBO_PART),
    ("joint_state", STATES),
    ("joint-state", STATES),
    ("JointState", STATES),
    ("amcl", NAVIGATES),
    ("cartographer", NAVIGATES),
    ("ldlidar", NAVIGATES),
    ("move_base", NAVIGATES),
    ("nav2_", NAVIGATES),
    ("rplidar", NAVIGATES),
    ("slam_toolbox", NAVIGATES),
    ("ydlidar", NAVIGATES),
    // drives of Gazebo that place wheels by themselves
    ("publish_wheel_tf", STATES),
    ("publishWheelTF", STATES),
];

impl TextWords {
    /// The words of a text.
    pub fn of(text: &str) -> Self {
        Self::among(text, u32::MAX)
    }

    /// Whether a text runs something that simulates, plans or controls: its other words are not looked for.
    pub fn is_about_simulation(text: &str) -> bool {
        Self::among(text, SIMULATES).simulates()
    }

    /// What the words of a text say of these bits. A word that says nothing new is not looked for.
    fn among(text: &str, bits: u32) -> Self {
        let add = |all: u32, &(word, says): &(&str, u32)| {
            if says & bits & !all != 0 && text.contains(word) {
                all | says & bits
            } else {
                all
            }
        };
        Self(WORDS.iter().fold(0, add))
    }

    const fn has(self, bits: u32) -> bool {
        self.0 & bits == bits
    }

    /// Whether a text runs something that needs masses and inertia, whatever else there is.
    pub const fn weighs(self) -> bool {
        self.has(MASSES)
    }

    /// Whether a text runs something that needs masses and inertia where it has no model of its own.
    pub const fn weighs_unless_own(self) -> bool {
        self.has(MASSES_UNLESS_OWN)
    }

    /// Whether a text runs something that computes with the triangles of collision meshes.
    pub const fn meets(self) -> bool {
        self.has(TRIANGLES)
    }

    /// Whether a text runs controllers, or is hardware for them.
    pub const fn controls(self) -> bool {
        self.has(CONTROLS)
    }

    /// Whether a text runs something that simulates, plans or controls.
    pub const fn simulates(self) -> bool {
        self.has(SIMULATES)
    }

    /// Whether a text runs something that navigates, or reads a sensor of a real robot.
    pub const fn navigates(self) -> bool {
        self.has(NAVIGATES)
    }

    /// Whether a text runs a simulator that refuses a tensor that no body has, or is for one.
    pub const fn refuses(self) -> bool {
        self.has(REFUSES)
    }

    /// Whether a text runs Gazebo.
    pub const fn runs_gazebo(self) -> bool {
        self.has(GAZEBO)
    }

    /// Whether a text starts Gazebo Classic.
    pub const fn runs_classic(self) -> bool {
        self.has(CLASSIC)
    }

    /// Whether a text is a model for MuJoCo, or loads one for Isaac.
    pub const fn is_own_model(self) -> bool {
        self.has(OWN_MODEL)
    }

    /// Whether a text is the launch file for Gazebo that the exporter of SolidWorks writes.
    pub const fn is_exported(self) -> bool {
        self.has(EXPORTED)
    }

    /// Whether a text starts controllers by their names.
    pub const fn starts_controllers(self) -> bool {
        self.has(STARTS)
    }

    /// Whether a launch file spawns a model of SDF in Gazebo.
    pub const fn spawns_model(self) -> bool {
        self.has(SPAWNS | SDF)
    }

    /// Whether all that a launch file spawns in Gazebo is a model of SDF.
    pub const fn spawns_only_models(self) -> bool {
        self.has(SPAWNS | MODEL) && !self.has(DESCRIPTION)
    }

    /// Whether a description has something that only Gazebo runs.
    pub const fn is_for_gazebo(self) -> bool {
        self.has(GAZEBO_TAG | GAZEBO_PART)
    }

    /// Whether a text may publish the states of joints.
    pub const fn publishes_states(self) -> bool {
        self.has(STATES)
    }

    /// Whether a text has the states of joints published, or runs what may do so and is not Gazebo.
    pub const fn may_move_joints(self) -> bool {
        self.0 & (STATES | CONTROLS | BUILDS_MOVEIT | MOVES) != 0
    }

    /// Whether a program builds the configuration of MoveIt from the names of packages.
    pub const fn builds_moveit(self) -> bool {
        self.has(BUILDS_MOVEIT)
    }
}
