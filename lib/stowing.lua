-- What events that raise or lower panels and antennas have in common.

local lsos = require 'lsos'

local stowing = {}

local result = { deploy = 'up', stow = 'stowed' }

-- Phases of an event that deploys or stows parts of a rover: `verb` is 'deploy' or 'stow', `group`
-- 'panels' or 'antennas', and `key` the parameter with the part's name.
function stowing.phases(verb, group, key)
  local function start(ev, rover)
    rover:brake()
    local parts, name = rover[group], ev.params[key]
    local takes_s, moves = parts[verb](parts, name, ev.params.duration_s)
    ev.state.takes_s = takes_s
    if not moves then
      ev:warn('%s %s already: nothing was done',
              name and ("'%s' is"):format(name) or 'all are', result[verb])
    end
    return verb
  end

  local function move(ev, rover)
    local left_s = ev.state.takes_s - ev.phase_elapsed_s
    if left_s > 0 then return lsos.sleep(left_s) end
    -- A panel that got stuck on its way says so when it is told again.
    if group == 'panels' and ev.state.takes_s > 0 then
      rover.panels[verb](rover.panels, ev.params[key])
    end
    return lsos.done
  end

  return { start = start, [verb] = move }
end

-- What moves is not stopped.
function stowing.on_abort(ev, _)
  local left_s = (ev.state.takes_s or 0) - ev.elapsed_s
  if left_s > 0 then return ('it goes on moving for %.4g s'):format(left_s) end
end

return stowing
