-- What several hard cases share: energies, block shapes, a source of numbers that is the same on every machine.
local tools = {}

tools.g = 9.81

-- Park–Miller numbers in [0, 1).
function tools.random(seed)
  local state = seed % 2147483647
  if state == 0 then state = 1 end
  return function()
    state = (state*48271) % 2147483647
    return (state - 1)/2147483646
  end
end

-- local gain = tools.gains(sim): gain(), after every step, is the most that a step has added to the total energy, of what moved and was stored before it.
function tools.gains(sim)
  local function now(energy) return energy.total, energy.kinetic + energy.strain + (energy.contact or 0) end
  local total, moving = now(sim.energy)
  local most = 0
  return function()
    local before, of = total, moving
    total, moving = now(sim.energy)
    if total > before then most = math.max(most, (total - before)/of) end
    return most
  end
end

-- Steps a simulation to its end and keeps what the checks ask for. each(sim, status) is called after every step.
function tools.watch(sim, each)
  local seen = { steps = 0, cut_steps = 0, cuts = 0, iterations = 0, most_iterations = 0, most_cuts = 0, cuts_in_row = 0, fastest = 0 }
  local row = 0
  local cpu = os.clock()
  local ok, message = pcall(function()
    for status in sim:steps() do
      seen.steps = seen.steps + 1
      seen.cuts = seen.cuts + status.cuts
      if status.cuts > 0 then seen.cut_steps = seen.cut_steps + 1 end
      row = status.cuts > 0 and row + status.cuts or 0
      seen.cuts_in_row = math.max(seen.cuts_in_row, row)
      seen.most_cuts = math.max(seen.most_cuts, status.cuts)
      seen.iterations = seen.iterations + status.iterations
      seen.most_iterations = math.max(seen.most_iterations, status.iterations)
      if each then each(sim, status) end
    end
  end)
  seen.error = not ok and tostring(message) or nil
  seen.cpu = os.clock() - cpu
  seen.mean_dt = sim.time/math.max(1, seen.steps)
  local engine = 0
  for _, seconds in pairs(sim.totals.seconds) do engine = engine + seconds end
  seen.per_step = engine/math.max(1, seen.steps)
  return seen
end

-- One line of cost, which scripts/verify puts into docs/stability.md.
function tools.cost(name, seen, blocks)
  print(string.format("COST  %s  %d blocks, %d steps, mean dt %.3g s, %.2f iterations a step (most %d), %d cuts in %d steps, %.3g ms a step, %.1f s CPU",
    name, blocks, seen.steps, seen.mean_dt, seen.iterations/math.max(1, seen.steps), seen.most_iterations, seen.cuts, seen.cut_steps,
    1e3*seen.per_step, seen.cpu))
  if seen.error then print("STOPPED  " .. name .. "  " .. seen.error) end
end

function tools.fastest(sim)
  local most = 0
  for _, v in ipairs(sim.blocks:field "speed") do most = math.max(most, v) end
  return most
end

-- Largest distance along a normal of `a` by which a convex polygon is apart from another, m; negative: none keeps them apart.
local function along_normals(a, b)
  local most = -math.huge
  for k, p in ipairs(a) do
    local q = a[k % #a + 1]
    local x, y = q[1] - p[1], q[2] - p[2]
    local least = math.huge
    for _, r in ipairs(b) do least = math.min(least, (r[1] - p[1])*y - (r[2] - p[2])*x) end
    most = math.max(most, least/math.sqrt(x*x + y*y))
  end
  return most
end

-- How far two convex polygons are apart, m; negative: how deep they overlap.
function tools.apart(a, b) return math.max(along_normals(a, b), along_normals(b, a)) end

-- Of convex blocks without bonds: the deepest overlap of two, as a part of the √area of the smaller.
function tools.overlap(sim)
  local outlines, area, fixed = sim.blocks:field "vertices", sim.blocks:field "area", sim.blocks:field "fixed"
  local boxes, order = {}, {}
  for i, outline in ipairs(outlines) do
    local box = { math.huge, math.huge, -math.huge, -math.huge }
    for _, p in ipairs(outline) do
      box = { math.min(box[1], p[1]), math.min(box[2], p[2]), math.max(box[3], p[1]), math.max(box[4], p[2]) }
    end
    boxes[i], order[i] = box, i
  end
  table.sort(order, function(i, j) return boxes[i][1] < boxes[j][1] end)
  local most = 0
  for n, i in ipairs(order) do
    for m = n + 1, #order do
      local j = order[m]
      if boxes[j][1] > boxes[i][3] then break end
      if boxes[i][2] < boxes[j][4] and boxes[j][2] < boxes[i][4] and fixed[i]*fixed[j] == 0 then
        local depth = -tools.apart(outlines[i], outlines[j])/math.sqrt(math.min(area[i], area[j]))
        most = math.max(most, depth)
      end
    end
  end
  return most
end

-- A convex polygon of `corners` corners at `at`, its size (mean diameter) `size`, corners on an ellipse of the given aspect.
function tools.stone(random, at, size, corners, aspect)
  local turn, points = 2*math.pi*random(), {}
  local c, s = math.cos(turn), math.sin(turn)
  for k = 1, corners do
    local a = 2*math.pi*(k - 1 + 0.6*(random() - 0.5))/corners
    local x, y = 0.5*size*math.cos(a), 0.5*size*math.sin(a)*(aspect or 1)
    points[k] = { at[1] + c*x - s*y, at[2] + s*x + c*y }
  end
  return points
end

return tools
