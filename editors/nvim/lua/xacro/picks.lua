--- What the user picked: robots with their arguments. It holds for all files of a robot, and in later sessions too.
local lsp = require('xacro.client')

local M = {}

---@return string
local function file()
  return vim.fs.joinpath and vim.fs.joinpath(vim.fn.stdpath('state'), 'xacro', 'picks.json')
    or vim.fn.stdpath('state') .. '/xacro/picks.json'
end

--- The picks of all workspaces, by folder.
---@return table<string, table[]>
local function read()
  local handle = io.open(file(), 'r')
  if not handle then
    return {}
  end
  local text = handle:read('*a')
  handle:close()
  local ok, known = pcall(vim.json.decode, text)
  return ok and type(known) == 'table' and known or {}
end

---@param client vim.lsp.Client
---@return string
local function workspace(client)
  return client.root_dir or client.config.root_dir or vim.uv.cwd() or ''
end

--- Keep a pick, in place of those of the same file and of `previous`; none: forget that of `previous`.
---@param client vim.lsp.Client
---@param root? table
---@param previous? table
function M.keep(client, root, previous)
  local all = read()
  local own = vim.tbl_filter(function(pick)
    return pick.uri ~= (root or {}).uri and pick.uri ~= (previous or {}).uri
  end, all[workspace(client)] or {})
  if root then
    table.insert(own, 1, root)
  end
  all[workspace(client)] = next(own) and own or nil
  vim.fn.mkdir(vim.fs.dirname(file()), 'p')
  local handle = io.open(file(), 'w')
  if handle then
    handle:write(vim.json.encode(next(all) and all or vim.empty_dict()))
    handle:close()
  end
end

---@param roots table
---@param uri string
---@return boolean
function M.reaches(roots, uri)
  return vim.iter(roots.candidates):any(function(candidate)
    return candidate.uri == uri
  end)
end

---@param one table
---@param other? table
---@return boolean
local function same(one, other)
  return other ~= nil
    and one.uri == other.uri
    and one.preset == other.preset
    and vim.deep_equal(one.args or {}, other.args or {})
end

--- Show a buffer under the robot that was picked for it, if one was.
---@param bufnr integer
function M.apply(bufnr)
  local client = vim.api.nvim_buf_is_loaded(bufnr) and lsp.of(bufnr)
  local picks = client and read()[workspace(client)]
  if not picks then
    return
  end
  local document = lsp.document(bufnr)
  lsp.ask(bufnr, 'xacro/roots', { textDocument = document }, function(roots)
    for _, pick in ipairs(picks) do
      if M.reaches(roots, pick.uri) then
        if not same(pick, roots.active) then
          lsp.ask(bufnr, 'xacro/setRoot', { root = pick, textDocument = document }, function() end, true)
        end
        return
      end
    end
  end, true)
end

return M
