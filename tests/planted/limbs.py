"""Legs, a turret and a lift: macros called by macros, property scope, transmissions, a URDF without xacro."""
from parts import HEAD, INERTIALS, MATERIALS, XACRO, box_mesh, fill, inertial, package


def legs(name, sides, control):
    """A leg macro that calls a limb macro; properties in global and parent scope; one ros2_control block per leg."""
    pkg = name + '_description'
    leg = HEAD + fill('''<robot @xacro@>
  <xacro:include filename="$(find @pkg@)/urdf/inertials.xacro"/>
  <xacro:property name="thigh_length" value="0.21"/>
  <xacro:property name="shin_length" value="0.20"/>

  <xacro:macro name="limb" params="name parent length mass lower upper *origin axis:='0 1 0' color:=^|chalk">
    <xacro:property name="width" value="${length / 6}"/>
    <link name="${name}">
      <visual>
        <origin xyz="0 0 ${-length / 2}" rpy="0 0 0"/>
        <geometry>
          <box size="${width} ${width} ${length}"/>
        </geometry>
        <material name="${color}"/>
      </visual>
      <collision>
        <origin xyz="0 0 ${-length / 2}" rpy="0 0 0"/>
        <geometry>
          <box size="${width} ${width} ${length}"/>
        </geometry>
      </collision>
      <xacro:box_inertial mass="${mass}" x="${width}" y="${width}" z="${length}">
        <origin xyz="0 0 ${-length / 2}" rpy="0 0 0"/>
      </xacro:box_inertial>
    </link>
    <joint name="${name}_joint" type="revolute">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${name}"/>
      <axis xyz="${axis}"/>
      <limit lower="${lower}" upper="${upper}" effort="33.5" velocity="21"/>
    </joint>
  </xacro:macro>

  <xacro:macro name="leg" params="side front left">
    <xacro:property name="x" value="${(1 if front else -1) * body_length / 2}"/>
    <xacro:property name="y" value="${(1 if left else -1) * body_width / 2}"/>
    <xacro:property name="color" value="slate"/>
    <xacro:limb name="${side}_hip" parent="trunk" length="0.09" mass="0.5" lower="-0.8" upper="0.8" axis="1 0 0">
      <origin xyz="${x} ${y} 0" rpy="0 0 0"/>
    </xacro:limb>
    <xacro:limb name="${side}_thigh" parent="${side}_hip" length="${thigh_length}" mass="1.0" lower="-1.0" upper="2.4">
      <origin xyz="0 0 -0.09" rpy="0 0 0"/>
    </xacro:limb>
    <xacro:limb name="${side}_shin" parent="${side}_thigh" length="${shin_length}" mass="0.3" lower="-2.6" upper="-0.5">
      <origin xyz="0 0 ${-thigh_length}" rpy="0 0 0"/>
    </xacro:limb>
    <link name="${side}_foot">
      <visual>
        <geometry>
          <sphere radius="0.02"/>
        </geometry>
      </visual>
      <collision>
        <geometry>
          <sphere radius="0.02"/>
        </geometry>
      </collision>
      <xacro:sphere_inertial mass="0.06" radius="0.02"/>
    </link>
    <joint name="${side}_foot_joint" type="fixed">
      <origin xyz="0 0 ${-shin_length}" rpy="0 0 0"/>
      <parent link="${side}_shin"/>
      <child link="${side}_foot"/>
    </joint>
@control@  </xacro:macro>
</robot>
''', xacro=XACRO, pkg=pkg, control='''    <ros2_control name="${side}_leg" type="system">
      <hardware>
        <plugin>mock_components/GenericSystem</plugin>
      </hardware>
      <joint name="${side}_thigh_joint">
        <command_interface name="effort"/>
        <state_interface name="position"/>
      </joint>
      <joint name="${side}_shin_joint">
        <command_interface name="effort"/>
        <state_interface name="position"/>
      </joint>
    </ros2_control>
''' if control else '')
    calls = ''.join('  <xacro:leg side="%s" front="%s" left="%s"/>\n' % (side, 'front' in side, 'left' in side) for side in sides)
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:arg name="body_mass" default="6.5"/>
  <xacro:property name="body_length" value="0.36"/>
  <xacro:property name="body_width" value="0.2"/>
  <xacro:include filename="$(find @pkg@)/urdf/materials.xacro"/>
  <xacro:include filename="leg.xacro"/>

  <link name="base_link"/>
  <joint name="trunk_joint" type="fixed">
    <origin xyz="0 0 0" rpy="0 0 0"/>
    <parent link="base_link"/>
    <child link="trunk"/>
  </joint>
  <link name="trunk">
    <visual>
      <geometry>
        <mesh filename="package://@pkg@/meshes/trunk.stl"/>
      </geometry>
      <material name="amber"/>
    </visual>
    <collision>
      <geometry>
        <box size="${body_length} ${body_width} 0.1"/>
      </geometry>
    </collision>
    <xacro:box_inertial mass="$(arg body_mass)" x="${body_length}" y="${body_width}" z="0.1">
      <origin xyz="0 0 0" rpy="0 0 0"/>
    </xacro:box_inertial>
  </link>
@calls@</robot>
''', xacro=XACRO, name=name, pkg=pkg, calls=calls)
    files = package(pkg, folders=('meshes', 'urdf'))
    files.update({pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/urdf/leg.xacro': leg,
                  pkg + '/urdf/inertials.xacro': INERTIALS, pkg + '/urdf/materials.xacro': MATERIALS,
                  pkg + '/meshes/trunk.stl': box_mesh(0.36, 0.2, 0.1)})
    return files


def turret(name, axes, legacy):
    """Transmissions by a macro in a file of its own, Gazebo references, a camera with an optical frame."""
    pkg = name + '_description'
    extras = HEAD + fill('''<robot @xacro@>
  <xacro:macro name="motor" params="joint ratio:=100">
    <transmission name="${joint}_transmission">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${joint}">
        <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
      </joint>
      <actuator name="${joint}_motor">
        <hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface>
        <mechanicalReduction>${ratio}</mechanicalReduction>
      </actuator>
    </transmission>
  </xacro:macro>

  <xacro:macro name="tinted" params="link color">
    <gazebo reference="${link}">
      <material>Gazebo/${color}</material>
    </gazebo>
  </xacro:macro>
</robot>
''', xacro=XACRO)
    body, previous = '', 'base_link'
    for i, (axis, xyz) in enumerate(axes):
        body += fill('''
  <link name="@axis@">
    <visual>
      <origin xyz="0 0 ${stage_height / 2}" rpy="0 0 0"/>
      <geometry>
        <cylinder radius="${stage_radius - @i@ * 0.005}" length="${stage_height}"/>
      </geometry>
      <material name="@color@"/>
    </visual>
    <collision>
      <origin xyz="0 0 ${stage_height / 2}" rpy="0 0 0"/>
      <geometry>
        <cylinder radius="${stage_radius - @i@ * 0.005}" length="${stage_height}"/>
      </geometry>
    </collision>
    <xacro:cylinder_inertial mass="@mass@" radius="${stage_radius - @i@ * 0.005}" length="${stage_height}">
      <origin xyz="0 0 ${stage_height / 2}" rpy="0 0 0"/>
    </xacro:cylinder_inertial>
  </link>
  <joint name="@axis@_joint" type="revolute">
    <origin xyz="0 0 ${stage_height}" rpy="0 0 0"/>
    <parent link="@previous@"/>
    <child link="@axis@"/>
    <axis xyz="@xyz@"/>
    <limit lower="${radians(-70)}" upper="${radians(70)}" effort="8" velocity="${pi}"/>
    <safety_controller soft_lower_limit="${radians(-65)}" soft_upper_limit="${radians(65)}" k_position="20" k_velocity="10"/>
  </joint>
  <xacro:motor joint="@axis@_joint"/>
  <xacro:tinted link="@axis@" color="Grey"/>
''', axis=axis, xyz=xyz, i=i, previous=previous, mass=round(0.9 - 0.2 * i, 2), color=('slate', 'amber', 'chalk')[i % 3])
        previous = axis
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:arg name="camera" default="true"/>
  <xacro:property name="stage_height" value="0.08"/>
  <xacro:property name="stage_radius" value="0.05"/>
  <xacro:include filename="$(find @pkg@)/urdf/materials.xacro"/>
  <xacro:include filename="$(find @pkg@)/urdf/inertials.xacro"/>
  <xacro:include filename="$(find @pkg@)/urdf/extras.xacro"/>

  <link name="base_link">
    <visual>
      <origin xyz="0 0 ${stage_height / 2}" rpy="0 0 0"/>
      <geometry>
        <box size="0.14 0.14 ${stage_height}"/>
      </geometry>
      <material name="chalk"/>
    </visual>
    <collision>
      <origin xyz="0 0 ${stage_height / 2}" rpy="0 0 0"/>
      <geometry>
        <box size="0.14 0.14 ${stage_height}"/>
      </geometry>
    </collision>
  </link>
@body@
  <xacro:if value="$(arg camera)">
    <link name="camera_link"/>
    <joint name="camera_joint" type="fixed">
      <origin xyz="0.03 0 ${stage_height}" rpy="0 0 0"/>
      <parent link="@previous@"/>
      <child link="camera_link"/>
    </joint>
    <link name="camera_optical_frame"/>
    <joint name="camera_optical_joint" type="fixed">
      <origin xyz="0 0 0" rpy="${-pi / 2} 0 ${-pi / 2}"/>
      <parent link="camera_link"/>
      <child link="camera_optical_frame"/>
    </joint>
  </xacro:if>
</robot>
''', xacro=XACRO, name=name, pkg=pkg, body=body, previous=previous)
    if legacy:
        root = root.replace('<origin xyz="0 0 0" rpy="${-pi / 2} 0 ${-pi / 2}"/>',
                            '<origin xyz="0 0 0" rpy="-1.5707963 0 -1.5707963"/>')
    files = package(pkg, folders=('urdf',))
    files.update({pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/urdf/extras.xacro': extras,
                  pkg + '/urdf/inertials.xacro': INERTIALS, pkg + '/urdf/materials.xacro': MATERIALS})
    return files


def lift(name, stages, stroke):
    """Telescope in a plain URDF: prismatic joints, casters, a mast."""
    pkg = name + '_description'
    text = HEAD + '<robot name="%s">\n' % name
    previous = None
    for i, link in enumerate(['base_link'] + ['stage_%d' % (i + 1) for i in range(stages)] + ['platform']):
        x = round(0.3 - 0.04 * i, 3)
        shape = '<box size="%s %s 0.4"/>' % (x, x)
        body = ''.join('    <%s>\n      <origin xyz="0 0 0.0" rpy="0 0 0"/>\n      <geometry>\n        %s\n      </geometry>\n%s    </%s>\n'
                       % (part, shape, '      <material name="stage_%s">\n        <color rgba="0.4 0.4 0.%d 1"/>\n      </material>\n'
                          % (i, 4 + i) if part == 'visual' else '', part) for part in ('visual', 'collision'))
        text += '  <link name="%s">\n%s%s  </link>\n' % (link, inertial(round(9.0 - 1.5 * i, 2), x, x, 0.4) if i else '', body)
        if previous:
            kind = 'fixed' if link == 'platform' else 'prismatic'
            text += fill('''  <joint name="@link@_joint" type="@kind@">
    <origin xyz="0 0 0.05" rpy="0 0 0"/>
    <parent link="@previous@"/>
    <child link="@link@"/>
@moving@  </joint>
''', link=link, kind=kind, previous=previous, moving='' if kind == 'fixed' else
                         '    <axis xyz="0 0 1"/>\n    <limit lower="0.0" upper="%s" effort="900" velocity="0.05"/>\n'
                         '    <dynamics damping="5.0" friction="1.0"/>\n' % stroke)
        previous = link
    text += ('  <gazebo reference="platform">\n    <mu1>0.6</mu1>\n  </gazebo>\n  <transmission name="lift_transmission">\n'
             '    <type>transmission_interface/SimpleTransmission</type>\n    <joint name="stage_1_joint">\n'
             '      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>\n    </joint>\n'
             '    <actuator name="stage_1_motor">\n      <mechanicalReduction>20</mechanicalReduction>\n    </actuator>\n'
             '  </transmission>\n</robot>\n')
    files = package(pkg, folders=('urdf',))
    files[pkg + '/urdf/%s.urdf' % name] = text
    return files
