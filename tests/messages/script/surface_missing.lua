-- expect: terrain: surface is missing; it or layers is wanted
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { api = 1, doc = 'x', soil = 'ApolloNominal' }
