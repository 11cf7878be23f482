-- Drive behind another rover along its track, until all its events have ended.

local lsos = require 'lsos'

-- It has followed when it is no farther behind in the end than this times Distance.
local near_enough = 1.2

local function start(ev, rover)
  rover:follow_rover(ev.params.leader, { distance_m = ev.params.distance_m })
  return 'drive'
end

local function drive(ev, rover)
  local status = rover.drive.status
  if status == 'failed' then
    return lsos.fail("%s; it followed '%s', %.1f m ahead along its track", rover.drive.reason,
      ev.params.leader, rover.drive.remaining_m)
  end
  if status == 'arrived' then return 'stop' end
  local duration_s = ev.params.duration_s
  if not duration_s then return lsos.arrival end
  if ev.elapsed_s >= duration_s then return 'stop' end
  return lsos.arrival_within(duration_s - ev.elapsed_s)
end

local function stop(ev, rover)
  local p, drives = ev.params, rover.drive
  local behind_m, why = drives.remaining_m, 'Duration is over'
  if drives.status == 'arrived' then why = ("all events of '%s' have ended"):format(p.leader) end
  rover:brake()
  if behind_m > near_enough * p.distance_m then
    return lsos.fail("%s, and '%s' is %.1f m ahead along its track; with Distance = %g m it may "
      .. 'be %.1f m', why, p.leader, behind_m, p.distance_m, near_enough * p.distance_m)
  end
  ev:log('followed', { leader = p.leader, distance_m = behind_m })
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Follow',
  doc    = 'Drive behind another rover along its track, until all its events have ended.',
  kind   = 'driving',

  geometry = 'none',
  drives   = true,
  params   = {
    leader     = lsos.text {
      kml = 'Leader', names = 'leader', required = true,
      doc = 'RoverId of the rover that it follows.',
    },
    distance_m = lsos.number {
      kml = 'Distance', unit = 'm', min = 1, max = 1000, default = 20,
      role = 'following_distance',
      doc = 'Kept to the leader, along its track, between their reference points.',
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = 'How long; without it until all events of the leader have ended.',
    },
  },

  start  = 'start',
  phases = { start = start, drive = drive, stop = stop },

  on_abort = function(ev, rover)
    local drives = rover.drive
    local behind_m = drives.remaining_m
    rover:brake()
    if drives.status == 'none' then return end
    return ("'%s' was %.1f m ahead along its track"):format(ev.params.leader, behind_m)
  end,
}
