--- `gx` on an include, a mesh or a YAML file.
local lsp = require('xacro.client')

local M = {}

-- what an editor of text is no use for
local elsewhere = {
  stl = true,
  dae = true,
  obj = true,
  ply = true,
  glb = true,
  gltf = true,
  png = true,
  jpg = true,
  jpeg = true,
  tif = true,
  tiff = true,
  tga = true,
  bmp = true,
}

---@param uri string
local function open(uri)
  local path = vim.startswith(uri, 'file:') and vim.uri_to_fname(uri)
  if not path or elsewhere[(path:match('%.(%w+)$') or ''):lower()] then
    local _, problem = vim.ui.open(path or uri)
    if problem then
      lsp.show(problem, vim.log.levels.ERROR)
    end
    return
  end
  vim.cmd("normal! m'")
  vim.cmd.edit(vim.fn.fnameescape(path))
end

---@param range lsp.Range
---@param at lsp.Position
---@return boolean
local function holds(range, at)
  local function before(a, b)
    return a.line < b.line or (a.line == b.line and a.character <= b.character)
  end
  return before(range.start, at) and before(at, range['end'])
end

--- Open the link under the cursor; what is no link is opened as without us.
function M.open()
  local bufnr = vim.api.nvim_get_current_buf()
  local client = lsp.of(bufnr)
  local function otherwise()
    vim.ui.open(vim.fn.expand('<cfile>'))
  end
  if not client then
    return otherwise()
  end
  local at = lsp.cursor(0, client)
  lsp.ask(bufnr, 'textDocument/documentLink', { textDocument = lsp.document(bufnr) }, function(links)
    for _, link in ipairs(links or {}) do
      if link.target and holds(link.range, at) then
        return open(link.target)
      end
    end
    otherwise()
  end)
end

---@param bufnr integer
function M.enable(bufnr)
  vim.keymap.set('n', 'gx', M.open, { buffer = bufnr, desc = 'Open the file or URL under the cursor' })
end

return M
