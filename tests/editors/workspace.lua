-- nvim --clean -l workspace.lua FOLDER: the workspace of the tests, for the other editors.
package.path = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h') .. '/nvim/?.lua;' .. package.path
require('fixture').make(arg[1])
