-- expect: terrain: 'surface' is missing
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { api = 1, doc = 'x', soil = 'ApolloNominal' }
