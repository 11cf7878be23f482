-- expect: api_missing.lua:4: event: 'api' is missing
-- as: events
local lsos = require 'lsos'
return lsos.event { doc = 'x', phases = { go = function() end } }
