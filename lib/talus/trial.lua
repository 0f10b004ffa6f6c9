-- Laws are tried when they are declared, twice alike: one that answers differently depends on something else than its
-- arguments.
local trial = {}

function trial.finite(value)
  return math.type(value) and value == value and value > -math.huge and value < math.huge
end

-- Both answers of the law; a law that fails is answered by `bad`. `given`: what it was asked, in words.
function trial.twice(law, field, given, bad, ...)
  local worked, first = pcall(law, ...)
  if not worked then bad(field, "a function that works " .. given, tostring(first)) end
  local _, second = pcall(law, ...)
  return first, second
end

return trial
