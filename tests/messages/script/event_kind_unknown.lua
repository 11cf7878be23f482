-- expect: event: kind = 'drivin': 'driving', 'waiting', 'energy', 'communication', 'crew' or 'science' is wanted; did you mean 'driving'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1, doc = 'Nothing.', kind = 'drivin',
  phases = { only = function() return lsos.done end },
}
