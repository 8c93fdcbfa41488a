--- What Neovim itself does with the server, through the plugin's configuration.
local fixture = require('fixture')

--- The answer of the server in the child.
local ask = [[(function(method, params)
  local answers = vim.lsp.buf_request_sync(0, method, params or vim.empty_dict(), 10000) or {}
  for _, answer in pairs(answers) do return answer.result or false end
end)(...)]]

return function(test)
  test('findings appear and go', function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
    local found = child:value('vim.diagnostic.get(0)[1]')
    assert(found.code == 'undefined-property', vim.inspect(found))
    assert(found.message:find('m_0'), found.message)
    local line = child:value('vim.api.nvim_buf_get_lines(0, ..., ... + 1, false)[1]', found.lnum)
    assert(line:sub(found.col + 1, found.end_col) == 'm_0', line)
    child:change('${m_0 / 3}', '${m0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 0')
  end)

  test('a finding in a macro names its call', function(child)
    child:edit(fixture.unit)
    child:change('${m0 * 2}', '${m0 * nothing}')
    child:wait('#vim.diagnostic.get(0) > 0')
    local found = child:value('vim.diagnostic.get(0)[1]')
    local related = found.user_data.lsp.relatedInformation
    assert(related and related[1].location.uri:find('%.urdf%.xacro$'), vim.inspect(found))
  end)

  test('unsaved text of an included file counts', function(child)
    child:edit(fixture.robot)
    child:lua([[vim.cmd.split(...)]], child.folder .. '/' .. fixture.unit)
    child:wait('#vim.lsp.get_clients({ bufnr = 0 }) > 0')
    child:change('name="unit"', 'name="unitt"')
    child:wait([[#vim.diagnostic.get(vim.fn.bufnr('pan_tilt.urdf.xacro')) == 2]])
  end)

  test('a completion is confirmed', function(child)
    child:edit(fixture.robot)
    child:at('<link name="$(arg mount)|"/>')
    child:type('o<lt>xacro:un<C-x><C-o>')
    child:wait('vim.fn.pumvisible() == 1')
    child:type('<C-n><C-y>')
    child:wait('vim.fn.pumvisible() == 0')
    child:type('<Esc>')
    child:wait([[vim.api.nvim_get_mode().mode:sub(1, 1) ~= 'i']])
    child:type('<Esc>')
    child:wait([[vim.api.nvim_get_mode().mode == 'n']])
    assert(child:text():find('<xacro:unit name="[^"]*" parent="'), child:text())
  end)

  test('completion knows the robot', function(child)
    child:edit(fixture.robot)
    child:lua([[vim.api.nvim_buf_set_lines(0, -2, -1, false, { '<joint name="j" type="fixed"><parent link="' })]])
    child:lua([[vim.api.nvim_win_set_cursor(0, { vim.api.nvim_buf_line_count(0), 100 })]])
    child:type('A<C-x><C-o>')
    child:wait('vim.fn.pumvisible() == 1')
    local words = child:value([[vim.tbl_map(function(item) return item.abbr ~= '' and item.abbr or item.word end,
        vim.fn.complete_info({ 'items' }).items)]])
    for _, link in ipairs({ 'desk', 'pan_body', 'tilt_body' }) do
      assert(vim.tbl_contains(words, link), vim.inspect(words))
    end
    child:type('<C-e><Esc>')
  end)

  test('hover shows a value', function(child)
    child:edit(fixture.robot)
    child:at('${m0 |/ 3}')
    child:lua('vim.lsp.buf.hover()')
    local text = child:wait([[(function()
      for _, window in ipairs(vim.api.nvim_list_wins()) do
        if vim.api.nvim_win_get_config(window).relative ~= '' then
          return table.concat(vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false), '\n')
        end
      end
    end)()]])
    assert(text:find('0%.05'), text)
  end)

  test('a definition lies in another file', function(child)
    child:edit(fixture.robot)
    child:at('<xacro:un|it name="pan"')
    child:lua('vim.lsp.buf.definition()')
    child:wait([[vim.api.nvim_buf_get_name(0):find('unit%.xacro$')]])
    assert(child:value('vim.api.nvim_get_current_line()'):find('xacro:macro name="unit"'))
  end)

  test('references of all files are listed', function(child)
    child:edit(fixture.robot)
    child:at('name="m|0"')
    child:lua('vim.lsp.buf.references()')
    child:wait('#vim.fn.getqflist() == 3')
    local names = child:value([[vim.tbl_map(function(item)
      return vim.fs.basename(vim.fn.bufname(item.bufnr)) end, vim.fn.getqflist())]])
    table.sort(names)
    assert(vim.deep_equal(names, { 'pan_tilt.urdf.xacro', 'pan_tilt.urdf.xacro', 'unit.xacro' }), vim.inspect(names))
  end)

  test('a rename changes all files', function(child)
    child:edit(fixture.unit)
    child:at('params="name parent ax|is:=')
    child:lua([[vim.lsp.buf.rename('turns_about')]])
    child:wait([[vim.api.nvim_buf_get_lines(0, 2, 3, false)[1]:find('turns_about:=')]])
    assert(child:text():find('<axis xyz="${turns_about}"/>', 1, true), child:text())
    child:wait([[vim.fn.bufnr('pan_tilt.urdf.xacro') > 0]])
    local robot = child:text(child:value([[vim.fn.bufnr('pan_tilt.urdf.xacro')]]))
    assert(robot:find('turns_about="0 1 0"', 1, true), robot)
  end)

  local not_taken =
    '<xacro:if value="false"><xacro:unit name="${m0}" parent="top"><origin/></xacro:unit></xacro:if></robot>'

  test('definition and references know branches that are not taken', function(child)
    child:edit(fixture.robot)
    child:change('</robot>', not_taken)
    child:at('name="${m|0}"')
    child:lua('vim.lsp.buf.references()')
    child:wait('#vim.fn.getqflist() == 4')
    child:lua('vim.cmd.cclose()')
    child:at('<xacro:un|it name="${m0}"')
    child:lua('vim.lsp.buf.definition()')
    child:wait([[vim.api.nvim_buf_get_name(0):find('unit%.xacro$')]])
    assert(child:value('vim.api.nvim_get_current_line()'):find('xacro:macro name="unit"'))
  end)

  test('a rename reaches branches that are not taken', function(child)
    child:edit(fixture.robot)
    child:change('</robot>', not_taken)
    child:at('<xacro:un|it name="${m0}"')
    child:lua([[vim.lsp.buf.rename('motor')]])
    child:wait([[vim.api.nvim_get_current_line():find('<xacro:motor name="${m0}"', 1, true)]])
    assert(child:text():find('<origin/></xacro:motor></xacro:if>', 1, true), child:text())
    child:wait([[vim.fn.bufnr('unit.xacro') > 0]])
    local unit = child:text(child:value([[vim.fn.bufnr('unit.xacro')]]))
    assert(unit:find('<xacro:macro name="motor"', 1, true), unit)
    child:at('name="${m|0}"')
    child:lua([[vim.lsp.buf.rename('weight')]])
    child:wait([[vim.api.nvim_get_current_line():find('name="${weight}"', 1, true)]])
    assert(child:text():find('<xacro:property name="weight"', 1, true), child:text())
  end)

  test('a quick fix corrects the text', function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
    child:at('${m_|0 / 3}')
    child:lua([[vim.lsp.buf.code_action({
      apply = true,
      filter = function(action) return action.title:find('m0') ~= nil end,
    })]])
    child:wait([[vim.api.nvim_get_current_line():find('${m0 / 3}', 1, true)]])
  end)

  test('the file is formatted', function(child)
    child:edit(fixture.robot)
    child:lua([[vim.bo.shiftwidth, vim.bo.expandtab = 2, true]])
    local before = child:text()
    child:change('  <xacro:arg name', '        <xacro:arg   name')
    child:lua('vim.lsp.buf.format({ timeout_ms = 10000 })')
    local after = child:text()
    assert(after:find('\n  <xacro:arg name', 1, true), after)
    assert(after:gsub('%s+', '') == before:gsub('%s+', ''), after)
  end)

  test('semantic tokens color the text', function(child)
    child:edit(fixture.robot)
    local row, column = child:at('${m|0 / 3}')
    child:wait(
      [[(function(row, column)
        for _, token in ipairs(vim.lsp.semantic_tokens.get_at_pos(0, row, column) or {}) do
          if token.type == 'variable' then return true end
        end
      end)(...)]],
      row - 1,
      column
    )
  end)

  test('symbols of a document form a tree', function(child)
    child:edit(fixture.unit)
    local symbols =
      child:value(ask, 'textDocument/documentSymbol', { textDocument = { uri = child:value('vim.uri_from_bufnr(0)') } })
    local macro = vim.iter(symbols):find(function(symbol)
      return symbol.name:find('unit')
    end) or symbols[1].children[1]
    assert(#macro.children >= 2, vim.inspect(macro))
    child:lua([[vim.lsp.buf.document_symbol()]])
    child:wait('#vim.fn.getloclist(0) + #vim.fn.getqflist() > 2')
  end)

  test('inlay hints show values', function(child)
    child:edit(fixture.robot)
    local shown = child:wait([[(function()
      local hints = vim.tbl_map(function(found)
        local label = found.inlay_hint.label
        return type(label) == 'string' and label or label[1].value
      end, vim.lsp.inlay_hint.get({ bufnr = 0 }))
      return #hints > 0 and table.concat(hints, ' ')
    end)()]])
    assert(shown:find('0%.05'), shown)
  end)

  test('one server serves two workspaces', function(child)
    child:edit(fixture.robot)
    local other = child.base .. '/other'
    fixture.write(other .. '/.git/HEAD', '')
    fixture.write(other .. '/a.urdf.xacro', '<robot name="a"><link name="${nothing}"/></robot>\n')
    child:lua('vim.cmd.edit(...)', other .. '/a.urdf.xacro')
    child:wait('#vim.diagnostic.get(0) > 0')
    assert(child:value('#vim.lsp.get_clients()') == 1)
    assert(child:value('#vim.lsp.get_clients()[1].workspace_folders') == 2)
  end)

  test('the server ends with the editor', function(child)
    child:edit(fixture.robot)
    child:lua([[for _, client in ipairs(vim.lsp.get_clients()) do client.stop(client) end]])
    child:wait('#vim.lsp.get_clients() == 0')
  end)
end
