--- Lines above macros and robots, kept up to date.
local scratch = require('xacro.scratch')

local M = {}

---@param bufnr integer
function M.enable(bufnr)
  if vim.lsp.codelens.enable then
    return vim.lsp.codelens.enable(true, { bufnr = bufnr })
  end
  local refresh = scratch.debounced(200, function()
    if vim.api.nvim_buf_is_loaded(bufnr) then
      vim.lsp.codelens.refresh({ bufnr = bufnr })
    end
  end)
  vim.api.nvim_create_autocmd({ 'TextChanged', 'InsertLeave', 'BufEnter' }, {
    group = vim.api.nvim_create_augroup('xacro_lens_' .. bufnr, {}),
    buffer = bufnr,
    callback = refresh,
  })
  refresh()
end

return M
