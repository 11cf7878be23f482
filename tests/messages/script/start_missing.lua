-- expect: event: 'start' is missing: which phase comes first?
-- as: events
local lsos = require 'lsos'
local function f() end
return lsos.event { api = 1, doc = 'x', phases = { a = f, b = f } }
