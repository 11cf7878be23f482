// The page of several runs over each other: the first is the trunk, with which all are compared.
const runs = page.runs.map((run, k) => ({
  ...run, isShown: true, ink: legible(run.colour), rovers: rovers.filter(rover => rover.run === k),
  short: run.folder.replace(/\/+$/, '').replace(/^.*\//, '') || run.folder,
}));
const trunk = runs[0];
const roverIds = [...new Set(rovers.map(rover => rover.id))].sort();
let chosenRover = roverIds.length > 1 ? roverIds[0] : null;  // null: all of them

function showChosen() {
  for (const rover of rovers) rover.isShown = runs[rover.run].isShown && (chosenRover === null || rover.id === chosenRover);
  showRovers();
}

function fillRunsHead() {
  document.title = `${trunk.short}: ${runs.length} runs`;
  document.getElementById('title').textContent = `${runs.length} runs over each other`;
  document.getElementById('subtitle').textContent =
    `${page.body}, ${page.start_utc.slice(0, 16).replace('T', ' ')} UTC; all are set against ${trunk.name}, ${trunk.folder}`;
  const done = runs.filter(run => run.status === 'completed').length;
  const facts = [['Completed', `${done} of ${runs.length}`], ['As the first', `${runs.filter(run => run.is_equal).length} of ${runs.length - 1}`],
    ['Events that differ', String(page.differing_events.length)], ['Simulated', durationText(page.end_s)]];
  document.getElementById('facts').append(...facts.map(([term, text]) => make('div', {}, make('dt', {}, term), make('dd', {}, text))));
}

const runSwatch = run => make('span', {title: run.folder}, make('i', {class: 'rover', style: `background:${run.ink}`}), make('b', {}, run.name), ` ${run.short}`);

function fillRunsFindings() {
  const list = items => make('ul', {}, ...items.map(item => make('li', {}, ...item)));
  const box = (kind, title, items) => make('div', {class: `finding ${kind}`}, make('h3', {}, title), list(items));
  const place = document.getElementById('findings');
  const bad = runs.filter(run => run.status !== 'completed');
  const whatFailed = run => run.rovers.flatMap(rover => rover.events)
    .filter(event => ['failed', 'incomplete'].includes(event.status))
    .map(event => `${event.rover_id}, ${event.label}: ${statusText(event.status)}${event.reason ? ', ' + event.reason : ''}`).join('; ');
  if (bad.length > 0) {
    place.append(box('bad', `${bad.length} of ${runs.length} runs did not complete`, bad.map(run => [
      runSwatch(run), `: ${run.status ? statusText(run.status) : 'not finished'}${whatFailed(run) ? '; ' + whatFailed(run) : ''}`])));
  }
  const later = runs.filter(run => run.start_utc !== trunk.start_utc);
  if (later.length > 0) {
    place.append(box('warn', 'Not all runs start at the same time: the axis counts from the start of each, UTC is that of the first',
      later.map(run => [runSwatch(run), `: starts ${run.start_utc.slice(0, 19).replace('T', ' ')} UTC`])));
  }
  const equal = runs.filter(run => run.is_equal);
  if (equal.length > 0) {
    place.append(box('good', `${equal.length} came to the same as ${trunk.name}`, equal.map(run => [
      runSwatch(run), run.has_equal_log ? ': its log is equal too' : ': only values along the way differ'])));
  }
  if (page.left_out.length > 0) place.append(box('warn', 'Not in this page', page.left_out.map(text => [text])));
}

// A value, and behind it by how much it is not the first run's.
function beside(text, value, first, change) {
  if (first === undefined || value === first || value === null || first === null || value === undefined) return text(value);
  const by = value - first, shown = change(Math.abs(by));
  if (parseFloat(shown) === 0) return text(value);
  return make('span', {}, text(value), make('small', {class: 'change'}, ` ${by < 0 ? '−' : '+'}${shown}`));
}
const clockText = time => (time === null || time === undefined ? '–' : elapsedText(time));
const plainMetres = value => (value >= 1000 ? `${(value / 1000).toFixed(3)} km` : `${value.toFixed(1)} m`);

function fillTotals() {
  document.querySelector('#summary h2').textContent = 'Totals';
  const rows = roverIds.flatMap(id => runs.map(run => ({id, run, own: run.totals?.[id] || {}, first: run === trunk ? {} : trunk.totals?.[id] || {}})));
  const cell = (name, text, change) => ({own, first}) => beside(text, own[name], first[name], change);
  document.getElementById('rover-table').append(table([
    ['Run', ({run}) => runSwatch(run)],
    ...(roverIds.length > 1 ? [['Rover', ({id}) => id]] : []),
    ['Result', ({run}) => make('span', {class: `result ${run.status || 'incomplete'}`}, run.status ? `${statusMarks[run.status]} ${statusText(run.status)}` : 'not finished')],
    ['Distance', cell('distance_m', distanceText, plainMetres), true],
    ['Duration', cell('duration_s', durationText, durationText), true],
    ['Driving', cell('drive_s', durationText, durationText), true],
    ['Energy used', cell('energy_used_j', energyText, energyText), true],
    ['From the Sun', cell('solar_j', energyText, energyText), true],
    ['Energy at end', cell('energy_end_j', energyText, energyText), true],
  ], rows));
}

// Per event the first run, and each other that differs from it.
function fillDiffering() {
  document.querySelectorAll('#summary h2')[1].textContent = 'What differs an event';
  const place = document.getElementById('event-table');
  if (page.differing_events.length === 0) {
    place.append(make('p', {class: 'same'}, 'No event differs in status, start, end, distance or energy.'));
    return;
  }
  const rows = page.differing_events.flatMap(event => event.runs.map((own, k) => ({event, own, k, first: event.runs[0]}))
    .filter(({own, k}) => k === 0 || (own ? own.differs : event.runs[0])));
  const cell = (name, text, change) => ({own, first, k}) =>
    (own ? beside(text, own[name], k > 0 ? first?.[name] : undefined, change) : '');
  document.getElementById('event-table').append(table([
    ['Event', ({event, k}) => (k === 0 ? `${event.rover_id}/${event.sequence} ${event.label}` : '')],
    ['Run', ({k}) => runSwatch(runs[k])],
    ['Result', ({own}) => (own ? make('span', {class: `result ${own.status}`}, `${statusMarks[own.status] || ''} ${statusText(own.status)}`) : 'no such event')],
    ['Start', cell('start_s', clockText, durationText), true],
    ['End', cell('end_s', clockText, durationText), true],
    ['Distance', cell('distance_m', distanceText, plainMetres), true],
    ['Energy used', cell('energy_used_j', energyText, energyText), true],
    ['Reason', ({own}) => own?.reason || ''],
  ], rows, (line, {event, own, k}) => {
    if (k === 0) line.className = 'first';
    const run = runs[k].rovers.find(rover => rover.id === event.rover_id);
    const shown = run?.events.find(one => one.sequence === event.sequence);
    if (own && shown) line.addEventListener('click', () => showEvent(shown));
  }));
}

function fillRunsOrigins() {
  const samples = rovers.reduce((sum, rover) => sum + rover.samples, 0);
  document.getElementById('thinned').append(
    make('span', {class: 'hint'}, 'Move over a plot for values, drag to zoom, double-click for all of it, click to hold the cursor (arrow keys move it). '),
    `Of the logs’ ${samples.toLocaleString('en')} samples each line shows at least the first, last, least and greatest of ${page.stretches.toLocaleString('en')} stretches; the page of one run shows more, log.gpkg all.`);
  const keys = [...new Set(runs.flatMap(run => Object.keys(run.made_of)))];
  const differing = keys.filter(key => runs.some(run => run.made_of[key] !== trunk.made_of[key]));
  const line = (name, cell) => make('tr', {}, make('td', {}, name), ...runs.map(run => make('td', {}, cell(run) ?? '–')));
  document.getElementById('made').append(make('details', {}, make('summary', {}, 'What these runs were made of, where they differ'),
    make('div', {class: 'wide'}, make('table', {}, make('tbody', {},
      make('tr', {}, make('td', {}), ...runs.map(run => make('td', {}, make('b', {}, run.name)))),
      line('folder', run => run.folder), line('plan', run => run.plan), line('log_sha256', run => run.log_sha256?.slice(0, 16)),
      ...differing.map(key => line(key, run => (run.made_of[key] ?? '–').slice(0, 40))))))));
}

// The events of all runs, a row of bars each.
class EventsPlot {
  constructor() {
    this.key = 'events';
    this.isDirty = true;
    this.isSeen = false;
    this.bar = make('canvas', {class: 'bar'});
    this.chosen = make('div', {class: 'chosen', hidden: ''});
    this.cursor = make('div', {class: 'cursor'});
    this.names = make('div', {class: 'bar-names'});
    this.surface = make('div', {class: 'surface'}, this.bar, this.names, make('div', {class: 'shield'}), this.chosen, this.cursor);
    this.element = make('figure', {class: 'plot', id: 'plot-events'}, make('figcaption', {}, make('h3', {}, 'Events')), this.surface);
    this.listRows();
    followPointer(this.surface, () => gutter, () => plotWidth(this.surface), (from, to) => Plot.prototype.choose.call(this, from, to));
  }
  listRows() {
    this.rows = rovers.filter(rover => chosenRover === null || rover.id === chosenRover);
    this.height = this.rows.length * (barHeight + 1) + 2;
    this.bar.style.height = `${this.height + axisHeight}px`;
    this.names.replaceChildren(...this.rows.map((rover, k) =>
      make('span', {style: `top:${k * (barHeight + 1)}px;color:${rover.ink}`}, rover.name)));
  }
  update() {
    this.isDirty = false;
    measure(this.surface);
    const pen = paper(this.bar, this.height + axisHeight), width = plotWidth(this.surface);
    drawEvents(pen, 0, width, this.rows);
    drawTimeAxis(pen, this.height, width);
    this.moveCursor();
  }
  moveCursor() {
    placeCursor(this.cursor, this.surface);
  }
  refresh() { Plot.prototype.refresh.call(this); }
  windowChanged() { this.refresh(); }
  roversChanged() { this.listRows(); this.refresh(); }
  cursorChanged() { if (this.isSeen && !this.isDirty) this.moveCursor(); }
  resized() { this.refresh(); }
}

// The legend: a button a run, which shows or hides it everywhere.
const legend = {
  buttons: runs.map(run => {
    const button = make('button', {class: 'chip run', type: 'button', 'aria-pressed': 'true',
      title: `${run.folder}: show or hide it; with Shift show it alone, or all again`},
    make('i', {style: `background:${run.ink}`}), make('b', {}, run.name), make('span', {}, run.short));
    button.addEventListener('click', event => {
      const isAlone = runs.every(other => other.isShown === (other === run));
      if (event.shiftKey) for (const other of runs) other.isShown = isAlone || other === run;
      else run.isShown = !run.isShown;
      legend.refresh();
      showChosen();
    });
    document.getElementById('chips').append(button);
    return button;
  }),
  refresh() { runs.forEach((run, k) => this.buttons[k].setAttribute('aria-pressed', String(run.isShown))); },
};
if (roverIds.length > 1) {
  const choice = make('select', {id: 'rover-choice', title: 'Whose values the plots show'},
    ...roverIds.map(id => make('option', {value: id}, id)), make('option', {value: ''}, 'all rovers'));
  choice.addEventListener('change', () => {
    chosenRover = choice.value || null;
    showChosen();
  });
  document.querySelector('#bar .tools').prepend(choice);
}

fillRunsHead();
fillRunsFindings();
fillTotals();
fillDiffering();
fillRunsOrigins();
document.getElementById('notes').remove();
document.getElementById('pictures').remove();
const map = new MissionMap(document.getElementById('map'));
showPlots([new EventsPlot(), ...plotSpecs().map(spec => new Plot(spec))]);
showChosen();
setCursor(endS);
