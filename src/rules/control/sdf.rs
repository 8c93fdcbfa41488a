//! What Gazebo reads in a `<gazebo>` element: the settings of URDF for it, and the elements of SDF that may stand there.
//!
//! Source: the descriptions of SDF 1.0 to 1.12 in `sdformat`, and its `parser_urdf.cc`.

use packages::edit_distance;

/// Settings that the URDF has for Gazebo.
pub(super) const SETTINGS: &str = "canonicalBody cfmDamping dampingFactor disableFixedJointLumping fdir1 fudgeFactor implicitSpringDamper kd kp laserRetro \
    material maxContacts maxVel minDepth mu1 mu2 preserveFixedJoint provideFeedback selfCollide springReference \
    springStiffness static stopCfm stopErp turnGravityOff";

/// Elements of SDF that are copied into a link or a joint.
pub(super) const COPIED: &str = "audio_sink audio_source axis axis2 battery collision damping enable_wind frame gravity inertial kinematic light \
    must_be_base_link origin particle_emitter physics plugin pose projector self_collide sensor velocity_decay visual";

/// The elements of a sensor: each with what may stand in it, in any version of SDF. Elements that are not listed hold no others, or
/// what others read.
const OF_SENSORS: &[(&str, &str)] = &[
    ("accel", "bias_mean bias_stddev mean stddev"),
    ("air_pressure", "pressure reference_altitude"),
    ("air_speed", "pressure"),
    ("altimeter", "vertical_position vertical_velocity"),
    ("angular_velocity", "x y z"),
    (
        "camera",
        "box_type camera_info_topic clip depth_camera distortion frame horizontal_fov image lens noise optical_frame_id pose save \
         segmentation_type trigger_topic triggered visibility_mask",
    ),
    ("clip", "far near"),
    ("contact", "collision topic"),
    ("custom_function", "c1 c2 c3 f fun"),
    ("depth_camera", "clip output"),
    ("distortion", "center k1 k2 k3 p1 p2"),
    ("force", "x y z"),
    ("force_torque", "force frame measure_direction torque"),
    ("gps", "position_sensing velocity_sensing"),
    ("horizontal", "max_angle min_angle noise resolution samples"),
    ("image", "anti_aliasing format height width"),
    (
        "imu",
        "angular_velocity enable_orientation linear_acceleration noise orientation_reference_frame topic",
    ),
    ("intrinsics", "cx cy fx fy s"),
    (
        "lens",
        "custom_function cutoff_angle env_texture_size intrinsics projection scale_to_hfov type",
    ),
    ("lidar", "noise range scan visibility_mask"),
    ("linear_acceleration", "x y z"),
    ("logical_camera", "aspect_ratio far horizontal_fov near"),
    ("magnetometer", "x y z"),
    ("navsat", "position_sensing velocity_sensing"),
    (
        "noise",
        "accel bias_mean bias_stddev dynamic_bias_correlation_time dynamic_bias_stddev mean precision rate stddev type",
    ),
    (
        "orientation_reference_frame",
        "custom_rpy grav_dir_x localization",
    ),
    ("position_sensing", "horizontal vertical"),
    ("pressure", "noise"),
    ("projection", "p_cx p_cy p_fx p_fy tx ty"),
    ("range", "max min resolution"),
    ("rate", "bias_mean bias_stddev mean stddev"),
    ("ray", "noise range scan visibility_mask"),
    ("scan", "horizontal vertical"),
    // Gazebo reads the names of frames, which SDF has only from 1.12 on
    (
        "sensor",
        "air_pressure air_speed altimeter always_on camera contact enable_metrics force_torque frame frame_id gps gz_frame_id \
         ignition_frame_id imu lidar logical_camera magnetometer navsat origin plugin pose ray rfid rfidtag sonar topic transceiver \
         update_rate visualize",
    ),
    ("sonar", "geometry max min radius"),
    ("torque", "x y z"),
    (
        "transceiver",
        "essid frequency gain max_frequency min_frequency power sensitivity",
    ),
    ("velocity_sensing", "horizontal vertical"),
    ("vertical", "max_angle min_angle noise resolution samples"),
    ("vertical_position", "noise"),
    ("vertical_velocity", "noise"),
    ("x", "noise"),
    ("y", "noise"),
    ("z", "noise"),
];

/// What may stand in an element of a sensor; none where that is the business of others.
pub(super) fn children_of(element: &str) -> Option<impl Iterator<Item = &'static str> + Clone> {
    let found = OF_SENSORS.binary_search_by_key(&element, |(name, _)| name);
    let (_, children) = OF_SENSORS.get(found.ok()?)?;
    Some(children.split_whitespace())
}

/// Whether a list of words has one.
pub(super) fn has(words: &str, word: &str) -> bool {
    words.split_whitespace().any(|own| own == word)
}

/// Whether an element of a sensor may stand in another one.
pub(super) fn may_hold(element: &str, name: &str) -> bool {
    children_of(element).is_some_and(|mut children| children.any(|child| child == name))
}

/// The element in which a sensor of a type has what is special of it.
pub(super) fn element_of(kind: &str) -> Option<&'static str> {
    let is = |part: &str| kind.contains(part);
    if is("logical") {
        Some("logical_camera")
    } else if is("camera") || is("depth") || is("rgbd") {
        Some("camera")
    } else {
        let kind = kind.strip_prefix("gpu_").unwrap_or(kind);
        children_of("sensor")?.find(|name| *name == kind && children_of(name).is_some())
    }
}

/// The name that is meant by one with other capitals, with or without `_`, or with one letter wrong.
pub(super) fn near(name: &str, known: &'static str) -> Option<&'static str> {
    let folded = |name: &str| name.to_lowercase().replace('_', "");
    let own = folded(name);
    if own.len() > LONGEST {
        return None;
    }
    let known = known.split_whitespace();
    let distances = known.map(|name| (edit_distance(&own, &folded(name)), name));
    let (distance, best) = distances.min_by_key(|(distance, _)| *distance)?;
    let is_near = distance == 0 || distance == 1 && name.len().max(best.len()) > 2;
    is_near.then_some(best)
}

/// No name that somebody meant has as many letters.
const LONGEST: usize = 40;

/// The materials of Gazebo Classic that are meant for robots, after `Gazebo/`.
///
/// Source: `gazebo.material` of Gazebo 2 to 11.
pub(super) const MATERIALS: &str = "Black BlackTransparent Blue BlueGlow BlueLaser BlueTransparent BlueTransparentOverlay Bricks BuildingFrame CeilingTiled \
    CloudySky CoM DarkGrey DarkMagentaTransparent DarkOrangeTransparentOverlay DarkYellow Editor EditorPlane FlatBlack \
    Footway Gold Grass Gray Green GreenGlow GreenTransparent GreenTransparentOverlay Grey GreyGradientSky GreyTransparent \
    Indigo JointAnchor Lane_1 Lanes_2 Lanes_4 Lanes_6 LightBlueLaser LightOff LightOn Motorway Orange OrangeTransparent \
    OrangeTransparentOverlay PaintedWall Pedestrian Pioneer2Body PioneerBody PointCloud Primary Purple PurpleGlow Red \
    RedBright RedGlow RedTransparent RedTransparentOverlay Residential Road Runway Secondary SkyBlue Steps Tertiary Trunk \
    Turquoise TurquoiseGlow TurquoiseGlowOutline White WhiteGlow WindowFrame Wood WoodFloor WoodPallet Yellow YellowGlow \
    YellowTransparent ZincYellow";

#[cfg(test)]
mod tests {
    use super::{MATERIALS, OF_SENSORS, SETTINGS, children_of, element_of, near};

    #[test]
    fn tables_are_sorted() {
        assert!(OF_SENSORS.is_sorted_by_key(|(name, _)| name));
        assert!(MATERIALS.split_whitespace().is_sorted());
    }

    #[test]
    fn near_names() {
        let table = [
            (SETTINGS, "min_depth", Some("minDepth")),
            (SETTINGS, "fdirl", Some("fdir1")),
            (SETTINGS, "stopKp", None),
            (SETTINGS, "ks", None),
            (MATERIALS, "black", Some("Black")),
            (MATERIALS, "Turquiose", Some("Turquoise")),
            (MATERIALS, "DarkGray", Some("DarkGrey")),
            (MATERIALS, "Darkgreen", None),
            (MATERIALS, "LightWood", None),
        ];
        for (known, name, meant) in table {
            assert_eq!(near(name, known), meant, "{name}");
        }
    }

    #[test]
    fn elements_of_sensors() {
        let table = [
            ("gpu_lidar", Some("lidar")),
            ("ray", Some("ray")),
            ("rgbd_camera", Some("camera")),
            ("depth", Some("camera")),
            ("logical_camera", Some("logical_camera")),
            ("imu", Some("imu")),
            ("plugin", None),
            ("unheard_of", None),
        ];
        for (kind, element) in table {
            assert_eq!(element_of(kind), element, "{kind}");
        }
        assert!(children_of("plugin").is_none());
    }
}
