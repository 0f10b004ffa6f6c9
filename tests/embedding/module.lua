-- lua5.4 module.lua PART REPOSITORY SCRATCH: what `require "talus"` does in a Lua that is not the engine's.
local part, root, scratch = arg[1], arg[2], arg[3]
local talus = require "talus"
local beam = root .. "/examples/02_cantilever.lua"
local parts = {}

local function is(value, wanted, what)
  if value ~= wanted then error(("%s: expected %s, got %s"):format(what, wanted, value), 2) end
end

local function scene(text)
  local name = scratch .. "/scene.lua"
  local file = assert(io.open(name, "w"))
  file:write('local talus = require "talus"\n', text)
  file:close()
  return name
end

local falling = [[
local sim = talus.simulation { regions = { talus.region { name = "b", outline = talus.rect(0, 0, 1, 1),
  material = talus.material { density = 2000, young = 1e9, poisson = 0.2 } } }, gravity = { 0, -10 },
  time = { mode = "dynamic", t_end = talus.param("t_end", 0.1), dt = 0.001 }, probes = { p = { 0.5, 0.5 } } }
sim:run()
talus.result("fallen", -sim.probes.p.uy, "m")
]]

local function fails(message, ...)
  local worked, problem = pcall(talus.run, ...)
  is(worked, false, "pcall")
  if not tostring(problem):find(message, 1, true) then error(("%q has no %q"):format(tostring(problem), message), 2) end
end

-- The program beside it gives the same number, to the last digit.
function parts.cantilever()
  local result = talus.run(beam, { size = 0.12 }, { output = scratch .. "/module" })
  is(result.status, 0, "status")
  is(result.outcome, "finished", "outcome")
  is(result.folder, scratch .. "/module", "folder")
  is(result.checks[1].pass, true, result.checks[1].name)
  assert(os.execute(("%s/moved/bin/talus %s -o %s/program >%s/log 2>&1"):format(scratch, beam, scratch, scratch)))
  for line in io.lines(scratch .. "/program/run.json") do
    local hash = line:match('"state_hash": "(%x+)"')
    if hash then is(result.state_hash, hash, "state hash") end
  end
  local uy = result.history["tip.uy"]
  if math.abs(uy[#uy]/-2.845853e-4 - 1) > 0.016 then error("tip deflection " .. uy[#uy]) end
end

function parts.two_runs_in_one_process()
  local coarse, fine = talus.run(beam, { size = 0.4 }, { output = "out/a" }), talus.run(beam, { size = 0.2 }, { output = "out/b" })
  assert(coarse.sizes.blocks < fine.sizes.blocks)
  is(coarse.status, 1, "a check that fails is no error: status")
  is(coarse.checks[1].pass, false, "its check")
end

function parts.wrong_scene()
  fails("scene.lua:2: material.yuong: there is no such field", scene 'talus.material { yuong = 1 }')
  fails("scene.lua:2:", scene 'local x = nil + 1')
  is(talus.run(scene(falling)).outcome, "finished", "a run after it")
end

function parts.missing_file()
  fails("nowhere.lua", "nowhere.lua")
end

function parts.wrong_arguments()
  fails("talus.run: scene: expected the name of a file, got 3", 3)
  fails("talus.run: options: expected output, on_step, progress or trust, got \"ouput\"", beam, {}, { ouput = "x" })
  fails("talus.run: options.on_step: expected a function, got a table", beam, {}, { on_step = {} })
  fails("talus.run: parameters.size: expected a number, a text, true or false, got a table", beam, { size = {} })
  fails("has no such parameter", beam, { sise = 0.2 })
  local _, problem = pcall(function() return talus.region end)
  assert(problem:find("talus.region: expected a scene, got a program", 1, true), problem)
end

function parts.results_without_a_folder()
  local result = talus.run(scene(falling), { t_end = 0.2 })
  is(result.folder, nil, "folder")
  is(result.results.fallen.unit, "m", "unit")
  if math.abs(result.results.fallen.value - 0.2) > 1e-9 then error(result.results.fallen.value) end
end

function parts.on_step_sees_every_step()
  local seen, last = 0, nil
  talus.run(scene(falling), {}, { on_step = function(step) seen, last = seen + 1, step end })
  is(seen, 100, "steps")
  is(last.number, 100, "number")
  is(last.simulation, 1, "simulation")
  if math.abs(last.time - 0.1) > 1e-12 then error(last.time) end
end

function parts.on_step_stops()
  local result = talus.run(scene(falling), {}, { on_step = function(step) return step.number < 40 end })
  is(result.outcome, "finished", "outcome")
  if math.abs(result.end_time - 0.04) > 1e-12 then error(result.end_time) end
end

function parts.on_step_fails()
  local name = scene(falling)
  fails("module.lua", name, {}, { on_step = function() local x = nil; return x.y end })
  local mine = setmetatable({ "mine" }, {})
  local _, problem = pcall(talus.run, name, {}, { output = "out/fails", on_step = function(step)
    if step.number == 3 then error(mine) end
  end })
  is(problem, mine, "the error itself")
  for line in io.lines("out/fails/run.json") do
    if line:find '"outcome"' then assert(line:find("on_step: an error that is no text", 1, true), line) end
  end
  fails("attempt to yield", name, {}, { on_step = function() coroutine.yield() end })
  fails("stack overflow", name, {}, { on_step = function() local function f() return 1 + f() end; return f() end })
  is(coroutine.wrap(function() return talus.run(name).outcome end)(), "finished", "in a coroutine")
end

function parts.one_run_at_a_time()
  local name = scene(falling)
  fails("expected one run at a time", name, {}, { on_step = function() talus.run(name) end })
end

-- Errors in the thousands: nothing grows, and the host's garbage is collected inside its function.
function parts.many_runs()
  local name = scene(falling)
  for i = 1, 200 do
    pcall(talus.run, name, { t_end = 0.005 }, { on_step = function(step)
      collectgarbage()
      if i % 3 == 0 then error { "text" } elseif i % 3 == 1 then return step.number < 2 end
    end })
  end
end

parts[part]()
