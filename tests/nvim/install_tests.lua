--- Installing, health, help, and doing without the plugin.
local fixture = require('fixture')

local repository = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h:h')

--- A block of docs/editors.md, by the comment above it.
local function snippet(name)
  local page = table.concat(vim.fn.readfile(repository .. '/docs/editors.md'), '\n')
  local _, above = page:find(('<!-- run: %s -->\n```lua\n'):format(name), 1, true)
  assert(above, name)
  return page:sub(above + 1, page:find('\n```', above, true))
end

--- The page's configuration, with the server where the page expects it.
local function by_the_page(block)
  return function(server)
    local path = ('vim.env.PATH = %q .. ":" .. vim.env.PATH\n'):format(vim.fn.fnamemodify(server, ':h'))
    local files = ('vim.opt.runtimepath:prepend(%q)\n'):format(repository .. '/editors/nvim-lspconfig')
    return path .. files .. block
  end
end

return function(test)
  -- by the syntax file or by the tree-sitter parser, where one is installed
  local colored =
    [[vim.fn.synID(1, 2, 1) > 0 or vim.treesitter.highlighter.active[vim.api.nvim_get_current_buf()] ~= nil]]
  local start, enable = snippet('nvim-start'), snippet('nvim-enable')
  test('the page of the editors, for 0.10', { plugin = false, init = by_the_page(start) }, function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
    assert(child:value(colored), 'the text has no colors')
  end)

  if vim.lsp.config then
    test('the page of the editors, for 0.11', { plugin = false, init = by_the_page(enable) }, function(child)
      child:edit(fixture.robot)
      child:change('${m0 / 3}', '${m_0 / 3}')
      child:wait('#vim.diagnostic.get(0) == 1')
      assert(child:value(colored), 'the text has no colors')
    end)
  end

  test('file types are known', function(child)
    local types = child:value([[vim.tbl_map(function(name) return vim.filetype.match({ filename = name }) or '' end,
      { 'a.xacro', 'a.urdf.xacro', 'a.srdf.xacro', 'a.urdf', 'a.yaml' })]])
    assert(vim.deep_equal(types, { 'xacro', 'xacro', 'xacro', 'urdf', 'yaml' }), vim.inspect(types))
    assert(child:value([[vim.treesitter.language.get_lang('xacro')]]) == 'xml')
  end)

  test('checkhealth tells of server and file', function(child)
    child:edit(fixture.robot)
    child:wait([[require('xacro').status() ~= '']])
    child:lua([[vim.cmd('checkhealth xacro')]])
    local text = child:wait(
      [[vim.bo.filetype == 'checkhealth' and table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')]]
    )
    for _, part in ipairs({
      'xacro-lsp 0',
      'is shown under: pan_tilt.urdf.xacro',
      '*.xacro is of filetype xacro',
      'log: ',
    }) do
      assert(text:find(part, 1, true), text)
    end
    assert(not text:find('ERROR'), text)
  end)

  test('checkhealth says what to do without server', { server = '/nowhere/xacro-lsp' }, function(child)
    child:lua([[vim.cmd('checkhealth xacro')]])
    local text = child:wait(
      [[vim.bo.filetype == 'checkhealth' and table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), '\n')]]
    )
    assert(text:find('ERROR', 1, true) and text:find('is not in PATH', 1, true), text)
  end)

  test('the help has its tags', function(child)
    child:lua([[
      local copy = vim.fn.tempname()
      vim.fn.mkdir(copy .. '/doc', 'p')
      vim.uv.fs_copyfile(vim.api.nvim_get_runtime_file('doc/xacro.txt', false)[1], copy .. '/doc/xacro.txt')
      vim.cmd.helptags(copy .. '/doc')
      vim.opt.runtimepath:prepend(copy)
    ]])
    for _, command in ipairs({ 'Expand', 'ExpandAt', 'Root', 'Args', 'Instance', 'Preview', 'Restart', 'Tree' }) do
      child:lua('vim.cmd.help(...)', ':Xacro' .. command)
      assert(child:value('vim.api.nvim_get_current_line()'):find('*:Xacro' .. command .. '*', 1, true))
    end
  end)

  test('it can be put on the runtimepath alone', {
    plugin = false,
    init = function(server)
      local root = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h:h')
      return ('vim.opt.runtimepath:prepend(%q)\nrequire("xacro").setup({ cmd = { %q } })\n'):format(
        root .. '/editors/nvim',
        server
      )
    end,
  }, function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
  end)

  test('the files for nvim-lspconfig do without the plugin', {
    plugin = false,
    init = function(server)
      local root = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h:h')
      return ([[
        vim.filetype.add({ extension = { xacro = 'xacro', urdf = 'urdf' } })
        local config = dofile(%q)
        config.name, config.cmd = 'xacro', { %q }
        if vim.lsp.config then
          vim.lsp.config('xacro', config)
          vim.lsp.enable('xacro')
        else
          vim.api.nvim_create_autocmd('FileType', { pattern = config.filetypes, callback = function(event)
            config.root_dir = vim.fs.root(event.buf, config.root_markers)
            vim.lsp.start(config)
          end })
        end
      ]]):format(root .. '/editors/nvim-lspconfig/lsp/xacro_lsp.lua', server)
    end,
  }, function(child)
    child:edit(fixture.robot)
    child:change('${m0 / 3}', '${m_0 / 3}')
    child:wait('#vim.diagnostic.get(0) == 1')
  end)
end
