--- Talking to the server, alike on all versions of Neovim.
local M = {}

local METHOD_NOT_FOUND = -32601
local CANCELLED = { [-32800] = true, [-32801] = true, [-32802] = true }
local new = vim.fn.has('nvim-0.11') == 1

---@param message string
---@param level? integer
function M.show(message, level)
  vim.notify('xacro: ' .. message, level or vim.log.levels.INFO)
end

--- The server of a buffer.
---@param bufnr? integer
---@return vim.lsp.Client?
function M.of(bufnr)
  return vim.lsp.get_clients({ bufnr = bufnr or 0, name = require('xacro.start').name })[1]
end

--- The server of a buffer; without one the user is told.
---@param bufnr? integer
---@return vim.lsp.Client?
function M.get_or_warn(bufnr)
  local client = M.of(bufnr)
  if not client then
    M.show('no server for this file; try :XacroRestart, or see :checkhealth xacro', vim.log.levels.WARN)
  end
  return client
end

---@param client vim.lsp.Client
---@param method string
---@param params table
function M.notify(client, method, params)
  if new then
    client:notify(method, params)
  else
    client.notify(method, params)
  end
end

---@param client vim.lsp.Client
---@return string
local function version(client)
  local info = client.server_info or {}
  return info.version and ('%s %s'):format(info.name or 'xacro-lsp', info.version) or 'this server'
end

--- Ask, and tell the user when there is no answer. `quiet` is for what the user did not ask for. Once the question is
--- cancelled, `on_answer` is not called any more.
---@param bufnr integer
---@param method string
---@param params table
---@param on_answer fun(answer: any, client: vim.lsp.Client)
---@param quiet? boolean
---@return fun()? cancel
function M.ask(bufnr, method, params, on_answer, quiet)
  local client = quiet and M.of(bufnr) or not quiet and M.get_or_warn(bufnr) or nil
  if not client then
    return
  end
  local given_up = false
  local function done(err, answer)
    if given_up then
      -- the answer may have been on its way already: what it says is about a place that nobody looks at
      return
    elseif not err then
      on_answer(answer, client)
    elseif not quiet and not CANCELLED[err.code] then
      if err.code == METHOD_NOT_FOUND then
        M.show(('%s does not know `%s`; a newer one may'):format(version(client), method), vim.log.levels.WARN)
      else
        M.show(err.message, vim.log.levels.ERROR)
      end
    end
  end
  local sent, id
  if new then
    sent, id = client:request(method, params, done, bufnr)
  else
    sent, id = client.request(method, params, done, bufnr)
  end
  return sent
    and function()
      given_up = true
      if new then
        client:cancel_request(id)
      else
        client.cancel_request(id)
      end
    end
end

--- Ask and wait for at most `patience` milliseconds, for what Neovim wants at once; none where there is no answer.
---@param bufnr integer
---@param method string
---@param params table
---@param patience integer
---@return any?
function M.ask_now(bufnr, method, params, patience)
  local client = M.of(bufnr)
  if not client then
    return nil
  end
  local answer
  if new then
    answer = client:request_sync(method, params, patience, bufnr)
  else
    answer = client.request_sync(method, params, patience, bufnr)
  end
  return answer and answer.result
end

--- Run a command of the server, when it has it.
---@param bufnr integer
---@param command string
---@param argument table
---@param on_answer fun(answer: any, client: vim.lsp.Client)
function M.command(bufnr, command, argument, on_answer)
  local client = M.get_or_warn(bufnr)
  if not client then
    return
  end
  local offered = vim.tbl_get(client.server_capabilities, 'executeCommandProvider', 'commands') or {}
  if not vim.tbl_contains(offered, command) then
    M.show(('%s has no `%s`; a newer one may'):format(version(client), command), vim.log.levels.WARN)
    return
  end
  M.ask(bufnr, 'workspace/executeCommand', { command = command, arguments = { argument } }, on_answer)
end

---@param bufnr? integer
---@return { uri: string }
function M.document(bufnr)
  return { uri = vim.uri_from_bufnr(bufnr or 0) }
end

--- A byte column of a line, counted as the server counts.
---@param line string
---@param column integer
---@param encoding string
---@return integer
local function to_units(line, column, encoding)
  column = math.min(column, #line)
  if encoding == 'utf-8' then
    return column
  elseif new then
    return vim.str_utfindex(line, encoding, column, false)
  end
  local utf32, utf16 = vim.str_utfindex(line, column)
  return encoding == 'utf-32' and utf32 or utf16
end

--- The other way round.
---@param line string
---@param units integer
---@param encoding string
---@return integer
function M.to_column(line, units, encoding)
  if encoding == 'utf-8' then
    return math.min(units, #line)
  elseif new then
    return vim.str_byteindex(line, encoding, units, false)
  end
  local ok, column = pcall(vim.str_byteindex, line, units, encoding == 'utf-16')
  return ok and column or #line
end

--- A byte column of a line, counted as the server counts.
---@param line string
---@param column integer
---@param client vim.lsp.Client
---@return integer
function M.units(line, column, client)
  return to_units(line, column, client.offset_encoding)
end

---@param bufnr integer
---@param row integer from 0
---@return string
local function line_of(bufnr, row)
  return vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1] or ''
end

--- The cursor of a window as a position of the protocol.
---@param window integer
---@param client vim.lsp.Client
---@return lsp.Position
function M.cursor(window, client)
  local row, column = unpack(vim.api.nvim_win_get_cursor(window))
  local line = line_of(vim.api.nvim_win_get_buf(window), row - 1)
  return { line = row - 1, character = to_units(line, column, client.offset_encoding) }
end

--- A position of the protocol as row (from 0) and byte column.
---@param bufnr integer
---@param position lsp.Position
---@param client vim.lsp.Client
---@return integer row
---@return integer column
function M.place(bufnr, position, client)
  local row = math.min(position.line, vim.api.nvim_buf_line_count(bufnr) - 1)
  return row, M.to_column(line_of(bufnr, row), position.character, client.offset_encoding)
end

--- File and position under the cursor of the current window.
---@param client vim.lsp.Client
---@return { textDocument: { uri: string }, position: lsp.Position }
function M.position_params(client)
  return { textDocument = M.document(0), position = M.cursor(0, client) }
end

return M
