-- Its route gives a key that is none.
local lsos = require 'lsos'

return lsos.event {
  api = 1,
  doc = 'Plans a way.',
  geometry = 'point',
  drives = true,
  route = function() return { speed = 1 } end,
  phases = { only = function() return lsos.done end },
}
