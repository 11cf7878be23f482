-- expect: rover: name = 'SEV': must be 'name_is_not_the_file', the name of the file
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { name = 'SEV' }
