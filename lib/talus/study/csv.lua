-- Reads the tables that a run writes: columns of numbers under a header "name [unit]" (RFC 4180).
local function cells(line)
  local list, at = {}, 1
  while at <= #line + 1 do
    if line:sub(at, at) == '"' then
      local text, from = "", at + 1
      repeat
        local stop = line:find('"', from, true) or #line + 1
        text = text .. line:sub(from, stop - 1)
        local doubled = line:sub(stop + 1, stop + 1) == '"'
        if doubled then text = text .. '"' end
        from = stop + (doubled and 2 or 1)
      until not doubled
      list[#list + 1], at = text, from + 1
    else
      local stop = line:find(",", at, true) or #line + 1
      list[#list + 1], at = line:sub(at, stop - 1), stop + 1
    end
  end
  return list
end

-- A list of columns { name, unit, values }; a cell that is no number becomes 0/0, and a last row cut short is left out.
return function(text)
  local header = text:match("^([^\n]*)\n") or ""
  local columns = {}
  for i, title in ipairs(cells(header)) do
    local name, unit = title:match("^(.*) %[(.*)%]$")
    columns[i] = { name = name or title, unit = unit or "", values = {} }
  end
  local row = 0
  for line in text:sub(#header + 2):gmatch("([^\n]*)\n") do
    row = row + 1
    local i = 0
    for cell in (line .. ","):gmatch("([^,]*),") do
      i = i + 1
      if columns[i] then columns[i].values[row] = tonumber(cell) or 0/0 end
    end
    for k = i + 1, #columns do columns[k].values[row] = 0/0 end
  end
  return columns
end
