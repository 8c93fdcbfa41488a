--- What a buffer gets when the server is attached: by Neovim where it can, by us where it cannot.
local config = require('xacro.config')

local M = {}

---@param client vim.lsp.Client
---@param bufnr integer
local function attached(client, bufnr)
  require('xacro.companions').attached()
  if vim.bo[bufnr].filetype == 'yaml' then
    return
  end
  local wanted = config.get()
  if wanted.inlay_hints then
    vim.lsp.inlay_hint.enable(true, { bufnr = bufnr })
  end
  if wanted.completion and vim.lsp.completion then
    vim.lsp.completion.enable(true, client.id, bufnr, { autotrigger = true })
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
