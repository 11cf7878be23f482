-- expect: event: geometry: 'none', 'point', 'line' or 'polygon' is wanted, found 'lines'; did you mean 'line'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  geometry = { 'lines' },
}
