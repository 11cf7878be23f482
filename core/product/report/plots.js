// The plots over time: a quantity of each rover, with the record of events as bars beneath.
const gutter = 64, rightGap = 10, barHeight = 13, axisHeight = 17;
// Widths are cached until the plot is redrawn: reading clientWidth costs a layout of the page.
const plotWidths = new WeakMap();
function measure(surface) {
  plotWidths.set(surface, Math.max(10, surface.clientWidth - gutter - rightGap));
}
// Puts the vertical line of a plot at the time of the cursor, or hides it where that is not shown.
function placeCursor(line, surface) {
  const isIn = view.cursor >= view.from && view.cursor <= view.to;
  line.style.transform = `translateX(${Math.round(timeX(view.cursor, plotWidth(surface)))}px)`;
  line.style.visibility = isIn ? 'visible' : 'hidden';
}

function plotWidth(surface) {
  if (!plotWidths.has(surface)) measure(surface);
  return plotWidths.get(surface);
}
const timeX = (time, width) => gutter + ((time - view.from) / (view.to - view.from)) * width;
let printScale = 1;
const pixelRatio = () => Math.max(printScale, window.devicePixelRatio || 1);

// Sizes a canvas to the width of its parent and returns a context in CSS pixels.
function paper(canvas, height) {
  const ratio = pixelRatio(), width = plotWidth(canvas.parentElement) + gutter + rightGap;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.height = `${height}px`;
  const pen = canvas.getContext('2d');
  pen.scale(ratio, ratio);
  return pen;
}
function drawTimeAxis(pen, top, width) {
  pen.font = '11px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
  pen.fillStyle = '#55626f';
  pen.strokeStyle = '#b6c0ca';
  pen.lineWidth = 1;
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  for (const tick of timeTicks(view.from, view.to, width)) {
    const x = Math.round(timeX(tick.v, width)) + 0.5;
    pen.beginPath();
    pen.moveTo(x, top);
    pen.lineTo(x, top + 4);
    pen.stroke();
    const half = pen.measureText(tick.label).width / 2;
    pen.fillText(tick.label, Math.max(gutter - 4 + half, Math.min(x, gutter + width + rightGap - half)), top + 5);
  }
}
function hatch(pen, x, y, w, h) {
  pen.save();
  pen.beginPath();
  pen.rect(x, y, w, h);
  pen.clip();
  pen.strokeStyle = '#c62828';
  pen.lineWidth = 1.4;
  for (let at = x - h; at < x + w; at += 4) {
    pen.beginPath();
    pen.moveTo(at, y + h);
    pen.lineTo(at + h, y);
    pen.stroke();
  }
  pen.restore();
}
const strip = '9.5px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
// Draws a label in its bar if there is room for at least its beginning.
function drawName(pen, label, x, y, w) {
  const room = w - 6, least = 26;
  if (room < least) return;
  pen.font = strip;
  let text = label;
  if (pen.measureText(text).width > room) {
    const perLetter = pen.measureText(text).width / text.length;
    text = text.slice(0, Math.max(1, Math.floor(room / perLetter) - 1)).trimEnd() + '…';
    if (text.length < 4 || pen.measureText(text).width > room + 2) return;
  }
  pen.fillStyle = '#17212b';
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  pen.fillText(text, x + 3, y + barHeight / 2 + 0.5);
}
// One row of bars per rover: its events, coloured by kind and labelled where there is room; red
// hatching marks failed and incomplete ones.
function drawEvents(pen, top, width, rows) {
  rows.forEach((rover, row) => {
    const y = top + row * (barHeight + 1);
    pen.fillStyle = rover.isShown ? rover.ink : '#d5dbe1';
    pen.fillRect(gutter - 7, y, 4, barHeight);
    pen.fillStyle = '#f1f4f6';
    pen.fillRect(gutter, y, width, barHeight);
    if (!rover.isShown) return;
    for (const event of rover.events) {
      if (event.start_s === null) continue;
      const x0 = Math.max(gutter, timeX(event.start_s, width));
      const x1 = Math.min(gutter + width, Math.max(timeX(event.end_s ?? endS, width), x0 + 1));
      if (x1 <= gutter || x0 >= gutter + width) continue;
      pen.fillStyle = kindOf(event).colour;
      pen.fillRect(x0, y, Math.max(1, x1 - x0 - (x1 - x0 > 3 ? 1 : 0)), barHeight);
      if (event.status === 'failed' || event.status === 'incomplete') hatch(pen, x0, y, x1 - x0, barHeight);
      drawName(pen, event.label, x0, y, x1 - x0);
    }
  });
}

// Whose events have bars beneath each plot; several runs, and the cases of a study, have a plot of
// their events instead.
const barRovers = page.runs || page.study ? [] : rovers;
const barsHeight = barRovers.length * (barHeight + 1);

// Merges lines {t, v}, which need not share their times, into rows for dygraphs: null where a line
// has no sample, NaN where it has one without a value.
function merged(lines, scale) {
  const rows = [], at = lines.map(() => 0);
  for (;;) {
    let time = Infinity;
    lines.forEach((line, k) => {
      if (at[k] < line.t.length) time = Math.min(time, line.t[at[k]]);
    });
    if (time === Infinity) return rows;
    const row = [time];
    lines.forEach((line, k) => {
      if (at[k] < line.t.length && line.t[at[k]] === time) row.push(line.v[at[k]++] * scale);
      else row.push(null);
    });
    rows.push(row);
  }
}

// Ticks with as many decimal places as distinguish each from the next.
function valueTicks(from, to, pixels, options, graph) {
  const ticks = Dygraph.numericTicks(from, to, pixels, options, graph);
  const step = ticks.length > 1 ? Math.abs(ticks[1].v - ticks[0].v) : 1;
  const places = Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
  for (const tick of ticks) tick.label = placesText(tick.v, places);
  return ticks;
}

class Plot {
  // `lines`: {t, v, name, colour, dash, rovers: [...]}; with `full` values are also shown in per cent
  // of it. `levels`: {value, text, colour, rovers}, horizontal lines. `range`: of the axis; by default
  // that of the values.
  constructor(spec) {
    Object.assign(this, spec);
    this.isDirty = true;
    this.isSeen = false;
    // The same number of decimal places for all values of a plot, so that no digit comes and goes.
    const most = this.scale * greatest(this.lines), digits = this.digits || 4;
    this.places = most > 0 ? Math.max(0, Math.min(6, digits - 1 - Math.floor(Math.log10(most)))) : 1;
    this.outputs = this.lines.map(() => make('output', {}, '–'));
    this.dots = this.lines.map(line => make('div', {class: 'dot', style: `background:${line.colour}`}));
    this.chosen = make('div', {class: 'chosen', hidden: ''});
    this.cursor = make('div', {class: 'cursor'});
    this.graphPlace = make('div', {class: 'graph'});
    this.bar = make('canvas', {class: 'bar'});
    this.surface = make('div', {class: 'surface'}, this.graphPlace, this.bar, make('div', {class: 'shield'}), this.chosen, this.cursor, ...this.dots);
    this.keys = this.lines.map((line, k) => make('span', {},
      draw('svg', {viewBox: '0 0 18 8'}, draw('line', line.isPoints
        ? {x1: 3, x2: 17, y1: 4, y2: 4, stroke: line.colour, 'stroke-width': 3.4, 'stroke-linecap': 'round', 'stroke-dasharray': '0 6'}
        : {x1: 0, x2: 18, y1: 4, y2: 4, stroke: line.colour, 'stroke-width': 2.2, 'stroke-dasharray': (line.dash || []).join(' ')})), line.name, this.outputs[k]));
    this.element = make('figure', {class: 'plot', id: `plot-${this.key}`},
      make('figcaption', {}, make('h3', {}, this.title, make('span', {}, ` ${this.unit}`)), make('div', {class: 'keys'}, ...this.keys)),
      this.surface);
    this.barTop = 4;
    this.bar.style.height = `${this.barTop + barsHeight + axisHeight + 1}px`;
    followPointer(this.surface, () => gutter, () => plotWidth(this.surface), (from, to) => this.choose(from, to));
  }
  choose(from, to) {
    this.chosen.hidden = from === null;
    if (from === null) return;
    const width = plotWidth(this.surface), a = timeX(Math.min(from, to), width), b = timeX(Math.max(from, to), width);
    this.chosen.style.transform = `translateX(${a}px)`;
    this.chosen.style.width = `${b - a}px`;
  }
  create() {
    this.graph = new Dygraph(this.graphPlace, this.rows(), this.options());
  }
  rows() { return merged(this.lines, this.scale); }
  options() {
    return {
      labels: ['time', ...this.lines.map(line => line.name)],
      colors: this.lines.map(line => line.colour),
      series: Object.fromEntries(this.lines.map(line => [line.name, line.isPoints
        ? {strokeWidth: 0, drawPoints: true, pointSize: 1.7} : {strokePattern: line.dash || null}])),
      visibility: this.lines.map(line => line.rovers.every(rover => rover.isShown)),
      dateWindow: [view.from, view.to],
      strokeWidth: 1.5, connectSeparatedPoints: true, legend: 'never', highlightCircleSize: 0,
      interactionModel: {}, rightGap, yRangePad: 5, includeZero: this.includesZero || false,
      valueRange: this.range || null,
      underlayCallback: (pen, area, graph) => this.drawLevels(pen, area, graph),
      gridLineColor: '#dfe5ea', axisLineColor: '#b6c0ca', pixelRatio: pixelRatio(),
      axes: {
        x: {drawAxis: false, drawGrid: true, ticker: (a, b, pixels) => timeTicks(a, b, pixels)},
        y: {axisLabelWidth: gutter - 4, pixelsPerLabel: 24, ticker: valueTicks},
      },
    };
  }
  drawLevels(pen, area, graph) {
    for (const level of this.levels || []) {
      if (!level.rovers.some(rover => rover.isShown)) continue;
      const y = Math.round(graph.toDomYCoord(level.value * this.scale)) + 0.5;
      if (!(y > area.y - 1 && y < area.y + area.h + 1)) continue;
      pen.save();
      pen.strokeStyle = pen.fillStyle = level.colour;
      pen.setLineDash([2, 3]);
      pen.beginPath();
      pen.moveTo(area.x, y);
      pen.lineTo(area.x + area.w, y);
      pen.stroke();
      pen.font = strip;
      pen.textAlign = 'right';
      pen.textBaseline = 'bottom';
      pen.fillText(level.text, area.x + area.w - 3, y - 1);
      pen.restore();
    }
  }
  update() {
    this.isDirty = false;
    measure(this.surface);
    const shown = this.lines.map(line => line.rovers.every(rover => rover.isShown));
    if (!this.graph) this.create();
    else {
      this.graph.updateOptions({dateWindow: [view.from, view.to], visibility: shown});
    }
    const width = plotWidth(this.surface);
    const pen = paper(this.bar, this.barTop + barsHeight + axisHeight + 1);
    drawEvents(pen, this.barTop, width, barRovers);
    drawTimeAxis(pen, this.barTop + barsHeight, width);
    this.moveCursor();
  }
  moveCursor() {
    const width = plotWidth(this.surface), x = timeX(view.cursor, width);
    const isIn = view.cursor >= view.from && view.cursor <= view.to;
    this.cursor.style.transform = `translateX(${Math.round(x)}px)`;
    this.cursor.style.visibility = isIn ? 'visible' : 'hidden';
    this.lines.forEach((line, k) => {
      const dot = this.dots[k];
      const isShown = line.rovers.every(rover => rover.isShown);
      this.keys[k].hidden = !isShown && page.runs !== undefined;
      const at = nearest(line.t, view.cursor), value = line.v[at] * this.scale;
      const share = line.full > 0 && !Number.isNaN(value) ? ` · ${placesText((100 * line.v[at]) / line.full, 1)} %` : '';
      this.outputs[k].textContent = isShown ? placesText(value, this.places) + share : '';
      const isDrawn = isShown && isIn && !Number.isNaN(value) && this.graph && line.t[at] >= view.from && line.t[at] <= view.to;
      dot.style.visibility = isDrawn ? 'visible' : 'hidden';
      if (isDrawn) dot.style.transform = `translate(${timeX(line.t[at], width)}px, ${this.graph.toDomYCoord(value)}px)`;
    });
  }
  refresh() {
    this.isDirty = true;
    if (this.isSeen) this.update();
  }
  windowChanged() { this.refresh(); }
  roversChanged() { this.refresh(); }
  cursorChanged() { if (this.isSeen && !this.isDirty) this.moveCursor(); }
  resized() {
    this.graph?.destroy();
    this.graph = null;
    this.refresh();
  }
}

// Lines of sight and links between pairs: a pale bar means visible, a dark one in it linked; another
// colour means joined through others. What hides a pair is told where the cursor is.
class SightPlot {
  constructor() {
    this.key = 'sight';
    this.rowHeight = 27;
    this.isDirty = true;
    this.isSeen = false;
    this.bar = make('canvas', {class: 'bar'});
    this.chosen = make('div', {class: 'chosen', hidden: ''});
    this.cursor = make('div', {class: 'cursor'});
    this.states = page.sight.map(() => make('span', {class: 'state'}));
    this.names = make('div', {class: 'sight-names'}, ...page.sight.flatMap((pair, k) => {
      const name = make('span', {style: `left:${gutter}px;top:${k * this.rowHeight + 2}px`}, `${pair.from} – ${pair.to}`);
      this.states[k].style.top = `${k * this.rowHeight + 2}px`;
      return [name, this.states[k]];
    }));
    this.surface = make('div', {class: 'surface'}, this.bar, this.names, this.chosen, this.cursor);
    const key = (colour, text) => make('span', {}, make('i', {class: 'kind', style: `background:${colour}`}), text);
    this.element = make('figure', {class: 'plot', id: 'plot-sight'},
      make('figcaption', {}, make('h3', {}, 'Lines of sight'), make('div', {class: 'keys'}, key('#b9d3c4', 'visible'), key('#2c7a53', 'linked'), key('#8f7fb8', 'linked through others'))),
      this.surface);
    this.height = page.sight.length * this.rowHeight + 3;
    this.bar.style.height = `${this.height + axisHeight}px`;
    followPointer(this.surface, () => gutter, () => plotWidth(this.surface), (from, to) => Plot.prototype.choose.call(this, from, to));
  }
  isOn(pair) { return [pair.from, pair.to].every(id => !roverOf(id) || roverOf(id).isShown); }
  update() {
    this.isDirty = false;
    measure(this.surface);
    const pen = paper(this.bar, this.height + axisHeight), width = plotWidth(this.surface);
    page.sight.forEach((pair, k) => {
      const y = k * this.rowHeight + 15;
      pen.fillStyle = '#f1f4f6';
      pen.fillRect(gutter, y, width, 9);
      if (!this.isOn(pair)) return;
      const relayed = Object.values(pair.relayed).map(spans => [spans, '#8f7fb8', 2.5]);
      for (const [spans, colour, inset] of [[pair.visible, '#b9d3c4', 0], [pair.link, '#2c7a53', 2.5], ...relayed]) {
        pen.fillStyle = colour;
        for (let i = 0; i < spans.length; i += 2) {
          const x0 = Math.max(gutter, timeX(spans[i], width)), x1 = Math.min(gutter + width, timeX(spans[i + 1], width));
          if (x1 >= gutter && x0 <= gutter + width) pen.fillRect(x0, y + inset, Math.max(1, x1 - x0), 9 - 2 * inset);
        }
      }
    });
    drawTimeAxis(pen, this.height, width);
    this.moveCursor();
  }
  moveCursor() {
    placeCursor(this.cursor, this.surface);
    const holds = spans => {
      for (let i = 0; i < spans.length; i += 2) if (view.cursor >= spans[i] && view.cursor <= spans[i + 1]) return true;
      return false;
    };
    const by = intervals => Object.keys(intervals).find(what => holds(intervals[what]))?.replaceAll(',', ', ');
    const state = pair => {
      if (holds(pair.link)) return 'linked';
      const hider = by(pair.hidden), relays = by(pair.relayed);
      const seen = holds(pair.visible) ? 'visible' : hider ? `hidden by ${hider}` : 'hidden';
      return relays ? `${seen}, linked through ${relays}` : seen;
    };
    page.sight.forEach((pair, k) => {
      this.states[k].textContent = this.isOn(pair) ? state(pair) : '';
    });
  }
  refresh() { Plot.prototype.refresh.call(this); }
  windowChanged() { this.refresh(); }
  roversChanged() { this.refresh(); }
  cursorChanged() { if (this.isSeen && !this.isDirty) this.moveCursor(); }
  resized() { this.refresh(); }
}
