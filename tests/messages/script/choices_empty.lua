-- expect: choice: choices: is empty
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { mode = lsos.choice { kml = 'Mode', choices = {} } },
}
