-- Fill the battery: at once to a level, from outside, from an asset, or by waiting for the Sun.

local lsos = require 'lsos'

local joules = { J = 1, kJ = 1e3, MJ = 1e6, Wh = 3600, kWh = 3.6e6, MWh = 3.6e9 }

-- '12 kWh', '12' (kWh) or '80%': its number and unit; nil when it is none.
local function parts(text)
  local number, unit = text:match('^%s*([%d.]+)%s*([%a%%]*)%s*$')
  return tonumber(number), unit
end

-- The same in joules.
local function level_j(text, capacity_j)
  local number, unit = parts(text)
  if not number then return nil end
  if unit == '%' then return number <= 100 and number / 100 * capacity_j or nil end
  local factor = unit == '' and joules.kWh or joules[unit]
  return factor and number * factor
end

-- A level that is the battery's own may be rounded.
local rounding = 1 + 1e-9

-- A battery that holds this share takes nothing more.
local full = 1 - 1e-6

-- What is wrong with the level, once the battery is known.
local function level_fault(p, rover)
  local capacity_j = rover.battery_capacity_j
  local wanted_j = level_j(p.energy_level, capacity_j)
  if wanted_j and wanted_j > capacity_j * rounding then
    local number, unit = parts(p.energy_level)
    local share = unit == '' and number <= 100 and ("; did you mean '%g%%'?"):format(number) or ''
    return ("EnergyLevel = '%s': the battery of %s holds %g kWh%s")
      :format(p.energy_level, rover.type, capacity_j / joules.kWh, share)
  end
end

-- A level that was meant as a share, as charges are.
local function as_share(p)
  local number, unit = parts(p.energy_level or '')
  if number and number > 0 and number <= 1 and unit == '' then
    return ("EnergyLevel = '%s': is %g kWh; did you mean '%g%%'?"):format(p.energy_level, number,
      100 * number)
  end
end

-- A round number without a unit that may as well be a share.
local function ambiguous(p, capacity_j)
  local number, unit = parts(p.energy_level or '')
  if not number or unit ~= '' or number < 10 or number > 100 or number % 5 ~= 0 then return nil end
  local percent = 100 * number * joules.kWh / capacity_j
  return ("EnergyLevel = '%s': is %g kWh, %.0f %% of what the battery holds; write '%g kWh', or "
    .. "'%g%%' for a share"):format(p.energy_level, number, percent, number, number)
end

-- A level that was meant as what is to be reached.
local function twice(p)
  if p.energy_level and (p.until_charge or p.from or p.energy_rate_w) then
    return ("EnergyLevel = '%s': sets the battery at once, out of nothing, before anything flows; "
      .. 'UntilCharge says how full it is to get'):format(p.energy_level)
  end
end

-- What is asked in vain, of a rover with a battery.
local function vain(p, rover)
  local most_w = rover.charge_power_max_w
  if p.duration_s == 0 and not p.until_charge then return 'Duration = 0: nothing flows' end
  local hours = p.energy_rate_w and rover.battery_capacity_j / p.energy_rate_w / 3600
  if hours and hours > 1000 and p.energy_rate_w > 0 then
    return ("EnergyRate = %g W: fills the battery of %s in %.0f d; did you mean '%g kW'?")
      :format(p.energy_rate_w, rover.type, hours / 24, p.energy_rate_w)
  end
  if p.energy_rate_w == 0 then return 'EnergyRate = 0 W: nothing comes from outside' end
  if most_w and p.energy_rate_w and p.energy_rate_w > most_w then
    return ('EnergyRate = %g W: the battery of %s takes %g W at most, what is used at once besides')
      :format(p.energy_rate_w, rover.type, most_w)
  end
  local waits_for_sun = p.until_charge and not (p.energy_rate_w or p.from)
  if waits_for_sun and #rover.panels == 0 and rover.generator_w == 0 then
    return ('UntilCharge without EnergyRate or From waits for the Sun, and %s has no solar panels')
      :format(rover.type)
  end
end

local function check(p, rover)
  if p.energy_level and not level_j(p.energy_level, 1) then
    local number, unit = parts(p.energy_level)
    if number and unit == '%' then
      return ("EnergyLevel = '%s': is above 100 %%, which is a full battery"):format(p.energy_level)
    end
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
  if not rover then return nil end
  if not rover.battery_capacity_j then return rover.type .. ' has no battery' end
  local fault = p.energy_level and level_fault(p, rover)
  if fault then return fault end
  return nil, as_share(p) or ambiguous(p, rover.battery_capacity_j) or twice(p) or vain(p, rover)
end

local function start(ev, rover)
  local p, battery = ev.params, rover.battery
  rover:brake()
  if not battery then return lsos.fail('%s has no battery', rover.id) end
  if p.energy_level then
    local wanted_j = level_j(p.energy_level, battery.capacity_j)
    if wanted_j > battery.capacity_j * rounding then
      return lsos.fail("EnergyLevel = '%s': the battery holds %g kWh", p.energy_level,
        battery.capacity_j / joules.kWh)
    end
    if wanted_j < battery.energy_j - 1 then
      ev:warn("EnergyLevel = '%s' lowers what the battery holds from %.4g to %.4g kWh",
        p.energy_level, battery.energy_j / joules.kWh, wanted_j / joules.kWh)
    end
    battery:set_energy(wanted_j)
  end
  if not (p.duration_s or p.until_charge) then return lsos.done end
  if p.until_charge and battery.charge >= p.until_charge then
    ev:warn(p.energy_level and 'EnergyLevel set the charge to %.4g at once, UntilCharge is %.4g: '
      .. 'nothing flowed' or 'charge is %.4g already, UntilCharge is %.4g: nothing was done',
      battery.charge, p.until_charge)
    return lsos.done
  end
  local waits_for_sun = p.until_charge and not (p.energy_rate_w or p.from or p.duration_s)
  local is_fed = rover.panels.is_any_up or battery.generator_w > 0
  if waits_for_sun and not is_fed then
    return lsos.fail('no panel is up, and UntilCharge without EnergyRate or From waits for the Sun')
  end
  if not (p.energy_rate_w or p.from) and not is_fed then
    ev:warn('no panel is up: nothing comes in')
  end
  -- Its upper limb may be up, and the horizon of a rim lies low: what is seen of it counts.
  local sun_rad = rover:sky().sun_elevation_rad
  local is_of_sun = not (p.energy_rate_w or p.from) and battery.generator_w == 0
  if is_of_sun and sun_rad < 0 and rover.panels.sun_fraction == 0 then
    ev:warn('no sunlight reaches it now: the Sun is %.3g deg below the horizon',
      -math.deg(sun_rad))
  end
  ev.state.external_j = battery.external_j
  ev.state.energy_j = battery.energy_j
  if p.from then
    local is_plugged, why = battery:plug_into(p.from, p.energy_rate_w)
    if not is_plugged then return lsos.fail('%s', why) end
  elseif p.energy_rate_w then
    battery:supply(p.energy_rate_w)
  end
  return 'charge'
end

local function charge(ev, rover)
  local p, battery = ev.params, rover.battery
  local left_s = (p.duration_s or math.huge) - ev.phase_elapsed_s
  if p.until_charge and battery.charge >= p.until_charge then return lsos.done end
  if left_s <= 0 and p.until_charge then
    return lsos.fail('Duration is over, charge is %.4g, UntilCharge is %.4g', battery.charge,
      p.until_charge)
  end
  if left_s <= 0 then
    local wants_power = p.from or (p.energy_rate_w or 0) > 0
    if wants_power and battery.charge < full and battery.external_j <= ev.state.external_j then
      return lsos.fail('Duration is over and no power came from %s',
        p.from and ("'%s'"):format(p.from) or 'outside')
    end
    if battery.energy_j < ev.state.energy_j - 1 then
      ev:warn('the battery held %.4g kWh before and %.4g kWh after: more was used than came in',
        ev.state.energy_j / joules.kWh, battery.energy_j / joules.kWh)
    end
    return lsos.done
  end
  if p.until_charge then battery:await_charge(p.until_charge) end
  return lsos.sleep(math.min(left_s, 86400))
end

return lsos.event {
  api    = 1,
  schema = 'Recharge',
  doc    = 'Fill the battery: to a level, from outside, from an asset, or by waiting for the Sun.',
  kind   = 'energy',

  goes_on_without_power = true,
  params = {
    energy_level  = lsos.text {
      kml = 'EnergyLevel',
      doc = 'Set at once: kWh, or a percentage as 80%.',
    },
    energy_rate_w = lsos.number {
      kml = 'EnergyRate', unit = 'W', min = 0, example = '500 W', role = 'outside_power',
      doc = 'Power from outside while the event runs; with From: what is asked of the asset.',
    },
    duration_s    = lsos.duration {
      kml = 'Duration', example = '10 min',
      doc = 'How long it takes; with UntilCharge the longest, and the event fails when it is over.',
    },
    until_charge  = lsos.number {
      kml = 'UntilCharge', unit = '1', min = 0, max = 1,
      doc = 'Ends when the battery is as full as this.',
    },
    from          = lsos.text {
      kml = 'From', names = 'power_source',
      doc = 'An asset within 20 m that has power to give.',
    },
  },

  -- Waiting for a charge has no end of its own.
  open_ended = function(p) return p.until_charge ~= nil and not p.duration_s end,

  -- With EnergyLevel alone nothing flows.
  awaits_sunlight = function(p)
    return not (p.energy_rate_w or p.from) and (p.until_charge or p.duration_s) ~= nil
  end,

  check  = check,
  start  = 'start',
  phases = { start = start, charge = charge },

  on_abort = function(ev, rover)
    if not (ev.params.until_charge and rover.battery) then return nil end
    return ('charge was %.4g, UntilCharge is %.4g'):format(rover.battery.charge,
      ev.params.until_charge)
  end,
}
