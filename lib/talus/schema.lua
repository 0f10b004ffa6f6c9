-- The one description of what a scene may say: it drives checks, defaults and the reference page.
--
-- kind      name of the object; `call` is how the script makes it ("" where a plain table is written); returns: what the call gives,
--           where that is no such object
-- field     name, type (types.lua), required or default, range (above, least, below, most), unit, doc, source
--           live: may change while a simulation runs; positional: the list part of the table
--           default_doc: what happens without the field, where that is no plain value
local schema = { kinds = {}, order = {} }

for _, part in ipairs { "materials", "shapes", "regions", "drawings", "boundaries", "charges", "run", "results", "lab", "refine", "study" } do
  for _, entry in ipairs(require("talus.schema." .. part)) do
    entry.by_name = {}
    for _, field in ipairs(entry.fields) do
      entry.by_name[field.name] = field
      entry.positional = entry.positional or field.positional
    end
    schema.kinds[entry.kind] = entry
    schema.order[#schema.order + 1] = entry.kind
  end
end

return schema
