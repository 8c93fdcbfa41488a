--- `:XacroRoot`, `:XacroArgs` and `:XacroInstance`: under which robot a file is shown.
local status = require('xacro.status')
local picks = require('xacro.picks')
local lsp = require('xacro.client')

local M = {}

---@param bufnr integer
---@param on_answer fun(roots: table, client: vim.lsp.Client)
local function ask(bufnr, on_answer)
  lsp.ask(bufnr, 'xacro/roots', { textDocument = lsp.document(bufnr) }, on_answer)
end

--- The server's own buffers, but for the one that is asked about.
---@param client vim.lsp.Client
---@param bufnr integer
---@return integer[]
local function others(client, bufnr)
  return vim.tbl_filter(function(other)
    return other ~= bufnr and vim.lsp.buf_is_attached(other, client.id) and vim.bo[other].filetype == 'xacro'
  end, vim.api.nvim_list_bufs())
end

--- Show a file and all others that the robot reaches under it, and remember that; none: automatically.
---@param bufnr integer
---@param root table|nil
local function set(bufnr, root)
  ask(bufnr, function(roots, client)
    local previous = roots.active
    picks.keep(client, root, previous)
    local params = { root = root or vim.NIL, textDocument = lsp.document(bufnr) }
    lsp.ask(bufnr, 'xacro/setRoot', params, function()
      status.ask(bufnr, function(text)
        lsp.show('root: ' .. text)
      end)
    end)
    for _, other in ipairs(others(client, bufnr)) do
      local document = lsp.document(other)
      lsp.ask(other, 'xacro/roots', { textDocument = document }, function(known)
        local is_shown = known.active and previous and known.active.uri == previous.uri
        if root and picks.reaches(known, root.uri) or not root and is_shown then
          local given = { root = root or vim.NIL, textDocument = document }
          lsp.ask(other, 'xacro/setRoot', given, function() end, true)
        end
      end, true)
    end
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
      return lsp.show(roots.reason, vim.log.levels.WARN)
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

--- The presets of the active root file: the default one, then the others in their order.
---@param roots table
---@return table[]
local function presets(roots)
  local default, named = {}, {}
  for _, candidate in ipairs(roots.candidates) do
    if candidate.uri == roots.active.uri then
      table.insert(candidate.preset and named or default, candidate)
    end
  end
  local own = vim.list_extend(default, named)
  return #own > 1 and own or {}
end

--- How long the command line waits for names.
local PATIENCE = 300

--- Presets and arguments of the robot that begin as typed, with the values that arguments have.
---@param lead string
---@return string[]
function M.complete(lead)
  local bufnr = vim.api.nvim_get_current_buf()
  local roots = lsp.ask_now(bufnr, 'xacro/roots', { textDocument = lsp.document(bufnr) }, PATIENCE)
  if not roots or not roots.active then
    return {}
  end
  local words = {}
  for _, known in ipairs(presets(roots)) do
    words[#words + 1] = known.preset or 'default'
  end
  for _, arg in ipairs(roots.args) do
    words[#words + 1] = ('%s:=%s'):format(arg.name, arg.value or '')
  end
  return vim.tbl_filter(function(word)
    return vim.startswith(word, lead)
  end, words)
end

---@param bufnr integer
---@param root table the active root
---@param arg table
---@param values? string[] that are known to be good ones
local function ask_value(bufnr, root, arg, values)
  local function typed()
    vim.ui.input({ prompt = arg.name .. ' := ', default = arg.value }, function(value)
      if value then
        set_args(bufnr, root, { [arg.name] = value })
      end
    end)
  end
  if not values or #values == 0 then
    return typed()
  end
  local other = 'another value ...'
  vim.ui.select(vim.list_extend(vim.list_slice(values), { other }), { prompt = arg.name }, function(value)
    if value == other then
      typed()
    elseif value then
      set_args(bufnr, root, { [arg.name] = value })
    end
  end)
end

---@param bufnr integer
---@param roots table
local function pick_arg(bufnr, roots)
  local given = roots.active.args or {}
  local items = vim.list_extend(presets(roots), roots.args)
  vim.ui.select(items, {
    prompt = 'Argument of ' .. shown({ uri = roots.active.uri }),
    format_item = function(item)
      if item.uri then
        return ('%spreset %s'):format(same(item, roots.active) and '● ' or '  ', item.preset or 'default')
      end
      return ('%s%s := %s'):format(given[item.name] and '● ' or '  ', item.name, item.value)
    end,
  }, function(item)
    if item and item.uri then
      set(bufnr, { uri = item.uri, args = item.args, preset = item.preset })
    elseif item then
      ask_value(bufnr, roots.active, item)
    end
  end)
end

--- Ask for the value of one argument.
---@param name string
---@param values? string[] that are known to be good ones
function M.argument(name, values)
  local bufnr = vim.api.nvim_get_current_buf()
  ask(bufnr, function(roots)
    if not roots.active then
      return lsp.show(roots.reason, vim.log.levels.WARN)
    end
    local arg = vim.iter(roots.args):find(function(known)
      return known.name == name
    end)
    ask_value(bufnr, roots.active, arg or { name = name }, values)
  end)
end

--- Words `name:=value` as a table, or the word that is none.
---@param words string[]
---@return table<string, string>? changes
---@return string? wrong
local function parse(words)
  local changes = {}
  for _, word in ipairs(words) do
    local name, value = word:match('^([%w_.-]+):=(.*)$')
    if not name then
      return nil, word
    end
    changes[name] = value
  end
  return changes
end

--- Run the robot with other arguments: `name:=value`, a preset by its name, or one that is picked. `reset` takes all
--- back.
---@param words string[]
---@param reset? boolean
function M.args(words, reset)
  local changes, wrong = parse(words)
  local bufnr = vim.api.nvim_get_current_buf()
  ask(bufnr, function(roots)
    if not roots.active then
      return lsp.show(roots.reason, vim.log.levels.WARN)
    end
    local preset = wrong
      and #words == 1
      and vim.iter(presets(roots)):find(function(known)
        return (known.preset or 'default') == wrong
      end)
    if reset then
      set(bufnr, { uri = roots.active.uri })
    elseif preset then
      set(bufnr, { uri = preset.uri, args = preset.args, preset = preset.preset })
    elseif not changes then
      lsp.show(('`%s` is not of the form name:=value, and no preset'):format(wrong), vim.log.levels.ERROR)
    elseif next(changes) then
      set_args(bufnr, roots.active, changes)
    elseif #roots.args == 0 then
      lsp.show(('`%s` has no arguments'):format(shown(roots.active)))
    else
      pick_arg(bufnr, roots)
    end
  end)
end

--- Look at the macro under the cursor as one of its calls. With `all`, as all of them.
---@param all? boolean
function M.instance(all)
  local bufnr = vim.api.nvim_get_current_buf()
  local client = lsp.get_or_warn(bufnr)
  if not client then
    return
  end
  local here = lsp.position_params(client)
  local function pin(number)
    local params = vim.tbl_extend('force', here, { instance = number or vim.NIL })
    -- the server tells what is shown then
    lsp.ask(bufnr, 'xacro/setInstance', params, function() end)
  end
  if all then
    return pin(nil)
  end
  lsp.ask(bufnr, 'xacro/toExpanded', here, function(answer)
    local items, seen = { { label = 'all calls' } }, {}
    for _, instance in ipairs(answer.instances) do
      if not seen[instance.label] then
        seen[instance.label] = true
        items[#items + 1] = { label = instance.label, number = #items - 1 }
      end
    end
    if #items == 1 then
      return lsp.show('no macro call at the cursor', vim.log.levels.WARN)
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
