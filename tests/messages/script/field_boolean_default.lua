-- expect: boolean: default: true or false is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { is_quick = lsos.boolean { kml = 'Quick', default = 1 } },
}
