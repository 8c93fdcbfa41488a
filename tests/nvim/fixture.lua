--- The workspace of the tests: a camera on two motors, each motor made by a macro of another file.
local M = {}

M.robot = 'src/pan_tilt/urdf/pan_tilt.urdf.xacro'
M.unit = 'src/pan_tilt/urdf/unit.xacro'
M.desk = 'src/desk/urdf/desk.urdf.xacro'

local files = {
  [M.robot] = [[
<robot name="pan_tilt" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="mount" default="desk"/>
  <xacro:property name="m0" value="0.15"/>
  <xacro:property name="cam" value="${xacro.load_yaml('$(find pan_tilt)/config/cam.yaml')}"/>
  <xacro:include filename="unit.xacro"/>
  <link name="$(arg mount)"/>
  <xacro:unit name="pan" parent="$(arg mount)"><origin xyz="0 0 0.1"/></xacro:unit>
  <xacro:unit name="tilt" parent="pan_body" axis="0 1 0"><origin xyz="0 0 ${m0 / 3}"/></xacro:unit>
</robot>
]],
  [M.unit] = [[
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <!-- A motor with its bracket. -->
  <xacro:macro name="unit" params="name parent axis:='0 0 1' *at">
    <link name="${name}_body">
      <inertial>
        <mass value="${m0 * 2}"/>
        <inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/>
      </inertial>
    </link>
    <joint name="${name}" type="revolute">
      <xacro:insert_block name="at"/>
      <parent link="${parent}"/>
      <child link="${name}_body"/>
      <axis xyz="${axis}"/>
      <limit lower="-1.57" upper="1.57" effort="3" velocity="2"/>
    </joint>
  </xacro:macro>
</robot>
]],
  [M.desk] = [[
<robot name="desk" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="m0" value="1"/>
  <xacro:include filename="$(find pan_tilt)/urdf/unit.xacro"/>
  <link name="top"/>
  <xacro:unit name="lamp" parent="top"><origin xyz="0 0 0.4"/></xacro:unit>
</robot>
]],
  ['src/pan_tilt/config/cam.yaml'] = 'fov: 1.2\nmass: {head: 0.4}\n',
  ['src/.git/HEAD'] = '',
}

local function manifest(name, depends)
  return ([[
<package format="3"><name>%s</name><version>1.0.0</version><description>-</description>
<maintainer email="a@b.c">a</maintainer><license>MIT</license>%s</package>
]]):format(name, depends)
end

files['src/pan_tilt/package.xml'] = manifest('pan_tilt', '<exec_depend>xacro</exec_depend>')
files['src/desk/package.xml'] = manifest('desk', '<exec_depend>xacro</exec_depend><exec_depend>pan_tilt</exec_depend>')

---@param path string
---@param text string
function M.write(path, text)
  vim.fn.mkdir(vim.fs.dirname(path), 'p')
  local file = assert(io.open(path, 'wb'))
  file:write(text)
  file:close()
end

--- Make the workspace again.
---@param folder string
function M.make(folder)
  for name, text in pairs(files) do
    M.write(folder .. '/' .. name, text)
  end
end

return M
