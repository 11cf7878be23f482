-- expect: sub_event: params: a table or a function is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'Pause', params = 5 } },
}
