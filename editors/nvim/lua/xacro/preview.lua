--- `:XacroPreview`: the robot in three dimensions, in a browser.
local lsp = require('xacro.client')

local M = {}

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
    local opened = not only_say and vim.ui.open(url)
    if not opened then
      pcall(vim.fn.setreg, '+', url)
      lsp.show('open this in a browser: ' .. url)
    end
  end)
end

return M
