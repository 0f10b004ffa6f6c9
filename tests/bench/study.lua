-- Eight runs of a second or two, for what a sweep adds to them.
local talus = require "talus"
talus.study { scene = "wall.lua", parameters = { courses = { 20, 21, 22, 23, 24, 25, 26, 27 } }, collect = { steps = "steps" } }
