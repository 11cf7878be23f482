-- Drive along the line of the placemark, or straight to its point, as drawn.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:follow(ev.geometry, {
    speed_mps        = ev.params.speed_mps,
    arrival_radius_m = ev.params.arrival_radius_m,
  })
  return 'drive'
end

-- What stopped it stopped it near enough.
local function is_near_end(ev, rover)
  local points = ev.geometry
  return rover:distance_to_m(points[#points]) <= ev.params.arrival_radius_m
end

local function drive(ev, rover)
  if rover.drive.status == 'arrived' then
    return 'stop'
  end
  if rover.drive.status == 'failed' then
    if is_near_end(ev, rover) then
      ev:warn('it stopped within ArrivalRadius: %s', rover.drive.reason)
      return 'stop'
    end
    return lsos.fail('%s', rover.drive.reason)
  end
  return lsos.arrival
end

local function stop(_, rover)
  rover:brake()
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Route',
  doc    = 'Drive along the waypoints as drawn.',
  kind   = 'driving',

  geometry = { 'line', 'point' },
  drives   = true,
  params   = {
    speed_mps = lsos.number {
      kml = 'Speed', unit = 'm/s', min = 0.01, max = 20, role = 'drive_speed',
      doc = 'Driving speed; without it the rover type\'s cruise speed.',
    },
    arrival_radius_m = lsos.number {
      kml = 'ArrivalRadius', unit = 'm', min = 0.1, max = 100, default = 1,
      role = 'arrival_radius',
      doc = 'Near enough to the last waypoint, which it drives up to all the same.',
    },
  },

  start  = 'start',
  phases = { start = start, drive = drive, stop = stop },

  on_abort = function(_, rover) rover:brake() end,
}
