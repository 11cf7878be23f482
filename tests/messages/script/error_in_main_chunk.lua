-- expect: error_in_main_chunk.lua:4: attempt to index a nil value (local 'x')
-- as: events
local lsos = require 'lsos'
local x = nil return x.y
