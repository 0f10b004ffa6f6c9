-- A criterion of failure and a law of what is left, written in Lua: the flattened disc breaks as with the laws of the engine.
-- Run: scripts/run examples/09_custom_law.lua    (5 s CPU)
-- Teaches: criterion and reduction of a joint as functions, and that they give the same cracks as the laws they copy.
-- Source: Ning, Yang, An & Ma (2011), eqs. 1 and 2; residual friction 35 degrees and cohesion 0.05 MPa as there.
local talus = require "talus"
local u = talus.units
local disc = require "parts.flattened_disc"

local size = talus.param("size", 3*u.mm, "triangle edge, m")

-- How far a bond's strength is used: it fails at 1. In proportion to the traction, as is best: load increments are found by it.
local function used(t)
  local tension = math.max(t.normal, 0)/t.tension
  local shear = math.max(math.abs(t.shear) + t.normal*math.tan(t.friction), 0)/t.cohesion
  return math.max(tension, shear)
end

-- What a failed bond still carries.
local function left(intact)
  return { friction = intact.friction, cohesion = 0.05*u.MPa, tension = 0 }
end

local function run(name, more)
  local body = talus.region { name = "disc", outline = disc.outline(size), material = disc.rock, mesh = { size = size },
                              joint = disc.joint(more) }
  local before = os.clock()
  local sim, seen = disc.break_up(body, { title = "Flattened disc, " .. name, output = { dir = "out/custom_law_" .. name } })
  local seconds = os.clock() - before
  local list = {}
  for _, crack in ipairs(seen.failed) do
    list[#list + 1] = string.format("%d %s %.17g %.17g", crack.joint, crack.kind, crack.time, crack.utilisation)
  end
  return table.concat(list, "; "), #seen.failed, seconds, sim:hash()
end

local residual = { friction = 35*u.deg, cohesion = 0.05*u.MPa, tension = 0 }
local built_in, count, fast = run("built_in", { residual = residual })
local own, own_count, slow = run("own", { criterion = used, reduction = left })
print(string.format("%d bonds failed; %.2f s CPU with the built-in laws, %.2f s with those in Lua", count, fast, slow))
talus.check.above("failed bonds", count, 5)
talus.check.equal("failed bonds with the laws in Lua", own_count, count)
talus.check.truth("the same bonds, order, times and utilisations, to the last bit", own == built_in)
