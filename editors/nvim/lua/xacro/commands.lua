--- The commands of the user.
local M = {}

---@return string[]
local function files(lead)
  return vim.fn.getcompletion(lead, 'file')
end

---@return string[]
local function arguments(lead)
  return require('xacro.roots').complete(lead)
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
  end, { bang = true, desc = 'Show the expanded robot next to the source; with ! close it' })
  command('XacroDiff', function(call)
    require('xacro.diff').open(call.args)
  end, { nargs = '?', desc = 'Diff of the expanded robot: saved files or a git revision versus the current text' })
  command('XacroExpandAt', function(call)
    require('xacro.expand_at').open(call.count)
  end, { count = 0, desc = 'Expand the element under the cursor; a count selects the call' })
  command('XacroRoot', function(call)
    require('xacro.roots').root(call.args, call.bang)
  end, { bang = true, nargs = '?', complete = files, desc = 'Select the robot for this file; with ! automatic' })
  command(
    'XacroArgs',
    function(call)
      require('xacro.roots').args(call.fargs, call.bang)
    end,
    { bang = true, nargs = '*', complete = arguments, desc = 'Set arguments of the robot, name:=value; with ! reset' }
  )
  command('XacroInstance', function(call)
    require('xacro.roots').instance(call.bang)
  end, { bang = true, desc = 'Select the macro call for values; with ! all calls' })
  command('XacroPreview', function(call)
    require('xacro.preview').open(call.bang)
  end, { bang = true, desc = 'Show the robot in the browser; with ! print only the URL' })
  command('XacroTree', function()
    require('xacro.tree').open()
  end, { desc = 'Show links, joints and masses of the robot' })
  command('XacroExplain', function(call)
    require('xacro.explain').open(call.args)
  end, { nargs = '?', desc = 'Explain a rule; without a name, that of the diagnostic at the cursor' })
  command('XacroRestart', function()
    require('xacro.start').restart()
  end, { desc = 'Stop the server and start it again' })
  vim.api.nvim_set_hl(0, 'XacroPlace', { link = 'Visual', default = true })
  vim.api.nvim_set_hl(0, 'XacroTitle', { link = 'Title', default = true })
  vim.api.nvim_set_hl(0, 'XacroBanner', { link = 'DiagnosticError', default = true })
end

return M
