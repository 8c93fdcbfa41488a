//! A large robot: one macro, and many calls of it.

/// The text of a robot with so many calls; each gives a link and a joint in four lines.
pub fn robot(calls: usize) -> String {
    let mut text = String::from(
        "<robot name=\"bench\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">
  <xacro:property name=\"base_mass\" value=\"2.5\"/>
  <xacro:macro name=\"seg\" params=\"name parent radius:=0.1 *origin\">
    <link name=\"${name}\">
      <inertial>
        <mass value=\"${base_mass * radius}\"/>
        <inertia ixx=\"${base_mass * radius ** 2}\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/>
      </inertial>
    </link>
    <joint name=\"${name}_joint\" type=\"revolute\">
      <parent link=\"${parent}\"/>
      <child link=\"${name}\"/>
      <xacro:insert_block name=\"origin\"/>
      <axis xyz=\"0 0 1\"/>
      <limit lower=\"${-pi}\" upper=\"${pi}\" effort=\"10\" velocity=\"1\"/>
    </joint>
  </xacro:macro>
  <link name=\"s0\"/>\n",
    );
    for n in 1..=calls {
        text.push_str(&format!(
            "  <xacro:property name=\"r_{n}\" value=\"${{0.1 + {n} / 1e5}}\"/>
  <xacro:seg name=\"s{n}\" parent=\"s{}\" radius=\"${{r_{n}}}\">
    <origin xyz=\"0.1 0 ${{r_{n} * 2}}\"/>
  </xacro:seg>\n",
            n - 1
        ));
    }
    text.push_str("</robot>\n");
    text
}
