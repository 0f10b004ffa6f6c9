-- Falls until it is interrupted; then it ends with status 7, which lua5.4 does not give by itself.
local talus = require "talus"
local file = assert(io.open("long.lua", "w"))
file:write [[
local talus = require "talus"
talus.simulation { regions = { talus.region { name = "b", outline = talus.rect(0, 0, 1, 1),
  material = talus.material { density = 2000, young = 1e9, poisson = 0.2 } } }, gravity = { 0, -10 },
  time = { mode = "dynamic", t_end = 1e6, dt = 0.001 } }
]]
file:close()
io.stdout:setvbuf "no"
local worked, problem = pcall(talus.run, "long.lua", {}, { on_step = function(step) if step.number == 3 then print "begun" end end })
print(worked or problem)
local _, ended = pcall(talus.run, "long.lua", {}, { on_step = function(step) return step.number < 5 end })
os.exit(type(ended) == "table" and ended.end_time < 1 and 7 or 1)
