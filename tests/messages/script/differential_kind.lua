-- expect: differential: kind = 'belt': must be 'bar' or 'gear'
-- as: rovers
local lsos = require 'lsos'
return lsos.differential { kind = 'belt' }
