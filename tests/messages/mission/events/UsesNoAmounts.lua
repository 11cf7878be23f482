-- It says names of what it uses, not how much.
local lsos = require 'lsos'

return lsos.event {
  api = 1,
  doc = 'Uses something.',
  uses = function() return { 'oxygen' } end,
  phases = { only = function() return lsos.done end },
}
