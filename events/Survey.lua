-- Cover an area in parallel lines, there and back, taking samples on the way.

local lsos = require 'lsos'

-- East and north to along and across the lines, and back: the same turn over undoes itself.
local function turned(point, azimuth_rad)
  local c, s = math.cos(azimuth_rad), math.sin(azimuth_rad)
  return lsos.vec3(point.x * s + point.y * c, point.x * c - point.y * s, 0)
end

-- Where the line at `across` crosses the area's outline, in order.
local function crossings(corners, across)
  local along = {}
  for i, a in ipairs(corners) do
    local b = corners[i % #corners + 1]
    if (a.y <= across) ~= (b.y <= across) then
      along[#along + 1] = a.x + (b.x - a.x) * (across - a.y) / (b.y - a.y)
    end
  end
  table.sort(along)
  return along
end

-- Places to sample on a line from one crossing to the next, its ends among them.
local function add_line(stops, from, to, across, every_m)
  local count = math.max(1, math.ceil(math.abs(to - from) / every_m - 1e-9))
  for k = 0, count do
    stops[#stops + 1] = lsos.vec3(from + (to - from) * k / count, across, 0)
  end
end

local function stops_of(ev)
  local p, corners = ev.params, {}
  local low, high = math.huge, -math.huge
  for i = 1, #ev.geometry do
    local corner = turned(ev.geometry[i], p.azimuth_rad)
    corners[i] = corner
    low, high = math.min(low, corner.y), math.max(high, corner.y)
  end
  local stops, lines = {}, math.max(1, math.floor((high - low) / p.spacing_m + 0.5))
  for line = 1, lines do
    local across = low + (line - 0.5) * (high - low) / lines
    local along = crossings(corners, across)
    local first, last, step = 1, #along, 1
    if line % 2 == 0 then first, last, step = #along, 1, -1 end
    for i = first, last - step, 2 * step do
      add_line(stops, along[i], along[i + step], across, p.sample_every_m)
    end
  end
  for i, stop in ipairs(stops) do stops[i] = turned(stop, p.azimuth_rad) end
  return stops
end

local function begin(ev, _)
  ev.state.stops = stops_of(ev)
  if #ev.state.stops == 0 then return lsos.fail('the polygon has no area') end
  ev.state.next = 0
  ev:log('survey', { stops = #ev.state.stops })
  return 'go_on'
end

local function go_on(ev, _)
  ev.state.next = ev.state.next + 1
  return ev.state.next <= #ev.state.stops and 'drive' or lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Survey',
  doc    = 'Cover an area in parallel lines, there and back, taking samples on the way.',

  geometry = 'polygon',
  drives   = true,
  params   = {
    spacing_m      = lsos.number {
      kml = 'Spacing', unit = 'm', min = 1, max = 1e4, default = 20,
      doc = 'Of the lines.',
    },
    sample_every_m = lsos.number {
      kml = 'SampleEvery', unit = 'm', min = 1, max = 1e4, default = 50,
      doc = 'Of the stops on a line, at most; its ends are stops.',
    },
    azimuth_rad    = lsos.number {
      kml = 'Azimuth', unit = 'deg', min = -360, max = 360, default = 0,
      doc = 'Of the lines, clockwise from true north.',
    },
    speed_mps      = lsos.number {
      kml = 'Speed', unit = 'm/s', min = 0.01, max = 20,
      doc = 'Driving speed; without it the rover type\'s cruise speed.',
    },
    duration_s     = lsos.duration {
      kml = 'SampleDuration', unit = 'min', default = 2,
      doc = 'Of each sample.',
    },
    power_w        = lsos.number {
      kml = 'SamplePower', unit = 'W', min = 0, default = 50,
      doc = 'While one is taken.',
    },
  },

  start  = 'begin',
  phases = {
    begin  = begin,
    go_on  = go_on,
    drive  = lsos.sub_event {
      event    = 'Route',
      geometry = function(ev) return ev.state.stops[ev.state.next] end,
      params   = function(ev) return { speed_mps = ev.params.speed_mps } end,
      next     = 'sample',
    },
    sample = lsos.sub_event {
      event  = 'Sample',
      params = function(ev)
        return { duration_s = ev.params.duration_s, power_w = ev.params.power_w }
      end,
      next   = 'go_on',
    },
  },

  on_abort = function(_, rover) rover:brake() end,
}
