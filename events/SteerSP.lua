-- Turn a solar panel. One that tracks goes on following the Sun until the next event for it.

local lsos = require 'lsos'

-- On ground steeper than this no panel is steered.
local tilt_max_rad = math.rad(30)

local function degrees(angle_rad)
  return ('%g deg'):format(math.floor(math.deg(angle_rad) * 100 + 0.5) / 100)
end

-- Whether an angle lies between two, going round either way.
local function is_within(angle_rad, min_rad, max_rad)
  return (angle_rad - min_rad) % (2 * math.pi) <= max_rad - min_rad + 1e-9
end

local function limits_text(panel)
  return ("the panel '%s' turns to azimuths of %s to %s and elevations of %s to %s"):format(
    panel.name, degrees(panel.azimuth_min_rad), degrees(panel.azimuth_max_rad),
    degrees(panel.elevation_min_rad), degrees(panel.elevation_max_rad))
end

-- Angles about the rover that a panel cannot have.
local function is_beyond(p, panel)
  return not (is_within(p.azimuth_rad, panel.azimuth_min_rad, panel.azimuth_max_rad)
    and p.elevation_rad >= panel.elevation_min_rad - 1e-9
    and p.elevation_rad <= panel.elevation_max_rad + 1e-9)
end

-- Elevations above the horizon that it cannot face however the ground may tilt.
local function is_out_of_sight(p, panel)
  return p.elevation_rad < panel.elevation_min_rad - tilt_max_rad
    or p.elevation_rad > panel.elevation_max_rad + tilt_max_rad
end

local function check(p, rover)
  if p.mode == 'track' then
    if not (p.azimuth_rad or p.elevation_rad) then return nil end
    return nil, 'Azimuth and Elevation are not used: Mode = track follows the Sun'
  end
  if not (p.azimuth_rad and p.elevation_rad) then
    return ('Mode = %s wants both Azimuth and Elevation'):format(p.mode)
  end
  for _, panel in ipairs(rover and rover.panels or {}) do
    if panel.turns and (not p.panel or p.panel == panel.name) then
      local cannot = p.mode == 'fixed' and is_beyond or is_out_of_sight
      if cannot(p, panel) then
        return nil, ('it cannot face azimuth %s, elevation %s: %s'):format(degrees(p.azimuth_rad),
          degrees(p.elevation_rad), limits_text(panel))
      end
    end
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
  local sun_rad = rover:sky().sun_elevation_rad
  if p.mode == 'track' and sun_rad < 0 then
    ev:warn('the Sun is %s below the horizon; what tracks it stays as it is until it rises',
      degrees(-sun_rad))
  end
  return 'turn'
end

-- Away from a Sun that is up, no light falls on a panel, however the deck may tilt.
local deck_tilt_max_rad = math.rad(25)

local function warn_of_the_sun(ev, rover)
  local p, sky = ev.params, rover:sky()
  if p.mode == 'track' or sky.sun_elevation_rad <= 0 then return end
  local azimuth_rad = p.azimuth_rad + (p.mode == 'fixed' and rover.heading_rad or 0)
  local cosine = math.sin(p.elevation_rad) * math.sin(sky.sun_elevation_rad)
    + math.cos(p.elevation_rad) * math.cos(sky.sun_elevation_rad)
    * math.cos(azimuth_rad - sky.sun_azimuth_rad)
  if cosine > -math.sin(deck_tilt_max_rad) then return end
  ev:warn('it faces away from the Sun, which stands at azimuth %s, elevation %s',
    degrees(sky.sun_azimuth_rad % (2 * math.pi)), degrees(sky.sun_elevation_rad))
end

-- A panel that stopped at a limit, or got stuck, faces another way than was asked.
local function turn(ev, rover)
  local left_s = rover.panels.turn_left_s
  if left_s > 0 then return lsos.sleep(left_s) end
  for _, miss in ipairs(rover.panels:misses()) do
    if not ev.params.panel or ev.params.panel == miss.panel then
      return lsos.fail(
        "the panel '%s' was asked for azimuth %s, elevation %s and %s at azimuth %s, elevation %s",
        miss.panel, degrees(miss.wanted_azimuth_rad), degrees(miss.wanted_elevation_rad),
        miss.is_stuck and 'is stuck' or 'stopped', degrees(miss.azimuth_rad),
        degrees(miss.elevation_rad))
    end
  end
  warn_of_the_sun(ev, rover)
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'SteerSP',
  doc    = 'Turn a solar panel, once or after the Sun.',
  kind   = 'energy',

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

  open_ended     = false,
  needs_deployed = 'panel',

  check  = check,
  start  = 'start',
  phases = { start = start, turn = turn },
}
