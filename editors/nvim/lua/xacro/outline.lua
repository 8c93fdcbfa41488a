--- `gO` in the expanded text: the links, joints and other elements of the robot, in the location list.
local M = {}

--- What stands directly below the robot: the printed text indents it by two.
---@param bufnr integer
---@return table[]
local function items(bufnr)
  local found = {}
  for row, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false)) do
    local tag, rest = line:match('^  <(%a[%w_:.-]*)(.*)$')
    if tag then
      local name = rest:match('%sname="([^"]*)"') or rest:match('%sreference="([^"]*)"')
      local text = name and ('%s %s'):format(tag, name) or tag
      found[#found + 1] = { bufnr = bufnr, lnum = row, col = 3, text = text }
    end
  end
  return found
end

--- Show it for the current window.
function M.open()
  vim.fn.setloclist(0, {}, ' ', { title = 'Outline', items = items(vim.api.nvim_get_current_buf()) })
  vim.cmd('lopen')
end

return M
