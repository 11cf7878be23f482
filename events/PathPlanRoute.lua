-- Plan a route over the ground to each waypoint in turn, for this rover, and drive it.

local lsos = require 'lsos'

-- What the routes keep to, when the mission is made and when they are driven.
local function route(params)
  return {
    speed_mps        = params.speed_mps,
    slope_max_rad    = params.slope_max_rad,
    aim              = params.aim,
    arrival_radius_m = params.arrival_radius_m,
  }
end

local function check(p, rover)
  local most_rad = rover and rover.slope_max_rad
  if most_rad and p.slope_max_rad and p.slope_max_rad > most_rad then
    return nil, ('MaxSlope = %.3g deg: %s is planned over %.3g deg at most')
      :format(math.deg(p.slope_max_rad), rover.type, math.deg(most_rad))
  end
end

local function plan(ev, rover)
  local options = route(ev.params)
  options.first = ev.state.next_waypoint
  options.avoid = ev.state.avoid
  options.avoid_radius_m = rover.length_m
  options.around = ev.state.around
  local found, reason = rover:plan_path(ev.geometry, options)
  if not found then
    if not ev.state.blocked_by then return lsos.fail('%s', reason) end
    return lsos.fail('%s; planned anew: %s', ev.state.blocked_by, reason)
  end
  ev.state.legs = found.legs
  rover:follow(found.path, {
    speed_mps          = ev.params.speed_mps,
    arrival_radius_m   = ev.params.arrival_radius_m,
    stray_max_m        = ev.params.stray_max_m,
    keeps_room_to_turn = true,
    slope_max_rad      = ev.params.slope_max_rad or rover.slope_max_rad,
  })
  return 'drive'
end

-- Remembers what to plan otherwise: from the waypoint that comes next, around what lay ahead: a
-- rover with the ground that it then covers, or else a place. Assets are gone round in any case.
local function replan(ev, rover)
  local drive = rover.drive
  for _, leg in ipairs(ev.state.legs) do
    if drive.next_point <= leg.last_point then
      ev.state.next_waypoint = leg.waypoint
      break
    end
  end
  if drive.blocked_by then
    ev.state.around = ev.state.around or {}
    table.insert(ev.state.around, drive.blocked_by)
  elseif drive.is_blocked then
    ev.state.avoid = ev.state.avoid or {}
    local way = drive.is_backward and -1 or 1
    table.insert(ev.state.avoid, rover:ahead(way * 1.25 * rover.length_m))
  end
  ev.state.replans = (ev.state.replans or 0) + 1
  ev.state.blocked_by = drive.reason
  ev:log('replan', {
    attempt  = ev.state.replans,
    reason   = drive.reason,
    waypoint = ev.state.next_waypoint,
  })
  rover:brake()
  return 'plan'
end

local function drive(ev, rover)
  if rover.drive.status == 'arrived' then
    return 'stop'
  end
  if rover.drive.status ~= 'failed' then
    return lsos.arrival
  end
  if (ev.state.replans or 0) < ev.params.replans then
    return replan(ev, rover)
  end
  return lsos.fail('%s', rover.drive.reason)
end

local function stop(_, rover)
  rover:brake()
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'PathPlanRoute',
  doc    = 'Plan a route to each waypoint on the ground that the rover will meet, and drive it.',
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
      doc = 'Near enough to the last waypoint, which it drives up to all the same; a waypoint '
        .. 'beyond a limit is met at the nearest place within it.',
    },
    slope_max_rad = lsos.number {
      kml = 'MaxSlope', unit = 'deg', min = 1, max = 60,
      doc = 'Steepest slope under its wheels; the rover type has a limit besides.',
    },
    aim = lsos.choice {
      kml = 'Cost', choices = { 'energy', 'risk' }, default = 'energy',
      doc = 'What is least: energy, or risk, metres weighed by how near each comes to a limit.',
    },
    replans = lsos.integer {
      kml = 'Replans', min = 0, max = 100, default = 3,
      doc = 'How often it may plan anew when the rover is stuck or strays; 0 switches that off.',
    },
    stray_max_m = lsos.number {
      kml = 'MaxStray', unit = 'm', min = 0.5, max = 1000, default = 3,
      doc = 'Farther than this from the planned route the rover has strayed.',
    },
  },

  check  = check,
  route  = route,
  start  = 'plan',
  phases = { plan = plan, drive = drive, stop = stop },

  on_abort = function(_, rover) rover:brake() end,
}
