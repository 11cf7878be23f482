-- expect: unknown_constructor.lua:4: lsos has no 'evnt'; did you mean 'event'?
-- as: events
local lsos = require 'lsos'
return lsos.evnt {}
