-- expect: event: start = 'og': there is no such phase; phases are go
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  start = 'og',
}
