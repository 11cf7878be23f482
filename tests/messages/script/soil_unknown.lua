-- expect: soil_unknown.lua:4: terrain: no soil 'ApoloNominal'; did you mean 'ApolloNominal'?
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { api = 1, doc = 'x', surface = lsos.plane {}, soil = 'ApoloNominal' }
