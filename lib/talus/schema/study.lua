-- Studies: many runs of one scene, for `talus sweep`.
local setting = { type = "setting" }

return {
  {
    kind = "study", call = "talus.study",
    doc = "Many runs of one scene, made by `talus sweep study.lua`, see [sweeps](sweeps.md). The runs are every combination of `cases`,"
      .. " `parameters`, `sample` and `seeds`; a parameter is in one of them.",
    fields = {
      { name = "scene", type = "string", required = true, doc = "the scene's file, from the study's folder on" },
      { name = "parameters", type = "map", of = { type = "settings" },
        doc = "a grid: `{ friction = {20, 30, 40}, size = talus.range(0.1, 0.4, 4) }`, names as in the scene's `talus.param`" },
      { name = "cases", type = "list", of = { type = "map", of = setting }, count = 1,
        doc = "values that go together: `{ { width = 1, height = 2 }, { width = 2, height = 3 } }`" },
      { name = "sample", type = "object", kinds = { "latin_hypercube" }, doc = "points spread over ranges" },
      { name = "seeds", type = "any", of = { { type = "integer", least = 1, most = 100000 }, { type = "list", of = { type = "integer" }, count = 1 } },
        doc = "repetitions of every run with another seed: how many (1, 2, …), or a list of seeds; plots show their means" },
      { name = "seed_parameter", type = "string", default = "seed", doc = "the scene's parameter that takes the seed" },
      { name = "where", type = "function", default_doc = "all runs are made", doc = "`function(p)`, the parameters of a run: whether it is made" },
      { name = "order", type = "list", of = { type = "string" }, count = 1, default_doc = "by the alphabet",
        doc = "parameters as the table's columns and the plots have them: the first varies slowest in the table and is the plots' x axis" },
      { name = "collect", type = "map", of = { type = "collected" },
        doc = "columns of the table: a path in run.json (`\"energy.kinetic\"`), a table of the fields of collect, or a `function(run)`" },
      { name = "dir", type = "string", default_doc = "`out/<study>`", doc = "folder of the results" },
      { name = "title", type = "string", default_doc = "the study's name", doc = "of the results page" },
      { name = "time_limit", type = "number", above = 0, unit = "s", default_doc = "none", doc = "wall time after which a run is stopped" },
      { name = "slurm", type = "object", kinds = { "slurm" }, inline = true, default_doc = "the cluster's defaults",
        doc = "what a run asks of Slurm, with `--slurm`" },
    },
  },
  {
    kind = "collect", call = "", doc = "What a study takes from a finished run: one of run, history and value.",
    fields = {
      { name = "run", type = "string", doc = "path in run.json: `\"sizes.blocks\"`, `\"checks[1].value\"`, `\"results.x50\"`" },
      { name = "history", type = "string", doc = "column of history.csv, without its unit: `\"tip.uy\"`, `\"kinetic_energy\"`" },
      { name = "take", type = "enum", values = { "last", "first", "max", "min", "mean", "largest" }, default = "last",
        doc = "of the history; `largest`: by its absolute value" },
      { name = "at", type = "number", least = 0, unit = "s", default_doc = "take",
        doc = "the history at this time, straight between output times" },
      { name = "value", type = "function",
        doc = "`function(run)` of `run.json`, `run.history[\"tip.uy\"]`, `run.history.time`, `run.parameters`, `run:table(\"pile\")`,"
          .. " `run:simulation(2)`, `run.name`; returns a number, a text, true or false" },
      { name = "simulation", type = "integer", least = 1, default = 1, doc = "of the scene, where it makes several" },
      { name = "unit", type = "string", default_doc = "that of the history", doc = "for table and plots" },
      { name = "label", type = "string", default_doc = "the column's name", doc = "for the plots; `_` begins a subscript" },
      { name = "log", type = "boolean", default = false, doc = "logarithmic axis" },
    },
  },
  {
    kind = "latin_hypercube", call = "talus.latin_hypercube",
    doc = "n points spread over ranges: each range is cut into n equal parts, and each part has one point (McKay, Beckman & Conover 1979).",
    fields = {
      { name = "n", type = "integer", least = 1, most = 100000, required = true, doc = "how many" },
      { name = "seed", type = "integer", least = 0, most = 4294967295, default = 1, doc = "the same seed gives the same points" },
      { name = "ranges", type = "map", of = { type = "interval" }, required = true, doc = "`{ friction = {20, 40}, cohesion = {1e3, 1e6} }`" },
      { name = "log", type = "list", of = { type = "string" }, doc = "names of those that are spread over the logarithm" },
      { name = "whole", type = "list", of = { type = "string" }, doc = "names of those that take whole numbers" },
    },
  },
  {
    kind = "slurm", call = "", doc = "Resources of a run under Slurm.",
    fields = {
      { name = "time", type = "number", above = 0, unit = "s", doc = "`--time`, rounded up to minutes" },
      { name = "memory", type = "number", above = 0, unit = "MB", doc = "`--mem`" },
      { name = "cpus", type = "integer", least = 1, default = 1, doc = "`--cpus-per-task`, threads that a run may use" },
      { name = "partition", type = "string", doc = "`--partition`" },
      { name = "account", type = "string", doc = "`--account`" },
      { name = "at_once", type = "integer", least = 1, default_doc = "as many as there is room for", doc = "runs at a time" },
      { name = "extra", type = "list", of = { type = "string" }, doc = "more options of sbatch: `{ \"--qos=long\" }`" },
    },
  },
}
