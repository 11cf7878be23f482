-- Raise a comm asset.

local lsos = require 'lsos'
local stowing = require 'lib/stowing'

return lsos.event {
  api    = 1,
  schema = 'DeployCA',
  doc    = 'Raise a comm asset.',
  kind   = 'communication',

  params = {
    asset      = lsos.text {
      kml = 'Asset', names = 'antenna',
      doc = "The rover's antenna; without one all that can be stowed.",
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = "How long it takes; without one the antenna's own.",
    },
  },

  deploys = 'asset',

  start  = 'start',
  phases = stowing.phases('deploy', 'antennas', 'asset'),

  on_abort = stowing.on_abort,
}
