// A histogram of each number that cases have.
const histogramSize = {width: 300, height: 128, left: 6, right: 6, top: 22, bottom: 20};
const numberTitle = number => (number.name === 'completed' && !number.column ? 'mission completed' : wordsOf(number.name));
// Values of a number by row of the table; those of the first number say whether missions completed.
function valuesOf(number) {
  if (number.column) return columnOf(number.column).values;
  return caseStatuses.map(status => (status === 'not_run' ? null : Number(status === 'completed')));
}
function shownOf(number) {
  return number.column ? columnOf(number.column).shown : {unit: '', scale: 1};
}

class Histogram {
  constructor(number) {
    this.number = number;
    this.values = valuesOf(number);
    this.shown = shownOf(number);
    const {width, height} = histogramSize;
    this.marker = draw('g');
    this.value = make('output', {});
    this.svg = draw('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `Histogram of ${numberTitle(number)}`});
    this.drawBars();
    this.svg.append(this.marker);
    this.element = make('figure', {class: 'histogram', title: number.sentence},
      make('figcaption', {}, make('h3', {}, numberTitle(number), make('span', {}, unitText(this.shown))), this.value), this.svg, make('p', {}, this.text()));
    viewers.push(this);
  }
  text() {
    const {quantiles, count, missing} = this.number;
    if (!quantiles) return 'no case has it';
    const [p5, p50, p95] = quantiles.map(value => numberText(value * this.shown.scale));
    return `${p50} (${p5} to ${p95})${missing > 0 ? `; ${count} cases have it` : ''}`;
  }
  // Values lie in the middle of their bars where each bar is of one value.
  x(value) {
    const {width, left, right} = histogramSize, {bars} = this.number;
    const isOfValues = bars[0][0] === bars[0][1];
    if (isOfValues) {
      const at = bars.findIndex(([from]) => from === value);
      return left + ((at + 0.5) / bars.length) * (width - left - right);
    }
    const first = bars[0][0], last = bars[bars.length - 1][1];
    return left + ((value - first) / (last - first)) * (width - left - right);
  }
  drawBars() {
    const {width, height, left, right, top, bottom} = histogramSize, {bars, quantiles} = this.number;
    if (bars.length === 0) return;
    const most = Math.max(...bars.map(([, , completed, other]) => completed + other)), floor = height - bottom;
    const isOfValues = bars[0][0] === bars[0][1], room = (width - left - right) / bars.length;
    const tall = count => (count / most) * (floor - top);
    bars.forEach(([from, to, completed, other], k) => {
      const x = left + k * room + (isOfValues ? room * 0.15 : 0.5), wide = Math.max(1, room * (isOfValues ? 0.7 : 1) - 1);
      const range = isOfValues ? numberText(from * this.shown.scale) : `${numberText(from * this.shown.scale)} to ${numberText(to * this.shown.scale)}`;
      this.svg.append(draw('g', {},
        draw('rect', {x, width: wide, y: floor - tall(completed), height: tall(completed), fill: outcomeInks.completed, 'fill-opacity': 0.75}),
        draw('rect', {x, width: wide, y: floor - tall(completed + other), height: tall(other), fill: outcomeInks.failed, 'fill-opacity': 0.85}),
        draw('title', {}, `${range}${unitText(this.shown).replace(', ', ' ')}: ${completed + other} cases, ${completed} of them completed`)));
    });
    this.svg.append(draw('line', {x1: left, x2: width - right, y1: floor + 0.5, y2: floor + 0.5, stroke: '#8b97a3'}),
      draw('text', {x: left, y: top - 10}, `${most} cases`));
    const ticks = isOfValues ? bars.map(([value]) => value) : this.ticks();
    ticks.forEach(value => {
      const x = this.x(value);
      this.svg.append(draw('line', {x1: x, x2: x, y1: floor, y2: floor + 3, stroke: '#8b97a3'}),
        draw('text', {x: Math.max(12, Math.min(width - 12, x)), y: height - 6, 'text-anchor': 'middle'}, placesText(value * this.shown.scale, this.places || 0)));
    });
    if (isOfValues) return;
    quantiles.forEach((value, k) => this.svg.append(draw('line', {
      x1: this.x(value), x2: this.x(value), y1: top - 2, y2: floor, stroke: chosenInk, 'stroke-width': k === 1 ? 1.6 : 1, 'stroke-dasharray': k === 1 ? 'none' : '3 2'})));
  }
  ticks() {
    const {bars} = this.number, {scale} = this.shown;
    const from = bars[0][0] * scale, to = bars[bars.length - 1][1] * scale, least = (to - from) / 5;
    const decade = 10 ** Math.floor(Math.log10(least)), step = [1, 2, 2.5, 5, 10].map(digit => digit * decade).find(size => size >= least);
    this.places = Math.max(0, Math.min(6, [0, 1, 2, 3, 4, 5, 6].find(places => Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) < 1e-6) ?? 6));
    const ticks = [];
    for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) ticks.push((k * step) / scale);
    return ticks;
  }
  caseChanged() {
    const value = choice.row === null ? null : this.values[choice.row];
    this.marker.replaceChildren();
    this.value.textContent = '';
    if (value === null || this.number.bars.length === 0) return;
    this.value.textContent = `case ${caseNumbers[choice.row]}: ${numberText(value * this.shown.scale)}`;
    this.marker.append(draw('path', {d: 'M-5 -8 L5 -8 L0 0 Z', fill: chosenInk, stroke: '#fff', transform: `translate(${this.x(value)} ${histogramSize.top + 2})`}));
  }
}

function fillNumbers(place) {
  const key = (ink, text) => make('span', {}, make('i', {style: `background:${ink}`}), text);
  const list = numbers => make('div', {class: 'histograms'}, ...numbers.map(number => new Histogram(number).element));
  const gathered = study.numbers.filter(number => number.kind === 'gathered');
  const others = study.numbers.filter(number => number.kind === 'summary' && number.bars.length > 0);
  place.append(make('h2', {}, 'What cases came to'),
    make('p', {class: 'note histogram-keys'}, key(outcomeInks.completed, 'missions that completed'), key(outcomeInks.failed, 'that did not'),
      'The full line is the median, dashed ones are P5 and P95; numbers below are median (P5 to P95).'));
  if (gathered.length > 0) place.append(list(gathered));
  if (others.length === 0) return;
  const folded = make('details', gathered.length > 0 ? {} : {open: ''}, make('summary', {}, `Numbers of the summary that vary (${others.length})`), list(others));
  openOnPaper(folded);
  place.append(folded);
}
// Unfolds what is folded while the page is printed.
function openOnPaper(folded) {
  let wasOpen = false;
  addEventListener('beforeprint', () => {
    wasOpen = folded.open;
    folded.open = true;
  });
  addEventListener('afterprint', () => { folded.open = wasOpen; });
}
