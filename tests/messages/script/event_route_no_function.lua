-- expect: event: route: a function is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1, doc = 'Nothing.', route = 1,
  phases = { only = function() return lsos.done end },
}
