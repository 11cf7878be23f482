-- Rovers together: one follows another, two meet, one is in the way of another.

local lsos = require 'lsos'

local function sev(east_m, north_m, heading_deg, event)
  return { type = 'SEV', at = { east_m, north_m }, heading_deg = heading_deg, events = { event } }
end

local function apart_m(sim, a, b)
  return (sim.rovers[a].position - sim.rovers[b].position):length()
end

lsos.scenario('Follow keeps its distance, stands with the leader and goes on with it', function(t)
  local leader = sev(0, 0, 90, { 'Route', at = { 60, 0 }, Speed = 1 })
  table.insert(leader.events, { 'Pause', Duration = '10 min' })
  table.insert(leader.events, { 'Route', at = { 120, 0 }, Speed = 1 })
  local sim = lsos.sim { rovers = { A = leader, B = sev(-20, 0, 90, { 'Follow', Leader = 'A' }) } }
  sim:run_until(function(s) return s:event('A/20').status == 'running' end, 200)
  sim:run_for('5 min')
  t:check(sim.rovers.B.is_parked, 'it stands')
  t:near(apart_m(sim, 'A', 'B'), 20, 1, 'while both stand')
  sim:run_until(function(s) return s:event('A/30').status == 'running' end, 600)
  sim:run_for(30)
  t:near(apart_m(sim, 'A', 'B'), 20, 3, 'on the way')
  sim:run()
  t:equal(sim:event('B/10').status, 'completed')
  t:equal(sim:notes('followed')[1].fields.leader, 'A')
  t:near(apart_m(sim, 'A', 'B'), 20, 2, 'in the end')
end)

lsos.scenario('Follow ends after its Duration, and says how far behind it was', function(t)
  local function followed(distance)
    local sim = lsos.sim {
      rovers = {
        A = sev(0, 0, 90, { 'Route', at = { 200, 0 } }),
        B = sev(-100, 0, 90, { 'Follow', Leader = 'A', Distance = distance, Duration = 30 }),
      },
    }
    sim:run()
    return sim:event('B/10')
  end
  t:equal(followed(110).status, 'completed')
  local late = followed(20)
  t:equal(late.status, 'failed')
  t:near(late.end_s, 30, 0.1)
  t:check(late.reason:find("^Duration is over, and 'A' is %d+%.%d m ahead along its track"),
    late.reason)
  t:check(late.reason:find('with Distance = 20 m it may be 24.0 m', 1, true), late.reason)
end)

lsos.scenario('a follower enters the track from aside and leaves no corner out', function(t)
  local sim = lsos.sim {
    rovers = {
      A = sev(0, 0, 90, { 'Route', path = { { 0, 0 }, { 80, 0 }, { 80, 60 } }, Speed = 0.5 }),
      B = sev(10, -40, 0, { 'Follow', Leader = 'A', Distance = 15 }),
    },
  }
  local aside_m = 0
  sim:run_until(function(s)
    local p = s.rovers.B.position
    if p.y > -0.5 then aside_m = math.max(aside_m, math.min(math.abs(p.y), math.abs(p.x - 80))) end
    return s:event('B/10').status ~= 'running'
  end)
  t:equal(sim:event('B/10').status, 'completed')
  t:check(aside_m < 2.5, ('%.2f m beside the track'):format(aside_m))
end)

lsos.scenario('a follower that gets stuck names its leader', function(t)
  local sim = lsos.sim {
    rovers = {
      A = sev(0, 0, 90, { 'Route', at = { 150, 0 } }),
      B = sev(-20, 0, 90, { 'Follow', Leader = 'A' }),
    },
  }
  sim:run_for(10)
  for _, axle in ipairs { 'front', 'middle', 'rear' } do
    for _, side in ipairs { 'left', 'right' } do
      for _, wheel in ipairs { 1, 2 } do
        sim:set_wheel('B', ('%s_%s_wheel_%d'):format(axle, side, wheel))
      end
    end
  end
  sim:run()
  local reason = sim:event('B/10').reason
  t:equal(sim:event('B/10').status, 'failed')
  t:check(reason:find("^stuck: no progress in 60 s.*; it followed 'A', %d+%.%d m ahead"), reason)
end)

lsos.scenario('two rovers that both drive and would touch both end, with both names', function(t)
  local function meet(a, b)
    local sim = lsos.sim { rovers = { A = a, B = b } }
    sim:run()
    for id, other in pairs { A = 'B', B = 'A' } do
      local event = sim:event(id .. '/10')
      t:equal(event.status, 'failed')
      local wanted = ('%s would touch %s, whose centre is'):format(id, other)
      t:check(event.reason:find(wanted, 1, true), event.reason)
      t:check(event.reason:find('the drives of both end', 1, true), event.reason)
    end
    local notes = sim:notes('would_touch')
    t:equal(#notes, 2)
    t:equal(notes[1].fields.ended[1] .. notes[1].fields.ended[2], 'AB')
    t:check(apart_m(sim, 'A', 'B') > 4, 'they do not touch')
  end
  meet(sev(0, 0, 90, { 'Route', at = { 80, 0 } }), sev(80, 0, 270, { 'Route', at = { 0, 0 } }))
  meet(sev(0, 0, 90, { 'Route', at = { 80, 0 } }), sev(40, -40, 0, { 'Route', at = { 40, 40 } }))
end)

lsos.scenario('a rover that stands is not touched, and its event goes on', function(t)
  local sim = lsos.sim {
    rovers = {
      A = sev(0, 0, 90, { 'Route', at = { 80, 0 } }),
      B = { type = 'ATHLETE', at = { 40, 0 }, events = { { 'Pause', Duration = '3 min' } } },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:check(sim:event('A/10').reason:find('^would touch B'), sim:event('A/10').reason)
  t:equal(sim:event('B/10').status, 'completed')
end)

lsos.scenario('a planned route goes round a rover that stands in its way', function(t)
  for _, type in ipairs { 'SEV', 'ATHLETE' } do
    local sim = lsos.sim {
      rovers = {
        A = sev(0, 0, 90, { 'PathPlanRoute', at = { 80, 0 } }),
        B = { type = type, at = { 40, 0 }, events = { { 'Pause', Duration = '10 min' } } },
      },
    }
    sim:run()
    t:equal(sim:event('A/10').status, 'completed', type .. ': ' .. (sim:event('A/10').reason or ''))
    t:equal(#sim:notes('replan'), 1, type)
    t:near(sim.rovers.A.position.x, 80, 1.5)
  end
end)

lsos.scenario('a slow or small rover finds room to go round another too', function(t)
  local function goes_round(type, speed, goal_m)
    local sim = lsos.sim {
      rovers = {
        A = {
          type = type, at = { 0, 0 }, heading_deg = 90,
          events = { { 'PathPlanRoute', at = { goal_m, 0 }, Speed = speed } },
        },
        B = { type = 'SEV', at = { 12, 0 }, events = { { 'Pause', Duration = '30 min' } } },
      },
    }
    sim:run_until(function(s) return s:event('A/10').status ~= 'running' and s.time_s > 1 end)
    local what = type .. ' at ' .. speed
    t:equal(sim:event('A/10').status, 'completed', what .. ': ' .. (sim:event('A/10').reason or ''))
    t:check(#sim:notes('replan') >= 1, what .. ' planned anew')
    t:near(sim.rovers.A.position.x, goal_m, 1.5, what)
  end
  goes_round('SEV', '0.3 m/s', 24)
  goes_round('MER', '0.05 m/s', 18)
end)

lsos.scenario('Rendezvous of two rovers that drive towards each other', function(t)
  for _, plans in ipairs { false, true } do
    local function event(other)
      return { 'Rendezvous', With = other, Distance = '25 m', Plan = plans }
    end
    local sim = lsos.sim {
      rovers = { A = sev(0, 0, 90, event('B')), B = sev(200, 30, 270, event('A')) },
    }
    sim:run()
    t:equal(sim:event('A/10').status, 'completed')
    t:equal(sim:event('B/10').status, 'completed')
    t:check(apart_m(sim, 'A', 'B') < 25.5, ('%.1f m apart'):format(apart_m(sim, 'A', 'B')))
    t:check(apart_m(sim, 'A', 'B') > 8, 'none drives into the other')
    t:check(sim.rovers.A.position.x > 60 and sim.rovers.B.position.x < 140, 'both drove')
  end
end)
