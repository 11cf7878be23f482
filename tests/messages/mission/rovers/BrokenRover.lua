-- Nearly nothing of a rover.
local lsos = require 'lsos'

return lsos.rover { api = 1, doc = 'Broken.' }
