-- expect: event: 'doc' is missing
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, phases = { go = function() end } }
