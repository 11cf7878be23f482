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
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
end)
