--- `:XacroDiff`: the expanded robot of the saved files, or of a git revision, beside that of the buffers.
local scratch = require('xacro.scratch')
local lsp = require('xacro.client')

local M = {}

--- What can change a robot.
local ENDINGS = { xacro = true, urdf = true, srdf = true, sdf = true, xml = true, yaml = true, yml = true }

--- The output of git; none when it fails.
---@param folder string
---@param ... string
---@return string?
local function git(folder, ...)
  local done, run = pcall(vim.system, { 'git', '-C', folder, ... }, { text = true })
  local result = done and run:wait()
  return result and result.code == 0 and result.stdout or nil
end

--- The texts that files had in a revision, of those that differ from it now.
---@param bufnr integer
---@param revision string
---@return table<string, string>? by URI
---@return string? problem
local function texts_of(bufnr, revision)
  local folder = vim.fs.dirname(vim.api.nvim_buf_get_name(bufnr))
  local top = git(folder, 'rev-parse', '--show-toplevel')
  if not top then
    return nil, 'this file is not in a git repository'
  end
  top = vim.trim(top)
  -- what begins with a dash would be an option
  local commit = git(top, 'rev-parse', '--verify', '--quiet', '--end-of-options', revision .. '^{commit}')
  if not commit then
    return nil, ('unknown git revision `%s`'):format(revision)
  end
  commit = vim.trim(commit)
  local names = {}
  for name in (git(top, 'diff', '--name-only', '-z', commit) or ''):gmatch('[^%z]+') do
    names[name] = true
  end
  local prefix = vim.uv.fs_realpath(top) .. '/'
  for _, open in ipairs(vim.api.nvim_list_bufs()) do
    local path = vim.bo[open].modified and vim.uv.fs_realpath(vim.api.nvim_buf_get_name(open))
    if path and vim.startswith(path, prefix) then
      names[path:sub(#prefix + 1)] = true
    end
  end
  local texts = vim.empty_dict()
  for name in pairs(names) do
    local text = ENDINGS[name:match('%.(%w+)$') or ''] and git(top, 'show', commit .. ':' .. name)
    if text then
      texts[vim.uri_from_fname(top .. '/' .. name)] = text
    end
  end
  return texts
end

--- A window of the new tab page.
---@param name string
---@param urdf string
local function show(name, urdf)
  local bufnr = scratch.buffer(name, 'xacro-expanded')
  vim.bo[bufnr].syntax = 'xml'
  scratch.set_lines(bufnr, vim.split((urdf:gsub('\n$', '')), '\n'))
  vim.api.nvim_win_set_buf(0, bufnr)
  vim.keymap.set('n', 'q', '<Cmd>tabclose<CR>', { buffer = bufnr, nowait = true, desc = 'close' })
  vim.cmd.diffthis()
end

--- Show what the changes since a revision, or since the files were saved, make of the robot.
---@param revision string empty: the files on the disk
function M.open(revision)
  local source = vim.api.nvim_get_current_buf()
  if not lsp.get_or_warn(source) then
    return
  end
  local texts, problem = vim.empty_dict(), nil
  if revision ~= '' then
    texts, problem = texts_of(source, revision)
  end
  if not texts then
    return lsp.show(problem, vim.log.levels.WARN)
  end
  local document = { textDocument = lsp.document(source) }
  lsp.ask(source, 'xacro/expand', document, function(now)
    local params = vim.tbl_extend('error', document, { root = now.root, texts = texts })
    lsp.ask(source, 'xacro/expand', params, function(before)
      if not before.ok or not now.ok then
        lsp.show(
          ('%s has errors: only a part of the robot is compared'):format(
            now.ok and 'the earlier version' or 'the robot'
          ),
          vim.log.levels.WARN
        )
      end
      local stem = vim.fs.basename(vim.uri_to_fname(now.root.uri))
      vim.cmd.tabnew()
      vim.bo.bufhidden = 'wipe'
      show(('xacro-expanded://%s (%s)'):format(stem, revision == '' and 'saved' or revision), before.urdf)
      vim.cmd('rightbelow vertical new')
      vim.bo.bufhidden = 'wipe'
      show(('xacro-expanded://%s (now)'):format(stem), now.urdf)
    end)
  end)
end

return M
