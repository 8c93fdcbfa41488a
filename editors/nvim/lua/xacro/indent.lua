--- A file that is indented already goes on as it is, whatever the defaults of the editor are.
local M = {}

local MOST_LINES = 500
local WIDEST = 8
local USUAL = 2

--- The first step of indentation in a text; a tabulator or a number of blanks.
---@param lines string[]
---@return string?
local function first_step(lines)
  for _, line in ipairs(lines) do
    local blanks = line:match('^([ \t]+)<')
    if blanks and (blanks:sub(1, 1) == '\t' or #blanks <= WIDEST) then
      return blanks:sub(1, 1) == '\t' and '\t' or blanks
    end
  end
end

--- Set 'expandtab' and 'shiftwidth' of a buffer by its text, unless .editorconfig or somebody else has.
---@param bufnr integer
function M.detect(bufnr)
  local config = vim.b[bufnr].editorconfig
  local options = vim.bo[bufnr]
  local untouched = not options.expandtab and options.shiftwidth == 8
  if not untouched or type(config) == 'table' and (config.indent_style or config.indent_size) then
    return
  end
  local step = first_step(vim.api.nvim_buf_get_lines(bufnr, 0, MOST_LINES, false))
  if step == '\t' then
    return
  end
  options.expandtab = true
  options.shiftwidth = step and #step or USUAL
  options.softtabstop = -1
end

return M
