-- expect: event: params: amount: amount_of = 'resorce': no text of this event has that key and names = 'resource'
-- as: events
local lsos = require 'lsos'

return lsos.event {
  api    = 1,
  doc    = 'Uses what no field names.',
  params = {
    resource = lsos.text { kml = 'Resource', names = 'resource' },
    amount   = lsos.number { kml = 'Amount', amount_of = 'resorce' },
  },
  start  = 'go',
  phases = { go = function() return lsos.done end },
}
