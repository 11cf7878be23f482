-- expect: event: params: speed_mps: lsos.number {...} or another field is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { speed_mps = 5 },
}
