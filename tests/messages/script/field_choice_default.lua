-- expect: choice: 'Mode': the default 'c' is not among the choices a, b
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { mode = lsos.choice { kml = 'Mode', choices = { 'a', 'b' }, default = 'c' } },
}
