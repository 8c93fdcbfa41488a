--- Files that robots are made from besides xacro: YAML, package.xml, xacro-lint.toml, launch files. The server has to know
--- their unsaved text and what is written to the disk. Those it gives features in, such as the parameters of controllers, are
--- attached; the others are told of here.
local start = require('xacro.start')

local M = {}

local names = { ['package.xml'] = true, ['xacro-lint.toml'] = true, ['.xacro-lint.toml'] = true }
local CHANGED = 2

--- Versions of what the servers were told, by client and buffer.
---@type table<integer, table<integer, integer>>
local told = {}

---@param bufnr integer
---@return boolean
local function is_companion(bufnr)
  local name = vim.api.nvim_buf_get_name(bufnr)
  return vim.bo[bufnr].buftype == ''
    and vim.api.nvim_buf_is_loaded(bufnr)
    and (names[vim.fs.basename(name)] or name:lower():match('%.ya?ml$') ~= nil or start.is_launch(name))
end

---@param method string
---@param params table
---@param wanted? fun(client: vim.lsp.Client): boolean
---@param bufnr? integer
local function tell(method, params, wanted, bufnr)
  for _, client in ipairs(vim.lsp.get_clients({ name = start.name })) do
    local is_attached = bufnr and vim.lsp.buf_is_attached(bufnr, client.id)
    if client.initialized and not is_attached and (not wanted or wanted(client)) then
      require('xacro.client').notify(client, method, params)
    end
  end
end

---@param bufnr integer
---@return string
local function text_of(bufnr)
  local text = table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false), '\n')
  return vim.bo[bufnr].endofline and text .. '\n' or text
end

--- Tell the text of a buffer where it is not known yet.
---@param bufnr integer
local function sync(bufnr)
  if not is_companion(bufnr) then
    return
  end
  local uri, version = vim.uri_from_bufnr(bufnr), vim.api.nvim_buf_get_changedtick(bufnr)
  local function known(client)
    told[client.id] = told[client.id] or {}
    return told[client.id][bufnr]
  end
  tell('textDocument/didChange', {
    textDocument = { uri = uri, version = version },
    contentChanges = { { text = text_of(bufnr) } },
  }, function(client)
    local is_old = known(client) ~= nil and known(client) ~= version
    told[client.id][bufnr] = is_old and version or told[client.id][bufnr]
    return is_old
  end, bufnr)
  tell('textDocument/didOpen', {
    textDocument = { uri = uri, version = version, languageId = vim.bo[bufnr].filetype, text = text_of(bufnr) },
  }, function(client)
    local is_new = known(client) == nil
    told[client.id][bufnr] = version
    return is_new
  end, bufnr)
end

---@param bufnr integer
local function closed(bufnr)
  tell('textDocument/didClose', { textDocument = { uri = vim.uri_from_bufnr(bufnr) } }, function(client)
    local open = told[client.id]
    local was = open and open[bufnr] ~= nil
    if was then
      open[bufnr] = nil
    end
    return was or false
  end)
end

--- Files may have changed on the disk: one that is known, or any.
---@param path? string
local function on_disk(path)
  local changes = path and { { uri = vim.uri_from_fname(path), type = CHANGED } } or {}
  tell('workspace/didChangeWatchedFiles', { changes = changes })
end

--- A server has started: tell it of the companions that are open already.
function M.attached()
  for _, bufnr in ipairs(vim.api.nvim_list_bufs()) do
    sync(bufnr)
  end
end

function M.watch()
  local group = vim.api.nvim_create_augroup('xacro_companions', {})
  local function on(events, run)
    vim.api.nvim_create_autocmd(events, { group = group, callback = run })
  end
  on({ 'BufReadPost', 'BufNewFile', 'TextChanged', 'TextChangedI', 'TextChangedP' }, function(event)
    sync(event.buf)
  end)
  on({ 'BufUnload' }, function(event)
    closed(event.buf)
  end)
  on({ 'BufWritePost', 'FileWritePost' }, function(event)
    local path = vim.fn.fnamemodify(event.match, ':p')
    if #vim.lsp.get_clients({ bufnr = event.buf, name = start.name }) == 0 then
      on_disk(path)
    end
  end)
  -- Neovim does not watch files on Linux: what other programs and shell commands did is asked for when one comes back
  on({ 'FocusGained', 'VimResume', 'ShellCmdPost', 'ShellFilterPost', 'TermClose', 'TermLeave' }, function()
    on_disk()
  end)
  on('LspDetach', function(event)
    if #vim.lsp.get_buffers_by_client_id(event.data.client_id) <= 1 then
      told[event.data.client_id] = nil
    end
  end)
end

return M
