-- expect: event: unknown key 'phase'; did you mean 'phases'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  phase = 1,
}
