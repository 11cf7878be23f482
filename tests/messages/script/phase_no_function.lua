-- expect: event: phases: go: a function or lsos.sub_event {...} is wanted, found a number
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = 'x', phases = { go = 5 } }
