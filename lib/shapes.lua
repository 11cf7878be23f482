-- Parts of a rover's body, as they are drawn and as they shade its panels.

local lsos = require 'lsos'

local shapes = {}

-- A box; size_m and position_m, of its middle, are vec(forward, left, up).
function shapes.box(size_m, position_m, colour)
  return lsos.shape { size_m = size_m, position_m = position_m, colour = colour }
end

-- A cylinder along an axis.
function shapes.tube(radius_m, length_m, axis, position_m, colour)
  return lsos.shape {
    radius_m = radius_m, length_m = length_m, axis = axis, position_m = position_m, colour = colour,
  }
end

return shapes
