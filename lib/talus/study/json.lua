-- Reads JSON (RFC 8259) that Talus wrote: objects and arrays as tables, null as nil.
local escapes = { ['"'] = '"', ["\\"] = "\\", ["/"] = "/", b = "\b", f = "\f", n = "\n", r = "\r", t = "\t" }

local value_at

local function fail(at)
  error(("no JSON at byte %d"):format(at), 0)
end

local function skip(text, at)
  return text:find("[^ \t\r\n]", at) or #text + 1
end

local function unescaped(body)
  body = body:gsub("\\u(%x%x%x%x)", function(code) return utf8.char(tonumber(code, 16)) end)
  return (body:gsub("\\(.)", escapes))
end

-- From the quote at `at`: the text, and the place after it.
local function text_at(text, at)
  local from = at + 1
  while true do
    local stop = text:find('["\\]', from)
    if not stop then fail(at) end
    if text:sub(stop, stop) == '"' then return unescaped(text:sub(at + 1, stop - 1)), stop + 1 end
    from = stop + 2
  end
end

local function object_at(text, at)
  local object = {}
  at = skip(text, at + 1)
  if text:sub(at, at) == "}" then return object, at + 1 end
  while true do
    if text:sub(at, at) ~= '"' then fail(at) end
    local key
    key, at = text_at(text, at)
    at = skip(text, at)
    if text:sub(at, at) ~= ":" then fail(at) end
    object[key], at = value_at(text, skip(text, at + 1))
    at = skip(text, at)
    local mark = text:sub(at, at)
    if mark == "}" then return object, at + 1 elseif mark ~= "," then fail(at) end
    at = skip(text, at + 1)
  end
end

local function array_at(text, at)
  local array, count = {}, 0
  at = skip(text, at + 1)
  if text:sub(at, at) == "]" then return array, at + 1 end
  while true do
    count = count + 1
    array[count], at = value_at(text, at)
    at = skip(text, at)
    local mark = text:sub(at, at)
    if mark == "]" then return array, at + 1 elseif mark ~= "," then fail(at) end
    at = skip(text, at + 1)
  end
end

local words = { ["true"] = true, ["false"] = false }

function value_at(text, at)
  local mark = text:sub(at, at)
  if mark == "{" then return object_at(text, at) end
  if mark == "[" then return array_at(text, at) end
  if mark == '"' then return text_at(text, at) end
  local word = text:match("^[%w+.-]+", at)
  if not word then fail(at) end
  if word == "null" then return nil, at + 4 end
  local value = words[word]
  if value == nil then value = tonumber(word) end
  if value == nil then fail(at) end
  return value, at + #word
end

return function(text)
  local value, at = value_at(text, skip(text, 1))
  if skip(text, at) <= #text then fail(at) end
  return value
end
