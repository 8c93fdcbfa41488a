--- Starting the server: one for all files, with a folder for each workspace.
local config = require('xacro.config')

local M = {}

M.name = 'xacro'
M.filetypes = { 'xacro', 'urdf' }
--- With those of files beside robots, and of launch files.
local ALL_FILETYPES = { 'xacro', 'urdf', 'yaml', 'python', 'xml', 'toml' }

---@param path string
---@return boolean
local function exists(path)
  return vim.uv.fs_stat(path) ~= nil
end

--- What YAML files about the controllers of a robot and its settings for MoveIt say.
local SETTINGS = {
  'ros__parameters:',
  'joint_limits:',
  'kinematics_solver:',
  'planner_configs:',
  'controller_names:',
  'controller_list:',
  'moveit_setup_assistant_config:',
}
local MOST_LINES = 2000
--- The signal by which Neovim stops servers.
local TERMINATED = 15

--- Whether a file may call robots with arguments, by its name.
---@param name string
---@return boolean
function M.is_launch(name)
  name = name:lower()
  for _, pattern in ipairs({ '%.launch$', '%.launch%.py$', '%.launch%.xml$', '%.launch%.ya?ml$', '/launch/.*%.py$' }) do
    if name:find(pattern) then
      return true
    end
  end
  return false
end

--- Whether the server has something to say about a buffer: most YAML files name no joint of a robot, and most launch files
--- call none.
---@param bufnr integer
---@return boolean
function M.concerns(bufnr)
  local name = vim.api.nvim_buf_get_name(bufnr)
  local is_launch = M.is_launch(vim.fs.normalize(name))
  if vim.tbl_contains(M.filetypes, vim.bo[bufnr].filetype) or name:find('xacro%-lint%.toml$') then
    return true
  elseif vim.bo[bufnr].filetype ~= 'yaml' and not is_launch then
    return false
  end
  for _, line in ipairs(vim.api.nvim_buf_get_lines(bufnr, 0, MOST_LINES, false)) do
    for _, word in ipairs(is_launch and { 'xacro' } or SETTINGS) do
      if line:find(word, 1, true) then
        return true
      end
    end
  end
  return false
end

--- The workspace of colcon around a folder: the one above `src` where builds have left their folders.
---@param folder string
---@return string?
local function colcon_workspace(folder)
  for parent in vim.fs.parents(folder .. '/x') do
    if vim.fs.basename(parent) == 'src' then
      local top = vim.fs.dirname(parent)
      if exists(top .. '/install') or exists(top .. '/build') or exists(top .. '/.catkin_workspace') then
        return top
      end
    end
  end
end

--- The folder that is looked through for robots that use the file.
---@param bufnr integer
---@return string
function M.root(bufnr)
  local name = vim.api.nvim_buf_get_name(bufnr)
  local folder = name == '' and vim.fn.getcwd() or vim.fs.dirname(vim.fs.normalize(name))
  return colcon_workspace(folder)
    or vim.fs.root(bufnr, '.git')
    or vim.fs.root(bufnr, { 'xacro-lint.toml', '.xacro-lint.toml' })
    or vim.fs.root(bufnr, 'package.xml')
    or folder
end

--- One server serves all folders: a robot may use packages of another one, and installed files
--- that were jumped to keep the robot they were reached from.
---@param client vim.lsp.Client
---@param wanted vim.lsp.ClientConfig
---@return boolean
local function reuse(client, wanted)
  if client.name ~= wanted.name or client.is_stopped(client) then
    return false
  end
  M.add_folder(client, wanted.root_dir)
  return true
end

---@param path string
---@param folder string
---@return boolean
local function inside(path, folder)
  return path == folder or vim.startswith(path, folder:gsub('/$', '') .. '/')
end

--- Whether a folder was installed rather than written by the user.
---@param folder string
---@return boolean
local function installed(folder)
  local prefixes = (vim.env.AMENT_PREFIX_PATH or '') .. ':/opt/ros:/usr'
  for prefix in vim.gsplit(prefixes, ':', { trimempty = true }) do
    if inside(folder, vim.fs.normalize(prefix)) then
      return true
    end
  end
  return false
end

--- Tell a running server of a further folder.
---@param client vim.lsp.Client
---@param folder? string
function M.add_folder(client, folder)
  if not folder or installed(folder) then
    return
  end
  for _, known in ipairs(client.workspace_folders or {}) do
    if inside(folder, vim.uri_to_fname(known.uri)) then
      return
    end
  end
  local added = { uri = vim.uri_from_fname(folder), name = folder }
  local params = { event = { added = { added }, removed = {} } }
  require('xacro.client').notify(client, 'workspace/didChangeWorkspaceFolders', params)
  client.workspace_folders = client.workspace_folders or {}
  table.insert(client.workspace_folders, added)
end

--- What both ways of starting have in common.
---@return vim.lsp.ClientConfig
local function common()
  local user = config.get()
  return {
    name = M.name,
    cmd = user.cmd,
    settings = { xacro = user.settings },
    -- what of the server's own protocol is known here
    init_options = { client = { contextChanged = true, lensCommands = true } },
    handlers = require('xacro.handlers').of_server(),
    commands = require('xacro.handlers').of_lenses(),
    on_exit = function(code, signal)
      -- that it has ended is said by Neovim
      if code ~= 0 or signal ~= 0 and signal ~= TERMINATED then
        vim.schedule(require('xacro.status').stopped)
      end
    end,
  }
end

--- The configuration for `vim.lsp.config`.
---@return vim.lsp.Config
function M.config()
  local found = common()
  found.filetypes = ALL_FILETYPES
  found.reuse_client = reuse
  found.root_dir = function(bufnr, use)
    if M.concerns(bufnr) then
      use(M.root(bufnr))
    end
  end
  return found
end

--- How often, and every how many milliseconds, it is asked whether a server has stopped.
local STOP_TRIES, STOP_PAUSE = 100, 30

---@param client vim.lsp.Client
local function stop(client)
  if vim.fn.has('nvim-0.11') == 1 then
    client:stop(true)
  else
    client.stop(true)
  end
end

local warned = false

---@return boolean
local function executable()
  local program = config.get().cmd[1]
  if vim.fn.executable(program) == 1 then
    return true
  end
  if not warned then
    warned = true
    vim.notify(('xacro: `%s` is not in PATH; see :checkhealth xacro'):format(program), vim.log.levels.WARN)
  end
  return false
end

--- Start the server for a buffer, or attach the running one.
---@param bufnr integer
function M.start(bufnr)
  if vim.bo[bufnr].buftype ~= '' or not M.concerns(bufnr) or not executable() then
    return
  end
  local wanted = common()
  wanted.root_dir = M.root(bufnr)
  vim.lsp.start(wanted, { bufnr = bufnr, reuse_client = reuse })
end

--- Start the server for all open files that it concerns.
local function start_all()
  if config.get().autostart and vim.lsp.enable then
    vim.lsp.enable(M.name)
    return
  end
  for _, bufnr in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(bufnr) then
      M.start(bufnr)
    end
  end
end

--- Stop the server, and start it again for all open files.
function M.restart()
  for _, client in ipairs(vim.lsp.get_clients({ name = M.name })) do
    stop(client)
  end
  local tries = 0
  local function once_stopped()
    tries = tries + 1
    if #vim.lsp.get_clients({ name = M.name }) == 0 or tries > STOP_TRIES then
      start_all()
    else
      vim.defer_fn(once_stopped, STOP_PAUSE)
    end
  end
  once_stopped()
end

--- Let opened files start the server.
function M.enable()
  if not config.get().autostart then
    return
  end
  if vim.lsp.enable then
    vim.lsp.enable(M.name)
    return
  end
  vim.api.nvim_create_autocmd('FileType', {
    group = vim.api.nvim_create_augroup('xacro_start', {}),
    pattern = ALL_FILETYPES,
    callback = function(event)
      M.start(event.buf)
    end,
  })
end

return M
