-- Back-break: bonds that failed behind a line.
local object = require "talus.object"
local choice = require "talus.blast.choice"
local get, given = object.get, object.given

-- How far a place lies behind the line (m), negative before it.
local function depth_of(options)
  local line, side = given(options, "line"), get(options, "behind") == "left" and 1 or -1
  if type(line) == "number" then return function(x) return side*(line - x) end end
  local from, to = given(line, "from"), given(line, "to")
  local dx, dy = to[1] - from[1], to[2] - from[2]
  local length = math.sqrt(dx^2 + dy^2)
  return function(x, y) return side*(dx*(y - from[2]) - dy*(x - from[1]))/length end
end

-- Length of the failed bonds that lie farther behind than each of them.
local function write(sim, name, failed)
  table.sort(failed, function(a, b) return a.depth < b.depth end)
  local depths, lengths, beyond = { 0 }, {}, 0
  for i, bond in ipairs(failed) do depths[i + 1] = bond.depth end
  for i = #failed, 1, -1 do
    lengths[i + 1] = beyond
    beyond = beyond + failed[i].length
  end
  lengths[1] = beyond
  sim:table(name, { { "d [m]", depths }, { "length of failed bonds farther behind [m]", lengths } })
  sim:plot(name, { title = "Back-break", x_label = "d behind the line", x_unit = "m", y_label = "failed farther behind", y_unit = "m",
                   { x = depths, y = lengths } })
end

return function(sim, fields)
  local options = choice.options("backbreak", sim, fields)
  local names, depth = choice.regions(sim, options), depth_of(options)
  local of, area = sim.blocks:field "region", sim.blocks:field "area"
  local mode, start, length = sim.joints:field "mode", sim.joints:field "mid_start", sim.joints:field "length"
  local a, b = sim.joints:field "block_a", sim.joints:field "block_b"
  local found, failed, counted = { length = 0, tension = 0, shear = 0, area = 0, depth = 0 }, {}, {}
  for j = 1, #mode do
    local behind = mode[j] ~= "none" and (names[of[a[j]]] or names[of[b[j]]]) and depth(start[j][1], start[j][2])
    if behind and behind > 0 then
      failed[#failed + 1] = { depth = behind, length = length[j] }
      found.length, found[mode[j]] = found.length + length[j], found[mode[j]] + length[j]
      found.depth = math.max(found.depth, behind)
      for _, block in ipairs { a[j], b[j] } do
        if not counted[block] then found.area, counted[block] = found.area + area[block], true end
      end
    end
  end
  if given(options, "file") then write(sim, given(options, "file"), failed) end
  return found
end
