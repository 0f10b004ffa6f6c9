-- Where in the user's script a thing was written, and the one way the library reports bad input.
local native = require "talus.native"

local places = {}

-- The line of the user's script that is being run now.
function places.here()
  local file, line = native.place()
  return { file = file or "", line = line or 0 }
end

-- Ends with one message: place, then text.
function places.fail(place, text)
  if place.file ~= "" then
    text = ("%s:%d: %s"):format(place.file, place.line, text)
  end
  native.fail(text)
end

-- `where` is a field that is being checked: { place = …, path = "material.young" }.
function places.expected(where, expected, given)
  places.fail(where.place, ("%s: expected %s, got %s"):format(where.path, expected, native.describe(given)))
end

function places.inside(where, suffix)
  return { place = where.place, path = where.path .. suffix }
end

return places
