-- StartWhen, SkipWhen, StopWhen and WarnWhen.

local lsos = require 'lsos'

lsos.scenario('StopWhen fails an event, and OnFailure goes on elsewhere', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type   = 'SEV', charge = 0.5,
        events = {
          { 'Route', at = { 0, 500 }, StopWhen = 'distance_m > 50', OnFailure = 'goto rest' },
          { 'Pause', Duration = 10, label = 'between' },
          { 'Pause', Duration = 10, label = 'rest' },
        },
      },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:equal(sim:event('A/10').reason, 'StopWhen: distance_m > 50')
  t:near(sim:event('A/10').distance_m, 50, 3)
  t:equal(sim:event('between').status, 'skipped')
  t:equal(sim:event('rest').status, 'completed')
  t:equal(#sim:notes('stop_when'), 1)
end)

lsos.scenario('WarnWhen tells each time that it begins to hold, and stops nothing', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type   = 'SEV',
        events = { { 'Pause', Duration = 55, WarnWhen = 'time_s % 20 > 5', label = 'stand' } },
      },
    },
  }
  sim:run()
  local notes = sim:notes('warn_when')
  t:equal(#notes, 3)
  t:equal(notes[1].time_s, 6)
  t:equal(notes[3].time_s, 46)
  t:equal(notes[1].fields.event, 'stand')
  t:equal(sim:event('stand').status, 'completed')
end)

lsos.scenario('SkipWhen skips, and StartWhen waits', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type   = 'SEV',
        events = {
          { 'Pause', Duration = 10, SkipWhen = 'charge > 0.9', label = 'no need' },
          { 'Pause', Duration = 10, StartWhen = "distance_to('B') < 30", label = 'near' },
        },
      },
      B = { type = 'SEV', at = { 80, 0 }, events = { { 'Route', at = { 20, 0 } } } },
    },
  }
  sim:run()
  t:equal(sim:event('no need').status, 'skipped')
  local start_s = sim:event('near').start_s
  t:equal(sim:event('near').status, 'completed')
  t:check(start_s > 10 and start_s == math.floor(start_s), 'at a whole second')
  t:equal(#sim:notes('waits_for'), 1)
  t:equal(#sim:notes('start_when'), 1)
end)

lsos.scenario('a condition with a wrong name is refused before anything runs', function(t)
  local function plan(condition)
    return function()
      local pause = { 'Pause', Duration = 1, StartWhen = condition }
      lsos.sim { rovers = { A = { type = 'SEV', events = { pause } } } }
    end
  end
  t:fails(plan 'chrage < 0.3', "did you mean 'charge'")
  t:fails(plan "distance_to('SEV9') < 3", "there is no rover or asset 'SEV9'")
  t:fails(plan 'charge <', 'StartWhen = charge <')
  t:fails(plan 'os.exit()', "a condition has no 'os'")
end)
