-- talus.result: a number (a text, a truth) that a scene has found out, printed and kept in run.json for whoever compares runs.
local native = require "talus.native"
local places = require "talus.places"

return function(name, value, unit)
  local place = places.here()
  if type(name) ~= "string" or not name:match("^[%a_][%w_]*$") then
    places.expected({ place = place, path = "result: name" }, "a name of letters, digits and _", name)
  end
  if type(value) ~= "number" and type(value) ~= "string" and type(value) ~= "boolean" then
    places.expected({ place = place, path = "result " .. name }, "a number, a text, true or false", value)
  end
  if unit ~= nil and type(unit) ~= "string" then
    places.expected({ place = place, path = ("result %s: unit"):format(name) }, "a text", unit)
  end
  local shown = math.type(value) == "float" and ("%.7g"):format(value) or tostring(value)
  print(("%s = %s%s"):format(name, shown, unit and " " .. unit or ""))
  native.add_result(name, value, unit or "")
end
