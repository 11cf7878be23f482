// The data of a study: its cases, and what all parts of the page share about them.
const study = page.study;
const columnOf = name => study.columns.find(column => column.name === name);
const caseNumbers = columnOf('case').values, caseStatuses = columnOf('status').values;
const rowOfCase = new Map(caseNumbers.map((number, row) => [number, row]));

// Colours that people with any colour vision can tell apart (Okabe and Ito).
const outcomeInks = {completed: '#0072b2', failed: '#d55e00', incomplete: '#e69f00', not_started: '#e69f00', not_run: '#8a949e'};
const outcomeInk = status => outcomeInks[status] || '#8a949e';
const outcomeMarks = {completed: '✓', failed: '✕', incomplete: '…', not_run: '∅'};
const outcomeText = status => (status === 'not_run' ? 'not run' : statusText(status));

// How values of a unit are shown, by the greatest of them.
function shownAs(unit, most) {
  const per = {
    s: most >= 3 * 86400 ? ['d', 1 / 86400] : most >= 7200 ? ['h', 1 / 3600] : most >= 600 ? ['min', 1 / 60] : ['s', 1],
    m: most >= 10000 ? ['km', 1e-3] : ['m', 1], 'm/s': most < 0.2 ? ['cm/s', 100] : ['m/s', 1],
    J: most >= 1.8e6 ? ['kWh', 1 / 3.6e6] : ['Wh', 1 / 3600], W: most >= 2000 ? ['kW', 1e-3] : ['W', 1],
    rad: ['°', 180 / Math.PI], Pa: most >= 20000 ? ['kPa', 1e-3] : ['Pa', 1],
  }[unit] || [unit, 1];
  return {unit: per[0], scale: per[1]};
}
function mostIn(values) {
  let most = 0;
  for (const value of values) if (typeof value === 'number' && Math.abs(value) > most) most = Math.abs(value);
  return most;
}
for (const column of study.columns) {
  Object.assign(column, {shown: column.is_text ? {unit: '', scale: 1} : shownAs(column.unit, mostIn(column.values)), ...timesIn(column)});
}
// Times of a column of UTC as numbers from the first of them, and their unit; nothing of others.
function timesIn({is_text: isText, values}) {
  if (!isText || values.length === 0 || !values.every(value => /^\d{4}-\d\d-\d\dT[\d:.]+Z$/.test(value || ''))) return {};
  const seconds = values.map(value => Date.parse(value.replace(/:60/, ':59')) / 1000), first = seconds.reduce((a, b) => Math.min(a, b));
  const {unit, scale} = shownAs('s', seconds.reduce((most, value) => Math.max(most, value - first), 0));
  return {times: seconds.map(value => (value - first) * scale), timeUnit: `${unit} after ${new Date(first * 1000).toISOString().slice(0, 16).replace('T', ' ')} UTC`};
}
// "SEV1_energy_used_j" as words: the unit is told beside it.
const wordsOf = name => name.replace(/_(m|s|j|w|rad|pa|mps|kg|deg)$/, '').replaceAll('_', ' ');
const unitText = ({unit}) => (unit ? `, ${unit}` : '');
const percentOf = (share, places = 0) => `${placesText(100 * share, places)} %`;
const caseName = number => String(number).padStart(6, '0');

// Course of a quantity in one case: {t, v}; null where the case has none.
const unpackedCourses = study.courses.map(of => {
  const unpacked = {rover: roverOf(of.rover_id), interval: of.interval_s, times: of.times};
  for (const name of ['x_m', 'y_m', 'charge', 'distance_m']) {
    unpacked[name] = of[name] && {...of[name], v: unpack(of[name].v, Uint16Array)};
  }
  return unpacked;
});
const noValue = 65535;
function courseOf(of, quantity, row) {
  const packed = of[quantity], t = [], v = [];
  if (!packed) return null;
  for (let k = 0; k < of.times; ++k) {
    const value = packed.v[row * of.times + k];
    if (value === noValue) continue;
    t.push(k * of.interval);
    v.push(packed.low + packed.step * value);
  }
  return t.length > 0 ? {t, v} : null;
}

// The case that is looked at, and the cases that pass the filter of the table; parts of the page
// follow with caseChanged() and filterChanged().
const choice = {row: null, passes: new Uint8Array(study.shown).fill(1)};
function chooseCase(row) {
  choice.row = row === undefined || choice.row === row ? null : row;
  for (const viewer of viewers) viewer.caseChanged?.();
}
function caseButton(number) {
  const row = rowOfCase.get(number);
  const button = make('button', {type: 'button', class: 'link', title: 'Show this case everywhere'}, String(number));
  if (row === undefined) button.disabled = true;
  button.addEventListener('click', () => chooseCase(row));
  return button;
}
const chosenInk = '#17212b';
