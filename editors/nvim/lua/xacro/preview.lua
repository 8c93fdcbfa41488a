--- `:XacroPreview`: the robot in three dimensions, in a browser.
local lsp = require('xacro.client')
local scratch = require('xacro.scratch')

local M = {}

--- Milliseconds that the cursor rests before the preview follows.
local REST = 80

--- Tell the server where the cursor is: the preview marks what was made there.
local function tell_cursor()
  local client = lsp.of(0)
  if client then
    local at = lsp.cursor(0, client)
    local location = { uri = lsp.document(0).uri, range = { start = at, ['end'] = at } }
    lsp.notify(client, 'xacro/preview/select', { location = location })
  end
end

local function follow_cursor()
  local moved = scratch.debounced(REST, tell_cursor)
  vim.api.nvim_create_autocmd({ 'CursorMoved', 'CursorMovedI' }, {
    group = vim.api.nvim_create_augroup('xacro_preview', {}),
    callback = function(event)
      if vim.tbl_contains(require('xacro.start').filetypes, vim.bo[event.buf].filetype) then
        moved()
      end
    end,
  })
end

--- Open the preview; with `only_say` the address is shown and put into register `+`, for a browser elsewhere.
---@param only_say? boolean
function M.open(only_say)
  local bufnr = vim.api.nvim_get_current_buf()
  lsp.command(bufnr, 'xacro.preview', { textDocument = lsp.document(bufnr) }, function(answer)
    local url = type(answer) == 'table' and answer.url
    if type(url) ~= 'string' then
      return lsp.show('the server returned no URL for the preview', vim.log.levels.ERROR)
    end
    vim.g.xacro_preview_url = url
    follow_cursor()
    local opened = not only_say and vim.ui.open(url)
    if not opened then
      pcall(vim.fn.setreg, '+', url)
      lsp.show('open this in a browser: ' .. url)
    end
  end)
end

return M
