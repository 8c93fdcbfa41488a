--- Start and end tag change together, on versions without vim.lsp.linked_editing_range.
local lsp = require('xacro.client')

local M = {}

local marks = vim.api.nvim_create_namespace('xacro_linked')

---@param bufnr integer
---@return { row: integer, from: integer, last: integer, to: integer, id: integer }[]
local function ranges(bufnr)
  local found = vim.api.nvim_buf_get_extmarks(bufnr, marks, 0, -1, { details = true })
  return vim.tbl_map(function(mark)
    return { id = mark[1], row = mark[2], from = mark[3], last = mark[4].end_row, to = mark[4].end_col }
  end, found)
end

---@param range { row: integer, from: integer, to: integer }
---@return boolean
local function has_cursor(range)
  local row, column = unpack(vim.api.nvim_win_get_cursor(0))
  return range.row == row - 1 and range.from <= column and column <= range.to
end

---@param bufnr integer
---@param range { row: integer, from: integer, last: integer, to: integer }
---@return string
local function text(bufnr, range)
  return table.concat(vim.api.nvim_buf_get_text(bufnr, range.row, range.from, range.last, range.to, {}), '\n')
end

---@param bufnr integer
local function forget(bufnr)
  vim.api.nvim_buf_clear_namespace(bufnr, marks, 0, -1)
end

--- The tag under the cursor was changed: change the other one.
---@param bufnr integer
local function changed(bufnr)
  local both = ranges(bufnr)
  local mine = vim.iter(both):find(has_cursor)
  if not mine then
    return forget(bufnr)
  end
  local name = text(bufnr, mine)
  if name:find('[^%w_:.-]') then
    return forget(bufnr)
  end
  for _, other in ipairs(both) do
    if other.id ~= mine.id and text(bufnr, other) ~= name then
      pcall(vim.cmd.undojoin)
      vim.api.nvim_buf_set_text(bufnr, other.row, other.from, other.last, other.to, { name })
    end
  end
end

--- Ask for the other tag, when the cursor is in the name of one.
---@param bufnr integer
local function look(bufnr)
  if vim.iter(ranges(bufnr)):any(has_cursor) then
    return
  end
  forget(bufnr)
  local before = vim.api.nvim_get_current_line():sub(1, vim.api.nvim_win_get_cursor(0)[2] + 1)
  local client = lsp.of(bufnr)
  if not client or not before:find('</?[%w_:.-]*$') then
    return
  end
  local tick = vim.api.nvim_buf_get_changedtick(bufnr)
  lsp.ask(bufnr, 'textDocument/linkedEditingRange', lsp.position_params(client), function(answer)
    if type(answer) ~= 'table' or not answer.ranges or vim.api.nvim_buf_get_changedtick(bufnr) ~= tick then
      return
    end
    forget(bufnr)
    for _, range in ipairs(answer.ranges) do
      local row, from = lsp.place(bufnr, range.start, client)
      local last, to = lsp.place(bufnr, range['end'], client)
      vim.api.nvim_buf_set_extmark(bufnr, marks, row, from, {
        end_row = last,
        end_col = to,
        right_gravity = false,
        end_right_gravity = true,
      })
    end
  end, true)
end

---@param client vim.lsp.Client
---@param bufnr integer
function M.enable(client, bufnr)
  if vim.lsp.linked_editing_range then
    return vim.lsp.linked_editing_range.enable(true, { client_id = client.id })
  end
  local group = vim.api.nvim_create_augroup('xacro_linked_' .. bufnr, {})
  local function on(events, run)
    vim.api.nvim_create_autocmd(events, {
      group = group,
      buffer = bufnr,
      callback = function()
        run(bufnr)
      end,
    })
  end
  on({ 'TextChanged', 'TextChangedI', 'TextChangedP' }, changed)
  on({ 'CursorMoved', 'CursorMovedI' }, look)
end

return M
