-- expect: sub_event: 'event' is missing
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { next = lsos.done } },
}
