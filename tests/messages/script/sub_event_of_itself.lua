-- expect: event: 'sub_event_of_itself' contains itself through its sub-events
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'sub_event_of_itself' } },
}
