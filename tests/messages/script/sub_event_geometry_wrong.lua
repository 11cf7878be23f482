-- expect: sub_event: geometry: a function is wanted, found a vec3
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = lsos.sub_event { event = 'Pause', geometry = lsos.vec3(1, 2) } },
}
