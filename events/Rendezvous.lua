-- Drive until near another rover or an asset, wherever it goes meanwhile.

local lsos = require 'lsos'

-- The route is planned again when the other has moved by this share of what is left, or this far.
local moved_share, moved_least_m = 0.2, 5

-- No route leads to the place of an asset itself: then one to where it is near enough will do.
local near_share = 0.9

-- Bodies are in each other's way before their reference points are so near.
local function check(p, rover)
  if rover and p.distance_m < rover.length_m then
    return nil, ('Distance = %g m: %s is %.1f m long, and comes no nearer than bodies allow')
      :format(p.distance_m, rover.type, rover.length_m)
  end
end

local function plan(ev, rover, target)
  local options = { speed_mps = ev.params.speed_mps, arrival_radius_m = ev.params.distance_m }
  local route, reason = rover:plan_path(target, options)
  if route then return route end
  local back = rover.position - target
  local near = target + back * (near_share * ev.params.distance_m / back:length())
  local near_route, near_reason = rover:plan_path(near, options)
  if near_route then return near_route end
  if near_reason == reason then return nil, reason end
  return nil, ('%s; nor to within %g m of it: %s'):format(reason, ev.params.distance_m, near_reason)
end

local function aim(ev, rover, target)
  local path = target
  if ev.params.plans then
    local route, reason = plan(ev, rover, target)
    if not route then return lsos.fail('%s', reason) end
    path = route.path
  end
  rover:follow(path, {
    speed_mps        = ev.params.speed_mps,
    arrival_radius_m = ev.params.distance_m,
    slope_max_rad    = ev.params.plans and rover.slope_max_rad or nil,
  })
  ev.state.target = target
end

local function chase(ev, rover)
  local target = rover:place_of(ev.params.with)
  local left_m = rover:distance_to_m(target)
  if left_m <= ev.params.distance_m then
    rover:brake()
    if not ev.state.target then
      ev:warn("it does nothing: '%s' is %.0f m away, and Distance is %g m", ev.params.with, left_m,
        ev.params.distance_m)
    end
    ev:log('met', { with = ev.params.with, distance_m = left_m })
    return lsos.done
  end
  local moved_m = ev.state.target and (target - ev.state.target):length()
  local is_old = not moved_m or moved_m > math.max(moved_least_m, moved_share * left_m)
  if is_old or rover.drive.status == 'arrived' then
    local failure = aim(ev, rover, target)
    if failure then return failure end
  elseif rover.drive.status == 'failed' then
    return lsos.fail('%s', rover.drive.reason)
  end
  return lsos.sleep(1)
end

return lsos.event {
  api    = 1,
  schema = 'Rendezvous',
  doc    = 'Drive until near another rover or an asset, wherever it goes meanwhile.',
  kind   = 'driving',

  geometry = 'none',
  drives   = true,
  params   = {
    with       = lsos.text {
      kml = 'With', names = 'other', required = true,
      doc = 'RoverId or AssetId.',
    },
    distance_m = lsos.number {
      kml = 'Distance', unit = 'm', min = 1, max = 1e5, default = 20, role = 'arrival_radius',
      doc = 'Near enough, between their reference points.',
    },
    speed_mps  = lsos.number {
      kml = 'Speed', unit = 'm/s', min = 0.01, max = 20, role = 'drive_speed',
      doc = 'Driving speed; without it the rover type\'s cruise speed.',
    },
    plans      = lsos.boolean {
      kml = 'Plan', default = true,
      doc = 'Whether routes are planned over the ground; else it drives straight.',
    },
  },

  open_ended = true,
  check      = check,
  start      = 'chase',
  phases     = { chase = chase },

  on_abort = function(ev, rover)
    rover:brake()
    local p = ev.params
    return ("'%s' was %.0f m away, Distance is %g m"):format(p.with,
      rover:distance_to_m(rover:place_of(p.with)), p.distance_m)
  end,
}
