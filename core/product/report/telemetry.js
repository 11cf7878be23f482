// The page of telemetry over a run: measured points on the run's curves, and the residuals.
const telemetry = page.telemetry;

// How values of a kind are shown, by the greatest of them in SI.
function shownUnit(kind, most) {
  const per = {
    length: most >= 10000 ? ['km', 1e-3] : ['m', 1], speed: most < 0.2 ? ['cm/s', 100] : ['m/s', 1],
    energy: most >= 1.8e6 ? ['kWh', 1 / 3.6e6] : ['Wh', 1 / 3600], power: most >= 2000 ? ['kW', 1e-3] : ['W', 1],
    angle: ['°', 180 / Math.PI], fraction: ['%', 100],
  }[kind] || ['', 1];
  return {unit: per[0], scale: per[1]};
}
const titleOf = series => series.title.replace(/, (m|m\/s|rad|J|W|0 to 1)$/, '');
const mostOf = lines => greatest(lines.map(({v}) => ({v: v.filter(value => !Number.isNaN(value))})));

function fillTelemetryHead() {
  const name = telemetry.file.replace(/^.*\//, ''), plan = page.plan.replace(/^.*\//, '').replace(/\.km[lz]$/, '');
  document.title = `${plan}: prediction against ${name}`;
  document.getElementById('title').textContent = `${plan}: prediction against ${name}`;
  document.getElementById('subtitle').textContent =
    `${page.body}, ${page.start_utc.slice(0, 16).replace('T', ' ')} UTC; residuals are measured − simulated, between samples linear in time`;
  document.getElementById('facts').append(...[['Rows used', `${telemetry.rows_used} of ${telemetry.rows}`], ['Run', durationText(page.end_s)]]
    .map(([term, text]) => make('div', {}, make('dt', {}, term), make('dd', {}, text))));
}

function fillTelemetryFindings() {
  const list = items => make('ul', {}, ...items.map(item => make('li', {}, item)));
  const place = document.getElementById('findings');
  if (telemetry.unusable.length > 0) {
    place.append(make('details', {class: 'finding warn', open: ''}, make('summary', {}, 'What could not be used'), list(telemetry.unusable)));
  }
  if (page.left_out.length > 0) place.append(make('div', {class: 'finding warn'}, make('h3', {}, 'Not in this page'), list(page.left_out)));
}

function fillResiduals() {
  const seriesOf = row => telemetry.series.find(series => series.rover_id === row.rover_id && series.quantity === row.quantity);
  const text = (row, name, isSigned) => {
    if (row[name] === null) return '–';
    const {unit, scale} = shownUnit(seriesOf(row).kind, Math.abs(row.greatest)), value = row[name] * scale;
    return `${isSigned && value > 0 ? '+' : ''}${numberText(value, 3)} ${unit}`;
  };
  const during = row => ({all: 'all along', event: `${row.sequence} ${row.label}`}[row.during] || row.during);
  const fill = (id, rows) => document.getElementById(id).append(table([
    ['Rover', row => swatch(roverOf(row.rover_id), row.rover_id)],
    ['During', during],
    ['Quantity', row => titleOf(seriesOf(row))],
    ['Count', row => row.count.toLocaleString('en'), true],
    ['Mean', row => text(row, 'mean', true), true],
    ['Rms', row => text(row, 'rms'), true],
    ['Greatest', row => text(row, 'greatest', true), true],
    ['at', row => (row.greatest_time_s === null ? '–' : elapsedText(row.greatest_time_s)), true],
  ], rows, (line, row) => {
    if (row.greatest_time_s !== null) line.addEventListener('click', () => showTime(row.greatest_time_s));
  }));
  const [overall, events] = document.querySelectorAll('#summary h2');
  overall.textContent = 'Residuals';
  events.textContent = 'Residuals an event';
  fill('rover-table', telemetry.residuals.filter(row => row.during === 'all'));
  fill('event-table', telemetry.residuals.filter(row => row.during !== 'all'));
}

const measuredInk = rover => (rovers.length === 1 ? '#17212b' : rover.ink);
function points(packed, rover, name) {
  return {...unpackSeries(packed), name, colour: measuredInk(rover), rovers: [rover], isPoints: true};
}
function curveOf(rover, quantity) {
  const {position} = rover;
  const series = {x_m: {t: position.t, v: position.x}, y_m: {t: position.t, v: position.y}}[quantity] || rover[quantity];
  return series ? [{...series, name: `${rover.name} simulated`, colour: rover.ink, rovers: [rover]}] : [];
}
// Per quantity a plot of what was measured over what was simulated, and one of the residuals.
function telemetryPlots() {
  const plots = [];
  for (const quantity of new Set(telemetry.series.map(series => series.quantity))) {
    const all = telemetry.series.filter(series => series.quantity === quantity && series.residual);
    if (all.length === 0) continue;
    const {kind} = all[0], title = titleOf(all[0]);
    if (!quantity.startsWith('place_')) {
      const lines = all.flatMap(series => {
        const rover = roverOf(series.rover_id);
        return [...curveOf(rover, quantity), points(series.measured, rover, `${rover.name} measured`)];
      });
      plots.push(new Plot({key: quantity, title, lines, digits: 5, ...shownUnit(kind, mostOf(lines))}));
    }
    const lines = all.map(series => points(series.residual, roverOf(series.rover_id), series.rover_id));
    plots.push(new Plot({key: `${quantity}-residual`, title: quantity.startsWith('place_') ? title : `${title}: residual`,
      lines, includesZero: true, ...shownUnit(kind, mostOf(lines))}));
  }
  return plots;
}

// Measured places as dots of the same size at any scale.
function drawPlaces(map) {
  for (const place of telemetry.places) {
    const x = unpackSeries(place.x), y = unpackSeries(place.y);
    const at = Array.from(x.v, (value, k) => `M${value.toFixed(2)} ${y.v[k].toFixed(2)}h0`).join('');
    for (const [stroke, width] of [['#fff', 5], [measuredInk(roverOf(place.rover_id)), 3]]) {
      map.world.append(draw('path', {d: at, stroke, 'stroke-width': width, 'stroke-linecap': 'round', 'vector-effect': 'non-scaling-stroke', class: 'measured'}));
    }
  }
  if (telemetry.places.length > 0) {
    map.place.querySelector('.map-legend').append(make('span', {},
      draw('svg', {viewBox: '0 0 26 10'}, draw('path', {d: 'M5 5h0M13 5h0M21 5h0', stroke: '#17212b', 'stroke-width': 4, 'stroke-linecap': 'round'})), 'measured'));
  }
}

fillTelemetryHead();
fillTelemetryFindings();
fillResiduals();
fillOrigins();
document.getElementById('notes').remove();
document.getElementById('pictures').remove();
showChips();
const map = new MissionMap(document.getElementById('map'));
drawPlaces(map);
showPlots(telemetryPlots());
setCursor(endS);
