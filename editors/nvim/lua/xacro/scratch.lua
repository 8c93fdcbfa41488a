--- Windows beside the source with text that is made, not edited.
local M = {}

--- A buffer without file.
---@param name string
---@param filetype string
---@return integer
function M.buffer(name, filetype)
  local bufnr = vim.api.nvim_create_buf(false, true)
  vim.api.nvim_buf_set_name(bufnr, name)
  vim.bo[bufnr].bufhidden = 'wipe'
  vim.bo[bufnr].swapfile = false
  vim.bo[bufnr].modifiable = false
  vim.bo[bufnr].filetype = filetype
  return bufnr
end

--- Open a window for the buffer; the cursor stays where it is.
---@param bufnr integer
---@param split string
---@return integer window
function M.show(bufnr, split)
  local before = vim.api.nvim_get_current_win()
  vim.cmd(('%s sbuffer %d'):format(split, bufnr))
  local window = vim.api.nvim_get_current_win()
  vim.wo[window].wrap = false
  vim.wo[window].cursorline = true
  vim.wo[window].foldcolumn = '0'
  vim.wo[window].signcolumn = 'no'
  vim.api.nvim_set_current_win(before)
  return window
end

--- Change only the lines that differ, so that cursor, view and marks stay.
---@param bufnr integer
---@param lines string[]
function M.set_lines(bufnr, lines)
  local old = vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)
  local first = 1
  while first <= #old and first <= #lines and old[first] == lines[first] do
    first = first + 1
  end
  local old_last, last = #old, #lines
  while old_last >= first and last >= first and old[old_last] == lines[last] do
    old_last, last = old_last - 1, last - 1
  end
  if old_last < first and last < first then
    return
  end
  vim.bo[bufnr].modifiable = true
  vim.api.nvim_buf_set_lines(bufnr, first - 1, old_last, false, vim.list_slice(lines, first, last))
  vim.bo[bufnr].modifiable = false
  vim.bo[bufnr].modified = false
end

--- A function that runs once things have been quiet for a while.
---@param delay integer milliseconds
---@param run fun(...)
---@return fun(...)
function M.debounced(delay, run)
  local timer ---@type uv.uv_timer_t?
  return function(...)
    local arguments = { ... }
    if timer then
      timer:stop()
      timer:close()
    end
    timer = vim.defer_fn(function()
      timer = nil
      run(unpack(arguments))
    end, delay)
  end
end

--- Call `changed` when text of files changes, as long as a buffer of ours is there.
---@param group integer autocommand group of the buffer
---@param bufnr integer
---@param events string[]
---@param changed fun()
---@param gone fun() called when the buffer is wiped
function M.follow(group, bufnr, events, changed, gone)
  vim.api.nvim_create_autocmd(events, {
    group = group,
    callback = function(event)
      if vim.bo[event.buf].buftype == '' then
        changed()
      end
    end,
  })
  vim.api.nvim_create_autocmd('BufWipeout', {
    group = group,
    buffer = bufnr,
    callback = function()
      vim.api.nvim_del_augroup_by_id(group)
      gone()
    end,
  })
end

--- A text for 'winbar', where `%` means something.
---@param text string
---@return string
function M.escaped(text)
  return (text:gsub('[%c]', ' '):gsub('%%', '%%%%'))
end

--- A window for source text: one that shows the buffer, else the one asked for, else any ordinary one.
---@param bufnr integer
---@param preferred? integer
---@return integer
function M.source_window(bufnr, preferred)
  for _, window in ipairs(vim.api.nvim_tabpage_list_wins(0)) do
    if vim.api.nvim_win_get_buf(window) == bufnr then
      return window
    end
  end
  local function ordinary(window)
    return vim.bo[vim.api.nvim_win_get_buf(window)].buftype == '' and vim.api.nvim_win_get_config(window).relative == ''
  end
  if preferred and vim.api.nvim_win_is_valid(preferred) and ordinary(preferred) then
    return preferred
  end
  for _, window in ipairs(vim.api.nvim_tabpage_list_wins(0)) do
    if ordinary(window) then
      return window
    end
  end
  local before = vim.api.nvim_get_current_win()
  vim.cmd('topleft vertical new')
  local window = vim.api.nvim_get_current_win()
  vim.api.nvim_set_current_win(before)
  return window
end

local mark = vim.api.nvim_create_namespace('xacro_place')

--- Show a place of a source file; only `focus` moves the user there.
---@param location lsp.Location
---@param client vim.lsp.Client
---@param options { focus?: boolean, window?: integer }
function M.show_location(location, client, options)
  local lsp = require('xacro.client')
  local bufnr = vim.uri_to_bufnr(location.uri)
  vim.fn.bufload(bufnr)
  vim.bo[bufnr].buflisted = true
  local window = M.source_window(bufnr, options.window)
  if options.focus then
    vim.cmd("normal! m'")
    vim.api.nvim_set_current_win(window)
  end
  if vim.api.nvim_win_get_buf(window) ~= bufnr then
    vim.api.nvim_win_call(window, function()
      vim.cmd(('keepalt keepjumps buffer %d'):format(bufnr))
    end)
  end
  local row, column = lsp.place(bufnr, location.range.start, client)
  vim.api.nvim_win_set_cursor(window, { row + 1, column })
  vim.api.nvim_win_call(window, function()
    vim.cmd('normal! zv')
  end)
  M.mark(bufnr, { location.range }, client, mark)
end

--- Mark ranges; of those over several lines, the first line.
---@param bufnr integer
---@param ranges lsp.Range[]
---@param client vim.lsp.Client
---@param namespace integer
function M.mark(bufnr, ranges, client, namespace)
  local lsp = require('xacro.client')
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  for _, range in ipairs(ranges) do
    local row, from = lsp.place(bufnr, range.start, client)
    local last, to = lsp.place(bufnr, range['end'], client)
    if last > row then
      to = #vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1]
    end
    vim.api.nvim_buf_set_extmark(bufnr, namespace, row, from, { end_col = to, hl_group = 'XacroPlace', priority = 150 })
  end
end

--- Take the marks of `show_location` away.
---@param bufnr integer
function M.unmark(bufnr)
  vim.api.nvim_buf_clear_namespace(bufnr, mark, 0, -1)
end

return M
