// Days of a mission longer than one: a chooser in the bar, which shows a day in the plots and its
// numbers, a table of all days, and the events of each day.
const dayS = 86400;
const dayCount = Math.max(1, Math.ceil(endS / dayS - 1e-9));
const daySpan = day => [(day - 1) * dayS, Math.min(day * dayS, endS)];

const chargeText = value => (isKnown(value) ? `${(100 * value).toFixed(0)} %` : '–');
const hoursText = value => (isKnown(value) ? `${(value / 3600).toFixed(1)} h` : '–');
function dayColumns(days) {
  const columns = [
    ['Rover', day => swatch(roverOf(day.rover_id), day.rover_id)],
    ['Distance', day => withEstimate(distanceText(day.distance_m), day.distance_m, dayEstimateOf(day).distance_m, distanceText), true],
    ['Driving', day => durationText(day.drive_s), true],
    ['Steepest sample', day => (isKnown(day.max_slope_rad) ? `${((day.max_slope_rad * 180) / Math.PI).toFixed(1)}°` : '–'), true],
    ['Energy used', day => withEstimate(energyText(day.energy_used_j), day.energy_used_j, dayEstimateOf(day).energy_used_j, energyText), true],
    ['From the Sun', day => withEstimate(energyText(day.solar_j), day.solar_j, dayEstimateOf(day).solar_j, energyText), true],
    ['Charge at start', day => chargeText(day.charge_start), true],
    ['least', day => withEstimate(chargeText(day.charge_min), day.charge_min, dayEstimateOf(day).charge_min, percentText, pointsText), true],
    ['at end', day => withEstimate(chargeText(day.charge_end), day.charge_end, dayEstimateOf(day).charge_end, percentText, pointsText), true],
    ...(days.some(day => isKnown(day.charge_dawn) || isKnown(day.charge_dusk)) ? [
      ['at dawn', day => chargeText(day.charge_dawn), true], ['at dusk', day => chargeText(day.charge_dusk), true],
    ] : []),
    ['Sunlit', day => hoursText(day.sunlit_s), true],
  ];
  if (days.some(day => isKnown(day.earth_visible_s))) {
    columns.push(['Earth in view', day => hoursText(day.earth_visible_s), true], ['linked', day => hoursText(day.earth_link_s), true]);
  }
  if (days.some(day => day.evas > 0)) columns.push(['EVAs', day => String(day.evas), true]);
  columns.push(['Events ended', day => String(day.events_ended), true]);
  return columns;
}

// A row a day and rover; a click shows the day.
function fillDays() {
  const days = [...(summary?.days || [])].sort((a, b) => a.day - b.day);
  if (dayCount > 1) showDayChooser(days);
  if (days.length === 0) return;
  const columns = [['Day', day => String(day.day), true], ...dayColumns(days)];
  document.getElementById('days').append(make('h2', {}, 'Days'), make('div', {class: 'wide', id: 'day-table'}, table(columns, days, (line, day) => {
    line.title = 'Show this day in the plots';
    line.addEventListener('click', () => {
      showDay(day.day);
      document.getElementById('course').scrollIntoView({block: 'start'});
    });
  })));
}

function showDay(day) {
  setWindow(...(day > 0 ? daySpan(day) : [0, endS]));
  if (day > 0) setCursor((day - 1) * dayS);
}

// The chooser follows the window of the plots: of a window that is no day it shows none.
function showDayChooser(days) {
  const numbers = make('div', {id: 'day-numbers'});
  document.querySelector('#course h2').after(numbers);
  const choice = make('select', {id: 'day', 'aria-label': 'Day'}, make('option', {value: '0'}, 'All days'));
  for (let day = 1; day <= dayCount; ++day) {
    choice.append(make('option', {value: String(day)}, `Day ${day}, ${utcText((day - 1) * dayS).slice(5, 16)}`));
  }
  choice.append(make('option', {value: '-1', hidden: ''}, 'Other time'));
  const step = (text, title, by) => {
    const button = make('button', {type: 'button', title}, text);
    button.addEventListener('click', () => showDay(Math.max(1, Math.min(dayCount, Math.max(0, Number(choice.value)) + by))));
    return button;
  };
  choice.addEventListener('change', () => showDay(Number(choice.value)));
  document.querySelector('#bar .tools').prepend(step('‹', 'The day before', -1), choice, step('›', 'The next day', 1));
  let shown = 0;  // not the chooser's value, which a choice has changed already
  viewers.push({
    windowChanged() {
      const isAt = (a, b) => Math.abs(a - b) < 0.5;
      let day = -1;
      if (isAt(view.from, 0) && isAt(view.to, endS)) day = 0;
      for (let k = 1; k <= dayCount; ++k) {
        const [from, to] = daySpan(k);
        if (isAt(view.from, from) && isAt(view.to, to)) day = k;
      }
      if (day === shown) return;
      shown = day;
      choice.value = String(day);
      const those = days.filter(each => each.day === day);
      numbers.replaceChildren(...(those.length > 0 ? [make('div', {class: 'wide'}, table(dayColumns(days), those))] : []));
    },
  });
}

// One table of a short mission. Of a longer one each day's events unfold; their rows are made then.
function showEvents(tableOf) {
  const place = document.getElementById('event-table');
  if (dayCount === 1) return place.append(tableOf(page.events));
  place.classList.remove('wide');
  const dayOf = event => {
    const time = event.end_s ?? event.start_s;
    return time === null ? dayCount + 1 : Math.min(dayCount, Math.floor(time / dayS) + 1);
  };
  for (let day = 1; day <= dayCount + 1; ++day) {
    const events = page.events.filter(event => dayOf(event) === day);
    if (events.length === 0) continue;
    events.sort((a, b) => (a.start_s ?? 0) - (b.start_s ?? 0));
    const counts = Object.keys(statusMarks).map(status => [events.filter(event => event.status === status).length, status])
      .filter(([count]) => count > 0).map(([count, status]) => `${count} ${statusText(status)}`);
    const isBad = events.some(event => event.status === 'failed');
    const fold = make('details', {class: 'day'},
      make('summary', isBad ? {class: 'failed'} : {}, `${day > dayCount ? 'Never begun' : `Day ${day}`}: ${counts.join(', ')}`));
    const fill = () => {
      if (fold.children.length === 1) fold.append(make('div', {class: 'wide'}, tableOf(events)));
    };
    fold.addEventListener('toggle', fill);
    // On paper all are unfolded.
    addEventListener('beforeprint', () => {
      fill();
      fold.open = true;
    });
    addEventListener('afterprint', () => { fold.open = false; });
    place.append(fold);
  }
}
