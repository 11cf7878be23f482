-- expect: event: phases: entries have names, found [1]
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = 'x', phases = { function() end } }
