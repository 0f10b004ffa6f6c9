-- docs/performance.md and its pictures, from what scripts/bench has measured: build/bench/points.lua and run.lua.
package.path = "build/bench/?.lua;tests/bench/?.lua;" .. package.path
local talus = require "talus"
local points, run, words = require "points", require "run", require "words"
local rock = talus.material { density = 1, young = 1, poisson = 0 }
local sim = talus.simulation { regions = { talus.region { outline = talus.rect(0, 0, 1, 1), material = rock, held = true } },
                               time = { t_end = 1 }, output = { dir = "build/bench/page", vtk = false, picture = false } }
local function out(format, ...) print(select("#", ...) > 0 and format:format(...) or format) end
local function is_peer(point) return point.series:match "^CalculiX" or point.series:match "^Box2D" end
local function percent(error) return error < 1e-6 and ("%.1g"):format(error) or error > 1 and "over 100 %" or ("%.2g %%"):format(100*error) end

local cases = {}  -- name -> points, in order
for _, point in ipairs(points) do
  cases[point.case] = cases[point.case] or {}
  table.insert(cases[point.case], point)
end

-- How far a value is off, of the reference; of a curve the root mean square over its times.
local function off(value, reference)
  if type(value) == "number" then return math.abs(value/reference - 1) end
  local sum, scale = 0, 0
  for k, v in ipairs(value) do
    sum, scale = sum + (v - reference[k])^2, scale + reference[k]^2
  end
  return math.sqrt(sum/scale)
end

-- Values without a closed form: the error is against the finest run, the last of those with the most blocks; of a series "by dt" against
-- its last.
local function errors_of(list)
  local finest, last = nil, {}
  for _, point in ipairs(list) do
    if not point.series:match "by dt" and (not finest or point.blocks >= finest.blocks) then finest = point end
    last[point.series] = point
  end
  local kept = {}
  for _, point in ipairs(list) do
    local reference = point.series:match "by dt" and last[point.series] or finest
    if point.value then point.error = off(point.value, reference.value) end
    point.cpu = math.max(point.cpu, 1e-3)  -- what the clock of processes tells apart
    if point.error == point.error and not (point.value and point == reference) then kept[#kept + 1] = point end
  end
  return kept, finest
end

-- What nothing else beats in both error and time, cheapest first; of Talus alone.
local function front(list)
  local sorted, best, least = {}, {}, math.huge
  for _, point in ipairs(list) do if not is_peer(point) then sorted[#sorted + 1] = point end end
  table.sort(sorted, function(a, b) return a.cpu < b.cpu or a.cpu == b.cpu and a.error < b.error end)
  for _, point in ipairs(sorted) do
    if point.error < least then
      least = point.error
      best[#best + 1] = point
    end
  end
  return best
end

local function draw(name, list, best)
  local series, of, order = {}, {}, {}
  for _, point in ipairs(list) do
    if point.error > 1 then goto next end  -- has gone wrong altogether: in the table only
    if not of[point.series] then
      of[point.series] = { name = point.series, x = {}, y = {}, markers = true, line = true }
      order[#order + 1] = of[point.series]
    end
    table.insert(of[point.series].x, point.cpu)
    table.insert(of[point.series].y, math.max(point.error, 1e-10))
    ::next::
  end
  for _, one in ipairs(order) do series[#series + 1] = one end
  local pareto = { name = "Pareto front", x = {}, y = {}, dashed = true }
  for _, point in ipairs(best) do
    table.insert(pareto.x, point.cpu)
    table.insert(pareto.y, math.max(point.error, 1e-10))
  end
  if #best > 1 then series[#series + 1] = pareto end
  series.x_label, series.x_unit, series.y_label, series.log_x, series.log_y = "CPU", "s", "error", true, true
  sim:plot("bench_" .. name, series)
end

local function cheapest(list, error, peer)
  local found
  for _, point in ipairs(list) do
    if point.error <= error and (not not is_peer(point)) == peer and (not found or point.cpu < found.cpu) then found = point end
  end
  return found
end
local function choice(point)
  return point and ("%s, %s: %.3g s, %s"):format(point.series, point.label, point.cpu, percent(point.error)) or "–"
end

-- What the values of some series scatter by, beside which a difference between two runs means little.
local function spread(asked, list)
  local values, sum, squares = {}, 0, 0
  for _, point in ipairs(list) do
    if asked.of(point) then values[#values + 1] = point.value end
  end
  for _, value in ipairs(values) do sum = sum + value/#values end
  for _, value in ipairs(values) do squares = squares + (value - sum)^2/(#values - 1) end
  out("\n%s: %d runs, %.3g to %.3g, mean %.3g, standard deviation %.2g.", asked.what, #values, math.min(table.unpack(values)),
    math.max(table.unpack(values)), sum, math.sqrt(squares))
end

local function section(name)
  local list, finest = errors_of(cases[name])
  local best = front(list)
  draw(name, list, best)
  out("\n## %s\n\n%s", words[name].title, words[name].what)
  if list[1].value then
    local value = type(finest.value) == "table" and finest.value[#finest.value] or finest.value
    out("The finest run, with which the others are compared: %s, %s, %d blocks, %.3g s, value %.5g.", finest.series, finest.label, finest.blocks, finest.cpu, value)
  end
  out("\n![%s](pictures/bench_%s.svg)\n\n%s\n", words[name].title, name, words[name].advice)
  local headed = false
  for _, error in ipairs { 0.1, 0.01, 0.001, 1e-4 } do
    local own, other = cheapest(list, error, false), cheapest(list, error, true)
    if own or other then
      if not headed then out "| error below | the cheapest of Talus | the cheapest of the others |\n|---|---|---|" end
      headed = true
      out("| %g %% | %s | %s |", 100*error, choice(own), choice(other))
    end
  end
  if words[name].spread then spread(words[name].spread, list) end
  local shown = {}
  for _, point in ipairs(best) do shown[point] = true end
  out "\n<details><summary>All points; * on the front</summary>\n\n| series | | blocks | CPU s | error |\n|---|---|---|---|---|"
  for _, point in ipairs(list) do
    out("| %s | %s%s | %d | %.3g | %s |", point.series, point.label, shown[point] and " *" or "", point.blocks, point.cpu, percent(point.error))
  end
  out "\n</details>"
end

local function solve_of(series, label)
  for _, point in ipairs(cases.solve) do if point.series == series and point.label == label then return point end end
end
local function bounds()
  local list = errors_of(cases.cantilever)
  local function of(pattern) local kept = {} for _, p in ipairs(list) do if p.series == pattern then kept[#kept + 1] = p end end return kept end
  local first, second, quadratic = cheapest(of "order 1", 1e-3, false), cheapest(of "order 2", 1e-3, false), cheapest(of "CalculiX, order 2", 1e-3, true)
  local one, two, few = solve_of("order 1", "h 0.12"), solve_of("order 2", "h 0.12"), solve_of("order 2", "h 0.25")
  local a, b = solve_of(first.series, first.label), solve_of(second.series, second.label)
  out "\n## What was asked for\n\n| what | measured | bound | |\n|---|---|---|---|"
  local function row(what, value, unit, bound, least)
    local met = least and value >= bound or not least and value <= bound
    out("| %s | %.3g%s | %s %g%s | %s |", what, value, unit, least and "≥" or "≤", bound, unit, met and "met" or "**missed**")
  end
  row("tip to 0.1 %, assembly and solution: first order over second", (a.assembly + a.solve)/(b.assembly + b.solve), "", 20, true)
  row("tip to 0.1 %, whole process: first order over second", first.cpu/second.cpu, "", 20, true)
  row("tip to 0.1 %, whole process: second order over CalculiX's quadratic elements", second.cpu/quadratic.cpu, "", 3)
  row(("factor and solution, %d first-order blocks"):format(one.blocks), 1e3*one.solve, " ms", 15)
  row(("factor and solution, %d second-order blocks"):format(two.blocks), 1e3*two.solve, " ms", 60)
  row(("assembly, factor and solution, %d second-order blocks"):format(few.blocks), 1e3*(few.assembly + few.solve), " ms", 30)
  row("start-up to the first line of Lua, CPU", 1e3*cases.start[1].cpu, " ms", 15)
  local saved, quickest = cases.checkpoint[1], {}
  for _, sweep in ipairs(cases.sweep) do
    if not quickest[sweep.jobs] or sweep.wall < quickest[sweep.jobs].wall then quickest[sweep.jobs] = sweep end
  end
  local alone, paired = quickest[1], quickest[2]
  row(("checkpoint of %d bricks in contact, CPU"):format(saved.blocks), saved.cpu, " ms", 50)
  row("its file", saved.size, " MB", 20)
  row("eight runs in a sweep, time beyond that of the runs themselves", 100*(alone.wall/alone.runs - 1), " %", 3)
  row("the same, CPU", 100*(alone.cpu/alone.own - 1), " %", 3)
  row("eight runs two at a time on two cores over one at a time, time", alone.wall/paired.wall, "", 1.8, true)
end

local function walls()
  out("\n## %s\n\n%s\n", words.dda.title, words.dda.what)
  out "| blocks | Talus, s a step | the other, s a step |\n|---|---|---|"
  for _, point in ipairs(cases.dda) do
    local other = words.dda.measured[point.label]
    out("| %d | %.3g | %.3g |", point.blocks, point.value, other)
  end
end

out "# Performance\n"
out("Written by `scripts/bench` on %s, commit %s, one thread of: %s. Others: %s.", run.date, run.commit, run.machine, run.peers)
out("Calibration kernel (`tests/bench/kernel.cpp`): %.2f s.", run.kernel)
out(words.intro)
bounds()
for _, name in ipairs { "cantilever", "hole", "hole_stress", "brazilian", "wave", "incline", "wall", "spinner", "splitting", "blast", "pile" } do section(name) end
walls()
sim:stop()
