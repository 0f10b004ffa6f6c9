-- Eight runs of a second each and nearly alike, for what a sweep adds to them.
local talus = require "talus"
talus.study { scene = "wall.lua", parameters = { courses = {22}, dt = talus.range(0.0166, 0.0168, 8) }, collect = { steps = "steps" } }
