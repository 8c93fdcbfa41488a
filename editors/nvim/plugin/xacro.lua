if vim.g.loaded_xacro then
  return
end
vim.g.loaded_xacro = true

if vim.fn.has('nvim-0.10') == 0 then
  vim.notify('xacro: requires Neovim 0.10 or newer', vim.log.levels.WARN)
  return
end

vim.treesitter.language.register('xml', { 'xacro', 'urdf' })
require('xacro.commands').define()
require('xacro.attach').watch()
require('xacro.companions').watch()
require('xacro.start').enable()
