-- expect: event: unknown key 'something_else'; known are api,
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  something_else = 1,
}
