-- expect: event: geometry: the list is empty; an event without one has geometry = 'none'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  geometry = {},
}
