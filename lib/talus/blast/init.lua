-- What a blasting engineer asks of a run: talus.blast.
local fragmentation = require "talus.blast.fragmentation"

return {
  fragmentation = fragmentation.of_run,
  distribution = fragmentation.of_sizes,
  pile = require "talus.blast.pile",
  vibration = require "talus.blast.vibration",
  backbreak = require "talus.blast.backbreak",
}
