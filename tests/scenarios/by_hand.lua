-- What a prompt and scenarios do with a simulation.

local lsos = require 'lsos'

local function sim_of(...)
  return lsos.sim { rovers = { A = { type = 'SEV', events = { ... } } } }
end

lsos.scenario('dispatch adds an event to a mission that runs, and to one that is over', function(t)
  local sim = sim_of { 'Pause', Duration = 60 }
  sim:run_for(30)
  local number = sim:dispatch('A', 'Pause', { Duration = 20 })
  t:equal(number, 11)
  sim:run()
  t:equal(sim:event('A/11').status, 'completed')
  t:near(sim.time_s, 80, 1)
  sim:dispatch('A', 'Route', { at = { 0, 20 } })
  sim:run()
  t:equal(sim:event('A/12').status, 'completed')
  t:near(sim.rovers.A.distance_m, '20 m', '2 m')
end)

lsos.scenario('what is saved and loaded goes on the same', function(t)
  local sim = sim_of { 'Route', at = { 0, 60 } }
  sim:run_for(20)
  sim:save('out/by_hand.state')
  sim:run()
  local end_s, drive_j = sim.time_s, sim.rovers.A.drive_j
  sim:load('out/by_hand.state')
  t:near(sim.time_s, 20, 0)
  sim:run()
  t:equal(sim.time_s, end_s)
  t:equal(sim.rovers.A.drive_j, drive_j)
end)

lsos.scenario('a phase at a time', function(t)
  local sim = sim_of { 'EVA' }
  local seen = {}
  while not sim.is_finished do
    seen[#seen + 1] = sim:where():match("'EVA 10' in (%a+)")
    sim:step_phase()
  end
  t:equal(table.concat(seen, ' '), 'exit activity entry')
end)

lsos.scenario('mistakes say what is there', function(t)
  local sim = lsos.sim { rovers = { A = { type = 'SEV' } } }
  t:fails(function() sim:event('B/10') end, "there is no event 'B/10'")
  t:fails(function() sim:dispatch('A', 'Puase', { Duration = 1 }) end, "did you mean 'Pause'")
  t:fails(function() sim:dispatch('B', 'Pause', { Duration = 1 }) end, "there is no rover 'B'")
  t:fails(function() sim:set_wheel('A', 'fifth wheel') end, "no wheel 'fifth wheel'")
  t:fails(function() lsos.sim { rovers = { A = { tpye = 'SEV' } } } end, "did you mean 'type'")
  t:fails(function() return sim.rover end, "did you mean 'rovers'")
end)

lsos.scenario('a picture of where it stands, from the sun or the side', function(t)
  local sim = sim_of { 'Route', at = { 0, 60 } }
  sim:run_for(20)
  t:equal(sim:picture(), sim.folder .. '/20_s.png')
  sim:run_for(10)
  t:equal(sim:picture(sim.folder .. '/side.png', { from = 'chase', size_px = 320 }),
    sim.folder .. '/side.png')
  t:fails(function() sim:picture('x.png', { from = 'behind' }) end, 'behind: no such view')
  t:fails(function() sim:picture('x.jpg') end, 'sim:picture x.jpg: the name must end in .png')
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
end)

local function driven_on(soil)
  local sim = sim_of { 'Route', at = { 0, 60 } }
  sim:run_for(10)
  sim:set_soil(soil)
  sim:save('out/by_hand_soil.state')
  sim:run()
  return sim, sim.rovers.A.drive_j
end

lsos.scenario('another soil is saved with the state, and in the log', function(t)
  local sim, drive_j = driven_on 'ApolloLoose'
  t:equal(#sim:notes('soil_set'), 1)
  t:equal(sim:notes('soil_set')[1].fields.soil, 'ApolloLoose')
  local other = sim_of { 'Route', at = { 0, 60 } }
  other:load('out/by_hand_soil.state')
  t:near(other.time_s, 10, 0)
  other:run()
  t:equal(other.rovers.A.drive_j, drive_j)
  t:fails(function() sim:set_soil('Quicksand') end, "no soil 'Quicksand'")
  t:equal(#sim.events, 1, 'all is as it was')
end)

lsos.scenario('dispatched events are saved with the state', function(t)
  local sim = sim_of { 'Pause', Duration = 60 }
  sim:run_for(10)
  sim:dispatch('A', 'Pause', { Duration = 20, label = 'more' })
  sim:save('out/by_hand_1.state')
  sim:dispatch('A', 'Pause', { Duration = 30 })
  sim:save('out/by_hand_2.state')
  sim:load('out/by_hand_1.state')
  t:equal(#sim.events, 2)
  sim:run()
  t:near(sim.time_s, 80, 1)
  local other = sim_of { 'Pause', Duration = 60 }
  other:load('out/by_hand_2.state')
  t:equal(#other.events, 3)
  other:run()
  t:equal(other:event('more').status, 'completed')
  t:near(other.time_s, 110, 1)
end)

lsos.scenario('what is dispatched later comes later, and before what the plan has next', function(t)
  local sim = lsos.sim {
    rovers = {
      A = { type = 'SEV', events = { { 'Pause', Duration = 60 }, { 'Pause', Duration = 60 } } },
    },
  }
  sim:run_for(10)
  t:equal(sim:dispatch('A', 'Pause', { Duration = 1 }), 11)
  t:equal(sim:dispatch('A', 'Pause', { Duration = 2 }), 12)
  sim:run()
  t:near(sim:event('A/12').end_s, 63, 0)
end)

lsos.scenario('notes are saved with the state', function(t)
  local sim = sim_of { 'Pause', Duration = 60 }
  sim:shade('A', 0.5)
  sim:save('out/by_hand_noted.state')
  local other = sim_of { 'Pause', Duration = 60 }
  other:silence('A')
  other:load('out/by_hand_noted.state')
  t:equal(#other:notes(), 1)
  t:equal(other:notes()[1].name, 'shaded')
end)

lsos.scenario('nothing else is replaced by what is saved or drawn', function(t)
  local sim = sim_of { 'Pause', Duration = 60 }
  sim:save('out/by_hand_kept.state')
  sim:save('out/by_hand_kept.state')
  sim:save('out/by_hand_kept.png')
  t:fails(function() sim:picture('out/by_hand_kept.png') end, 'is there and is something else')
  t:fails(function() sim:save(sim.folder .. '/plan.kml') end, 'plan.kml is there and is something')
  sim:load('out/by_hand_kept.state')
end)

lsos.scenario('what a hand does is in the notes', function(t)
  local sim = sim_of { 'Route', at = { 0, 60 } }
  sim:run_for(5)
  sim:set_wheel('A', 'front_left_wheel_1', 'free')
  sim:shade('A', 0.5)
  sim:silence('A')
  sim:stick_panel('A')
  local names = {}
  for _, note in ipairs(sim:notes()) do names[#names + 1] = note.name end
  -- A run that begins as this one ends reads what is broken from the notes 'fault'.
  t:equal(names,
    { 'fault', 'wheel_set', 'shaded', 'fault', 'silenced', 'fault', 'panel_stuck' })
  t:equal(sim:notes('wheel_set')[1].fields, { mode = 'free', wheel = 'front_left_wheel_1' })
  t:near(sim:notes('shaded')[1].time_s, 5, 0)
end)

lsos.scenario('dispatched events are checked as those of a plan', function(t)
  local sim = sim_of { 'Pause', Duration = 60 }
  local function add(event) return function() sim:dispatch('A', 'Pause', event) end end
  local function condition(text, fault) t:fails(add { Duration = 1, StartWhen = text }, fault) end
  condition('chrage < 1', "did you mean 'charge'")
  condition("distance_to('A') < 5", "'A' is the event's own rover")
  condition("sees('Earth') == 1",
    "'==' compares true or false with a number, and they never are the same; sees needs no " ..
    "comparison: 'not' turns it round")
  condition('true ~= charge', "'~=' compares true or false with a number")
  condition("charge == 'full'", "'==' compares a number with a text")
  condition('not charge == 1', "'==' compares true or false with a number")
  add { Duration = 1, StartWhen = "charge < 2 == true and sees('Earth') == false or charge == 1" }()
  add { Duration = 1, StartWhen = 'pitch_rad > -0.1 == true or charge < 1e-2 == false' }()
  add { Duration = 1, StartWhen = "charge > 2 * 3 ~= sees('Earth') or 0 + '1' == charge" }()
  t:fails(function() sim:dispatch('A', 'Rendezvous', { With = 'nobody' }) end, 'nobody')
  t:equal(#sim.events, 4)
end)

lsos.scenario('a mission goes on for what is dispatched', function(t)
  local sim = lsos.sim 'plans/first_drive.kml'
  sim:run()
  sim:dispatch('SEV1', 'Pause', { Duration = '3 d' })
  sim:run()
  t:equal(sim.events[#sim.events].status, 'completed', 'though its MaxDuration is 25 h by default')
end)

lsos.scenario('a plan that is wrong says so', function(t)
  local function with(events)
    return function() lsos.sim { rovers = { A = { type = 'SEV', events = events } } } end
  end
  t:fails(with(5), 'events: a list is wanted')
  t:fails(with { { {} } }, 'an event is a table that begins with its type')
  t:fails(with { { 123 } }, 'an event is a table that begins with its type')
  t:fails(with { Pause = { Duration = 5 } }, 'a list without gaps')
  t:fails(with { { 'Pause', Duration = 5 }, nil, { 'Pause', Duration = 5 } }, 'a list without gaps')
end)

lsos.scenario('the ground and the sky at a rover', function(t)
  local sim = lsos.sim {
    site = { 25, -89.5 },
    rovers = { A = { type = 'SEV', events = { { 'Pause', Duration = 60 } } } },
  }
  local ground = sim.rovers.A:ground_at(lsos.vec3(30, 40, 100))
  t:near(ground.position.x, '30 m', '1 cm')
  t:near(ground.slope_rad, '0 deg', '0.01 deg')
  t:equal(ground.soil, 'ApolloNominal')
  local sky = sim.rovers.A:sky()
  t:near(sky.sun_elevation_rad, '0 deg', '2.1 deg', 'near the pole the Sun stays low')
  t:near(sky.earth_elevation_rad, '0 deg', '8 deg', 'so does Earth')
end)
