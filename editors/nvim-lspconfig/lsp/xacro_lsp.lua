---@brief
---
--- xacro-lsp, the language server for xacro and URDF.
---
--- It expects the filetypes `xacro` and `urdf`, which Neovim does not set by itself:
---
--- ```lua
--- vim.filetype.add({ extension = { xacro = 'xacro', urdf = 'urdf' } })
--- ```

---@type vim.lsp.Config
return {
  cmd = { 'xacro-lsp' },
  filetypes = { 'xacro', 'urdf' },
  root_markers = { 'xacro-lint.toml', '.git', 'package.xml' },
}
