-- expect: event: doc: must not be empty
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = '', phases = { go = function() end } }
