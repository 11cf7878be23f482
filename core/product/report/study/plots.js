// The plots of a study over time: bands of charge and distance, how many cases are under way, and when
// events end.

// A band from P5 to P95 a rover, with a line at P50; the chosen case as a dark line.
class BandPlot extends Plot {
  // `spec.lines`: {t, v, low, high, name, colour, rovers}; `spec.quantity`: of the courses.
  constructor(spec) {
    super(spec);
    this.chosenLines = [];
  }
  allLines() { return [...this.lines, ...this.chosenLines]; }
  rows() {
    const rows = new Map(), lines = this.allLines();
    lines.forEach((line, k) => line.t.forEach((time, i) => {
      if (!rows.has(time)) rows.set(time, new Array(lines.length).fill(null));
      const values = line.low ? [line.low[i], line.v[i], line.high[i]] : [line.v[i], line.v[i], line.v[i]];
      rows.get(time)[k] = values.map(value => value * this.scale);
    }));
    return [...rows].sort((a, b) => a[0] - b[0]).map(([time, values]) => [time, ...values]);
  }
  options() {
    const lines = this.allLines();
    return {
      ...super.options(), customBars: true, fillAlpha: 0.2,
      labels: ['time', ...lines.map(line => line.name)], colors: lines.map(line => line.colour),
      series: Object.fromEntries(lines.map(line => [line.name, {strokeWidth: line.low ? 1.6 : 1.8, strokePattern: line.dash || null}])),
      visibility: lines.map(line => line.rovers.every(rover => rover.isShown)),
    };
  }
  update() {
    this.graph?.destroy();
    this.graph = null;
    super.update();
  }
  moveCursor() {
    super.moveCursor();
    this.lines.forEach((line, k) => {
      if (!line.rovers.every(rover => rover.isShown)) return;
      const at = nearest(line.t, view.cursor), text = values => placesText(values[at] * this.scale, this.places);
      const isOver = view.cursor > line.t[line.t.length - 1] + (line.t[1] || 0) / 2;
      this.outputs[k].textContent = isOver ? 'over' : `${text(line.v)} (${text(line.low)} to ${text(line.high)})`;
    });
  }
  caseChanged() {
    this.chosenLines = choice.row === null ? [] : unpackedCourses.flatMap(of => {
      const course = courseOf(of, this.quantity, choice.row);
      if (!course || !this.lines.some(line => line.rovers[0] === of.rover)) return [];
      return [{...course, name: `${of.rover.name}, case ${caseNumbers[choice.row]}`, colour: chosenInk, dash: [6, 2], rovers: [of.rover]}];
    });
    this.refresh();
  }
}

const studyBands = study.bands.map(band => ({
  ...band, rover: roverOf(band.rover_id), t: unpackTimes(band.t), p5: unpack(band.p5, Float32Array), p50: unpack(band.p50, Float32Array),
  p95: unpack(band.p95, Float32Array), share: unpack(band.share_reached, Float32Array),
}));
function bandLines(quantity) {
  return studyBands.filter(band => band.quantity === quantity && band.rover && band.t.length > 0).map(band => ({
    t: band.t, v: band.p50, low: band.p5, high: band.p95, name: band.rover_id, colour: band.rover.ink, rovers: [band.rover],
  }));
}

// When each event ends: a bar from P5 to P95, a line at P50, a diamond for the chosen case, and the
// share of cases that completed the event.
class ArrivalPlot {
  constructor() {
    this.key = 'arrivals';
    this.rowHeight = 26;
    this.isDirty = true;
    this.isSeen = false;
    this.arrivals = study.arrivals.filter(arrival => roverOf(arrival.rover_id));
    for (const arrival of this.arrivals) arrival.ended = unpack(arrival.ended_s, Float32Array);
    this.bar = make('canvas', {class: 'bar'});
    this.chosen = make('div', {class: 'chosen', hidden: ''});
    this.cursor = make('div', {class: 'cursor'});
    this.names = make('div', {class: 'sight-names arrival-names'}, ...this.arrivals.flatMap((arrival, k) => {
      const top = `top:${k * this.rowHeight + 2}px`, end = arrival.end_s;
      const several = rovers.length > 1 ? `${arrival.rover_id} ` : '';
      const times = end ? `${elapsedText(end[1])} (${elapsedText(end[0])} to ${elapsedText(end[2])}), ` : '';
      return [make('span', {style: `left:${gutter}px;${top}`}, `${several}${arrival.sequence} ${arrival.label}`),
        make('span', {class: 'reached', style: top}, times, make('b', {}, percentOf(arrival.share_reached, arrival.share_reached < 1 ? 1 : 0)))];
    }));
    this.surface = make('div', {class: 'surface'}, this.bar, this.names, this.chosen, this.cursor);
    const key = (style, text) => make('span', {}, make('i', {class: 'kind', style}), text);
    this.element = make('figure', {class: 'plot', id: 'plot-arrivals'},
      make('figcaption', {}, make('h3', {}, 'End of events', make('span', {}, ' median (P5 to P95), share of cases that completed it')),
        make('div', {class: 'keys'}, key('background:#b7c6d4', 'P5 to P95'), key('background:#17212b;width:3px', 'P50'))),
      this.surface);
    this.height = this.arrivals.length * this.rowHeight + 3;
    this.bar.style.height = `${this.height + axisHeight}px`;
    followPointer(this.surface, () => gutter, () => plotWidth(this.surface), (from, to) => Plot.prototype.choose.call(this, from, to));
  }
  update() {
    this.isDirty = false;
    measure(this.surface);
    const pen = paper(this.bar, this.height + axisHeight), width = plotWidth(this.surface);
    const clamp = time => Math.max(gutter, Math.min(gutter + width, timeX(time, width)));
    this.arrivals.forEach((arrival, k) => {
      const y = k * this.rowHeight + 15, rover = roverOf(arrival.rover_id);
      pen.fillStyle = rover.isShown ? rover.ink : '#d5dbe1';
      pen.fillRect(gutter - 7, y, 4, 9);
      pen.fillStyle = '#f1f4f6';
      pen.fillRect(gutter, y, width, 9);
      if (!rover.isShown || !arrival.end_s) return;
      const [p5, p50, p95] = arrival.end_s, x0 = clamp(p5), x1 = clamp(p95);
      pen.globalAlpha = 0.35;
      pen.fillStyle = rover.ink;
      pen.fillRect(x0, y, Math.max(2, x1 - x0), 9);
      pen.globalAlpha = 1;
      pen.fillStyle = chosenInk;
      if (p50 >= view.from && p50 <= view.to) pen.fillRect(Math.round(timeX(p50, width)) - 1, y - 1, 2, 11);
      const ended = choice.row === null ? NaN : arrival.ended[choice.row];
      if (!(ended >= view.from && ended <= view.to)) return;
      const x = timeX(ended, width);
      pen.beginPath();
      for (const [dx, dy] of [[0, -6], [5, 0], [0, 6], [-5, 0]]) pen.lineTo(x + dx, y + 4.5 + dy);
      pen.closePath();
      pen.fillStyle = '#fff';
      pen.fill();
      pen.strokeStyle = chosenInk;
      pen.lineWidth = 1.6;
      pen.stroke();
    });
    drawTimeAxis(pen, this.height, width);
    this.moveCursor();
  }
  moveCursor() { placeCursor(this.cursor, this.surface); }
  refresh() { Plot.prototype.refresh.call(this); }
  windowChanged() { this.refresh(); }
  roversChanged() { this.refresh(); }
  caseChanged() { this.refresh(); }
  cursorChanged() { if (this.isSeen && !this.isDirty) this.moveCursor(); }
  resized() { this.refresh(); }
}

function studyPlots() {
  const charge = bandLines('charge'), distance = bandLines('distance_m');
  const most = lines => lines.reduce((sum, line) => Math.max(sum, mostIn(line.high)), 0);
  const plots = [];
  if (charge.length > 0) plots.push(new BandPlot({key: 'charge', quantity: 'charge', title: 'Charge', lines: charge, unit: '%: median (P5 to P95)', scale: 100, range: [0, 105]}));
  if (distance.length > 0) {
    const {unit, scale} = shownAs('m', most(distance));
    plots.push(new BandPlot({key: 'distance', quantity: 'distance_m', title: 'Distance driven', lines: distance, unit: `${unit}: median (P5 to P95)`, scale, includesZero: true}));
  }
  const underWay = studyBands.filter(band => band.quantity === 'lon_deg' && band.rover && band.t.length > 0).map(band => ({
    t: band.t, v: band.share, name: band.rover_id, colour: band.rover.ink, rovers: [band.rover]}));
  if (underWay.some(line => line.v.some(share => share < 1))) {
    plots.push(new Plot({key: 'under-way', title: 'Cases under way', lines: underWay, unit: '% of those that ran; bands are of these', scale: 100, range: [0, 105]}));
  }
  if (study.arrivals.length > 0) plots.push(new ArrivalPlot());
  return plots;
}
