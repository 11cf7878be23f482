-- expect: endless_loop.lua:4: more than 3000000 instructions in one call
-- as: events
local lsos = require 'lsos'
while true do end
