--- What a buffer gets when the server is attached: by Neovim where it can, by us where it cannot.
local config = require('xacro.config')

local M = {}

--- Neovim lets the server format `gq`, which it does for descriptions alone.
---@param client vim.lsp.Client
---@param bufnr integer
local function keep_gq(client, bufnr)
  for _, other in ipairs(vim.lsp.get_clients({ bufnr = bufnr, method = 'textDocument/rangeFormatting' })) do
    if other.id ~= client.id then
      return
    end
  end
  if vim.bo[bufnr].formatexpr:find('vim.lsp.formatexpr', 1, true) then
    vim.bo[bufnr].formatexpr = ''
  end
end

--- The menu that opens while one types must put nothing into the text by itself, which the default of 'completeopt' lets
--- it do. Who chose `noselect` or `noinsert` has chosen. Before 0.11 the option is that of all buffers, and is left alone.
---@param bufnr integer
local function keep_what_is_typed(bufnr)
  local words = vim.split(vim.o.completeopt, ',', { trimempty = true })
  if vim.tbl_contains(words, 'noselect') or vim.tbl_contains(words, 'noinsert') then
    return
  end
  local wanted = vim.list_extend(words, { 'menuone', 'noselect' })
  vim.bo[bufnr].completeopt = table.concat(wanted, ',')
end

--- Completion while one types, where Neovim has it.
---@param client vim.lsp.Client
---@param bufnr integer
local function complete(client, bufnr)
  if not vim.lsp.completion then
    return
  end
  keep_what_is_typed(bufnr)
  vim.lsp.completion.enable(true, client.id, bufnr, { autotrigger = true })
end

---@param client vim.lsp.Client
---@param bufnr integer
local function attached(client, bufnr)
  require('xacro.companions').attached()
  local wanted = config.get()
  if not vim.tbl_contains(require('xacro.start').filetypes, vim.bo[bufnr].filetype) then
    keep_gq(client, bufnr)
    if wanted.completion and vim.bo[bufnr].filetype ~= 'yaml' then
      complete(client, bufnr)
    end
    return
  end
  if wanted.inlay_hints then
    vim.lsp.inlay_hint.enable(true, { bufnr = bufnr })
  end
  if wanted.completion then
    complete(client, bufnr)
  end
  if wanted.code_lens then
    require('xacro.lens').enable(bufnr)
  end
  if wanted.close_tags then
    require('xacro.on_type').enable(bufnr)
  end
  if wanted.linked_editing then
    require('xacro.linked').enable(client, bufnr)
  end
  if wanted.colors then
    require('xacro.colors').enable(client, bufnr)
  end
  if wanted.gx then
    require('xacro.links').enable(bufnr)
  end
  require('xacro.status').ask(bufnr)
  require('xacro.picks').apply(bufnr)
end

function M.watch()
  vim.api.nvim_create_autocmd('LspAttach', {
    group = vim.api.nvim_create_augroup('xacro_attach', {}),
    callback = function(event)
      local client = vim.lsp.get_client_by_id(event.data.client_id)
      if client and client.name == require('xacro.start').name then
        attached(client, event.buf)
      end
    end,
  })
end

return M
