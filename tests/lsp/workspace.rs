//! The workspace of the tests: a camera on two motors, each motor made by a macro of another file.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

pub const ROBOT: &str = "src/pan_tilt/urdf/pan_tilt.urdf.xacro";
pub const UNIT: &str = "src/pan_tilt/urdf/unit.xacro";

pub const ROBOT_TEXT: &str = r#"<robot name="pan_tilt" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="mount" default="desk"/>
  <xacro:property name="m0" value="0.15"/>
  <xacro:property name="cam" value="${xacro.load_yaml('$(find pan_tilt)/config/cam.yaml')}"/>
  <xacro:include filename="unit.xacro"/>
  <link name="$(arg mount)"/>
  <xacro:unit name="pan" parent="$(arg mount)"><origin xyz="0 0 0.1"/></xacro:unit>
  <xacro:unit name="tilt" parent="pan_body" axis="0 1 0"><origin xyz="0 0 ${m0 / 3}"/></xacro:unit>
</robot>
"#;

pub const UNIT_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- A motor with its bracket. -->
  <xacro:macro name="unit" params="name parent axis:='0 0 1' *at">
    <link name="${name}_body"><inertial><mass value="${m0 * 2}"/><inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial></link>
    <joint name="${name}" type="revolute">
      <xacro:insert_block name="at"/><parent link="${parent}"/><child link="${name}_body"/>
      <axis xyz="${axis}"/><limit lower="-1.57" upper="1.57" effort="3" velocity="2"/>
    </joint>
  </xacro:macro>
</robot>
"#;

const LENS_TEXT: &str = r#"<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="lens" params="prefix"><link name="${prefix}lens"/></xacro:macro>
</robot>
"#;

fn manifest(name: &str, depends: &str) -> String {
    format!(
        "<package format=\"3\"><name>{name}</name><version>1.0.0</version><description>-</description>\
         <maintainer email=\"a@b.c\">a</maintainer><license>MIT</license>{depends}</package>\n"
    )
}

/// A folder that is made again for each test.
pub fn fresh_folder() -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let number = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("lsp")
        .join(format!("{}-{number}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    // a repository of its own: nothing is read of folders above
    fs::create_dir_all(folder.join(".git")).unwrap();
    folder
}

pub fn write(folder: &Path, name: &str, text: impl AsRef<[u8]>) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// The workspace with the packages `pan_tilt` and `lens`.
pub fn pan_tilt() -> PathBuf {
    let folder = fresh_folder();
    write(&folder, ROBOT, ROBOT_TEXT);
    write(&folder, UNIT, UNIT_TEXT);
    write(
        &folder,
        "src/pan_tilt/config/cam.yaml",
        "fov: 1.2\nmass: {head: 0.4}\n",
    );
    write(
        &folder,
        "src/pan_tilt/package.xml",
        manifest("pan_tilt", "<exec_depend>xacro</exec_depend>"),
    );
    write(&folder, "src/lens/package.xml", manifest("lens", ""));
    write(&folder, "src/lens/urdf/lens.xacro", LENS_TEXT);
    folder
}
