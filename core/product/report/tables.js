// Text and tables: findings, results of rovers and events, notes, pictures, inputs of the run.
const summary = page.summary;

function fillHead() {
  const name = page.plan.replace(/^.*\//, '').replace(/\.km[lz]$/, '');
  document.title = `${name}: mission report`;
  document.getElementById('title').textContent = name;
  document.getElementById('subtitle').textContent =
    `${page.body}, ${page.start_utc.slice(0, 16).replace('T', ' ')} to ${page.end_utc.slice(0, 16).replace('T', ' ')} UTC`;
  const done = page.events.filter(event => event.status === 'completed').length;
  const facts = [
    ['Result', summary ? statusText(summary.status) : 'not finished', summary ? summary.status : 'incomplete'],
    ['Events completed', `${done} of ${page.events.length}`],
    ['Simulated', durationText(page.end_s)],
    ['Driven', distanceText(rovers.reduce((sum, rover) => sum + rover.distance_m, 0))],
  ];
  if (summary?.wall_s > 0) facts.push(['Computed in', durationText(summary.wall_s)]);
  document.getElementById('facts').append(...facts.map(([term, text, kind]) =>
    make('div', {}, make('dt', {}, term), make('dd', kind ? {class: kind} : {}, text))));
}

// Whether an assumption concerns the terrain or the body as a whole, not one vehicle's part.
const isBasic = assumption => [page.terrain, page.body].some(name => assumption.startsWith(`${name}:`));

// What failed, in order of time, each with a link to its time in the plots. Of a rover whose later
// events never began the last failure says how many.
function failureList(bad) {
  const ended = event => event.end_s ?? endS;
  const inOrder = [...bad].sort((a, b) => ended(a) - ended(b));
  const lost = new Map();
  for (const event of inOrder) {
    const count = page.events.filter(other => other.rover_id === event.rover_id && other.status === 'not_started').length;
    if (count > 0) lost.set(event.rover_id, {event, count});
  }
  const lines = inOrder.map(event => {
    const go = make('button', {type: 'button', class: 'link', title: 'Show it in the plots'}, elapsedText(ended(event)));
    go.addEventListener('click', () => (event.start_s === null ? showTime(ended(event)) : showEvent(event)));
    const after = lost.get(event.rover_id);
    return make('li', {}, `${event.rover_id}, ${event.label}: ${statusText(event.status)}${event.reason ? ', ' + event.reason : ''} (`, go,
      `)${after?.event === event ? `; ${after.count} event${after.count > 1 ? 's' : ''} of ${event.rover_id} never began` : ''}`);
  });
  const shown = 10, list = items => make('ul', items.length > 4 ? {class: 'long'} : {}, ...items);
  if (lines.length <= shown) return list(lines);
  return make('div', {}, list(lines.slice(0, shown)),
    make('details', {}, make('summary', {}, `${lines.length - shown} more`), list(lines.slice(shown))));
}

function fillFindings() {
  const list = items => make('ul', items.length > 4 ? {class: 'long'} : {}, ...items.map(item => make('li', {}, item)));
  const box = (kind, title, ...more) => make('div', {class: `finding ${kind}`}, make('h3', {}, title), ...more);
  const place = document.getElementById('findings');
  if (!summary) place.append(box('bad', 'This run has not finished', make('p', {}, 'The page shows what its log held when the page was written.')));
  const bad = page.events.filter(event => event.status === 'failed' || event.status === 'incomplete');
  if (bad.length > 0) {
    const counts = ['failed', 'incomplete', 'not_started']
      .map(status => [page.events.filter(event => event.status === status).length, status])
      .filter(([count]) => count > 0).map(([count, status]) => `${count} ${statusText(status)}`);
    place.append(box('bad', `Of ${page.events.length} event${page.events.length > 1 ? 's' : ''} ${counts.join(', ')}`,
      failureList(bad)));
  }
  const warnings = summary?.warnings || [], assumptions = summary?.assumptions || [];
  // Without a summary the warnings are unknown.
  if (summary) place.append(warnings.length > 0
    ? box('warn', `${warnings.length} warning${warnings.length > 1 ? 's' : ''}`, list(warnings))
    : box('good', 'No warnings', make('p', {},
      'Neither the plan as it was read nor the run had any; what the estimate foresees, lsos-host check says.')));
  // Assumptions are folded, as they are many and the same from run to run. On paper they are unfolded
  // and come last.
  if (summary && assumptions.length > 0) {
    const basic = assumptions.filter(isBasic);
    const folded = make('details', {class: 'finding'},
      make('summary', {}, `${assumptions.length} assumption${assumptions.length > 1 ? 's' : ''}`,
        ...(basic.length > 0 ? [make('span', {}, `; all results rest on: ${basic.join('; ')}`)] : [])),
      list(assumptions));
    addEventListener('beforeprint', () => {
      folded.open = true;
      document.getElementById('made').prepend(folded);
    });
    addEventListener('afterprint', () => {
      folded.open = false;
      place.append(folded);
    });
    place.append(folded);
  } else if (summary) {
    place.append(box('', 'No assumptions listed'));
  }
  if (page.left_out.length > 0) place.append(box('warn', 'Not in this page', list(page.left_out)));
}

// `columns`: [heading, function from row to cell, whether it is a number].
function table(columns, rows, dress = () => {}) {
  return make('table', {}, make('thead', {}, make('tr', {}, ...columns.map(([name, , isNumber]) => make('th', isNumber ? {class: 'number'} : {}, name)))),
    make('tbody', {}, ...rows.map(row => {
      const line = make('tr', {}, ...columns.map(([name, cell, isNumber]) =>
        make('td', isNumber ? {class: 'number'} : name.startsWith('Re') && name !== 'Result' ? {class: 'reason'} : {}, cell(row))));
      dress(line, row);
      return line;
    })));
}
const swatch = (rover, text) => make('span', {}, make('i', {class: 'rover', style: `background:${rover ? rover.ink : '#888'}`}), text);

function fillTables() {
  const about = rover => summary?.rovers?.[rover.id] || {};
  const degrees = value => (value === null || value === undefined ? '–' : `${((value * 180) / Math.PI).toFixed(1)}°`);
  const percent = value => (value === null || value === undefined ? '–' : `${(100 * value).toFixed(1)} %`);
  const has = name => rovers.some(rover => about(rover)[name] !== null && about(rover)[name] !== undefined);
  const columns = [
    ['Rover', rover => swatch(rover, rover.id)],
    ['Type', rover => rover.type || '–'],
    ['Distance', rover => distanceText(rover.distance_m), true],
    ['Duration', rover => durationText(about(rover).duration_s), true],
    ['Driving', rover => durationText(about(rover).drive_s), true],
    ['Energy at start', rover => energyText(about(rover).energy_start_j), true],
    ['at end', rover => energyText(about(rover).energy_end_j), true],
    ['used', rover => energyText(about(rover).energy_used_j), true],
    ['from the Sun', rover => energyText(about(rover).solar_j), true],
    ['Climbed', rover => distanceText(about(rover).elevation_gain_m), true],
    ['Steepest', rover => degrees(about(rover).max_slope_rad), true],
    ['Most slip', rover => percent(about(rover).max_slip), true],
    ['Slip, 95 %', rover => percent(about(rover).p95_slip), true],
  ];
  if (has('resources')) {
    columns.push(['Resources left', rover => Object.entries(about(rover).resources || {}).map(([name, left]) => `${name} ${numberText(left)}`).join(', ') || '–']);
  }
  document.getElementById('rover-table').append(table(columns, rovers));
  const at = time => (time === null ? '–' : elapsedText(time));
  const eventColumns = [
    ['Rover', event => swatch(roverOf(event.rover_id), event.rover_id)],
    ['No', event => String(event.sequence), true],
    ['Event', event => event.label],
    ['Type', event => event.type],
    ['Result', event => make('span', {class: `result ${event.status}`}, `${statusMarks[event.status] || ''} ${statusText(event.status)}`)],
    ['Start', event => at(event.start_s), true],
    ['End', event => withEstimate(at(event.end_s), event.end_s, estimateOf(event).end_s, clockOfEnd), true],
    ['Took', event => (event.start_s === null || event.end_s === null ? '–' : durationText(event.end_s - event.start_s)), true],
    ['Distance', event => distanceText(event.distance_m), true],
    ['Energy used', event => withEstimate(energyText(event.energy_used_j), event.energy_used_j, estimateOf(event).energy_used_j, energyText), true],
    ['From the Sun', event => withEstimate(energyText(event.solar_j), event.solar_j, estimateOf(event).solar_j, energyText), true],
    ...(hasEstimate ? [
      ['Charge at end', event => withEstimate(percentText(chargeAtEnd(event)), chargeAtEnd(event), estimateOf(event).charge_end, percentText, pointsText), true],
    ] : []),
    ['Reason', event => event.reason || ''],
  ];
  if (hasEstimate) document.getElementById('event-table').before(make('p', {class: 'note', id: 'estimate-about'}, estimateText()));
  showEvents(events => table(eventColumns, events, (line, event) => {
    line.title = event.start_s === null ? 'It did not start' : 'Show it in the plots';
    line.addEventListener('click', () => showEvent(event));
  }));
}

const noteText = note => Object.entries(note.fields || {}).map(([name, value]) =>
  `${name} ${typeof value === 'number' ? numberText(value) : typeof value === 'object' ? JSON.stringify(value) : value}`).join(', ');

// The table of notes: messages of events, findings, decisions.
function fillNotes() {
  if (page.notes.length === 0) return document.getElementById('notes').remove();
  document.getElementById('notes-about').textContent = page.notes.length < page.notes_in_log
    ? `${page.notes.length.toLocaleString('en')} of ${page.notes_in_log.toLocaleString('en')}; log.gpkg has all.`
    : 'What events logged, what was found and decided.';
  const labelOf = note => roverOf(note.rover_id)?.events.find(event => event.sequence === note.sequence)?.label || '';
  document.getElementById('note-table').append(table([
    ['Time', note => elapsedText(note.time_s), true],
    ['Rover', note => swatch(roverOf(note.rover_id), note.rover_id)],
    ['Event', labelOf],
    ['Note', note => note.name.replaceAll('_', ' ')],
    ['Reading', noteText],
  ], page.notes, (line, note) => {
    line.title = 'Show its time in the plots';
    line.addEventListener('click', () => showTime(note.time_s));
  }));
}

function showTime(time) {
  if (time < view.from || time > view.to) setWindow(0, endS);
  setCursor(time);
  document.getElementById('course').scrollIntoView({block: 'start'});
}

// Zooms the plots to an event, with a margin of half its duration on either side.
function showEvent(event) {
  if (event.start_s === null) return;
  const end = event.end_s ?? endS, around = Math.max((end - event.start_s) / 2, endS / 200);
  setWindow(event.start_s - around, end + around);
  setCursor(event.start_s);
  document.getElementById('course').scrollIntoView({block: 'start'});
}

// A picture that fills the window on a click, until the next click or Escape.
function enlarging(image) {
  const button = make('button', {type: 'button', class: 'enlarge'}, image);
  button.addEventListener('click', () => {
    const large = make('dialog', {class: 'large'}, make('img', {src: image.src, alt: image.alt}), make('p', {}, image.alt));
    large.addEventListener('click', () => large.close());
    large.addEventListener('close', () => large.remove());
    document.body.append(large);
    large.showModal();
  });
  return button;
}

function fillPictures() {
  const place = document.getElementById('picture-list');
  const moments = new Map();
  for (const picture of page.pictures) {
    const key = `${picture.rover_id}\n${picture.time_s}`;
    if (!moments.has(key)) moments.set(key, []);
    moments.get(key).push(picture);
  }
  if (moments.size === 0) document.getElementById('pictures').remove();
  for (const group of moments.values()) {
    const {rover_id, title, time_s} = group[0];
    const go = make('button', {type: 'button'}, elapsedText(time_s));
    go.addEventListener('click', () => {
      setCursor(time_s);
      document.getElementById('course').scrollIntoView({block: 'start'});
    });
    place.append(make('figure', {},
      make('div', {class: 'frames'}, ...group.map(picture => enlarging(make('img', {
        src: picture.src, alt: `${rover_id}, ${title}, ${picture.view}`, title: `${picture.view}; click to enlarge`,
      })))),
      make('figcaption', {}, swatch(roverOf(rover_id), ''), make('b', {}, title), make('span', {}, ` ${rover_id}, ${group.map(p => p.view).join('; ')}, `), go)));
  }
}

function fillOrigins() {
  const isThinned = rovers.some(rover => rover.shown < rover.samples);
  const samples = rovers.reduce((sum, rover) => sum + rover.samples, 0);
  document.getElementById('thinned').append(
    make('span', {class: 'hint'}, 'Move over a plot for values, drag to zoom, double-click for the whole run, click to hold the cursor (arrow keys move it). '),
    isThinned
      ? `Of the log’s ${samples.toLocaleString('en')} samples each line shows the first, last, least and greatest of ${page.stretches.toLocaleString('en')} stretches, so no extreme is missing; log.gpkg has all.`
      : `Lines show the log’s samples as they are (${samples.toLocaleString('en')}).`);
  const rows = [['plan', page.plan], ['log_sha256', summary?.log_sha256 || ''], ...Object.entries(page.run)];
  document.getElementById('made').append(make('details', {}, make('summary', {}, 'What this run was made of'),
    make('table', {}, make('tbody', {}, ...rows.map(([key, value]) => make('tr', {}, make('td', {}, key), make('td', {}, value)))))));
}
