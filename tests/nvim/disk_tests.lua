--- Files besides the robot: unsaved, saved in the same Neovim, changed by a shell.
local fixture = require('fixture')

local CAM = 'src/pan_tilt/config/cam.yaml'
local ROBOT_FINDINGS = [[#vim.diagnostic.get(vim.fn.bufnr('pan_tilt.urdf.xacro'))]]

return function(test)
  test('unsaved text of a YAML file counts', function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', [[${cam['fov'] / 3}]])
    child:wait(ROBOT_FINDINGS .. ' == 0')
    child:lua('vim.cmd.split(...)', child.folder .. '/' .. CAM)
    child:change('fov:', 'field:')
    child:wait(ROBOT_FINDINGS .. ' > 0')
    assert(#child:value('vim.lsp.get_clients({ bufnr = 0 })') == 0, 'a YAML file has no client of ours')
    child:change('field:', 'fov:')
    child:wait(ROBOT_FINDINGS .. ' == 0')
    -- what was never saved is forgotten with its buffer
    child:change('fov:', 'field:')
    child:wait(ROBOT_FINDINGS .. ' > 0')
    child:lua('vim.cmd("bwipeout!")')
    child:wait(ROBOT_FINDINGS .. ' == 0')
  end)

  test('unsaved text of a manifest counts', function(child)
    child:edit(fixture.desk)
    child:wait(ROBOT_FINDINGS:gsub('pan_tilt.urdf', 'desk.urdf') .. ' == 0')
    child:lua('vim.cmd.split(...)', child.folder .. '/src/desk/package.xml')
    child:change('<exec_depend>pan_tilt</exec_depend>', '')
    child:wait([[(function()
      local found = vim.diagnostic.get(vim.fn.bufnr('desk.urdf.xacro'))
      return found[1] and found[1].code == 'missing-package-dependency'
    end)()]])
  end)

  test('what a shell did to the disk counts', function(child)
    child:edit(fixture.robot)
    child:wait(ROBOT_FINDINGS .. ' == 0')
    local unit = vim.fn.shellescape(child.folder .. '/' .. fixture.unit)
    child:lua('vim.cmd(...)', ('silent !mv %s %s.away'):format(unit, unit))
    child:wait(ROBOT_FINDINGS .. ' > 0')
    child:lua('vim.cmd(...)', ('silent !mv %s.away %s'):format(unit, unit))
    child:wait(ROBOT_FINDINGS .. ' == 0')
  end)
end
