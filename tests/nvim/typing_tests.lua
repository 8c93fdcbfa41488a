--- What happens while typing, and on the text itself.
local fixture = require('fixture')

return function(test)
  test('a tag is closed', function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    child:type('o<lt>link name="x">')
    child:wait([[vim.api.nvim_get_current_line():find('<link name="x"></link>', 1, true)]])
    child:type('y')
    child:wait([[vim.api.nvim_get_current_line():find('<link name="x">y</link>', 1, true)]])
    child:type('<Esc>')
  end)

  test('an end tag typed by habit takes the place of the one that was added', function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    child:type('o<lt>link name="x">')
    child:wait([[vim.api.nvim_get_current_line():find('<link name="x"></link>', 1, true)]])
    child:type('<lt>/')
    child:wait([[vim.trim(vim.api.nvim_get_current_line()) == '<link name="x"></']])
    child:type('link>')
    child:wait([[vim.trim(vim.api.nvim_get_current_line()) == '<link name="x"></link>']])
    child:type('<Esc>')
  end)

  if vim.lsp.completion then
    test('the menu that opens while one types inserts nothing', { config = '{ completion = true }' }, function(child)
      child:edit(fixture.robot)
      child:at('<link name="$(arg mount)|"/>')
      child:type('o')
      child:type('<lt>')
      child:wait([[vim.fn.pumvisible() == 1]])
      child:type('jo')
      child:wait([[vim.trim(vim.api.nvim_get_current_line()) == '<jo']])
      child:type('<Esc>')
    end)

    test('who chose how the menu behaves is left alone', {
      init = function(server)
        return ('vim.o.completeopt = "menu,noinsert"\nvim.g.xacro = { cmd = { %q }, completion = true }\n'):format(
          server
        )
      end,
    }, function(child)
      child:edit(fixture.robot)
      assert(child:value('vim.bo.completeopt') == '', child:value('vim.bo.completeopt'))
    end)
  end

  test('an end tag typed by habit on a line of its own is the only one', function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    child:type('o<lt>link name="x">')
    child:wait([[vim.api.nvim_get_current_line():find('<link name="x"></link>', 1, true)]])
    child:type('<CR>')
    child:wait([[vim.tbl_contains(vim.api.nvim_buf_get_lines(0, 0, -1, false), '  </link>')]])
    child:type('<lt>/link>')
    local closed_once = [[(function()
      local text = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')
      local _, count = text:gsub('</link>', '')
      return count == 1 and text:find('<link name="x">\n *</link>\n')
    end)()]]
    child:wait(closed_once)
    child:type('<Esc>')
    child:wait(closed_once)
  end)

  test('lines between tags are indented as the file is', function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    local steps = {
      { 'o<lt>link name="x">', '  <link name="x"></link>' },
      { '<CR>', '    ' },
      { '<lt>visual>', '    <visual></visual>' },
      { '<CR>', '      ' },
      { '<lt>origin/>', '      <origin/>' },
    }
    for _, step in ipairs(steps) do
      child:type(step[1])
      child:wait([[vim.tbl_contains(vim.api.nvim_buf_get_lines(0, 0, -1, false), (...))]], step[2])
    end
    child:type('<Esc>')
    local made = '  <link name="x">\n    <visual>\n      <origin/>\n    </visual>\n  </link>\n'
    child:wait([[(table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n') .. '\n'):find(..., 1, true)]], made)
  end)

  test('no tag is closed when switched off', { config = '{ close_tags = false }' }, function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    child:type('o<lt>link name="x"><Esc>')
    child:wait([[vim.api.nvim_get_mode().mode == 'n']])
    child:value(
      [[vim.lsp.buf_request_sync(0, 'textDocument/foldingRange', { textDocument = { uri = vim.uri_from_bufnr(0) } }, 10000)]]
    )
    assert(not child:text():find('</link>', 1, true), child:text())
  end)

  test('start and end tag change together', { config = '{ linked_editing = true }' }, function(child)
    child:edit(fixture.unit)
    child:at('<j|oint name=')
    child:wait([[(function()
      for name, space in pairs(vim.api.nvim_get_namespaces()) do
        if name:find('linked') and #vim.api.nvim_buf_get_extmarks(0, space, 0, -1, {}) > 0 then return true end
      end
    end)()]])
    child:type('lix<Esc>')
    child:wait([[table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false)):find('</joxint>', 1, true)]])
    assert(child:text():find('<joxint name=', 1, true), child:text())
  end)

  test('colors are shown', function(child)
    child:edit(fixture.robot)
    child:change(
      '<link name="$(arg mount)"/>',
      '<link name="$(arg mount)"/><material name="red"><color rgba="1 0 0 1"/></material>'
    )
    child:wait([[(function()
      for name, space in pairs(vim.api.nvim_get_namespaces()) do
        if name:find('color') and #vim.api.nvim_buf_get_extmarks(0, space, 0, -1, {}) > 0 then return true end
      end
    end)()]])
  end)

  test('gx opens an include here and a mesh elsewhere', function(child)
    fixture.write(child.folder .. '/src/pan_tilt/meshes/head.stl', ('\0'):rep(84))
    child:edit(fixture.robot)
    child:change(
      '<link name="$(arg mount)"/>',
      '<link name="$(arg mount)"><visual><geometry><mesh filename="package://pan_tilt/meshes/head.stl"/></geometry></visual></link>'
    )
    child:at('package://pan_tilt/mesh|es')
    child:type('gx')
    child:wait('_G.opened[1]')
    assert(child:value('_G.opened[1]'):find('/src/pan_tilt/meshes/head.stl', 1, true))
    child:at('filename="un|it.xacro"')
    child:type('gx')
    child:wait([[vim.api.nvim_buf_get_name(0):find('/unit.xacro', 1, true)]])
    child:type('<C-o>')
    child:wait([[vim.api.nvim_buf_get_name(0):find('pan_tilt.urdf.xacro', 1, true)]])
    child:at('config/cam|.yaml')
    child:type('gx')
    child:wait([[vim.bo.filetype == 'yaml']])
  end)

  test('the lens of a macro lists its calls', { config = '{ code_lens = true }' }, function(child)
    child:edit(fixture.unit)
    child:type(':XacroRoot ' .. fixture.robot .. '<CR>')
    child:wait([[require('xacro').status():find('pan_tilt', 1, true)]])
    child:at('<xacro:ma|cro')
    child:lua([[vim.ui.select = function(items, options, on_choice)
      for number, item in ipairs(items) do
        if options.format_item(item):find('call') then return on_choice(item, number) end
      end
    end]])
    -- as long as nothing is known of the calls, the other lens is the only one, and it is run without a question
    child:lua([[require('xacro.expand_at').open = function() end]])
    child:wait([[(function()
      vim.lsp.codelens.run()
      return #vim.fn.getqflist() == 2
    end)()]])
  end)

  test('values of XML carry expressions in color', function(child)
    child:edit(fixture.robot)
    local row, column = child:at('${m|0 / 3}')
    local group =
      child:value([[vim.fn.synIDattr(vim.fn.synID(select(1, ...), select(2, ...), 1), 'name')]], row, column + 1)
    assert(group == 'xacroExpression', group)
    assert(child:value('vim.bo.commentstring') == '<!-- %s -->')
  end)
end
