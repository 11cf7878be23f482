// The mission as planners draw it: a block a day with a lane a rover, its events as bars, dark while no
// Sun reaches its panels or they are stowed, a red edge while it does not see Earth. A bar shows its time in the plots.

// Pairs of begin and end, from a series, where the condition holds.
function spansOf(series, holds) {
  const spans = [];
  for (let i = 0; i + 1 < series.t.length; ++i) {
    if (!holds(series.v[i])) continue;
    const last = spans[spans.length - 1];
    if (last && last[1] === series.t[i]) last[1] = series.t[i + 1];
    else spans.push([series.t[i], series.t[i + 1]]);
  }
  return spans;
}

// What lies between the spans of a list [begin, end, begin, end, ...].
function gapsOf(list) {
  const gaps = [];
  let from = 0;
  for (let i = 0; i < list.length; i += 2) {
    if (list[i] > from) gaps.push([from, list[i]]);
    from = Math.max(from, list[i + 1]);
  }
  if (from < endS) gaps.push([from, endS]);
  return gaps;
}

function fillTimeline() {
  const place = document.getElementById('timeline');
  if (dayCount === 1) return place.remove();
  const shades = new Map(rovers.map(rover => {
    const earth = page.sight.find(pair => pair.from === rover.id && pair.to === 'Earth');
    return [rover, {
      dark: rover.sun_fraction ? spansOf(rover.sun_fraction, value => value === 0) : [],
      unseen: earth ? gapsOf(earth.visible) : [],
    }];
  }));
  const key = (attributes, text) => make('span', {}, make('i', {class: 'kind', ...attributes}), text);
  const used = kinds.filter(kind => page.events.some(event => event.start_s !== null && kindOf(event) === kind));
  place.append(make('h2', {}, 'Timeline'), make('div', {class: 'keys'},
    ...used.map(kind => key({style: `background:${kind.colour}`}, kind.name)),
    ...([...shades.values()].some(shade => shade.dark.length > 0) ? [key({class: 'kind dark'}, 'no Sun on its panels, or they are stowed')] : []),
    ...([...shades.values()].some(shade => shade.unseen.length > 0) ? [key({class: 'kind unseen'}, 'no Earth')] : [])));
  // Days begin at the clock time at which the mission does.
  const clocks = [0, 0.25, 0.5, 0.75].map(share => make('span', {style: `left:${100 * share}%`}, utcText(share * dayS).slice(11, 16)));
  place.append(make('div', {class: 'day-block'}, make('span', {class: 'day-name'}, make('small', {}, 'UTC')),
    make('div', {class: 'lanes'}, make('div', {class: 'lane-row'}, make('b', {}, ''), make('div', {class: 'clocks'}, ...clocks)))));
  for (let day = 1; day <= dayCount; ++day) {
    const [from, to] = [(day - 1) * dayS, day * dayS];
    const bar = (begin, end, attributes) => {
      const left = Math.max(begin, from), right = Math.min(end, to);
      if (right < left || begin >= to || end < from) return [];
      const style = `left:${(100 * (left - from)) / dayS}%;width:${(100 * (right - left)) / dayS}%;${attributes.style || ''}`;
      return [make('i', {...attributes, style})];
    };
    const lanes = rovers.map(rover => {
      const lane = make('div', {class: 'lane'});
      for (const [begin, end] of shades.get(rover).dark) lane.append(...bar(begin, end, {class: 'dark'}));
      for (const event of rover.events) {
        if (event.start_s === null) continue;
        const end = event.end_s ?? endS;
        const [made] = bar(event.start_s, end, {class: event.status === 'failed' ? 'event failed' : 'event', style: `background:${kindOf(event).colour}`,
          title: `${event.label}: ${utcText(event.start_s).slice(5, 16)}, ${durationText(end - event.start_s)}, ${statusText(event.status)}`});
        made?.addEventListener('click', () => {
          showDay(day);
          setCursor(event.start_s);
          document.getElementById('course').scrollIntoView({block: 'start'});
        });
        if (made) lane.append(made);
      }
      for (const [begin, end] of shades.get(rover).unseen) lane.append(...bar(begin, end, {class: 'unseen'}));
      return make('div', {class: 'lane-row'}, make('b', {style: `color:${rover.ink}`}, rover.id), lane);
    });
    place.append(make('div', {class: 'day-block'}, make('span', {class: 'day-name'}, `Day ${day}`, make('small', {}, utcText(from).slice(5, 16))),
      make('div', {class: 'lanes'}, ...lanes)));
  }
}
