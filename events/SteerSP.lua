-- Turn a solar panel. One that tracks goes on following the Sun until the next event for it.

local lsos = require 'lsos'

local function check(p)
  if p.mode ~= 'track' and not (p.azimuth_rad and p.elevation_rad) then
    return ('Mode = %s wants both Azimuth and Elevation'):format(p.mode)
  end
end

local function start(ev, rover)
  local p = ev.params
  rover:brake()
  rover.panels:steer(p.panel, {
    mode          = p.mode,
    azimuth_rad   = p.azimuth_rad,
    elevation_rad = p.elevation_rad,
  })
  return 'turn'
end

local function turn(_, rover)
  local left_s = rover.panels.turn_left_s
  if left_s <= 0 then return lsos.done end
  return lsos.sleep(left_s)
end

return lsos.event {
  api    = 1,
  schema = 'SteerSP',
  doc    = 'Turn a solar panel, once or after the Sun.',

  params = {
    panel = lsos.text {
      kml = 'Panel', names = 'turning_panel',
      doc = 'Its name; without one all that turn.',
    },
    mode  = lsos.choice {
      kml = 'Mode', choices = { 'track', 'point', 'fixed' }, default = 'track',
      doc = 'Follow the Sun; face an azimuth and elevation; or stay at angles about the rover.',
    },
    azimuth_rad = lsos.number {
      kml = 'Azimuth', unit = 'deg', min = -360, max = 360,
      doc = 'Clockwise from true north (point) or from the nose (fixed).',
    },
    elevation_rad = lsos.number {
      kml = 'Elevation', unit = 'deg', min = -90, max = 180,
      doc = 'Above the horizon (point) or the deck (fixed).',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, turn = turn },
}
