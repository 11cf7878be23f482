-- expect: event: api = 2: this program knows api 1
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 2, doc = 'x', phases = { go = function() end } }
