-- expect: event: drives: true or false is wanted, found a text
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  drives = 'yes',
}
