-- Move the limbs into another stance.

local lsos = require 'lsos'

local function check(p, rover)
  if p.stance and p.height_m then
    return 'Stance and Height: a stance has its own height; one of them is wanted'
  end
  if not p.stance and not p.height_m and p.level == nil then
    return 'nothing is asked: Stance, Height or Level is wanted'
  end
  if not rover then return nil end
  if not rover.height_max_m then
    return rover.type .. ' has no limbs: it cannot change its posture'
  end
  if p.level ~= nil and not rover.has_posture_control then
    return ('Level: %s has no posture control: it lies as the ground does'):format(rover.type)
  end
  local h = p.height_m
  if h and (h < rover.height_min_m or h > rover.height_max_m) then
    return ('Height = %g m: %s can stand with %.3f to %.3f m under its chassis')
      :format(h, rover.type, rover.height_min_m, rover.height_max_m)
  end
end

local function start(ev, rover)
  local p = ev.params
  rover:brake()
  ev.state.takes_s = rover:set_posture {
    stance = p.stance, height_m = p.height_m, level = p.level, duration_s = p.duration_s,
  }
  return 'move'
end

local function move(ev, rover)
  local left_s = ev.state.takes_s - ev.phase_elapsed_s
  if left_s > 0 then return lsos.sleep(left_s) end
  if rover.is_adjusting then return nil end
  local why = rover.stance_fault
  if why then return lsos.fail('%s', why) end
  return lsos.done
end

-- What moves is not stopped.
local function on_abort(ev, _)
  local left_s = (ev.state.takes_s or 0) - ev.elapsed_s
  if left_s > 0 then return ('its limbs go on moving for %.4g s'):format(left_s) end
end

return lsos.event {
  api    = 1,
  schema = 'SetPosture',
  doc    = 'Move the limbs into another stance.',

  params = {
    stance     = lsos.text {
      kml = 'Stance', names = 'stance',
      doc = "A configuration of the rover's script, without payload and modes of wheels: Drive, "
        .. 'Stow.',
    },
    height_m   = lsos.number {
      kml = 'Height', unit = 'm', min = 0,
      doc = "From the ground to the chassis' underside, with the wheels where they stand.",
    },
    level      = lsos.boolean {
      kml = 'Level',
      doc = 'Whether it is kept level, else parallel to the ground (default: as the stance says).',
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = 'How long its limbs move; without one as long as the joints need.',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, move = move },

  on_abort = on_abort,
}
