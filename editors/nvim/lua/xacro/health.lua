--- `:checkhealth xacro`
local config = require('xacro.config')

local M = {}

local function check_neovim()
  vim.health.start('Neovim')
  local version = tostring(vim.version())
  if vim.fn.has('nvim-0.11') == 1 then
    vim.health.ok(version .. ': the server is started by vim.lsp.enable')
  elseif vim.fn.has('nvim-0.10') == 1 then
    vim.health.ok(version .. ': the server is started by vim.lsp.start')
  else
    vim.health.error(version .. ' is too old', { 'install Neovim 0.10 or newer' })
  end
end

local function check_server()
  vim.health.start('Server')
  local command = config.get().cmd
  local path = vim.fn.exepath(command[1])
  if path == '' then
    return vim.health.error(('`%s` is not in PATH'):format(command[1]), {
      'install it with: cargo install --locked --path . (in a checkout of xacro-lsp)',
      "or name it: vim.g.xacro = { cmd = { '/path/to/xacro-lsp' } }",
    })
  end
  local ok, run = pcall(function()
    return vim.system({ path, '--version' }, { text = true, timeout = 5000 }):wait()
  end)
  if ok and run.code == 0 then
    vim.health.ok(('%s: %s'):format(path, vim.trim(run.stdout)))
  else
    vim.health.error(path .. ' does not run', { ok and vim.trim(run.stderr) or tostring(run) })
  end
end

--- The last lines of the server's log.
local function check_log(client)
  local reply
  if vim.fn.has('nvim-0.11') == 1 then
    reply = client:request_sync('xacro/log', {}, 1000)
  else
    reply = client.request_sync('xacro/log', {}, 1000)
  end
  local lines = reply and reply.result or {}
  for index = math.max(1, #lines - 4), #lines do
    vim.health.info('log: ' .. lines[index])
  end
end

local function check_clients()
  local clients = vim.lsp.get_clients({ name = require('xacro.start').name })
  if #clients == 0 then
    return vim.health.info('not running; open a file of xacro or URDF')
  end
  for _, client in ipairs(clients) do
    local folders = vim.tbl_map(function(folder)
      return vim.uri_to_fname(folder.uri)
    end, client.workspace_folders or {})
    vim.health.ok(
      ('running for %d buffers in %s'):format(vim.tbl_count(client.attached_buffers), table.concat(folders, ', '))
    )
    for bufnr in pairs(client.attached_buffers) do
      local name = vim.fn.fnamemodify(vim.api.nvim_buf_get_name(bufnr), ':~:.')
      local text = require('xacro.status').text(bufnr)
      vim.health.info(('%s is shown under: %s'):format(name, text ~= '' and text or '(unknown yet)'))
    end
  end
  check_log(clients[1])
  local others = {}
  for _, client in ipairs(vim.lsp.get_clients()) do
    local filetypes = client.config.filetypes or {}
    if client.name ~= require('xacro.start').name and vim.tbl_contains(filetypes, 'xacro') then
      others[#others + 1] = client.name
    end
  end
  if #others > 0 then
    vim.health.warn('other servers for xacro: ' .. table.concat(others, ', '), { 'findings may be shown twice' })
  end
end

local function check_files()
  vim.health.start('Files')
  local found = vim.filetype.match({ filename = 'robot.urdf.xacro' })
  if found == 'xacro' then
    vim.health.ok('*.xacro is of filetype xacro')
  else
    vim.health.error(('*.xacro is of filetype %s'):format(found), { 'another plugin or vim.filetype.add changed it' })
  end
  if pcall(vim.treesitter.language.inspect, 'xml') then
    vim.health.ok('tree-sitter parser for XML found')
  else
    vim.health.info('no tree-sitter parser for XML; the syntax file is used')
  end
end

local function check_world()
  vim.health.start('Around')
  local sourced = vim.env.AMENT_PREFIX_PATH or vim.env.ROS_PACKAGE_PATH
  if sourced then
    vim.health.ok('a ROS environment is sourced: ' .. sourced)
  else
    vim.health.info('no ROS environment is sourced: packages are searched in the folders around a file and in /opt/ros')
  end
  for _, opener in ipairs({ 'xdg-open', 'open', 'wslview', 'explorer.exe' }) do
    if vim.fn.executable(opener) == 1 then
      return vim.health.ok(('the preview is opened by `%s`'):format(opener))
    end
  end
  vim.health.info('no program found to open a browser; :XacroPreview prints the URL')
end

function M.check()
  check_neovim()
  check_server()
  check_clients()
  check_files()
  check_world()
end

return M
