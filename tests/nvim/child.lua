--- A Neovim of its own for each test, started as a user starts it: configuration and plugin in their usual
--- folders, real keystrokes.
local fixture = require('fixture')

local Child = {}
Child.__index = Child

local TIMEOUT = 20000
local repository = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h:h')
local count = 0

---@param options? { config?: string, server?: string, plugin?: boolean }
function Child.start(options)
  options = options or {}
  count = count + 1
  local base = ('%s/%d-%d'):format(vim.env.NVIM_TEST_FOLDER, vim.fn.getpid(), count)
  local self = setmetatable({ base = base, folder = base .. '/ws', options = options }, Child)
  fixture.make(self.folder)
  local server = options.server or vim.env.XACRO_LSP
  local config = ('vim.g.xacro = vim.tbl_extend("force", { cmd = { %q } }, %s)\n'):format(
    server,
    options.config or '{}'
  )
  fixture.write(base .. '/config/nvim/init.lua', options.init and options.init(server) or config)
  if options.plugin ~= false then
    local start = base .. '/data/nvim/site/pack/tests/start'
    vim.fn.mkdir(start, 'p')
    assert(vim.uv.fs_symlink(repository .. '/editors/nvim', start .. '/xacro'))
  end
  self.channel = vim.fn.jobstart({ vim.env.NVIM_PROGRAM, '--embed', '--headless', '-i', 'NONE' }, {
    rpc = true,
    cwd = self.folder,
    env = {
      XDG_CONFIG_HOME = base .. '/config',
      XDG_DATA_HOME = base .. '/data',
      XDG_STATE_HOME = base .. '/state',
      XDG_CACHE_HOME = base .. '/cache',
      NVIM_APPNAME = 'nvim',
      AMENT_PREFIX_PATH = '',
      ROS_PACKAGE_PATH = '',
    },
  })
  assert(self.channel > 0, 'no child')
  self:lua([[
    vim.o.swapfile = false
    vim.o.shortmess = vim.o.shortmess .. 'I'
    vim.o.columns, vim.o.lines = 140, 40
    _G.said = {}
    vim.notify = function(message) table.insert(_G.said, message) end
    _G.opened = {}
    vim.ui.open = function(what) table.insert(_G.opened, what) return { wait = function() return { code = 0 } end } end
  ]])
  return self
end

function Child:request(method, ...)
  return vim.rpcrequest(self.channel, method, ...)
end

--- Run Lua in the child.
function Child:lua(code, ...)
  return self:request('nvim_exec_lua', code, { ... })
end

--- The value of a Lua expression there.
function Child:value(expression, ...)
  return self:lua('return ' .. expression, ...)
end

--- Keystrokes.
function Child:type(keys)
  self:request('nvim_input', keys)
end

--- Wait until a Lua expression of the child holds; its value.
function Child:wait(expression, ...)
  local value
  local arguments = { ... }
  local ok = vim.wait(TIMEOUT, function()
    value = self:value(expression, unpack(arguments))
    return value ~= nil and value ~= false and value ~= vim.NIL
  end, 10)
  if not ok then
    local state = self:value([[vim.inspect({
      mode = vim.api.nvim_get_mode().mode, said = _G.said, messages = vim.fn.execute('messages'),
      cursor = vim.api.nvim_win_get_cursor(0), line = vim.api.nvim_get_current_line(),
      file = vim.api.nvim_buf_get_name(0), diagnostics = vim.tbl_map(function(d)
        return d.lnum + 1 .. ': ' .. d.message end, vim.diagnostic.get(0)),
    })]])
    error(('waited in vain for %s\n%s'):format(expression, state), 2)
  end
  return value
end

--- Open a file of the workspace and wait for the server.
function Child:edit(name)
  self:lua('vim.cmd.edit(vim.fn.fnameescape(...))', self.folder .. '/' .. name)
  self:wait([[(function()
    local client = vim.lsp.get_clients({ bufnr = 0 })[1]
    return client and client.initialized
  end)()]])
end

--- Put the cursor where `|` stands in a piece of the text.
function Child:at(piece)
  local before, behind = piece:match('^(.-)|(.*)$')
  local row, column = unpack(self:value(
    [[(function(text, before)
      for row, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
        local column = line:find(text, 1, true)
        if column then
          vim.api.nvim_win_set_cursor(0, { row, column - 1 + #before })
          return { row, column - 1 + #before }
        end
      end
      return {}
    end)(...)]],
    before .. behind,
    before
  ))
  assert(row, 'no ' .. piece)
  return row, column
end

--- Replace a piece of the text of the current buffer, as an edit of the user would.
function Child:change(old, new)
  local done = self:value(
    [[(function(old, new)
      for row, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
        local first, last = line:find(old, 1, true)
        if first then
          vim.api.nvim_buf_set_text(0, row - 1, first - 1, row - 1, last, { new })
          vim.api.nvim_exec_autocmds('TextChanged', { buffer = 0 })
          return true
        end
      end
    end)(...)]],
    old,
    new
  )
  assert(done == true, 'no ' .. old)
end

--- The text of a buffer (the current one) in one string.
function Child:text(bufnr)
  return self:value([[table.concat(vim.api.nvim_buf_get_lines(..., 0, -1, false), '\n')]], bufnr or 0)
end

function Child:stop()
  pcall(self.request, self, 'nvim_command', 'silent! qall!')
  vim.fn.jobwait({ self.channel }, 3000)
  vim.fn.jobstop(self.channel)
  vim.fn.delete(self.base, 'rf')
end

return Child
