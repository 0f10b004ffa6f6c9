-- A static scene remeshed until the estimated error of its stress is small enough: sizes that give every block the same error,
-- which is the least number of blocks for it (docs/theory.md, § 8).
local object = require "talus.object"
local places = require "talus.places"
local nearest = require "talus.nearest"
local get, given = object.get, object.given

local finest, coarsest = 1/4, 2  -- edge over the one before, in a round: rates of convergence hold for so far
local steepest = 0.3             -- growth of the edge with distance
local farthest = 1/4             -- error aimed at over that found: on a coarse mesh the estimate is too large
local margin = 0.9               -- of the wanted error, aimed at: sizes are kept by the mesher to some per cent
local near_most = 0.7            -- of max_blocks: as many as there can be, as far as the mesher goes

local function edge_of(area) return math.sqrt(4/math.sqrt(3)*area) end  -- of an equilateral triangle

-- What a round has found: for each block its place, edge, squared error and order q: that error goes with h^(2q + 2).
local function measure(sim)
  local error = sim.error
  if not error then
    places.fail(places.here(), "talus.refine: the scene has no bonded blocks whose error could be estimated")
  end
  local stress_error, area, order = sim.blocks:field "stress_error", sim.blocks:field "area", sim.blocks:field "order"
  local place, region = sim.blocks:field "centroid", sim.blocks:field "region"
  local young, blocks = {}, {}
  for b = 1, #area do
    local name = region[b]
    young[name] = young[name] or given(given(sim:region(name), "material"), "young")
    blocks[b] = { place[b][1], place[b][2], edge = edge_of(area[b]), error = stress_error[b]^2*area[b]/young[name],
                  order = math.max(order[b], 1) }
  end
  return { blocks = blocks, relative = error.relative, error = error.norm^2 }
end

-- Of the edge that gives a block the squared error `each`, over the one it has.
local function edge_ratio(block, each)
  local ratio = (each/math.max(block.error, 1e-300))^(1/(2*block.order + 2))
  return math.min(math.max(ratio, finest), coarsest)
end

-- How many blocks, and what squared error, when each has the squared error `each`.
local function forecast(blocks, each)
  local count, error = 0, 0
  for _, block in ipairs(blocks) do
    local ratio = edge_ratio(block, each)
    count, error = count + ratio^-2, error + block.error*ratio^(2*block.order)
  end
  return count, error
end

-- The largest squared error of a block for which `enough(count, error)` holds, by bisection of its logarithm.
local function share(found, enough)
  local low, high = math.log(found.error) - 80, math.log(found.error) + 10
  for _ = 1, 60 do
    local middle = (low + high)/2
    if enough(forecast(found.blocks, math.exp(middle))) then low = middle else high = middle end
  end
  return math.exp(low)
end

-- No edge longer than those beside it by more than `steepest` of the way.
local function smooth(sim, edges, blocks)
  local a, b = sim.joints:field "block_a", sim.joints:field "block_b"
  local changed = true
  while changed do
    changed = false
    for j = 1, #a do
      local p, q = blocks[a[j]], blocks[b[j]]
      local way = steepest*math.sqrt((p[1] - q[1])^2 + (p[2] - q[2])^2)
      for _, pair in ipairs { { a[j], b[j] }, { b[j], a[j] } } do
        local most = edges[pair[2]] + way
        if edges[pair[1]] > most*(1 + 1e-9) then edges[pair[1]], changed = most, true end
      end
    end
  end
end

local function sizes(sim, found, each, largest)
  local edges = {}
  for b, block in ipairs(found.blocks) do
    edges[b] = math.min(block.edge*edge_ratio(block, each), largest)
  end
  smooth(sim, edges, found.blocks)
  local at = nearest(found.blocks)
  return function(x, y) return edges[at(x, y)] end
end

local function run(options, size)
  local sim = given(options, "scene")(size)
  if type(sim) ~= "userdata" then
    places.expected({ place = object.place(options), path = "refine.scene" }, "a function(size) that returns a simulation", sim)
  end
  sim:run()
  return sim
end

local function percent(part) return ("%.3g %%"):format(100*part) end

local function refuse(options, result, why)
  local last = result.rounds[#result.rounds]
  places.fail(object.place(options), ("talus.refine: %s; %d blocks have %s after %d rounds and %.2g s"):format(why, last.blocks,
    percent(last.error), #result.rounds, result.seconds))
end

return function(fields)
  local options = object.new("refine", fields)
  local wanted, most = get(options, "error"), get(options, "max_blocks")
  local result = { rounds = {}, wanted = wanted }
  local size, started = given(options, "size"), os.clock()
  for round = 1, get(options, "rounds") do
    local sim = run(options, size)
    local found = measure(sim)
    result.sim, result.size, result.error, result.blocks, result.seconds = sim, size, found.relative, #found.blocks, os.clock() - started
    result.rounds[round] = { blocks = #found.blocks, error = found.relative, seconds = result.seconds }
    if get(options, "log") then
      print(("talus.refine: round %d, %d blocks: estimated error %s of %s, %.2g s CPU"):format(round, #found.blocks,
        percent(found.relative), percent(wanted), result.seconds))
    end
    if found.relative <= wanted then return result end
    local aim = math.max(margin*wanted, farthest*found.relative)
    local allowed = found.error*(aim/found.relative)^2*(1 - found.relative^2)/(1 - aim^2)
    local each = share(found, function(_, error) return error <= allowed end)
    local count = forecast(found.blocks, each)
    if count > most then
      if #found.blocks > near_most*most then
        refuse(options, result, ("%s of error would take about %d blocks, more than max_blocks = %d"):format(percent(wanted),
          math.ceil(count), most))
      end
      each = share(found, function(blocks) return blocks > near_most*1.15*most end)
    end
    size = sizes(sim, found, each, given(options, "size"))
  end
  refuse(options, result, ("%s of error is not reached in %d rounds"):format(percent(wanted), get(options, "rounds")))
end
