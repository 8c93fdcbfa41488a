-- For `vim.lsp.config` (Neovim 0.11 and later); older ones read the same table in lua/xacro/start.lua.
return require('xacro.start').config()
