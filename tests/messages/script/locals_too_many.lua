-- expect: locals_too_many.lua:13: event: its functions reach more than 10000 values in locals of the file; all are looked at after each call, as only ev.state may change
-- as: events
local lsos = require 'lsos'

local squares = {}
for k = 1, 10000 do squares[k] = k * k end

local function go()
  if squares[3] == 9 then return lsos.done end
end

-- The fault is told of the constructor.
return lsos.event { api = 1, doc = 'A long list.', phases = { go = go } }
