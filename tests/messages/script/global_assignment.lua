-- expect: global_assignment.lua:4: assignment to global 'plan': make it local
-- as: events
local lsos = require 'lsos'
plan = 1
return plan
