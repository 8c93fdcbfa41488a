--- Files beside a robot: its SRDF, its controllers and its settings for MoveIt, in the arm of the examples.
local ARM = 'pick_arm/src/pick_arm_description/urdf/arm_macro.xacro'
local SRDF = 'pick_arm/src/pick_arm_moveit_config/config/pick_arm.srdf'
local CONTROLLERS = 'pick_arm/src/pick_arm_bringup/config/controllers.yaml'
local LIMITS = 'pick_arm/src/pick_arm_moveit_config/config/joint_limits.yaml'
local repository = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h:h')

local FINDINGS = [[#vim.diagnostic.get(0, { severity = { min = vim.diagnostic.severity.WARN } })]]

--- Put the workspace of the arm into the folder of the test.
local function bring(child)
  local from = repository .. '/docs/examples/pick_arm'
  for name in vim.fs.dir(from, { depth = 10 }) do
    if vim.fn.isdirectory(from .. '/' .. name) == 0 then
      local to = child.folder .. '/pick_arm/' .. name
      vim.fn.mkdir(vim.fs.dirname(to), 'p')
      assert(vim.uv.fs_copyfile(from .. '/' .. name, to))
    end
  end
  vim.fn.mkdir(child.folder .. '/pick_arm/.git', 'p')
end

return function(test)
  test('names in an SRDF and in YAML are checked while typing', function(child)
    bring(child)
    for _, case in ipairs({
      { SRDF, 'tip_link="left_tool"', 'tip_link="left_tol"' },
      { CONTROLLERS, '- left_elbow', '- left_elbw' },
      { LIMITS, 'left_elbow:', 'left_elbw:' },
    }) do
      local file, good, bad = unpack(case)
      child:edit(file)
      child:change(good, bad)
      child:wait(FINDINGS .. ' == 1')
      child:change(bad, good)
      child:wait(FINDINGS .. ' == 0')
    end
  end)

  test('a joint of a macro is renamed in all files', function(child)
    bring(child)
    child:edit(SRDF)
    child:edit(CONTROLLERS)
    child:edit(ARM)
    child:at('name="${prefix}wr|ist"')
    child:lua([[vim.lsp.buf.rename('roll')]])
    for _, file in ipairs({
      'arm_macro.xacro',
      'control_macro.xacro',
      'config/controllers.yaml',
      'joint_limits.yaml',
      'moveit_controllers.yaml',
      'pick_arm.srdf',
    }) do
      child:wait(
        [[(function(file)
        local bufnr = vim.fn.bufnr(file)
        local text = bufnr > 0 and table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) or ''
        return text:find('roll', 1, true)
      end)(...)]],
        file
      )
    end
    child:lua([[vim.cmd('silent wall')]])
    for _, file in ipairs({ SRDF, CONTROLLERS, LIMITS, ARM }) do
      child:edit(file)
      child:wait(FINDINGS .. ' == 0')
    end
    -- that is no silence of a server that says nothing
    child:edit(SRDF)
    child:change('left_roll', 'left_wrist')
    child:wait(FINDINGS .. ' > 0')
    child:change('left_wrist', 'left_roll')
    child:wait(FINDINGS .. ' == 0')
  end)

  test('YAML without names of a robot is left alone', function(child)
    bring(child)
    child:edit(ARM)
    local file = child.folder .. '/pick_arm/notes.yaml'
    assert(vim.fn.writefile({ 'a: 1' }, file) == 0)
    child:lua('vim.cmd.edit(vim.fn.fnameescape(...))', file)
    child:wait([[vim.bo.filetype == 'yaml']])
    assert(child:value([[#vim.lsp.get_clients({ bufnr = 0 })]]) == 0)
  end)
end
