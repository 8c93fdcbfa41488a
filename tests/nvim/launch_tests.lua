--- Launch files that call the robot with arguments, and the configuration.
local fixture = require('fixture')

local LAUNCH = 'src/pan_tilt/launch/camera.launch.py'
local OLD = 'src/pan_tilt/launch/camera.launch'
local CONFIG = 'xacro-lint.toml'

local PYTHON = [[
from launch.substitutions import Command
from launch_ros.substitutions import FindPackageShare

path = [FindPackageShare('pan_tilt'), '/urdf/pan_tilt.urdf.xacro']
robot = Command(['xacro ', *path, ' mount:=wall'])
other = Command(['xacro ', *path, ' '])
]]

local XML = [[
<launch>
  <param name="d" command="$(find xacro)/xacro $(find pan_tilt)/urdf/pan_tilt.urdf.xacro mount:=pole"/>
</launch>
]]

local TOML = [==[
[[roots]]
file = "src/pan_tilt/urdf/pan_tilt.urdf.xacro"
args = {  }
]==]

--- Put the launch files and the configuration into the workspace.
local function bring(child)
  fixture.write(child.folder .. '/' .. LAUNCH, PYTHON)
  fixture.write(child.folder .. '/' .. OLD, XML)
end

--- The text of the floating window, once it holds a word. What opens before Neovim has noticed that the cursor was put there is
--- closed by that: it is asked for again, as a person would.
local function hover(child, word)
  child:lua('_G.asked = nil')
  return child:wait(
    [[(function(word)
      for _, window in ipairs(vim.api.nvim_list_wins()) do
        if vim.api.nvim_win_get_config(window).relative ~= '' then
          local lines = vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false)
          local text = table.concat(lines, '\n')
          return text:find(word, 1, true) and text
        end
      end
      local now = vim.uv.now()
      if now - (_G.asked or -1000) >= 1000 then
        _G.asked = now
        vim.lsp.buf.hover()
      end
    end)(...)]],
    word
  )
end

--- The words that the completion at the cursor offers, after keys in insert mode.
local function offered(child, keys)
  child:lua([[vim.o.completeopt = 'menuone']])
  child:type(keys .. '<C-x><C-o>')
  child:wait('vim.fn.pumvisible() == 1')
  local words = child:value([[vim.tbl_map(function(item) return item.abbr ~= '' and item.abbr or item.word end,
      vim.fn.complete_info({ 'items' }).items)]])
  child:type('<C-y>')
  child:wait('vim.fn.pumvisible() == 0')
  child:type('<Esc>')
  child:wait([[vim.api.nvim_get_mode().mode == 'n']])
  return words
end

return function(test)
  test('hover on an argument names the launch files that give it', function(child)
    bring(child)
    child:edit(fixture.robot)
    child:at('<xacro:arg name="mo|unt"')
    local text = hover(child, 'camera.launch.py')
    assert(text:find('wall', 1, true) and text:find('pole', 1, true), text)
  end)

  test('calls of launch files are picked as robots', function(child)
    bring(child)
    child:edit(fixture.robot)
    child:lua([[vim.ui.select = function(items, options, on_choice)
      _G.offered = vim.tbl_map(options.format_item, items)
      for number, text in ipairs(_G.offered) do
        if text:find('camera.launch.py', 1, true) then return on_choice(items[number], number) end
      end
    end]])
    child:type(':XacroRoot<CR>')
    child:wait([[require('xacro.status').text(0):find('mount:=wall', 1, true)]])
    local shown = table.concat(child:value('_G.offered'), '\n')
    assert(shown:find('camera.launch) mount:=pole', 1, true), shown)
    child:at('<link name="$(arg mo|unt)"/>')
    hover(child, 'wall')
  end)

  test('an argument leads from a launch file to the robot, and back', function(child)
    bring(child)
    for _, file in ipairs({ LAUNCH, OLD }) do
      child:edit(file)
      child:at(file == LAUNCH and "' mo|unt:=wall'" or 'mo|unt:=pole')
      hover(child, 'desk')
      child:lua('vim.lsp.buf.definition()')
      child:wait([[vim.api.nvim_buf_get_name(0):find('pan_tilt.urdf.xacro', 1, true)]])
      local place = child:value('vim.api.nvim_win_get_cursor(0)')
      assert(place[1] == 2 and place[2] == 19, vim.inspect(place))
    end
    child:at('<xacro:arg name="mo|unt"')
    child:lua('vim.lsp.buf.references()')
    local places = child:wait([[(function()
      local names = vim.tbl_map(function(item)
        return vim.fs.basename(vim.api.nvim_buf_get_name(item.bufnr))
      end, vim.fn.getqflist())
      return #names > 0 and names
    end)()]])
    local shown = table.concat(places, ' ')
    assert(shown:find('camera.launch.py', 1, true) and shown:find('camera.launch ', 1, true), shown)
  end)

  test('an argument is renamed in launch files', function(child)
    bring(child)
    child:edit(OLD)
    child:edit(LAUNCH)
    child:edit(fixture.robot)
    child:at('<xacro:arg name="mo|unt"')
    child:lua([[vim.lsp.buf.rename('holder')]])
    child:wait([[vim.api.nvim_buf_get_lines(0, 1, 2, false)[1]:find('name="holder"', 1, true)]])
    child:edit(LAUNCH)
    assert(child:text():find("' holder:=wall'", 1, true), child:text())
    -- and from there, once the server was told of the edits in all buffers
    child:wait([[(function()
      local robot = vim.fn.bufnr('pan_tilt.urdf.xacro')
      local params = { textDocument = { uri = vim.uri_from_bufnr(robot) } }
      local _, answer = next(vim.lsp.buf_request_sync(robot, 'xacro/roots', params, 5000) or {})
      local known = vim.tbl_filter(function(root)
        return (root.args or {}).holder ~= nil
      end, answer.result.candidates)
      return #known == 2
    end)()]])
    child:at("' hol|der:=wall'")
    child:lua([[vim.lsp.buf.rename('place')]])
    child:wait([[vim.api.nvim_buf_get_lines(0, 4, 5, false)[1]:find('place:=wall', 1, true)]])
    child:edit(OLD)
    assert(child:text():find('place:=pole', 1, true), child:text())
  end)

  test('arguments are completed in launch files', function(child)
    bring(child)
    child:edit(LAUNCH)
    child:at("*path, ' |'])")
    local words = offered(child, 'i')
    assert(vim.tbl_contains(words, 'mount'), vim.inspect(words))
    assert(child:text():find("*path, ' mount:='])", 1, true), child:text())
    -- who gives an argument that does not exist is told
    child:change("' mount:=wall'", "' mont:=wall'")
    child:wait([[(vim.diagnostic.get(0)[1] or {}).code == 'unknown-launch-argument']])
    child:edit(OLD)
    child:at('mount:=pole|"')
    words = offered(child, 'i ')
    assert(vim.tbl_contains(words, 'mount'), vim.inspect(words))
  end)

  test('keys and arguments are completed in the configuration', function(child)
    bring(child)
    fixture.write(child.folder .. '/' .. CONFIG, TOML)
    child:edit(CONFIG)
    child:at('args = { | }')
    local words = offered(child, 'i')
    assert(vim.deep_equal(words, { 'mount' }), vim.inspect(words))
    assert(child:text():find('args = { mount =  }', 1, true), child:text())
    child:at('args = { mount = | }')
    words = offered(child, 'i')
    assert(vim.tbl_contains(words, 'wall') and vim.tbl_contains(words, 'pole'), vim.inspect(words))
    child:at('fi|le =')
    hover(child, 'root files')
  end)

  test('other files are left alone, and gq formats as before', function(child)
    bring(child)
    child:edit(LAUNCH)
    assert(child:value('vim.bo.formatexpr') == '', child:value('vim.bo.formatexpr'))
    assert(
      child:value(
        [[#vim.lsp.buf_request_sync(0, 'textDocument/formatting',
      { textDocument = vim.lsp.util.make_text_document_params(), options = { tabSize = 2, insertSpaces = true } }, 5000)]]
      ) == 1
    )
    for name, text in pairs({
      ['tool.py'] = 'print("xacro")\n',
      ['launch/nodes.launch.py'] = 'x = 1\n',
      ['a.toml'] = '',
    }) do
      fixture.write(child.folder .. '/' .. name, text)
      child:lua('vim.cmd.edit(vim.fn.fnameescape(...))', child.folder .. '/' .. name)
      child:wait([[vim.bo.filetype ~= '']])
      assert(child:value([[#vim.lsp.get_clients({ bufnr = 0 })]]) == 0, name)
    end
  end)
end
