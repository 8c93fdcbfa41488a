-- `robot.urdf.xacro`, `robot.srdf.xacro` and the like all end in `.xacro`.
vim.filetype.add({
  extension = {
    xacro = 'xacro',
    urdf = 'urdf',
    srdf = 'urdf',
  },
  filename = {
    -- which files MoveIt's setup assistant works on
    ['.setup_assistant'] = 'yaml',
  },
  pattern = {
    -- in letters of any case, as some CAD exporters write them
    ['.*%.[xX][aA][cC][rR][oO]'] = 'xacro',
    ['.*%.[uU][rR][dD][fF]'] = 'urdf',
    -- templates that a build step fills in
    ['.*%.urdf%.xacro%.in'] = 'xacro',
    ['.*%.urdf%.in'] = 'urdf',
    -- launch files of ROS 1, unless another plugin knows them
    ['.*%.launch'] = { 'xml', { priority = -1 } },
  },
})
