-- Profiles: what fields of `numerics` and of `joint` that a scene leaves out are taken to be, in place of the
-- defaults of the schema.
local object = require "talus.object"

local profiles = {
  {
    name = "default", doc = "The best we know: the defaults of the tables on this page.",
    numerics = {}, joint = {},
  },
  {
    name = "ning2011",
    doc = "The choices of Ning, Yang, An & Ma (2011): DDA's own integrator, and springs of fixed stiffness at "
      .. "contacts and at the ends of bonds, also for a joint that says nothing else. E is that of the region's "
      .. "material, between regions that of the softest one, when the simulation is put together. (Unlike the paper, "
      .. "no step is accepted before its contacts have converged.)",
    numerics = { integrator = "newmark", dynamic_parameter = 1 },
    joint = { bond = "spring", stiffness = object.new("stiffness", { per = "contact", times_young = 40 }),
              shear_ratio = 1/2.5 },
  },
}

local presets, by_name = {}, {}
for _, profile in ipairs(profiles) do
  by_name[profile.name] = profile
  presets[profile.name] = object.new("numerics", { profile = profile.name })
end

local function read(self, name, choices)
  local value = object.given(self, name)
  if value == nil then value = choices[name] end
  if value == nil then value = object.get(self, name) end
  return value
end

local function numerics_value(numerics, name)
  return read(numerics, name, by_name[object.get(numerics, "profile")].numerics)
end

local function joint_value(joint, name, profile)
  return read(joint, name, profile.joint)
end

return { list = profiles, presets = presets, by_name = by_name, numerics_value = numerics_value,
         joint_value = joint_value }
