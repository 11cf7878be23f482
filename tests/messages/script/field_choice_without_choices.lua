-- expect: choice: 'choices' is missing
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { mode = lsos.choice { kml = 'Mode' } },
}
