-- expect: event: on_abort: a function is wanted, found a text
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  on_abort = 'brake',
}
