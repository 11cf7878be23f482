-- expect: event: phases: at least one is needed
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = 'x', phases = {} }
