--- Inlay hints whose values changed though the text did not.
---
--- Neovim draws new hints of an unchanged text only if nothing was drawn while it waited for them.
local M = {}

--- Have the hints of a buffer made again.
---@param bufnr integer
function M.again(bufnr)
  if vim.api.nvim_buf_is_loaded(bufnr) and vim.lsp.inlay_hint.is_enabled({ bufnr = bufnr }) then
    vim.lsp.inlay_hint.enable(false, { bufnr = bufnr })
    vim.lsp.inlay_hint.enable(true, { bufnr = bufnr })
  end
end

--- For `workspace/inlayHint/refresh`: the buffer that is edited asks by itself.
---@param context lsp.HandlerContext
function M.refresh(_, _, context)
  local client = vim.lsp.get_client_by_id(context.client_id)
  for bufnr in pairs(client and client.attached_buffers or {}) do
    if bufnr ~= vim.api.nvim_get_current_buf() and #vim.fn.win_findbuf(bufnr) > 0 then
      M.again(bufnr)
    end
  end
  return vim.NIL
end

return M
