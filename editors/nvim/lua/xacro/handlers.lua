--- What the server sends by itself, and what the lines above macros and robots run.
local M = {}

---@return table<string, lsp.Handler>
function M.of_server()
  return {
    ['xacro/contextChanged'] = function(_, params)
      require('xacro.status').set(params.textDocument.uri, params.text)
      require('xacro.hints').again(vim.uri_to_bufnr(params.textDocument.uri))
      require('xacro.expand').refresh()
      require('xacro.tree').refresh()
      require('xacro.picks').apply(vim.uri_to_bufnr(params.textDocument.uri))
    end,
    ['window/showDocument'] = M.show_document,
    ['workspace/inlayHint/refresh'] = require('xacro.hints').refresh,
  }
end

--- A click in the preview: the place is shown beside, never in the window of a made text.
---@param params lsp.ShowDocumentParams
---@param context lsp.HandlerContext
function M.show_document(_, params, context)
  local client = vim.lsp.get_client_by_id(context.client_id)
  if params.external or not client then
    return { success = params.external and vim.ui.open(params.uri) ~= nil or false }
  end
  local start = { line = 0, character = 0 }
  local range = params.selection or { start = start, ['end'] = start }
  local location = { uri = params.uri, range = range }
  local focus = params.takeFocus ~= false
  local ok = pcall(require('xacro.scratch').show_location, location, client, { focus = focus })
  return { success = ok }
end

---@param bufnr integer
---@param run fun()
local function within(bufnr, run)
  if vim.api.nvim_buf_is_valid(bufnr) then
    vim.api.nvim_buf_call(bufnr, run)
  end
end

---@param places lsp.Location[]
---@param client vim.lsp.Client
local function list(places, client)
  if #places == 1 then
    return require('xacro.scratch').show_location(places[1], client, { focus = true })
  end
  local items = vim.lsp.util.locations_to_items(places, client.offset_encoding)
  vim.fn.setqflist({}, ' ', { title = 'Calls', items = items })
  vim.cmd('botright copen')
end

--- The commands of code lenses, which run here.
---@return table<string, fun(command: lsp.Command, context: table)>
function M.of_lenses()
  return {
    ['xacro.expand'] = function()
      require('xacro.expand').open()
    end,
    ['xacro.expandAt'] = function(command)
      require('xacro.expand_at').open(nil, command.arguments[1])
    end,
    ['xacro.preview'] = function()
      require('xacro.preview').open()
    end,
    ['xacro.selectRoot'] = function()
      require('xacro.roots').root()
    end,
    ['xacro.setArgs'] = function(command, context)
      local given = (command.arguments or {})[1] or {}
      within(context.bufnr, function()
        if given.name then
          require('xacro.roots').argument(given.name, given.values)
        else
          require('xacro.roots').args({})
        end
      end)
    end,
    ['xacro.tree'] = function()
      require('xacro.tree').open()
    end,
    ['xacro.showReferences'] = function(command, context)
      local client = vim.lsp.get_client_by_id(context.client_id)
      if client then
        list(command.arguments[2] or {}, client)
      end
    end,
  }
end

return M
