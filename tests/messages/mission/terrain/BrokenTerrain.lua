-- No surface.
local lsos = require 'lsos'

return lsos.terrain { api = 1, doc = 'Broken.', soil = 'ApolloNominal' }
