--- The plugin from the outside.
local M = {}

--- Choose settings; the same as `vim.g.xacro = options` before the plugin is loaded.
---@param options? xacro.Config
function M.setup(options)
  vim.g.xacro = vim.tbl_deep_extend('force', vim.g.xacro or {}, options or {})
end

--- The robot that a buffer is shown under, for 'statusline'.
---@param bufnr? integer
---@return string
function M.status(bufnr)
  return require('xacro.status').text(bufnr)
end

return M
