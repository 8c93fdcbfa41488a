--- Colors of `rgba`, on versions without vim.lsp.document_color.
local scratch = require('xacro.scratch')
local lsp = require('xacro.client')

local M = {}

local marks = vim.api.nvim_create_namespace('xacro_colors')

---@param color { red: number, green: number, blue: number } each from 0 to 1
---@return string highlight group
local function group_of(color)
  local function byte(part)
    return math.floor(math.min(math.max(part, 0), 1) * 255 + 0.5)
  end
  local code = ('%02x%02x%02x'):format(byte(color.red), byte(color.green), byte(color.blue))
  local group = 'XacroColor_' .. code
  vim.api.nvim_set_hl(0, group, { fg = '#' .. code })
  return group
end

---@param bufnr integer
local function show(bufnr)
  lsp.ask(bufnr, 'textDocument/documentColor', { textDocument = lsp.document(bufnr) }, function(answer, client)
    if not vim.api.nvim_buf_is_loaded(bufnr) then
      return
    end
    vim.api.nvim_buf_clear_namespace(bufnr, marks, 0, -1)
    for _, found in ipairs(answer or {}) do
      local row, column = lsp.place(bufnr, found.range.start, client)
      vim.api.nvim_buf_set_extmark(bufnr, marks, row, column, {
        virt_text = { { '■ ', group_of(found.color) } },
        virt_text_pos = 'inline',
      })
    end
  end, true)
end

---@param client vim.lsp.Client
---@param bufnr integer
function M.enable(client, bufnr)
  if vim.lsp.document_color then
    local filter = vim.fn.has('nvim-0.12') == 1 and { bufnr = bufnr, client_id = client.id } or bufnr
    return vim.lsp.document_color.enable(true, filter)
  end
  local again = scratch.debounced(200, show)
  vim.api.nvim_create_autocmd({ 'TextChanged', 'TextChangedI' }, {
    group = vim.api.nvim_create_augroup('xacro_colors_' .. bufnr, {}),
    buffer = bufnr,
    callback = function()
      again(bufnr)
    end,
  })
  show(bufnr)
end

return M
