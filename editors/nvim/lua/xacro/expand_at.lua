--- `:XacroExpandAt`: what the macro call, expression or include under the cursor becomes.
local lsp = require('xacro.client')

local M = {}

---@param answer { kind: string, title: string, expanded: string, instances: integer }
---@param number integer
local function show(answer, number)
  local lines = vim.split((answer.expanded:gsub('\n$', '')), '\n')
  local title = answer.title
  if answer.instances > 1 then
    title = ('%s (%d of %d)'):format(title, number, answer.instances)
  end
  local syntax = answer.kind == 'expression' and '' or 'xml'
  local _, window = vim.lsp.util.open_floating_preview(lines, syntax, {
    border = 'rounded',
    title = (' %s '):format(title),
    focus_id = 'xacro-expand-at',
    wrap = false,
    max_width = math.floor(vim.o.columns * 0.8),
    max_height = math.floor(vim.o.lines * 0.6),
  })
  vim.wo[window].conceallevel = 0
end

--- Show it in a floating window; a second time moves into the window.
---@param number? integer which instance, from 1
---@param at? { textDocument: table, position: table }
function M.open(number, at)
  local bufnr = vim.api.nvim_get_current_buf()
  local client = lsp.get_or_warn(bufnr)
  if not client then
    return
  end
  local params = vim.deepcopy(at or lsp.position_params(client)) ---@type table<string, any>
  if number and number > 0 then
    params.instance = number - 1
  end
  lsp.ask(bufnr, 'xacro/expandAt', params, function(answer)
    if not answer or answer == vim.NIL then
      lsp.show('nothing to expand here')
    elseif vim.trim(answer.expanded) == '' then
      lsp.show(('%s expands to nothing'):format(answer.title))
    else
      show(answer, math.max(number or 1, 1))
    end
  end)
end

return M
