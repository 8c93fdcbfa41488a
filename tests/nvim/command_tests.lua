--- The commands of the plugin.
local fixture = require('fixture')

local VIEW = [[require('xacro.expand').view()]]

--- Answer the next `vim.ui.select` with the item whose text holds a word.
local function answer_select(child, word)
  child:lua(
    [[_G.offered = {}
      local word = ...
      vim.ui.select = function(items, options, on_choice)
        for _, item in ipairs(items) do
          table.insert(_G.offered, options.format_item and options.format_item(item) or item)
        end
        for number, text in ipairs(_G.offered) do
          if text:find(word, 1, true) then return on_choice(items[number], number) end
        end
        on_choice(nil)
      end]],
    word
  )
end

--- Open the expanded text of the current file; its buffer.
local function expand(child)
  child:type(':XacroExpand<CR>')
  child:wait(VIEW .. ' and ' .. VIEW .. '.fresh')
  return child:value(VIEW .. '.bufnr')
end

--- The line of the cursor in the window that shows a buffer.
local function line_in(name)
  return ([[(function()
    for _, window in ipairs(vim.api.nvim_list_wins()) do
      local bufnr = vim.api.nvim_win_get_buf(window)
      if vim.api.nvim_buf_get_name(bufnr):find(%q, 1, true) then
        local row = vim.api.nvim_win_get_cursor(window)[1]
        return vim.api.nvim_buf_get_lines(bufnr, row - 1, row, false)[1]
      end
    end
    return ''
  end)()]]):format(name)
end

local winbar = [[vim.wo[vim.fn.win_findbuf(]] .. VIEW .. [[.bufnr)[1] ].winbar]]

return function(test, skip)
  test('XacroExpand shows the robot and follows edits', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    assert(child:text(bufnr):find('<link name="tilt_body">', 1, true), child:text(bufnr))
    assert(child:value('vim.api.nvim_buf_get_name(0)'):find('pan_tilt.urdf.xacro', 1, true), 'the cursor moved away')
    child:at('value="0.1|5"')
    child:type('r7')
    child:wait(
      [[table.concat(vim.api.nvim_buf_get_lines(..., 0, -1, false)):find('<mass value="0.34"/>', 1, true)]],
      bufnr
    )
    child:type(':XacroExpand!<CR>')
    child:wait('not ' .. VIEW)
    assert(child:value('#vim.api.nvim_list_wins()') == 1)
  end)

  test('a macro file is expanded as part of its robot', function(child)
    child:edit(fixture.unit)
    local bufnr = expand(child)
    assert(child:text(bufnr):find('<robot name="', 1, true), child:text(bufnr))
  end)

  test('the last good text stays while there is an error', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    local before = child:text(bufnr)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('not ' .. VIEW .. '.fresh')
    assert(child:text(bufnr) == before)
    local banner = child:value(winbar)
    assert(banner:find('last valid text', 1, true) and banner:find('m_0', 1, true), banner)
    child:change('${m_0 / 3}', '${m0 / 5}')
    child:wait(VIEW .. '.fresh')
    assert(child:text(bufnr):find('0 0 0.03"', 1, true), child:text(bufnr))
  end)

  test('the cursor of the source leads that of the expanded text', function(child)
    child:edit(fixture.robot)
    expand(child)
    child:at('<xacro:unit name="ti|lt"')
    child:wait(line_in('xacro-expanded:') .. [[:find('tilt', 1, true)]])
    child:at('<xacro:unit name="pa|n"')
    child:wait(line_in('xacro-expanded:') .. [[:find('"pan', 1, true)]])
    child:type('j')
    child:wait(line_in('xacro-expanded:') .. [[:find('tilt', 1, true)]])
    -- in front of the tag as well
    child:type('0k')
    child:wait(line_in('xacro-expanded:') .. [[:find('"pan', 1, true)]])
  end)

  test('all instances of a line in a macro are marked', function(child)
    child:edit(fixture.robot)
    expand(child)
    child:lua('vim.cmd.edit(...)', child.folder .. '/' .. fixture.unit)
    child:wait('#vim.lsp.get_clients({ bufnr = 0 }) > 0')
    child:at('<axi|s xyz')
    child:wait([[(function()
      local marks = vim.api.nvim_get_namespaces().xacro_instances
      return #vim.api.nvim_buf_get_extmarks(]] .. VIEW .. [[.bufnr, marks, 0, -1, {}) == 2
    end)()]])
    child:wait(line_in('xacro-expanded:') .. [[:find('<axis', 1, true)]])
  end)

  test('the cursor of the expanded text leads that of the source', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:type('/lower=<CR>')
    child:wait(line_in('unit.xacro') .. [[:find('<limit', 1, true)]])
    assert(child:value('vim.api.nvim_get_current_buf()') == bufnr, 'the focus moved')
    assert(child:value(winbar):find('unit.xacro:15 ← pan_tilt.urdf.xacro:7', 1, true), child:value(winbar))
    child:type('gg/name="tilt"<CR>2E')
    child:wait(line_in('unit.xacro') .. [[:find('type="revolute"', 1, true)]])
    child:type('gC')
    child:wait([[vim.api.nvim_buf_get_name(0):find('pan_tilt.urdf.xacro', 1, true)]])
    child:wait([[vim.api.nvim_get_current_line():find('name="tilt"', 1, true)]])
  end)

  test('Enter goes to the source', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:type('/<lt>axis<CR><CR>')
    child:wait([[vim.api.nvim_buf_get_name(0):find('unit.xacro', 1, true)]])
    child:wait([[vim.api.nvim_get_current_line():find('<axis', 1, true)]])
  end)

  -- The text of the floating window.
  local floating = [[(function()
    for _, window in ipairs(vim.api.nvim_list_wins()) do
      if vim.api.nvim_win_get_config(window).relative ~= '' then
        return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), '\n')
      end
    end
  end)()]]

  test('the expanded text says where it comes from, and has an outline', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:type('/lower=<CR>K')
    local said = child:wait(floating)
    local expected = {
      'unit.xacro:15',
      '    <limit lower="-1.57" upper="1.57" effort="3" velocity="2"/>',
      '← pan_tilt.urdf.xacro:7',
      '    <xacro:unit name="pan" parent="$(arg mount)"><origin xyz="0 0 0.1"/></xacro:unit>',
    }
    assert(vim.startswith(said, table.concat(expected, '\n')), said)
    child:type('gO')
    child:wait([[vim.bo.filetype == 'qf']])
    local listed = child:value([[vim.tbl_map(function(item) return item.text end, vim.fn.getloclist(0))]])
    local names = { 'link desk', 'link pan_body', 'joint pan', 'link tilt_body', 'joint tilt' }
    assert(vim.deep_equal(listed, names), vim.inspect(listed))
    child:type('/tilt_body<CR><CR>')
    child:wait([[vim.api.nvim_get_current_line():find('<link name="tilt_body"', 1, true)]])
    assert(child:value('vim.api.nvim_get_current_buf()') == bufnr)
  end)

  test('columns are right behind characters of other planes', function(child)
    child:edit(fixture.robot)
    child:change('<link name="$(arg mount)"/>', '<!-- 𝄞 é --><link name="a𝄞é_$(arg mount)"/>')
    child:change('parent="$(arg mount)"', 'parent="a𝄞é_$(arg mount)"')
    local bufnr = expand(child)
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:type('/_desk"\\/<CR>ll')
    child:wait(line_in('pan_tilt.urdf.xacro') .. [[:find('<!-- 𝄞', 1, true)]])
    local marked = child:wait([[(function()
      local bufnr = vim.fn.bufnr('pan_tilt.urdf.xacro')
      local marks = vim.api.nvim_get_namespaces().xacro_place
      local found = vim.api.nvim_buf_get_extmarks(bufnr, marks, 0, -1, { details = true })[1]
      return found and vim.api.nvim_buf_get_text(bufnr, found[2], found[3], found[2], found[4].end_col, {})[1]
    end)()]])
    assert(marked:find('mount', 1, true) or marked == 'desk', marked)
  end)

  -- The texts of the two windows that are compared, the earlier one first.
  local compared = [[(function()
    local texts = {}
    for _, window in ipairs(vim.api.nvim_tabpage_list_wins(0)) do
      if vim.wo[window].diff then
        local bufnr = vim.api.nvim_win_get_buf(window)
        texts[#texts + 1] = table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false), '\n')
      end
    end
    return #texts == 2 and texts
  end)()]]

  test('XacroDiff shows what unsaved changes make of the robot', function(child)
    child:edit(fixture.robot)
    child:change('value="0.15"', 'value="0.25"')
    child:type(':XacroDiff<CR>')
    local texts = child:wait(compared)
    assert(texts[1]:find('<mass value="0.3"/>', 1, true), texts[1])
    assert(texts[2]:find('<mass value="0.5"/>', 1, true), texts[2])
    child:type('q')
    child:wait('#vim.api.nvim_list_tabpages() == 1')
  end)

  test('XacroDiff compares with a revision of git', function(child)
    if vim.fn.executable('git') == 0 then
      skip('there is no git')
    end
    child:edit(fixture.unit)
    child:type(':XacroDiff HEAD<CR>')
    assert(child:wait('_G.said[1]'):find('not in a git repository', 1, true))
    -- the folder is a repository from here on
    local folder = child:value('vim.fs.dirname(vim.api.nvim_buf_get_name(0))')
    local function git(...)
      local run = vim.system({ 'git', '-C', folder, '-c', 'user.name=a', '-c', 'user.email=a@b.c', ... }):wait()
      assert(run.code == 0, run.stderr)
    end
    git('init', '--quiet')
    git('add', '.')
    git('commit', '--quiet', '--no-verify', '--message', 'first')
    child:change('${m0 * 2}', '${m0 * 4}')
    child:type(':write<CR>')
    child:type(':XacroDiff nothing<CR>')
    assert(child:wait('_G.said[2]'):find('unknown git revision `nothing`', 1, true))
    child:type(':XacroDiff HEAD<CR>')
    local texts = child:wait(compared)
    assert(texts[1]:find('<mass value="0.3"/>', 1, true), texts[1])
    assert(texts[2]:find('<mass value="0.6"/>', 1, true), texts[2])
  end)

  test('XacroExpandAt shows one call', function(child)
    child:edit(fixture.robot)
    child:at('<xacro:un|it name="pan"')
    child:type(':XacroExpandAt<CR>')
    local shown = child:wait([[(function()
      for _, message in ipairs(_G.said) do
        if message:find('xacro/expandAt') then return 'unknown' end
      end
      for _, window in ipairs(vim.api.nvim_list_wins()) do
        if vim.api.nvim_win_get_config(window).relative ~= '' then
          return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), '\n')
        end
      end
    end)()]])
    if shown == 'unknown' then
      skip('the server does not know `xacro/expandAt`, and the user was told so')
    end
    assert(shown:find('pan_body', 1, true) and not shown:find('tilt_body', 1, true), shown)
  end)

  test('XacroExpandAt of an empty value says so', function(child)
    child:edit(fixture.robot)
    child:change('<link name="$(arg mount)"/>', '<xacro:property name="no" value=""/><link name="desk${no}"/>')
    child:at('${n|o}')
    child:type(':XacroExpandAt<CR>')
    local said = child:wait('_G.said[1] or ' .. floating)
    assert(said == 'xacro: `${no}` expands to nothing', said)
    local messages = child:value([[vim.fn.execute('messages')]])
    assert(not messages:find('E%d+:') and not messages:find('Error', 1, true), messages)
  end)

  test('a finding is settled by an argument', function(child)
    child:edit(fixture.robot)
    child:change('<xacro:arg name="mount"', '<xacro:arg name="part" default="motor"/><xacro:arg name="mount"')
    child:change('filename="unit.xacro"', 'filename="$(arg part).xacro"')
    child:wait([[vim.iter(vim.diagnostic.get(0)):any(function(found) return found.code == 'include-not-found' end)]])
    child:lua([[
      _G.asked = {}
      vim.ui.select = function(items, options, on_choice)
        for _, item in ipairs(items) do
          local text = options.format_item and options.format_item(item) or item
          table.insert(_G.asked, text)
          if text:find('Set argument `part`', 1, true) or text == 'unit' then
            return on_choice(item)
          end
        end
      end
    ]])
    child:at('filename="$(arg| part)')
    child:lua('vim.lsp.buf.code_action()')
    child:wait([[require('xacro').status():find('part:=unit', 1, true)]])
    child:wait('#vim.diagnostic.get(0) == 0')
  end)

  test('a rule is configured from its finding', function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    local severity = [[(function()
      for _, found in ipairs(vim.diagnostic.get(vim.fn.bufnr('pan_tilt.urdf.xacro'))) do
        if found.code == 'undefined-property' then return found.severity end
      end
    end)()]]
    child:wait(severity .. ' == vim.diagnostic.severity.ERROR')
    child:at('${m|_0 / 3}')
    child:lua([[vim.lsp.buf.code_action({ apply = true, filter = function(action)
      return action.title == 'Configure `undefined-property` as warning for this project'
    end })]])
    child:wait([[vim.fn.bufnr('xacro-lint.toml') > 0]])
    child:wait(severity .. ' == vim.diagnostic.severity.WARN')
    local text = child:text(child:value([[vim.fn.bufnr('xacro-lint.toml')]]))
    assert(vim.startswith(text, '[severity]\nundefined-property = "warning"'), text)
  end)

  test('XacroRoot picks the robot of a macro file', function(child)
    child:edit(fixture.unit)
    -- the workspace has been looked through
    child:wait([[(function()
      local params = { textDocument = { uri = vim.uri_from_bufnr(0) } }
      for _, answer in pairs(vim.lsp.buf_request_sync(0, 'xacro/roots', params, 10000) or {}) do
        return answer.result and #answer.result.candidates == 2
      end
    end)()]])
    answer_select(child, 'desk.urdf.xacro')
    child:type(':XacroRoot<CR>')
    child:wait([[require('xacro').status() == 'desk.urdf.xacro']])
    assert(#child:value('_G.offered') == 3, vim.inspect(child:value('_G.offered')))
    local bufnr = expand(child)
    assert(child:text(bufnr):find('lamp_body', 1, true), child:text(bufnr))
    answer_select(child, 'pan_tilt.urdf.xacro')
    child:type(':XacroRoot<CR>')
    child:wait([[table.concat(vim.api.nvim_buf_get_lines(..., 0, -1, false)):find('tilt_body', 1, true)]], bufnr)
    child:type(':XacroRoot!<CR>')
    child:wait([[_G.said[3] ]])
  end)

  test('XacroArgs sets, asks for and resets arguments', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    local function text_with(word)
      child:wait(
        [[table.concat(vim.api.nvim_buf_get_lines(..., 0, -1, false)):find(select(2, ...), 1, true)]],
        bufnr,
        word
      )
    end
    child:type(':XacroArgs mount:=wall<CR>')
    text_with('<link name="wall"/>')
    child:wait([[require('xacro').status() == 'pan_tilt.urdf.xacro mount:=wall']])
    answer_select(child, 'mount')
    child:lua([[vim.ui.input = function(options, on_input) _G.asked = options; on_input('shelf') end]])
    child:type(':XacroArgs<CR>')
    text_with('<link name="shelf"/>')
    assert(child:value('_G.asked.default') == 'wall')
    child:type(':XacroArgs!<CR>')
    text_with('<link name="desk"/>')
    child:type(':XacroArgs mount=wall<CR>')
    child:wait([[_G.said[#_G.said]:find('name:=value', 1, true)]])
  end)

  test('the cursors keep together with arguments of the session', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    child:type(':XacroArgs mount:=a_much_longer_name<CR>')
    child:wait(
      [[table.concat(vim.api.nvim_buf_get_lines(..., 0, -1, false)):find('a_much_longer_name', 1, true)]],
      bufnr
    )
    child:at('<xacro:unit name="ti|lt"')
    child:wait(line_in('xacro-expanded:') .. [[:find('tilt', 1, true)]])
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:type('gg/longer<CR>')
    child:wait(line_in('pan_tilt.urdf.xacro') .. [[:find('mount', 1, true)]])
  end)

  test('arguments hold for all files of the robot, and for the next session', function(child)
    local mount = [[(function()
      local params = { textDocument = { uri = vim.uri_from_bufnr(0) } }
      for _, answer in pairs(vim.lsp.buf_request_sync(0, 'xacro/roots', params, 10000) or {}) do
        return vim.tbl_get(answer, 'result', 'active', 'args', 'mount')
      end
    end)() == 'wall']]
    child:edit(fixture.robot)
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    child:type(':XacroArgs mount:=wall<CR>')
    child:wait(mount)
    child:edit(fixture.unit)
    child:wait(mount)
    -- a server that is started again knows nothing of it
    child:lua([[
      for _, client in ipairs(vim.lsp.get_clients()) do
        vim.lsp.stop_client(client.id, true)
      end
    ]])
    child:wait([[#vim.lsp.get_clients() == 0]])
    child:type(':%bwipeout!<CR>')
    child:edit(fixture.robot)
    child:wait(mount)
    child:type(':XacroRoot!<CR>')
    child:wait('not (' .. mount .. ')')
  end)

  test('XacroArgs completes presets and arguments', function(child)
    fixture.write(
      child.folder .. '/src/xacro-lint.toml',
      table.concat({
        '[[roots]]',
        'file = "pan_tilt/urdf/pan_tilt.urdf.xacro"',
        'args = { mount = "shelf" }',
        'presets.wall = { mount = "wall" }',
      }, '\n')
    )
    child:edit(fixture.robot)
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    local words = child:value([[vim.fn.getcompletion('XacroArgs ', 'cmdline')]])
    table.sort(words)
    assert(vim.deep_equal(words, { 'default', 'mount:=shelf', 'wall' }), vim.inspect(words))
    assert(vim.deep_equal(child:value([[vim.fn.getcompletion('XacroArgs w', 'cmdline')]]), { 'wall' }))
    child:type(':XacroArgs wall<CR>')
    child:wait([[require('xacro').status():find('mount:=wall', 1, true)]])
  end)

  test('XacroArgs asks for one argument, with values that are known', function(child)
    child:edit(fixture.robot)
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    answer_select(child, 'shelf')
    child:lua(
      [[require('xacro.handlers').of_lenses()['xacro.setArgs'](
      { arguments = { { name = 'mount', values = { 'wall', 'shelf' } } } }, { bufnr = vim.api.nvim_get_current_buf() })]]
    )
    child:wait([[require('xacro').status() == 'pan_tilt.urdf.xacro mount:=shelf']])
  end)

  test('XacroExplain shows the page of a rule', function(child)
    child:edit(fixture.robot)
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    child:type(':XacroExplain unused-property<CR>')
    child:wait([[vim.iter(vim.api.nvim_list_wins()):any(function(win)
      local lines = vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(win), 0, -1, false)
      return vim.api.nvim_win_get_config(win).relative ~= '' and table.concat(lines):find('unused', 1, true) ~= nil
    end)]])
  end)

  test('XacroInstance picks a call', function(child)
    child:edit(fixture.unit)
    child:wait([[require('xacro').status():find('urdf.xacro', 1, true)]])
    child:type(':XacroRoot ' .. fixture.robot .. '<CR>')
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    child:at('<axi|s xyz')
    answer_select(child, 'pan_tilt.urdf.xacro:8')
    child:type(':XacroInstance<CR>')
    child:wait('_G.offered[1]')
    assert(#child:value('_G.offered') == 3, vim.inspect(child:value('_G.offered')))
    local found = child:wait([[(function()
      for _, message in ipairs(_G.said) do
        if message:find('xacro/setInstance') then return 'unknown' end
      end
      return require('xacro').status():find('pan_tilt.urdf.xacro:8', 1, true) and 'pinned'
    end)()]])
    if found == 'unknown' then
      skip('the server does not know `xacro/setInstance`, and the user was told so')
    end
  end)

  test('XacroPreview opens an address that answers', function(child)
    child:edit(fixture.robot)
    child:type(':XacroPreview<CR>')
    local address = child:wait([[_G.opened[1] or _G.said[1] ]])
    if address:find('has no `xacro.preview`', 1, true) then
      skip('the server has no `xacro.preview` yet, and the user was told so')
    end
    local host, port = address:match('^http://([%w.]+):(%d+)/')
    assert(host == '127.0.0.1' or host == 'localhost', address)
    local answer = ''
    local socket = assert(vim.uv.new_tcp())
    socket:connect('127.0.0.1', tonumber(port), function(problem)
      assert(not problem, problem)
      socket:read_start(function(_, data)
        answer = answer .. (data or '')
      end)
      socket:write(('GET / HTTP/1.1\r\nHost: %s:%s\r\nConnection: close\r\n\r\n'):format(host, port))
    end)
    assert(
      vim.wait(10000, function()
        return answer:find('^HTTP/1%.%d 200') ~= nil
      end),
      answer
    )
    socket:close()
  end)

  test('the preview follows the cursor', function(child)
    child:edit(fixture.robot)
    child:lua([[
      _G.told = {}
      local client = require('xacro.client')
      local notify = client.notify
      client.notify = function(to, method, params)
        if method == 'xacro/preview/select' then
          table.insert(_G.told, params.location)
        end
        notify(to, method, params)
      end
    ]])
    child:type('gg')
    child:type(':XacroPreview<CR>')
    child:wait([[_G.opened[1] or _G.said[1] ]])
    assert(child:value('#_G.told') == 0)
    child:type('5jw')
    child:wait([[_G.told[1] ~= nil]])
    local told = child:value('_G.told[#_G.told]')
    assert(told.uri:find('pan_tilt.urdf.xacro', 1, true) and told.range.start.line == 5, vim.inspect(told))
  end)

  test('a server that has ended is said once, and started again', function(child)
    child:edit(fixture.robot)
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    -- without the request before it, this ends the server with an error
    child:lua([[require('xacro.client').notify(vim.lsp.get_clients()[1], 'exit', {})]])
    child:wait([[require('xacro').status() == 'server stopped, see :XacroRestart']])
    local said = child:value('_G.said')
    assert(#said == 1 and said[1]:find('exit code 1', 1, true), vim.inspect(said))
    child:type(':XacroRestart<CR>')
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    child:type(':XacroRestart<CR>')
    child:wait([[#vim.lsp.get_clients() == 0 or require('xacro').status():find('pan_tilt', 1, true)]])
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
  end)

  test('XacroTree lists links and leads to them', function(child)
    child:edit(fixture.robot)
    child:type(':XacroTree<CR>')
    child:wait([[vim.api.nvim_buf_get_lines(vim.fn.bufnr('xacro-tree:'), 0, 1, false)[1] == 'desk']])
    local tree = child:text(child:value([[vim.fn.bufnr('xacro-tree:')]]))
    assert(tree == 'desk\n└ pan → pan_body  0.3 kg\n  └ tilt → tilt_body  0.3 kg', tree)
    child:lua([[vim.api.nvim_set_current_win(vim.fn.win_findbuf(vim.fn.bufnr('xacro-tree:'))[1])]])
    child:type('G<CR>')
    child:wait([[vim.api.nvim_buf_get_name(0):find('%.xacro$')]])
    child:lua([[vim.cmd.edit(...)]], child.folder .. '/' .. fixture.robot)
    child:change('axis="0 1 0"><origin', 'axis="0 1 0" ><origin')
    child:change('name="tilt"', 'name="nod"')
    child:wait(
      [[table.concat(vim.api.nvim_buf_get_lines(vim.fn.bufnr('xacro-tree:'), 0, -1, false)):find('nod_body', 1, true)]]
    )
  end)

  test('the server shows a document beside made text', function(child)
    child:edit(fixture.robot)
    local bufnr = expand(child)
    child:type('<C-w>w')
    child:wait('vim.api.nvim_get_current_buf() == ...', bufnr)
    child:lua(
      [[local client = vim.lsp.get_clients()[1]
        _G.answer = require('xacro.handlers').show_document(nil, {
          uri = vim.uri_from_fname(...), takeFocus = true,
          selection = { start = { line = 3, character = 4 }, ['end'] = { line = 3, character = 9 } },
        }, { client_id = client.id })]],
      child.folder .. '/' .. fixture.unit
    )
    assert(child:value('_G.answer.success'))
    assert(child:value('vim.api.nvim_buf_get_name(0)'):find('unit.xacro', 1, true))
    assert(child:value('vim.api.nvim_win_get_cursor(0)[1]') == 4)
    assert(child:value('#vim.fn.win_findbuf(...) == 1', bufnr), 'the expanded text is gone')
  end)

  test('what a server does not know is said politely', function(child)
    child:edit(fixture.robot)
    child:lua([[require('xacro.client').ask(0, 'xacro/nothing', {}, function() end)]])
    local said = child:wait('_G.said[1]')
    assert(said:find('does not know `xacro/nothing`', 1, true), said)
    child:lua([[require('xacro.client').command(0, 'xacro.nothing', {}, function() end)]])
    said = child:wait('_G.said[2]')
    assert(said:find('has no `xacro.nothing`', 1, true), said)
  end)

  test('commands in a file without server say so', function(child)
    child:lua([[vim.cmd.enew()]])
    child:type(':XacroExpand<CR>')
    assert(child:wait('_G.said[1]'):find('no server', 1, true))
  end)
end
