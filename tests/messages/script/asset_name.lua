-- expect: asset: name = 'Other': must be 'asset_name', the name of the file
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  name = 'Other',
}
