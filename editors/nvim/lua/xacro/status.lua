--- Under which robot each file is shown, for the status line.
local lsp = require('xacro.client')

local M = {}

---@type table<string, string>
local texts = {}

--- The arguments of a root: `side:=right sim:=true`.
---@param root { args?: table<string, string> }
---@return string
function M.args(root)
  local parts = {}
  for name, value in vim.spairs(root.args or {}) do
    parts[#parts + 1] = ('%s:=%s'):format(name, value)
  end
  return table.concat(parts, ' ')
end

---@param uri string
---@param text string
function M.set(uri, text)
  texts[uri] = text
  vim.cmd.redrawstatus({ bang = true })
  local data = { uri = uri, text = text }
  vim.api.nvim_exec_autocmds('User', { pattern = 'XacroContextChanged', modeline = false, data = data })
end

--- The robot of a buffer, or an empty string: for 'statusline'.
---@param bufnr? integer
---@return string
function M.text(bufnr)
  return texts[vim.uri_from_bufnr(bufnr or vim.api.nvim_get_current_buf())] or ''
end

--- What is shown where the server has ended although nobody stopped it.
local STOPPED = 'server stopped, see :XacroRestart'

--- The server has ended by itself: what it said of the files holds no more.
function M.stopped()
  for uri in pairs(texts) do
    M.set(uri, STOPPED)
  end
end

--- Ask the server, which tells of changes only.
---@param bufnr integer
---@param on_text? fun(text: string)
function M.ask(bufnr, on_text)
  local document = lsp.document(bufnr)
  lsp.ask(bufnr, 'xacro/roots', { textDocument = document }, function(roots)
    M.set(document.uri, roots.text)
    if on_text then
      on_text(roots.text)
    end
  end, true)
end

return M
