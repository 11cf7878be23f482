-- Fill the battery: at once to a level, from outside, from an asset, or by waiting for the Sun.

local lsos = require 'lsos'

local kwh = 3.6e6

-- '12 kWh' or '80%': joules.
local function level_j(text, capacity_j)
  local percent = text:match('^%s*([%d.]+)%s*%%%s*$')
  if percent and tonumber(percent) and tonumber(percent) <= 100 then
    return tonumber(percent) / 100 * capacity_j
  end
  local energy = tonumber(text:match('^%s*([%d.]+)%s*$') or text:match('^%s*([%d.]+)%s*kWh%s*$'))
  return energy and energy * kwh
end

local function check(p)
  if p.energy_level and not level_j(p.energy_level, 1) then
    return ("EnergyLevel = '%s': kWh or a percentage is wanted, as in 12 or 80%%")
      :format(p.energy_level)
  end
  if (p.energy_rate_w or p.from) and not (p.duration_s or p.until_charge) then
    return (p.from and 'From' or 'EnergyRate')
      .. ' without Duration or UntilCharge: when should it end?'
  end
  if not (p.energy_level or p.duration_s or p.until_charge) then
    return 'nothing is asked: EnergyLevel, Duration or UntilCharge is wanted'
  end
end

local function start(ev, rover)
  local p, battery = ev.params, rover.battery
  rover:brake()
  if not battery then return lsos.fail('%s has no battery', rover.id) end
  if p.energy_level then
    battery:set_energy(level_j(p.energy_level, battery.capacity_j))
  end
  if not (p.duration_s or p.until_charge) then return lsos.done end
  if p.from then
    local is_plugged, why = battery:plug_into(p.from, p.energy_rate_w)
    if not is_plugged then return lsos.fail('%s', why) end
  elseif p.energy_rate_w then
    battery:supply(p.energy_rate_w)
  end
  return 'charge'
end

-- What flows follows the Sun, so it is looked at again each minute.
local function charge(ev, rover)
  local p, battery = ev.params, rover.battery
  local left_s = p.duration_s and p.duration_s - ev.phase_elapsed_s or math.huge
  if left_s <= 0 then return lsos.done end
  if not p.until_charge then return lsos.sleep(left_s) end
  if battery.charge >= p.until_charge then return lsos.done end
  local charged_s = battery:time_to_charge_s(p.until_charge) or math.huge
  return lsos.sleep(math.min(60, left_s, charged_s))
end

return lsos.event {
  api    = 1,
  schema = 'Recharge',
  doc    = 'Fill the battery: to a level, from outside, from an asset, or by waiting for the Sun.',

  goes_on_without_power = true,
  params = {
    energy_level  = lsos.text {
      kml = 'EnergyLevel',
      doc = 'Set at once: kWh, or a percentage as 80%.',
    },
    energy_rate_w = lsos.number {
      kml = 'EnergyRate', unit = 'W', min = 0,
      doc = 'Power from outside while the event runs; with From: what is asked of the asset.',
    },
    duration_s    = lsos.duration { kml = 'Duration', doc = 'The longest that it takes.' },
    until_charge  = lsos.number {
      kml = 'UntilCharge', unit = '1', min = 0, max = 1,
      doc = 'Ends when the battery is as full as this.',
    },
    from          = lsos.text {
      kml = 'From',
      doc = 'An asset within 20 m that has power to give.',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, charge = charge },
}
