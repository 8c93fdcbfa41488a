--- The commands of the user.
local M = {}

--- Names and values of arguments, for the command line.
---@return string[]
local function files(lead)
  return vim.fn.getcompletion(lead, 'file')
end

function M.define()
  local function command(name, run, options)
    vim.api.nvim_create_user_command(name, run, options)
  end
  command('XacroExpand', function(call)
    if call.bang then
      require('xacro.expand').close()
    else
      require('xacro.expand').open()
    end
  end, { bang = true, desc = 'Expanded robot beside the source; with ! close it' })
  command('XacroDiff', function(call)
    require('xacro.diff').open(call.args)
  end, { nargs = '?', desc = 'What the changes make of the robot, against the files on the disk or a git revision' })
  command('XacroExpandAt', function(call)
    require('xacro.expand_at').open(call.count)
  end, { count = 0, desc = 'What stands under the cursor, expanded; a count picks the call' })
  command('XacroRoot', function(call)
    require('xacro.roots').root(call.args, call.bang)
  end, { bang = true, nargs = '?', complete = files, desc = 'Pick the robot of this file; with ! automatic' })
  command('XacroArgs', function(call)
    require('xacro.roots').args(call.fargs, call.bang)
  end, { bang = true, nargs = '*', desc = 'Set arguments of the robot, name:=value; with ! reset' })
  command('XacroInstance', function(call)
    require('xacro.roots').instance(call.bang)
  end, { bang = true, desc = 'Look at this macro as one of its calls; with ! as all' })
  command('XacroPreview', function(call)
    require('xacro.preview').open(call.bang)
  end, { bang = true, desc = 'Robot in the browser; with ! only say its address' })
  command('XacroTree', function()
    require('xacro.tree').open()
  end, { desc = 'Links, joints and masses of the robot' })
  vim.api.nvim_set_hl(0, 'XacroPlace', { link = 'Visual', default = true })
  vim.api.nvim_set_hl(0, 'XacroTitle', { link = 'Title', default = true })
  vim.api.nvim_set_hl(0, 'XacroBanner', { link = 'DiagnosticError', default = true })
end

return M
