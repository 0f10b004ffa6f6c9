-- Units as factors to SI: 35*talus.units.GPa is 35e9 (Pa). Each: name, value, what it is.
local list = {
  { "m", 1, "metre" }, { "mm", 1e-3, "millimetre" }, { "cm", 1e-2, "centimetre" }, { "km", 1e3, "kilometre" },
  { "s", 1, "second" }, { "ms", 1e-3, "millisecond" }, { "us", 1e-6, "microsecond" }, { "min", 60, "minute" },
  { "kg", 1, "kilogram" }, { "g", 1e-3, "gram" }, { "t", 1e3, "tonne" },
  { "N", 1, "newton" }, { "kN", 1e3, "kilonewton" }, { "MN", 1e6, "meganewton" },
  { "Pa", 1, "pascal" }, { "kPa", 1e3, "kilopascal" }, { "MPa", 1e6, "megapascal" }, { "GPa", 1e9, "gigapascal" },
  { "J", 1, "joule" }, { "kJ", 1e3, "kilojoule" }, { "MJ", 1e6, "megajoule" },
  { "rad", 1, "radian" }, { "deg", math.pi/180, "degree" },
}

local units = {}
for _, unit in ipairs(list) do units[unit[1]] = unit[2] end

return { list = list, units = units }
