-- luacheck for scenes and the library: `luacheck lib examples tests`. Copy it beside scenes of your own.
std = "lua54"
max_line_length = false       -- tables of a scene are read better wide
unused_args = false           -- handlers take (sim, events) whether they need both or not
exclude_files = { "lib/meta", "build*" }
ignore = { "212", "421", "422", "423", "431", "432", "433", "581" }  -- a name taken again further in; `not (x > y)`, which is meant for NaN
