// What the estimate of the plan expected, beside what was simulated. Differences are simulated minus
// expected; of a range they count from its nearer end.
const hasEstimate = Boolean(page.estimate);
const estimatesOf = (list, number) => new Map((list || []).map(each => [`${each.rover_id}\n${each[number]}`, each]));
const eventEstimates = estimatesOf(page.estimate?.events, 'sequence'), dayEstimates = estimatesOf(page.estimate?.days, 'day');
const estimateOf = event => eventEstimates.get(`${event.rover_id}\n${event.sequence}`) || {};
const dayEstimateOf = day => dayEstimates.get(`${day.rover_id}\n${day.day}`) || {};

const isKnown = value => value !== null && value !== undefined;
const rangeOf = expected => (isKnown(expected?.low) ? [expected.low, expected.high] : [expected, expected]);
function differenceFrom(expected, value) {
  const [low, high] = rangeOf(expected);
  return value < low ? value - low : value > high ? value - high : 0;
}

// A cell of a table: the result, and under it what was expected and the difference. A difference
// too small for its text is none.
function withEstimate(result, value, expected, textOf, differenceOf = textOf) {
  if (!hasEstimate || !isKnown(expected)) return result;
  const [low, high] = rangeOf(expected), isRange = textOf(low) !== textOf(high);
  let text = `est. ${isRange ? `${textOf(low)} – ${textOf(high)}` : textOf(low)}`;
  if (isKnown(value)) {
    const difference = differenceFrom(expected, value), isNone = differenceOf(Math.abs(difference)) === differenceOf(0);
    if (!isNone) text += `, ${difference < 0 ? '−' : '+'}${differenceOf(Math.abs(difference))}`;
    else if (isRange) text += ', within';
  }
  const cell = make('span', {}, result, make('small', {class: 'expected'}, text));
  if (isKnown(value) && Math.abs(low) > 0 && !isRange) cell.title = `${numberText((100 * (value - low)) / low, 2)} % from the estimate`;
  return cell;
}
const clockOfEnd = time => elapsedText(Math.abs(time));
const percentText = value => (isKnown(value) ? `${(100 * value).toFixed(1)} %` : '–');
const pointsText = value => `${(100 * value).toFixed(1)} points`;

// Charge of an event's rover at its end, from the series of the page.
function chargeAtEnd(event) {
  const rover = roverOf(event.rover_id, event.run), series = rover?.energy_j, capacity = rover?.battery?.capacity_j;
  if (!series || !(capacity > 0) || !isKnown(event.end_s) || series.t.length === 0) return null;
  let k = nearest(series.t, event.end_s);
  if (series.t[k] > event.end_s && k > 0) --k;
  if (k + 1 >= series.t.length || series.t[k] >= event.end_s) return series.v[k] / capacity;
  const share = (event.end_s - series.t[k]) / (series.t[k + 1] - series.t[k]);
  return (series.v[k] + share * (series.v[k + 1] - series.v[k])) / capacity;
}

// How far the estimate was off, and by which events: from the middle of ranges.
function estimateText() {
  const furthest = (valueOf, name) => page.events
    .map(event => ({event, value: valueOf(event), expected: estimateOf(event)[name]}))
    .filter(({value, expected}) => isKnown(value) && isKnown(expected))
    .map(({event, value, expected}) => {
      const [low, high] = rangeOf(expected);
      return {event, away: value - (low + high) / 2, isWithin: low < high && differenceFrom(expected, value) === 0};
    })
    .reduce((most, each) => (most && Math.abs(most.away) >= Math.abs(each.away) ? most : each), null);
  const nameOf = ({event, isWithin}) => `‘${event.label}’ of ${event.rover_id}${isWithin ? ', within its range' : ''}`;
  const end = furthest(event => event.end_s, 'end_s'), charge = furthest(chargeAtEnd, 'charge_end');
  const parts = [];
  if (end) parts.push(`of ends ${durationText(Math.abs(end.away))} ${end.away < 0 ? 'earlier' : 'later'} (${nameOf(end)})`);
  if (charge) parts.push(`of charges ${pointsText(Math.abs(charge.away))} ${charge.away < 0 ? 'lower' : 'higher'} (${nameOf(charge)})`);
  const cut = page.estimate.cut_short ? ` It is cut short, ${page.estimate.cut_short}.` : '';
  return `Under results stands what the estimate of the plan expected (est.), as lsos-host check gives it without simulating, and simulated minus expected.${parts.length > 0 ? ` The greatest differences are ${parts.join(', and ')}.` : ''}${cut}`;
}
