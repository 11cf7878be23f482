-- expect: event: phases: a table is wanted, found a text
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = 'x', phases = 'go' }
