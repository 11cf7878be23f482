-- expect: locals_with_holes.lua:8: 'codes', a local of the file that is used here: [3] without [2]; a list begins at 1 and has no holes, as its length would depend on earlier calls; use text keys otherwise
-- as: events
local lsos = require 'lsos'

local codes = { 10, nil, 30, [2 ^ 60 | 0] = 40 }
local others = { [false] = { [-1] = 0, [1] = 1, [2.5] = 0, [2] = 2 } }

local function go()
  return others[false][1] + #codes > 0 and lsos.done
end

return lsos.event { api = 1, doc = 'A list with a hole.', phases = { go = go } }
