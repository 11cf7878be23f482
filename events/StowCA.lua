-- Lower a comm asset.

local lsos = require 'lsos'
local stowing = require 'lib/stowing'

return lsos.event {
  api    = 1,
  schema = 'StowCA',
  doc    = 'Lower a comm asset.',
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

  stows = 'asset',

  start  = 'start',
  phases = stowing.phases('stow', 'antennas', 'asset'),

  on_abort = stowing.on_abort,
}
