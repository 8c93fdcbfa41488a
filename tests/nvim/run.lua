--- nvim --clean -l tests/nvim/run.lua [NAME]
--- Runs the tests whose name holds NAME with the Neovim that runs this file. Environment: XACRO_LSP, the server;
--- NVIM_PROGRAM, the starter of this Neovim where it has one.
local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h')
package.path = here .. '/?.lua;' .. package.path

local function say(...)
  io.stdout:write(table.concat({ ... }, ' '), '\n')
end

vim.env.XACRO_LSP = vim.fn.fnamemodify(assert(vim.env.XACRO_LSP, 'XACRO_LSP names no server'), ':p')
vim.env.NVIM_PROGRAM = vim.env.NVIM_PROGRAM or vim.v.progpath
vim.env.NVIM_TEST_FOLDER = vim.env.NVIM_TEST_FOLDER or vim.fn.tempname()
local Child = require('child')
local wanted = arg[1] or ''
local passed, failed, skipped = 0, 0, 0

local SKIP = {}

--- Ends a test that cannot run here, with the reason.
local function skip(reason)
  error(setmetatable({ reason = reason }, SKIP))
end

---@param options? table
---@param body fun(child: table)
---@return boolean ok
---@return any problem
local function attempt(options, body)
  local child
  local ok, problem = xpcall(function()
    child = Child.start(options)
    body(child)
  end, function(problem)
    return getmetatable(problem) == SKIP and problem or debug.traceback(problem, 2)
  end)
  if child then
    child:stop()
  end
  return ok, problem
end

---@param name string
---@param options? table
---@param body fun(child: table)
local function test(name, options, body)
  if type(options) == 'function' then
    options, body = nil, options
  end
  if not name:find(wanted, 1, true) then
    return
  end
  local begin = vim.uv.hrtime()
  local ok, problem = attempt(options, body)
  if not ok and getmetatable(problem) ~= SKIP then
    -- real programs at real speed: who fails by chance says so, who fails twice fails
    say('once more:', name, problem:sub(1, 2000))
    ok, problem = attempt(options, body)
  end
  local ms = ('(%d ms)'):format((vim.uv.hrtime() - begin) / 1e6)
  if ok then
    passed = passed + 1
    say('ok  ', name, ms)
  elseif getmetatable(problem) == SKIP then
    skipped = skipped + 1
    say('skip', name .. ':', problem.reason)
  else
    failed = failed + 1
    say('FAIL', name, ms)
    say(problem:sub(1, 4000))
  end
end

local begin = vim.uv.hrtime()
say('Neovim', tostring(vim.version()))
for _, group in ipairs({
  'beside_tests',
  'language_tests',
  'command_tests',
  'launch_tests',
  'typing_tests',
  'disk_tests',
  'install_tests',
}) do
  require(group)(test, skip)
end
say(('%d passed, %d failed, %d skipped in %.1f s'):format(passed, failed, skipped, (vim.uv.hrtime() - begin) / 1e9))
os.exit(failed == 0 and passed > 0 and 0 or 1)
