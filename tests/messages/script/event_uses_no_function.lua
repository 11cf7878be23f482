-- expect: event: uses: a function is wanted, found a boolean
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  uses = true,
}
