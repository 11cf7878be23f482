-- expect: event: 'phases' is missing
-- as: events
local lsos = require 'lsos'
return lsos.event { api = 1, doc = 'x' }
