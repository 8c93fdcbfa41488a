--- `:XacroTree`: links, joints and masses of the robot.
local scratch = require('xacro.scratch')
local lsp = require('xacro.client')

local M = {}

---@class xacro.Tree
---@field bufnr integer
---@field source integer
---@field window integer
---@field places table<integer, lsp.Location> by line

---@type xacro.Tree?
local tree

--- One line for each link, below that of its parent.
---@param nodes table[]
---@return string[] lines
---@return table<integer, lsp.Location> places
local function drawn(nodes)
  local below, tops, known = {}, {}, {}
  for _, node in ipairs(nodes) do
    known[node.link] = true
  end
  for _, node in ipairs(nodes) do
    if node.parent and known[node.parent] then
      below[node.parent] = below[node.parent] or {}
      table.insert(below[node.parent], node)
    else
      table.insert(tops, node)
    end
  end
  local lines, places, seen = {}, {}, {}
  local function add(node, lead, last)
    local branch = lead and (lead .. (last and '└ ' or '├ ')) or ''
    local joint = node.joint and node.joint .. ' → ' or ''
    local mass = node.mass and ('  %.4g kg'):format(node.mass) or ''
    lines[#lines + 1] = branch .. joint .. node.link .. mass
    places[#lines] = node.location
    if seen[node.link] then
      return
    end
    seen[node.link] = true
    local children = below[node.link] or {}
    for number, child in ipairs(children) do
      add(child, lead and (lead .. (last and '  ' or '│ ')) or '', number == #children)
    end
  end
  for _, node in ipairs(tops) do
    add(node, nil, true)
  end
  return lines, places
end

---@param answer { nodes: table[], problems: table[] }
local function take(answer)
  if not tree then
    return
  end
  local lines, places = drawn(answer.nodes)
  if #lines == 0 and #answer.problems == 0 then
    lines = { 'no links' }
  end
  for number, problem in ipairs(answer.problems) do
    if number == 1 and #lines > 0 then
      lines[#lines + 1] = ''
    end
    lines[#lines + 1] = '! ' .. problem.message
    places[#lines] = problem.location
  end
  scratch.set_lines(tree.bufnr, lines)
  tree.places = places
end

--- Ask for the tree again.
function M.refresh()
  if tree and vim.api.nvim_buf_is_loaded(tree.source) then
    local params = { textDocument = lsp.document(tree.source) }
    lsp.ask(tree.source, 'xacro/tree', params, take, true)
  end
end

--- Go to the link of the line.
function M.jump()
  local client = tree and lsp.of(tree.source)
  local place = tree and tree.places[vim.api.nvim_win_get_cursor(0)[1]]
  if tree and client and place then
    scratch.show_location(place, client, { focus = true, window = tree.window })
  end
end

local function prepare()
  assert(tree)
  local bufnr = tree.bufnr
  vim.keymap.set('n', '<CR>', M.jump, { buffer = bufnr, nowait = true, desc = 'go to the link' })
  vim.keymap.set('n', 'q', function()
    vim.api.nvim_buf_delete(bufnr, { force = true })
  end, { buffer = bufnr, nowait = true, desc = 'close' })
  local group = vim.api.nvim_create_augroup('xacro_tree', {})
  local changed = scratch.debounced(300, M.refresh)
  scratch.follow(group, bufnr, { 'TextChanged', 'InsertLeave', 'BufWritePost' }, changed, function()
    tree = nil
  end)
end

--- Show the tree of the robot of the current file.
function M.open()
  local source = vim.api.nvim_get_current_buf()
  if not lsp.get_or_warn(tree and source == tree.bufnr and tree.source or source) then
    return
  end
  if not tree then
    local bufnr = scratch.buffer('xacro-tree://' .. source, 'xacro-tree')
    tree = { bufnr = bufnr, source = source, window = vim.api.nvim_get_current_win(), places = {} }
    prepare()
  elseif source ~= tree.bufnr then
    tree.source, tree.window = source, vim.api.nvim_get_current_win()
  end
  if #vim.fn.win_findbuf(tree.bufnr) == 0 then
    vim.api.nvim_win_set_width(scratch.show(tree.bufnr, 'topleft vertical'), 40)
  end
  M.refresh()
end

return M
