--- `>` adds the end tag and `</` completes it, on versions without vim.lsp.on_type_formatting.
local talk = require('xacro.client')

local M = {}

---@param bufnr integer
---@param typed string
local function ask(bufnr, typed)
  local client = talk.of(bufnr)
  if not client or vim.api.nvim_get_current_buf() ~= bufnr then
    return
  end
  local params = talk.here(client) ---@type table<string, any>
  params.ch = typed
  params.options = { tabSize = vim.fn.shiftwidth(), insertSpaces = vim.bo[bufnr].expandtab }
  local tick = vim.api.nvim_buf_get_changedtick(bufnr)
  local cursor = vim.api.nvim_win_get_cursor(0)
  talk.ask(bufnr, 'textDocument/onTypeFormatting', params, function(edits)
    local same = vim.api.nvim_buf_get_changedtick(bufnr) == tick and vim.api.nvim_get_current_buf() == bufnr
    if type(edits) ~= 'table' or #edits == 0 or not same then
      return
    end
    vim.lsp.util.apply_text_edits(edits, bufnr, client.offset_encoding)
    if typed == '>' then
      -- the end tag comes behind the cursor
      vim.api.nvim_win_set_cursor(0, cursor)
    else
      vim.api.nvim_win_set_cursor(0, { cursor[1], cursor[2] + #edits[1].newText })
    end
  end, true)
end

---@param client vim.lsp.Client
---@param bufnr integer
function M.enable(client, bufnr)
  if vim.lsp.on_type_formatting then
    return vim.lsp.on_type_formatting.enable(true, { client_id = client.id })
  end
  vim.api.nvim_create_autocmd('InsertCharPre', {
    group = vim.api.nvim_create_augroup('xacro_on_type_' .. bufnr, {}),
    buffer = bufnr,
    callback = function()
      local typed = vim.v.char
      if typed == '>' or typed == '/' then
        vim.schedule(function()
          ask(bufnr, typed)
        end)
      end
    end,
  })
end

return M
