const isWarning = note => note.name === 'warn_when';
// WarnWhen: a red pin that points at its place, so that neither a rover nor an event there covers it. Its
// outline is white within dark, so that it stands out from a red rover's line and from the ground.
const warningPin = () => ['#17212b', '#fff', statusColours.failed].map((colour, k) => draw('path', {
  d: 'M0 0 L-8 -14 L8 -14 Z', fill: colour, stroke: colour, 'stroke-width': [6, 3.6, 0][k], 'stroke-linejoin': 'round',
})).concat(draw('path', {d: 'M0 -12.2 V-7.4 M0 -5.6 V-4.2', stroke: '#fff', 'stroke-width': 2}));
const placedNotes = () => page.notes.filter(note => note.x_m !== undefined && roverOf(note.rover_id));
// Of several runs the first one's events are marked, and those of others that ended in another way.
const markedEvents = () => page.events.filter(event => event.x_m !== undefined && event.start_s !== null && !isAsInFirst(event));
function isAsInFirst(event) {
  return event.run > 0 && page.events.some(first => first.run === 0 && first.rover_id === event.rover_id
    && first.sequence === event.sequence && first.status === event.status);
}

// Of several runs the first is drawn over the others, which depart from it.
const firstOnTop = parts => (page.runs ? [...parts].reverse() : parts);

// The map: ground, drawn, planned and driven lines, events, and the rovers at the cursor's time.
class MissionMap {
  constructor(place) {
    this.place = place;
    this.box = this.bounds();
    this.world = draw('g');
    this.marks = draw('g');
    this.grid = draw('g', {class: 'graticule'});
    this.readout = draw('text', {x: 10, id: 'map-place'});
    this.scaleBar = draw('g');
    const north = draw('g', {transform: 'translate(22 30)'},
      draw('path', {d: 'M0 -18 L6 2 L0 -3 L-6 2 Z', fill: '#17212b', stroke: '#fff', 'stroke-width': 1.5, 'paint-order': 'stroke'}),
      draw('text', {x: 0, y: 16, 'text-anchor': 'middle'}, 'N'));
    this.svg = draw('svg', {role: 'img', 'aria-label': 'Map of the mission'},
      this.world, this.grid, this.marks, this.scaleBar, north, this.readout);
    place.append(this.svg, this.buttons(), this.legend());
    this.drawWorld();
    this.drawMarks();
    this.resized();
    this.fit();
    this.listen();
    viewers.push(this);
  }
  // One unit per pixel, so that text is as large as elsewhere on the page.
  resized() {
    const aspect = (this.box.top - this.box.bottom) / (this.box.right - this.box.left), was = this.width;
    this.width = Math.max(200, this.place.clientWidth);
    this.height = Math.round(this.width * Math.max(0.5, Math.min(1.15, aspect)));
    this.svg.setAttribute('viewBox', `0 0 ${this.width} ${this.height}`);
    this.readout.setAttribute('y', this.height - 10);
    if (!was) return;
    this.scale *= this.width / was;
    this.leastScale *= this.width / was;
    this.update();
  }
  bounds() {
    if (page.map) return {left: page.map.left_m, right: page.map.right_m, bottom: page.map.bottom_m, top: page.map.top_m};
    const box = {left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity};
    const add = (x, y) => {
      box.left = Math.min(box.left, x); box.right = Math.max(box.right, x);
      box.bottom = Math.min(box.bottom, y); box.top = Math.max(box.top, y);
    };
    for (const rover of rovers) {
      rover.position.x.forEach((x, k) => add(x, rover.position.y[k]));
      for (const line of [...rover.drawn, ...rover.planned]) for (let i = 0; i < line.length; i += 2) add(line[i], line[i + 1]);
    }
    for (const asset of page.assets) add(asset.x_m, asset.y_m);
    if (box.left > box.right) add(0, 0);
    const pad = Math.max(20, 0.12 * Math.max(box.right - box.left, box.top - box.bottom));
    return {left: box.left - pad, right: box.right + pad, bottom: box.bottom - pad, top: box.top + pad};
  }
  drawWorld() {
    const image = (href, id) => draw('image', {
      href, id, x: page.map.left_m, y: -page.map.top_m, width: page.map.right_m - page.map.left_m,
      height: page.map.top_m - page.map.bottom_m, preserveAspectRatio: 'none', transform: 'scale(1 -1)',
    });
    if (page.map) this.world.append(image(page.map.relief, 'relief'));
    if (page.map?.shadow) this.world.append(image(page.map.shadow, 'shadow'));
    this.layers = rovers.map(rover => {
      const points = flat => {
        const list = [];
        for (let i = 0; i < flat.length; i += 2) list.push(`${flat[i]},${flat[i + 1]}`);
        return list.join(' ');
      };
      const line = (text, more) => draw('polyline', {
        points: text, fill: 'none', 'vector-effect': 'non-scaling-stroke', 'stroke-linejoin': 'round', 'stroke-linecap': 'round', ...more,
      });
      const driven = Array.from(rover.position.x, (x, k) => `${x.toFixed(2)},${rover.position.y[k].toFixed(2)}`);
      const course = driven.filter((point, k) => k === 0 || point !== driven[k - 1]).join(' ');
      const layer = draw('g', {},
        ...rover.drawn.map(flat => line(points(flat), {stroke: rover.ink, 'stroke-width': 8, 'stroke-opacity': 0.28})),
        ...rover.planned.map(flat => line(points(flat), {stroke: '#fff', 'stroke-width': 3.4, 'stroke-opacity': 0.85})),
        ...rover.planned.map(flat => line(points(flat), {stroke: rover.ink, 'stroke-width': 1.3, 'stroke-dasharray': '5 4'})),
        line(course, {stroke: '#fff', 'stroke-width': 4, 'stroke-opacity': 0.8}),
        line(course, {stroke: rover.ink, 'stroke-width': 2.1}));
      return layer;
    });
    this.world.append(...firstOnTop(this.layers));
  }
  drawMarks() {
    // Notes, as diamonds in their rover's colour, beneath the events; warnings over all.
    this.notes = placedNotes().map(note => {
      const rover = roverOf(note.rover_id);
      const mark = draw('g', {class: 'note-mark', style: 'cursor:pointer'},
        ...(isWarning(note) ? warningPin() : [draw('path', {d: 'M0 -4.5 L4.5 0 L0 4.5 L-4.5 0 Z', fill: '#fff', stroke: rover.ink, 'stroke-width': 1.6})]),
        draw('title', {}, `${rover.id}, ${elapsedText(note.time_s)}: ${note.name.replaceAll('_', ' ')} ${noteText(note)}`));
      mark.addEventListener('click', () => showTime(note.time_s));
      if (!isWarning(note)) this.marks.append(mark);
      return {rover, x: note.x_m, y: note.y_m, mark, isWarning: isWarning(note)};
    });
    this.events = [];
    // Failed events are drawn on top.
    const started = markedEvents();
    started.sort((a, b) => (a.status === 'failed') - (b.status === 'failed'));
    started.forEach(event => {
      const rover = roverOf(event.rover_id, event.run);
      const title = `${rover.name}: ${event.label} (${event.type}), ${statusText(event.status)}${event.reason ? ': ' + event.reason : ''}`;
      const mark = draw('g', {style: 'cursor:pointer'},
        draw('circle', {r: 4.6, fill: statusColours[event.status], stroke: '#fff', 'stroke-width': 1.5}), draw('title', {}, title));
      if (event.status === 'failed') mark.append(draw('path', {d: 'M-2 -2 L2 2 M-2 2 L2 -2', stroke: '#fff', 'stroke-width': 1.4}));
      const label = draw('text', {y: 4}, event.label.length > 26 ? event.label.slice(0, 25) + '…' : event.label);
      mark.addEventListener('click', () => showEvent(event));
      this.marks.append(mark, label);
      this.events.push({rover, x: event.x_m, y: event.y_m, mark, label, text: event.label, event});
    });
    // Labels are placed in this order: events at a stop before drives, the longest first, so that a
    // place is named after the longest event there.
    const isDrive = ({event}) => event.distance_m > 1, took = ({event}) => (event.end_s ?? endS) - event.start_s;
    this.named = [...this.events].sort((a, b) => isDrive(a) - isDrive(b) || took(b) - took(a));
    this.assets = page.assets.map(asset => {
      const mark = draw('g', {}, draw('rect', {x: -5, y: -5, width: 10, height: 10, fill: '#17212b', stroke: '#fff', 'stroke-width': 1.5}),
        draw('title', {}, `${asset.id} (${asset.type})`));
      const label = draw('text', {y: 4, 'font-weight': 600}, asset.id);
      this.marks.append(mark, label);
      return {x: asset.x_m, y: asset.y_m, mark, label, text: asset.id};
    });
    this.arrows = rovers.map(rover => {
      const arrow = draw('g', {id: `rover-${rover.name}`, style: 'pointer-events:none'},
        draw('path', {d: 'M0 -11 L8 9 L0 4.5 L-8 9 Z', fill: rover.ink, stroke: '#fff', 'stroke-width': 2, 'stroke-linejoin': 'round', 'paint-order': 'stroke'}));
      return arrow;
    });
    this.marks.append(...firstOnTop(this.arrows), ...this.notes.filter(note => note.isWarning).map(note => note.mark));
  }
  buttons() {
    const button = (text, title, act) => {
      const element = make('button', {type: 'button', title}, text);
      element.addEventListener('click', act);
      return element;
    };
    return make('div', {class: 'zoom'}, button('+', 'Nearer', () => this.zoom(1.5)),
      button('−', 'Farther', () => this.zoom(1 / 1.5)), button('⤢', 'All of it', () => this.fit()));
  }
  legend() {
    const sample = (text, more) => make('span', {}, draw('svg', {viewBox: '0 0 26 10'}, draw('line', {x1: 0, x2: 26, y1: 5, y2: 5, stroke: '#44515d', ...more})), text);
    const legend = make('div', {class: 'map-legend'}, sample('driven', {'stroke-width': 2.2}),
      sample('drawn in the plan', {'stroke-width': 7, 'stroke-opacity': 0.28}));
    if (rovers.some(rover => rover.planned.length > 0)) legend.append(sample('planned way', {'stroke-width': 1.4, 'stroke-dasharray': '5 4'}));
    for (const status of new Set(markedEvents().map(e => e.status))) {
      legend.append(make('span', {}, draw('svg', {viewBox: '0 0 10 10', style: 'width:10px!important'}, draw('circle', {cx: 5, cy: 5, r: 4, fill: statusColours[status]})), `event ${statusText(status)}`));
    }
    if (placedNotes().some(isWarning)) {
      legend.append(make('span', {}, draw('svg', {viewBox: '-11 -18 22 22', style: 'width:14px!important;height:14px!important'}, ...warningPin()), 'WarnWhen begins to hold'));
    }
    if (placedNotes().some(note => !isWarning(note))) {
      legend.append(make('span', {}, draw('svg', {viewBox: '0 0 10 10', style: 'width:10px!important'}, draw('path', {d: 'M5 1 L9 5 L5 9 L1 5 Z', fill: '#fff', stroke: '#44515d', 'stroke-width': 1.6})), 'note'));
    }
    if (page.map?.shadow) {
      const box = make('input', {type: 'checkbox', checked: '', id: 'shadow-on'});
      box.addEventListener('change', () => this.svg.querySelector('#shadow').setAttribute('visibility', box.checked ? 'visible' : 'hidden'));
      legend.append(make('label', {}, box, `shadow at ${utcText(page.map.shadow_s)}: the ground sees ${Math.round(100 * page.map.sunlit_share)} % of the Sun${this.groundEnd()}`));
    }
    if (page.map?.missing_share > 0) legend.append(make('span', {}, make('i', {class: 'no-ground'}), 'no ground is known'));
    if (page.map) legend.append(make('span', {}, `ground ${placesText(page.map.lowest_m, 0)} to ${placesText(page.map.highest_m, 0)} m`));
    return legend;
  }
  // Text of how far the known ground reaches: shadows of anything beyond it are missing.
  groundEnd() {
    const {ground_reaches_m: reaches, ground_matters_m: matters} = page.map;
    return reaches === undefined ? '' : `; towards it the ground ends ${distanceText(reaches)} from the middle, what stands up to ${distanceText(matters)} away could shade it`;
  }
  fit() {
    const {left, right, bottom, top} = this.box;
    this.scale = Math.min(this.width / (right - left), this.height / (top - bottom));
    this.leastScale = this.scale / 2;
    this.centre = {x: (left + right) / 2, y: (bottom + top) / 2};
    this.update();
  }
  zoom(factor, at = this.centre) {
    const scale = Math.max(this.leastScale, Math.min(400 * this.leastScale, this.scale * factor));
    const share = 1 - this.scale / scale;
    this.centre = {x: this.centre.x + share * (at.x - this.centre.x), y: this.centre.y + share * (at.y - this.centre.y)};
    this.scale = scale;
    this.update();
  }
  screen(x, y) {
    return [this.width / 2 + (x - this.centre.x) * this.scale, this.height / 2 - (y - this.centre.y) * this.scale];
  }
  ground(event) {
    const box = this.svg.getBoundingClientRect(), k = this.width / box.width;
    return {
      x: this.centre.x + ((event.clientX - box.left) * k - this.width / 2) / this.scale,
      y: this.centre.y - ((event.clientY - box.top) * k - this.height / 2) / this.scale,
    };
  }
  update() {
    const s = this.scale, [x0, y0] = this.screen(0, 0);
    this.world.setAttribute('transform', `matrix(${s} 0 0 ${-s} ${x0} ${y0})`);
    rovers.forEach((rover, k) => this.layers[k].setAttribute('visibility', rover.isShown ? 'visible' : 'hidden'));
    for (const note of this.notes) {
      note.mark.setAttribute('transform', `translate(${this.screen(note.x, note.y).join(' ')})`);
      note.mark.setAttribute('visibility', note.rover.isShown ? 'visible' : 'hidden');
    }
    const taken = [];
    for (const mark of [...this.assets, ...this.named]) {
      const [x, y] = this.screen(mark.x, mark.y), isShown = !mark.rover || mark.rover.isShown;
      mark.mark.setAttribute('transform', `translate(${x} ${y})`);
      mark.mark.setAttribute('visibility', isShown ? 'visible' : 'hidden');
      const width = 6.1 * mark.text.length + 12, turn = x + width + 12 > this.width ? -1 : 1;
      const box = {left: turn > 0 ? x + 7 : x - 7 - width, right: turn > 0 ? x + 7 + width : x - 7, top: y - 7, bottom: y + 7};
      const isFree = isShown && taken.every(other => box.right < other.left || box.left > other.right || box.bottom < other.top || box.top > other.bottom);
      if (isFree) taken.push(box);
      mark.label.setAttribute('visibility', isFree ? 'visible' : 'hidden');
      mark.label.setAttribute('transform', `translate(${x + 9 * turn} ${y})`);
      mark.label.setAttribute('text-anchor', turn > 0 ? 'start' : 'end');
    }
    this.drawGraticule();
    this.drawScale();
    this.cursorChanged();
  }
  // Meridians and parallels over the part that is shown, with their degrees at the edges.
  drawGraticule() {
    const lines = graticule(
      {left: this.centre.x - this.width / 2 / this.scale, right: this.centre.x + this.width / 2 / this.scale,
        bottom: this.centre.y - this.height / 2 / this.scale, top: this.centre.y + this.height / 2 / this.scale});
    this.grid.replaceChildren(...lines.flatMap(({points, text, isMeridian}) => {
      const places = points.map(([x, y]) => this.screen(x, y));
      const line = draw('polyline', {points: places.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ')});
      const at = isMeridian ? crossing(places, 1, 12) : crossing(places, 0, 0);
      if (at === null) return [line];
      const [x, y] = isMeridian ? [at, 12] : [4, at - 3];
      // The corners are occupied by north, buttons, the place under the cursor, and the scale.
      if (isMeridian ? x < 60 || x > this.width - 90 : y < 70 || y > this.height - 30) return [line];
      return [line, draw('text', {x: x.toFixed(1), y: y.toFixed(1), 'text-anchor': isMeridian ? 'middle' : 'start'}, text)];
    }));
  }
  drawScale() {
    const most = 150 / this.scale, decade = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map(d => d * decade).find(l => l <= most), px = length * this.scale;
    const right = this.width - 14, y = this.height - 12;
    this.scaleBar.replaceChildren(
      draw('path', {d: `M${right - px} ${y - 5} V${y} H${right} V${y - 5}`, fill: 'none', stroke: '#fff', 'stroke-width': 4, 'stroke-opacity': 0.8}),
      draw('path', {d: `M${right - px} ${y - 5} V${y} H${right} V${y - 5}`, fill: 'none', stroke: '#17212b', 'stroke-width': 1.6}),
      draw('text', {x: right - px / 2, y: y - 6, 'text-anchor': 'middle'}, length >= 1000 ? `${length / 1000} km` : `${length} m`));
  }
  cursorChanged() {
    rovers.forEach((rover, k) => {
      const p = rover.position;
      if (p.t.length === 0) return;
      const at = nearest(p.t, view.cursor), [x, y] = this.screen(p.x[at], p.y[at]);
      this.arrows[k].setAttribute('transform', `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${(p.heading[at] * 180) / Math.PI})`);
      this.arrows[k].setAttribute('visibility', rover.isShown ? 'visible' : 'hidden');
    });
  }
  roversChanged() { this.update(); }
  listen() {
    let grip = null;
    this.svg.addEventListener('pointerdown', event => {
      if (event.button !== 0 || event.target.closest('g[style*=pointer]')) return;
      grip = this.ground(event);
      hold(this.svg, event);
    });
    this.svg.addEventListener('pointerup', () => { grip = null; });
    this.svg.addEventListener('pointercancel', () => { grip = null; });
    this.svg.addEventListener('pointermove', event => {
      const at = this.ground(event);
      if (grip) {
        this.centre = {x: this.centre.x + grip.x - at.x, y: this.centre.y + grip.y - at.y};
        this.update();
        return;
      }
      this.readout.textContent = placeText(at.x, at.y);
      if (!view.isPinned) this.follow(at);
    });
    this.svg.addEventListener('pointerleave', () => { this.readout.textContent = ''; });
    this.svg.addEventListener('dblclick', () => this.fit());
    this.svg.addEventListener('wheel', event => {
      if (!event.ctrlKey && !event.metaKey) return;  // leave scrolling to the page
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 300), this.ground(event));
    }, {passive: false});
  }
  // Over a driven line the time cursor moves to the time at which the rover was there.
  follow(at) {
    let nearestM = 10 / this.scale, time = null;
    for (const rover of rovers) {
      if (!rover.isShown) continue;
      const p = rover.position;
      for (let k = 0; k < p.t.length; ++k) {
        const away = Math.hypot(p.x[k] - at.x, p.y[k] - at.y);
        if (away < nearestM) { nearestM = away; time = p.t[k]; }
      }
    }
    if (time !== null) setCursor(time);
  }
}
