-- expect: event: schema = 'Other': must be 'schema_is_not_the_file', the name of the file
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  schema = 'Other',
}
