-- expect: event: phases = 'pa\xffuse': a name is text in UTF-8 without control characters
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1, doc = 'Ends at once.',
  phases = { ['pa\xffuse'] = function() return lsos.done end },
}
