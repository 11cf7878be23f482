-- A phase name that is not there.
local lsos = require 'lsos'

local function drop() return lsos.done end

return lsos.event { api = 1, doc = 'Broken.', start = 'drp', phases = { drop = drop } }
