--- `>` adds the end tag, `</` completes it, and Enter between tags indents. vim.lsp.on_type_formatting of newer versions
--- does the same, but leaves the cursor in front of the indentation.
local lsp = require('xacro.client')

local M = {}

---@param bufnr integer
---@param typed string
local function ask(bufnr, typed)
  local client = lsp.of(bufnr)
  if not client or vim.api.nvim_get_current_buf() ~= bufnr then
    return
  end
  local params = lsp.position_params(client) ---@type table<string, any>
  params.ch = typed
  params.options = { tabSize = vim.fn.shiftwidth(), insertSpaces = vim.bo[bufnr].expandtab }
  local tick = vim.api.nvim_buf_get_changedtick(bufnr)
  local cursor = vim.api.nvim_win_get_cursor(0)
  lsp.ask(bufnr, 'textDocument/onTypeFormatting', params, function(edits)
    local same = vim.api.nvim_buf_get_changedtick(bufnr) == tick and vim.api.nvim_get_current_buf() == bufnr
    if type(edits) ~= 'table' or #edits == 0 or not same then
      return
    end
    vim.lsp.util.apply_text_edits(edits, bufnr, client.offset_encoding)
    if typed == '>' then
      -- the end tag comes behind the cursor
      vim.api.nvim_win_set_cursor(0, cursor)
    elseif typed == '/' then
      vim.api.nvim_win_set_cursor(0, { cursor[1], cursor[2] + #edits[1].newText })
    else
      local line = vim.api.nvim_buf_get_lines(bufnr, cursor[1] - 1, cursor[1], false)[1] or ''
      vim.api.nvim_win_set_cursor(0, { cursor[1], #line:match('^[ \t]*') })
    end
  end, true)
end

---@param bufnr integer
function M.enable(bufnr)
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
  -- Enter is no character that is inserted
  vim.on_key(function(_, typed)
    local mode = vim.api.nvim_get_mode()
    if typed == '\r' and mode.mode == 'i' and vim.api.nvim_get_current_buf() == bufnr then
      vim.schedule(function()
        ask(bufnr, '\n')
      end)
    end
  end, vim.api.nvim_create_namespace('xacro_on_type_' .. bufnr))
  vim.api.nvim_create_autocmd('BufUnload', {
    group = vim.api.nvim_create_augroup('xacro_on_key_' .. bufnr, {}),
    buffer = bufnr,
    callback = function()
      vim.on_key(nil, vim.api.nvim_create_namespace('xacro_on_type_' .. bufnr))
    end,
  })
end

return M
