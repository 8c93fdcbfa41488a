-- `robot.urdf.xacro`, `robot.srdf.xacro` and the like all end in `.xacro`.
vim.filetype.add({
  extension = {
    xacro = 'xacro',
    urdf = 'urdf',
    srdf = 'urdf',
  },
  pattern = {
    -- templates that a build step fills in
    ['.*%.urdf%.xacro%.in'] = 'xacro',
    ['.*%.urdf%.in'] = 'urdf',
  },
})
