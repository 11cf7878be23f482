-- expect: event: phases: go: next = 'gone': there is no such phase; did you mean 'go'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'Pause', next = 'gone' } },
}
