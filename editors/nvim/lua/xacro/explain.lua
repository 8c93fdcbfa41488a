--- `:XacroExplain`: the page of a rule.
local lsp = require('xacro.client')

local M = {}

--- The rule of the diagnostic at the cursor, or of the first one in its line.
---@return string?
local function at_cursor()
  local row, column = unpack(vim.api.nvim_win_get_cursor(0))
  local first
  for _, diagnostic in ipairs(vim.diagnostic.get(0, { lnum = row - 1 })) do
    local is_here = diagnostic.col <= column and column <= (diagnostic.end_col or diagnostic.col)
    if diagnostic.source == 'xacro' and (is_here or not first) then
      first = diagnostic.code
      if is_here then
        break
      end
    end
  end
  return first and tostring(first)
end

---@param rule? string
function M.open(rule)
  rule = rule ~= '' and rule or at_cursor()
  if not rule then
    return lsp.show('no diagnostic of xacro in this line', vim.log.levels.WARN)
  end
  lsp.command(vim.api.nvim_get_current_buf(), 'xacro.explain', { rule = rule }, function(page)
    local lines = vim.split(vim.trim(page), '\n')
    vim.lsp.util.open_floating_preview(
      lines,
      'markdown',
      { border = 'rounded', max_width = 100, focus_id = 'xacro_rule' }
    )
  end)
end

return M
