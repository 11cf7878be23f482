-- Put a solar panel up.

local lsos = require 'lsos'
local stowing = require 'lib/stowing'

return lsos.event {
  api    = 1,
  schema = 'DeploySP',
  doc    = 'Put a solar panel up.',
  kind   = 'energy',

  params = {
    panel      = lsos.text {
      kml = 'Panel', names = 'stowable_panel',
      doc = 'Its name; without one all that can be stowed.',
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = "How long it takes; without one the panel's own.",
    },
  },

  deploys = 'panel',

  start  = 'start',
  phases = stowing.phases('deploy', 'panels', 'panel'),

  on_abort = stowing.on_abort,
}
