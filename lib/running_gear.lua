-- Where wheels stand, and the damping of what holds them.

local lsos = require 'lsos'
local vec = lsos.vec3

local gear = {}

-- Steered modules of a wishbone suspension: one on each side of axles that are evenly spaced and
-- named from front to rear.
function gear.modules(axles, wheelbase_m, track_m)
  local modules = {}
  for axle, name in ipairs(axles) do
    local x_m = wheelbase_m / 2 - (axle - 1) * wheelbase_m / (#axles - 1)
    modules[#modules + 1] = lsos.module { name = name .. '_left',
                                          position_m = vec(x_m, track_m / 2, 0) }
    modules[#modules + 1] = lsos.module { name = name .. '_right',
                                          position_m = vec(x_m, -track_m / 2, 0) }
  end
  return modules
end

-- Six wheels of a rover of JPL: the front wheel on the rocker, the others on the bogie, those at
-- the corners steered. Distances are half the wheelbase, and those of wheels from the middle line.
function gear.stations(half_base_m, corner_m, middle_m)
  return {
    lsos.station { name = 'front', position_m = vec(half_base_m, corner_m, 0), is_steered = true },
    lsos.station { name = 'middle', position_m = vec(0, middle_m, 0), on = 'bogie' },
    lsos.station { name = 'rear', position_m = vec(-half_base_m, corner_m, 0), is_steered = true,
                   on = 'bogie' },
  }
end

-- Damping that is a share of critical, of a spring on a mass, or on a moment of inertia.
function gear.damping(share, stiffness, inertia)
  return 2 * share * math.sqrt(stiffness * inertia)
end

return gear
