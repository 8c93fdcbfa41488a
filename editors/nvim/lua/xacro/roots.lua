--- `:XacroRoot`, `:XacroArgs` and `:XacroInstance`: under which robot a file is shown.
local status = require('xacro.status')
local talk = require('xacro.client')

local M = {}

---@param bufnr integer
---@param on_answer fun(roots: table, client: vim.lsp.Client)
local function ask(bufnr, on_answer)
  talk.ask(bufnr, 'xacro/roots', { textDocument = talk.document(bufnr) }, on_answer)
end

---@param bufnr integer
---@param root table|nil
local function set(bufnr, root)
  local params = { root = root or vim.NIL, textDocument = talk.document(bufnr) }
  talk.ask(bufnr, 'xacro/setRoot', params, function()
    status.ask(bufnr, function(text)
      talk.say('root: ' .. text)
    end)
  end)
end

---@param a table?
---@param b table?
---@return boolean
local function same(a, b)
  return a ~= nil and b ~= nil and a.uri == b.uri and a.preset == b.preset
end

---@param root table
---@return string
local function shown(root)
  local path = vim.fn.fnamemodify(vim.uri_to_fname(root.uri), ':~:.')
  local parts = { path, root.preset and ('(%s)'):format(root.preset) or '', status.args(root) }
  return table.concat(
    vim.tbl_filter(function(part)
      return part ~= ''
    end, parts),
    ' '
  )
end

--- Pick the robot of the current file. With `automatic` the server chooses again; with a path that file is the root.
---@param path? string
---@param automatic? boolean
function M.root(path, automatic)
  local bufnr = vim.api.nvim_get_current_buf()
  if automatic then
    return set(bufnr, nil)
  elseif path and path ~= '' then
    return set(bufnr, { uri = vim.uri_from_fname(vim.fn.fnamemodify(path, ':p')) })
  end
  ask(bufnr, function(roots)
    if #roots.candidates == 0 then
      return talk.say(roots.reason, vim.log.levels.WARN)
    end
    local items = vim.list_extend({ { automatic = true } }, roots.candidates)
    vim.ui.select(items, {
      prompt = 'Robot for this file',
      format_item = function(item)
        if item.automatic then
          return 'automatic'
        end
        return (same(item, roots.active) and '● ' or '  ') .. shown(item)
      end,
    }, function(item)
      if item then
        set(bufnr, not item.automatic and { uri = item.uri, args = item.args, preset = item.preset } or nil)
      end
    end)
  end)
end

---@param bufnr integer
---@param root table the active root
---@param changes table<string, string>
local function set_args(bufnr, root, changes)
  local args = vim.tbl_extend('force', root.args or {}, changes)
  set(bufnr, { uri = root.uri, preset = root.preset, args = next(args) and args or nil })
end

---@param bufnr integer
---@param roots table
local function pick_arg(bufnr, roots)
  local given = roots.active.args or {}
  vim.ui.select(roots.args, {
    prompt = 'Argument of ' .. shown({ uri = roots.active.uri }),
    format_item = function(arg)
      local mark = given[arg.name] and '● ' or '  '
      return ('%s%s := %s'):format(mark, arg.name, arg.value)
    end,
  }, function(arg)
    if not arg then
      return
    end
    vim.ui.input({ prompt = arg.name .. ' := ', default = arg.value }, function(value)
      if value then
        set_args(bufnr, roots.active, { [arg.name] = value })
      end
    end)
  end)
end

--- Run the robot with other arguments: `name:=value`, or one that is picked. `reset` takes all back.
---@param words string[]
---@param reset? boolean
function M.args(words, reset)
  local changes = {}
  for _, word in ipairs(words) do
    local name, value = word:match('^([%w_.-]+):=(.*)$')
    if not name then
      return talk.say(('`%s` is not of the form name:=value'):format(word), vim.log.levels.ERROR)
    end
    changes[name] = value
  end
  local bufnr = vim.api.nvim_get_current_buf()
  ask(bufnr, function(roots)
    if not roots.active then
      talk.say(roots.reason, vim.log.levels.WARN)
    elseif reset then
      set(bufnr, { uri = roots.active.uri })
    elseif next(changes) then
      set_args(bufnr, roots.active, changes)
    elseif #roots.args == 0 then
      talk.say(('`%s` has no arguments'):format(shown(roots.active)))
    else
      pick_arg(bufnr, roots)
    end
  end)
end

--- Look at the macro under the cursor as one of its calls. With `all`, as all of them.
---@param all? boolean
function M.instance(all)
  local bufnr = vim.api.nvim_get_current_buf()
  local client = talk.need(bufnr)
  if not client then
    return
  end
  local here = talk.here(client)
  local function pin(number)
    local params = vim.tbl_extend('force', here, { instance = number or vim.NIL })
    -- the server tells what is shown then
    talk.ask(bufnr, 'xacro/setInstance', params, function() end)
  end
  if all then
    return pin(nil)
  end
  talk.ask(bufnr, 'xacro/toExpanded', here, function(answer)
    local items, seen = { { label = 'all calls' } }, {}
    for _, instance in ipairs(answer.instances) do
      if not seen[instance.label] then
        seen[instance.label] = true
        items[#items + 1] = { label = instance.label, number = #items - 1 }
      end
    end
    if #items == 1 then
      return talk.say('no macro call at the cursor', vim.log.levels.WARN)
    end
    vim.ui.select(items, {
      prompt = 'Macro call for values',
      format_item = function(item)
        return item.label
      end,
    }, function(item)
      if item then
        pin(item.number)
      end
    end)
  end)
end

return M
