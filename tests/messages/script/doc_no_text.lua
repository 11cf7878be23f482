-- expect: event: doc = 'Wei\xdf.': a text in UTF-8 is wanted
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1, doc = 'Wei\xdf.',
  phases = { only = function() return lsos.done end },
}
