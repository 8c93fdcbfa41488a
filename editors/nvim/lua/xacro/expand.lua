--- `:XacroExpand`: the expanded robot beside its source, both ways in step.
local config = require('xacro.config')
local scratch = require('xacro.scratch')
local lsp = require('xacro.client')

local M = {}

---@class xacro.View
---@field bufnr integer the expanded text
---@field source integer the buffer whose robot is shown
---@field window integer where sources are shown
---@field root? { uri: string, preset?: string, args?: table<string, string> }
---@field fresh boolean whether the text is that of the present sources
---@field shown boolean whether there is a text yet
---@field errors table[]
---@field way string from the line under the cursor to the calls that made it
---@field cancel? fun() the question under way
---@field cancel_cursor? fun()

---@type xacro.View?
local view
local marks = vim.api.nvim_create_namespace('xacro_instances')

---@param uri string
---@return string
local function base(uri)
  return vim.fs.basename(vim.uri_to_fname(uri))
end

--- Cut a text to a width, as 'winbar' would do at the wrong end.
---@param text string
---@param width integer
---@return string
local function cut(text, width)
  if vim.fn.strdisplaywidth(text) > width then
    text = vim.fn.strcharpart(text, 0, math.max(width - 1, 0)) .. '…'
  end
  return scratch.escaped(text)
end

--- The line above the expanded text: the robot, or what keeps the text from being up to date.
---@param shown xacro.View
---@param width integer
---@return string
local function banner(shown, width)
  if not shown.root then
    return 'expanding'
  end
  if shown.fresh then
    local title = vim.trim(base(shown.root.uri) .. ' ' .. require('xacro.status').args(shown.root))
    local left = cut(title, width - vim.fn.strdisplaywidth(shown.way) - 3)
    return ('%%#XacroTitle# %s %%*%%=%s '):format(left, scratch.escaped(shown.way))
  end
  local first = shown.errors[1]
  local why = 'no answer'
  if first then
    local line = first.location.range.start.line + 1
    local more = #shown.errors > 1 and (' (and %d more)'):format(#shown.errors - 1) or ''
    why = ('%s:%d: %s%s'):format(base(first.location.uri), line, first.message, more)
  end
  local what = shown.shown and 'last valid text' or 'incomplete'
  return ('%%#XacroBanner# %s '):format(cut(what .. ': ' .. why, width - 2))
end

local function show_banner()
  if view then
    for _, window in ipairs(vim.fn.win_findbuf(view.bufnr)) do
      vim.wo[window].winbar = banner(view, vim.api.nvim_win_get_width(window))
    end
  end
end

---@param answer { ok: boolean, urdf: string, root: table, errors: table[] }
local function take(answer)
  if not view then
    return
  end
  local same = view.root and view.root.uri == answer.root.uri
  view.root, view.errors = answer.root, answer.errors
  view.fresh = answer.ok
  if not same then
    pcall(vim.api.nvim_buf_set_name, view.bufnr, 'xacro-expanded://' .. base(answer.root.uri))
  end
  if answer.ok or not view.shown or not same then
    scratch.set_lines(view.bufnr, vim.split((answer.urdf:gsub('\n$', '')), '\n'))
    view.shown = answer.ok
  end
  if not answer.ok then
    vim.api.nvim_buf_clear_namespace(view.bufnr, marks, 0, -1)
  end
  show_banner()
  vim.api.nvim_exec_autocmds('User', { pattern = 'XacroExpanded', modeline = false })
end

--- Ask for the text again.
function M.refresh()
  if not view then
    return
  end
  if not vim.api.nvim_buf_is_loaded(view.source) then
    return
  end
  if view.cancel then
    view.cancel()
  end
  local params = { textDocument = lsp.document(view.source) }
  view.cancel = lsp.ask(view.source, 'xacro/expand', params, function(answer)
    if view then
      view.cancel = nil
      take(answer)
      if vim.bo.buftype == '' then
        M.from_source()
      end
    end
  end, view.root ~= nil)
end

--- Move the cursor of the window with the expanded text, unless it is at one of the places already.
---@param shown xacro.View
---@param ranges lsp.Range[]
---@param client vim.lsp.Client
local function move_to(shown, ranges, client)
  for _, window in ipairs(vim.fn.win_findbuf(shown.bufnr)) do
    local now = vim.api.nvim_win_get_cursor(window)[1] - 1
    local best
    for _, range in ipairs(ranges) do
      if not best or math.abs(range.start.line - now) < math.abs(best.start.line - now) then
        best = range
      end
    end
    local row, column = lsp.place(shown.bufnr, best.start, client)
    vim.api.nvim_win_set_cursor(window, { row + 1, column })
    vim.api.nvim_win_call(window, function()
      if row + 1 < vim.fn.line('w0') or row + 1 > vim.fn.line('w$') then
        vim.cmd('normal! zz')
      end
    end)
  end
end

--- The tag of the line, for cursors in front of it or between its attributes.
---@param client vim.lsp.Client
---@return { textDocument: { uri: string }, position: lsp.Position }?
local function tag_of_line(client)
  local before = vim.api.nvim_get_current_line():match('^(.-<)[%a]')
  local place = lsp.position_params(client)
  if before then
    place.position.character = lsp.units(before, #before, client)
    return place
  end
end

--- Show what a place of a source made.
---@param shown xacro.View
---@param instances { range: lsp.Range, label: string }[]
---@param client vim.lsp.Client
local function show_instances(shown, instances, client)
  local ranges, labels = {}, {}
  for _, instance in ipairs(instances) do
    ranges[#ranges + 1] = instance.range
    labels[#labels + 1] = instance.label
  end
  scratch.mark(shown.bufnr, ranges, client, marks)
  shown.way = #labels == 1 and labels[1] or #labels > 1 and ('%d instances'):format(#labels) or ''
  show_banner()
  if #ranges > 0 then
    move_to(shown, ranges, client)
  end
end

---@param shown xacro.View
---@param bufnr integer
---@param client vim.lsp.Client
---@param place { textDocument: { uri: string }, position: lsp.Position }
---@param otherwise? { textDocument: { uri: string }, position: lsp.Position } asked when the first made nothing
local function ask_instances(shown, bufnr, client, place, otherwise)
  -- under the robot that is shown, whichever the file is shown under elsewhere
  local active = shown.root
  local args = active.args and next(active.args) and active.args or vim.empty_dict()
  local root = { uri = active.uri, preset = active.preset, args = args }
  local params = vim.tbl_extend('error', place, { root = root })
  shown.cancel_cursor = lsp.ask(bufnr, 'xacro/toExpanded', params, function(answer)
    if view ~= shown or not shown.fresh then
      return
    end
    shown.cancel_cursor = nil
    if answer.root.uri ~= shown.root.uri then
      return
    elseif #answer.instances == 0 and otherwise then
      return ask_instances(shown, bufnr, client, otherwise)
    end
    show_instances(shown, answer.instances, client)
  end, true)
end

--- The cursor of a source moved: show what it made.
function M.from_source()
  local bufnr = vim.api.nvim_get_current_buf()
  local client = view and lsp.of(bufnr)
  if not view or not client or not view.fresh or bufnr == view.bufnr then
    return
  end
  view.window = vim.api.nvim_get_current_win()
  if view.cancel_cursor then
    view.cancel_cursor()
  end
  scratch.unmark(bufnr)
  ask_instances(view, bufnr, client, lsp.position_params(client), tag_of_line(client))
end

---@param on_places fun(places: table[], client: vim.lsp.Client)
local function places_of_cursor(on_places)
  local client = view and lsp.of(view.source)
  if not view or not client then
    return
  end
  if view.cancel_cursor then
    view.cancel_cursor()
  end
  local params = { root = lsp.document(view.source).uri, position = lsp.cursor(0, client) }
  view.cancel_cursor = lsp.ask(view.source, 'xacro/toSource', params, function(answer)
    if view then
      view.cancel_cursor = nil
      on_places(answer.locations, client)
    end
  end, true)
end

--- The cursor of the expanded text moved: show where the text comes from.
function M.from_expanded()
  if not view or not view.fresh then
    return
  end
  places_of_cursor(function(places, client)
    if not view or #places == 0 or vim.api.nvim_get_current_buf() ~= view.bufnr then
      return
    end
    local way = vim.tbl_map(function(place)
      return ('%s:%d'):format(base(place.uri), place.range.start.line + 1)
    end, places)
    view.way = table.concat(way, ' ← ')
    show_banner()
    scratch.show_location(places[1], client, { window = view.window })
  end)
end

--- Whether the shown text is that of the source as it is now; if not, the user is told.
---@return boolean
local function is_current()
  if view and not view.fresh then
    lsp.show('the text is out of date; fix the error first', vim.log.levels.WARN)
  end
  return view ~= nil and view.fresh
end

--- Go to the source of the line, or to the call that made it.
---@param role 'origin'|'call'
function M.jump(role)
  if not is_current() then
    return
  end
  places_of_cursor(function(places, client)
    for _, place in ipairs(places) do
      if place.role == role then
        scratch.show_location(place, client, { focus = true, window = view and view.window })
        return
      end
    end
    lsp.show(role == 'call' and 'no macro call for this text' or 'no source for this text')
  end)
end

--- The line of a source that a place is in.
---@param place { uri: string, range: lsp.Range }
---@return string
local function line_of(place)
  local path, row = vim.uri_to_fname(place.uri), place.range.start.line
  local bufnr = vim.fn.bufnr('^' .. vim.fn.fnameescape(path) .. '$')
  if bufnr > 0 and vim.api.nvim_buf_is_loaded(bufnr) then
    return vim.api.nvim_buf_get_lines(bufnr, row, row + 1, false)[1] or ''
  end
  local ok, lines = pcall(vim.fn.readfile, path, '', row + 1)
  return ok and lines[row + 1] or ''
end

--- Say where the text under the cursor comes from: its source, then the calls and includes that led there.
function M.hover()
  if not is_current() then
    return
  end
  places_of_cursor(function(places)
    if #places == 0 then
      lsp.show('no source for this text')
      return
    end
    local lines = {}
    for number, place in ipairs(places) do
      local at = ('%s:%d'):format(base(place.uri), place.range.start.line + 1)
      lines[#lines + 1] = (number == 1 and '' or '← ') .. at
      lines[#lines + 1] = '    ' .. vim.trim(line_of(place))
    end
    vim.lsp.util.open_floating_preview(lines, '', { border = 'rounded', focus_id = 'xacro-origin', wrap = false })
  end)
end

--- Close the window with the expanded text.
function M.close()
  if view then
    vim.api.nvim_buf_delete(view.bufnr, { force = true })
  end
end

--- Give the buffer of the expanded text its keys, and follow cursors and changes.
---@param shown xacro.View
local function prepare(shown)
  local bufnr = shown.bufnr
  vim.bo[bufnr].syntax = 'xml'
  pcall(vim.treesitter.start, bufnr, 'xml')
  local function map(key, run, what)
    vim.keymap.set('n', key, run, { buffer = bufnr, nowait = true, desc = what })
  end
  map('<CR>', function()
    M.jump('origin')
  end, 'go to the source')
  map('gd', function()
    M.jump('origin')
  end, 'go to the source')
  map('gC', function()
    M.jump('call')
  end, 'go to the macro call')
  map('K', M.hover, 'say where the text comes from')
  map('gO', function()
    require('xacro.outline').open()
  end, 'list links and joints')
  map('q', M.close, 'close')
  local group = vim.api.nvim_create_augroup('xacro_expand', {})
  local follow = config.get().expand.follow
  if follow then
    vim.api.nvim_create_autocmd('CursorMoved', { group = group, buffer = bufnr, callback = M.from_expanded })
    vim.api.nvim_create_autocmd({ 'CursorMoved', 'CursorMovedI' }, {
      group = group,
      callback = function(event)
        if vim.tbl_contains(require('xacro.start').filetypes, vim.bo[event.buf].filetype) then
          M.from_source()
        end
      end,
    })
  end
  local changed = scratch.debounced(config.get().expand.delay, M.refresh)
  scratch.follow(group, bufnr, { 'TextChanged', 'TextChangedI', 'TextChangedP', 'BufWritePost' }, changed, function()
    view = nil
  end)
end

--- Show the robot of the current file.
function M.open()
  local source = vim.api.nvim_get_current_buf()
  if view and source == view.bufnr then
    return M.refresh()
  end
  if not lsp.get_or_warn(source) then
    return
  end
  if not view then
    local bufnr = scratch.buffer('xacro-expanded://' .. source, 'xacro-expanded')
    view = {
      bufnr = bufnr,
      source = source,
      window = vim.api.nvim_get_current_win(),
      fresh = false,
      shown = false,
      errors = {},
      way = '',
    }
    prepare(view)
  end
  view.source, view.window = source, vim.api.nvim_get_current_win()
  if #vim.fn.win_findbuf(view.bufnr) == 0 then
    scratch.show(view.bufnr, config.get().expand.split)
  end
  show_banner()
  M.refresh()
end

--- What is shown, for other parts and for tests.
---@return xacro.View?
function M.view()
  return view
end

return M
