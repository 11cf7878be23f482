-- expect: error_in_function.lua:4: attempt to call a nil value (local 'f')
-- as: events
local lsos = require 'lsos'
local function call(f) f() end
call()
return {}
