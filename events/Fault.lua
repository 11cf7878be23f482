-- Something of the rover breaks, or works again. The rover goes on as well as it can.

local lsos = require 'lsos'

local function breakage(p)
  return { what = p.what, part = p.part, mode = p.mode, share = p.share, is_repair = p.repair }
end

local function start(ev, rover)
  rover:break_part(breakage(ev.params))
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Fault',
  doc    = 'Something of the rover breaks, or works again.',

  params = {
    what   = lsos.choice {
      kml = 'What', required = true,
      choices = { 'wheel', 'steering', 'limb', 'antenna', 'battery', 'panel' },
      doc = 'What breaks.',
    },
    part   = lsos.text {
      kml = 'Part', doc = 'Its name on the rover; of a limb, a joint of it too; without one all.',
    },
    mode   = lsos.choice {
      kml = 'Mode', choices = { 'locked', 'free', 'stuck', 'dead' },
      doc = 'A wheel is locked (default) or free, steering stuck, a limb locked, an antenna '
        .. 'dead, a panel stuck (default) or dead; a repair undoes that alone, without one all.',
    },
    share  = lsos.number {
      kml = 'Share', unit = '1', min = 0, max = 1,
      doc = 'Of the area of a dead panel, or of the capacity that the battery had at first; '
        .. 'without one the whole panel.',
    },
    at_s   = lsos.moment {
      kml = 'At',
      doc = 'UTC, or from the start of the mission: when it happens, whatever the rover does; '
        .. 'without one in its turn.',
    },
    repair = lsos.boolean {
      kml = 'Repair', default = false, doc = 'It works again, as before the mission.',
    },
  },

  goes_on_without_power = true,

  at     = 'at_s',
  breaks = breakage,
  start  = 'start',
  phases = { start = start },
}
