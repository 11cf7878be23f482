-- Cover an area in parallel lines, there and back, taking samples on the way.

local lsos = require 'lsos'

-- East and north to along and across the lines, and back: the same turn over undoes itself.
local function turned(point, azimuth_rad)
  local c, s = math.cos(azimuth_rad), math.sin(azimuth_rad)
  return lsos.vec3(point.x * s + point.y * c, point.x * c - point.y * s, 0)
end

-- How far the rover keeps from holes: half of it sticks out ahead of where it is said to be, the
-- rest is for the ends of its turns.
local function margin_of(ev, rover)
  if ev.params.margin_m then return ev.params.margin_m end
  return math.max(rover.length_m, rover.length_m / 2 + 2 * rover.turning_radius_m)
end

-- Places to sample on a line from one end to the other, both among them.
local function add_line(stops, from, to, every_m)
  local count = math.max(1, math.ceil((to - from):length() / every_m - 1e-9))
  for k = 0, count do stops[#stops + 1] = from + (to - from) * (k / count) end
end

-- How far the area reaches along the lines and across them.
local function extent_of(ev)
  local low, high = lsos.vec3(math.huge, math.huge), lsos.vec3(-math.huge, -math.huge)
  for i = 1, #ev.geometry do
    local corner = turned(ev.geometry[i], ev.params.azimuth_rad)
    low = lsos.vec3(math.min(low.x, corner.x), math.min(low.y, corner.y))
    high = lsos.vec3(math.max(high.x, corner.x), math.max(high.y, corner.y))
  end
  return low, high
end

-- The parts of each line that lie in the area, holes and what is too near to them left out; every
-- other line from its far end.
local function lines_of(ev, margin_m)
  local p = ev.params
  local low, high = extent_of(ev)
  local lines, count = {}, math.max(1, math.floor((high.y - low.y) / p.spacing_m + 0.5))
  for line = 1, count do
    local across = low.y + (line - 0.5) * (high.y - low.y) / count
    local from = turned(lsos.vec3(low.x - 1, across), p.azimuth_rad)
    local to = turned(lsos.vec3(high.x + 1, across), p.azimuth_rad)
    if line % 2 == 0 then from, to = to, from end
    lines[line] = ev.geometry:parts(from, to, margin_m)
  end
  return lines
end

-- The part nearest to a place, of the lines from one number to another, taken out of its line and
-- with its nearer end first; and the number of its line.
local function take_nearest(lines, first, last, at)
  local best, best_m
  for line = first, last do
    for k, part in ipairs(lines[line] or {}) do
      for turn = 1, 2 do
        local away_m = (part[turn] - at):length()
        if not best or away_m < best_m then
          best, best_m = { line = line, k = k, turn = turn }, away_m
        end
      end
    end
  end
  if not best then return nil end
  local part = table.remove(lines[best.line], best.k)
  if best.turn == 2 then part = { part[2], part[1] } end
  return part, best.line
end

-- The part that is driven after one on a line, and the number of its own line; nil at the end.
local function next_part(lines, line, at, is_cut)
  if is_cut then
    local part, its_line = take_nearest(lines, line - 1, line + 1, at)
    if part then return part, its_line end
    return take_nearest(lines, 1, #lines, at)
  end
  for k = line + 1, #lines do
    if #lines[k] > 0 then return table.remove(lines[k], 1), k end
  end
end

-- Lines there and back. Where holes or bays cut them, the parts on one side first.
local function stops_of(ev, margin_m)
  local lines, stops, is_cut = lines_of(ev, margin_m), {}, false
  for _, parts in ipairs(lines) do is_cut = is_cut or #parts > 1 end
  local part, line = next_part(lines, 0, nil, false)
  while part do
    add_line(stops, part[1], part[2], ev.params.sample_every_m)
    part, line = next_part(lines, line, part[2], is_cut)
  end
  return stops
end

local function begin(ev, rover)
  ev.state.margin_m = margin_of(ev, rover)
  ev.state.stops = stops_of(ev, ev.state.margin_m)
  if #ev.state.stops == 0 then
    return lsos.fail(#ev.geometry.holes == 0 and 'the polygon has no area'
      or 'no line fits between the outline and %.1f m from the holes', ev.state.margin_m)
  end
  local low, high = extent_of(ev)
  if ev.params.spacing_m > high.y - low.y then
    ev:warn('Spacing = %g m, and the area is %.4g m across its lines: it has one line',
      ev.params.spacing_m, high.y - low.y)
  end
  ev.state.next = 0
  ev:log('survey', { stops = #ev.state.stops })
  return 'go_on'
end

-- The path to the next stop within the area: straight where that leaves it nowhere.
local function go_on(ev, rover)
  ev.state.next = ev.state.next + 1
  local stop = ev.state.stops[ev.state.next]
  if not stop then return lsos.done end
  -- Without a path the second is why.
  local path, kept_m = ev.geometry:path(rover.position, stop, ev.state.margin_m)
  if not path then
    return lsos.fail('stop %d of %d: %s', ev.state.next, #ev.state.stops, kept_m)
  end
  if kept_m < ev.state.margin_m and not ev.state.is_narrow_told then
    ev.state.is_narrow_told = true
    ev:warn('the path to stop %d keeps %.1f m from holes where %.1f m are wanted: there is no room',
      ev.state.next, kept_m, ev.state.margin_m)
  end
  ev.state.path = path
  return 'drive'
end

return lsos.event {
  api    = 1,
  schema = 'Survey',
  doc    = 'Cover an area in parallel lines, there and back and round its holes, taking samples.',
  kind   = 'science',

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
    margin_m       = lsos.number {
      kml = 'Margin', unit = 'm', min = 0, max = 1000,
      doc = 'From holes of the polygon, to the rover\'s middle; without it the rover\'s length, '
        .. 'more for one that does not turn on the spot.',
    },
    speed_mps      = lsos.number {
      kml = 'Speed', unit = 'm/s', min = 0.01, max = 20, role = 'drive_speed',
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

  -- How long it takes depends on its lines.
  open_ended = true,

  start  = 'begin',
  phases = {
    begin  = begin,
    go_on  = go_on,
    drive  = lsos.sub_event {
      event    = 'Route',
      geometry = function(ev) return ev.state.path end,
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

  on_abort = function(ev, rover)
    rover:brake()
    return ev.state.next and ('%d of %d stops were done'):format(math.max(0, ev.state.next - 1),
      #ev.state.stops)
  end,
}
