--- What the user chose: `vim.g.xacro`, over the defaults.
local M = {}

---@class xacro.Config
---@field cmd? string[] how the server is started
---@field autostart? boolean start the server for files of xacro and URDF
---@field settings? table the settings of the server, what is below `xacro.` elsewhere
---@field inlay_hints? boolean show values behind expressions
---@field code_lens? boolean show lines above macros and robots
---@field completion? boolean complete while typing, by Neovim itself (0.11 and later)
---@field close_tags? boolean `>` adds the end tag
---@field linked_editing? boolean start and end tag are renamed together
---@field colors? boolean show the colors of `rgba`
---@field gx? boolean `gx` opens includes, meshes and YAML files
---@field expand? xacro.ExpandConfig

---@class xacro.ExpandConfig
---@field split? string command that opens the window beside
---@field delay? integer milliseconds of rest after a keystroke before the expanded text is asked for
---@field follow? boolean the cursors of both windows follow each other

---@type xacro.Config
M.defaults = {
  cmd = { 'xacro-lsp' },
  autostart = true,
  settings = {},
  inlay_hints = true,
  code_lens = false,
  completion = false,
  close_tags = true,
  linked_editing = false,
  colors = true,
  gx = true,
  expand = { split = 'botright vertical', delay = 100, follow = true },
}

---@return xacro.Config
function M.get()
  local user = vim.g.xacro
  if type(user) == 'function' then
    user = user()
  end
  return vim.tbl_deep_extend('force', M.defaults, user or {})
end

return M
