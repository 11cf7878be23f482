-- expect: sub_event: next: a phase's name or lsos.done is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'Pause', next = 5 } },
}
