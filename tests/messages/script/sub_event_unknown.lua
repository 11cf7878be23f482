-- expect: event: phases: go: no event 'Puase'; did you mean 'Pause'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'Puase' } },
}
