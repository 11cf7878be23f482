// The map of a study: courses of the cases, the median course, where rovers are at the time of the
// cursor, where events end, and where missions ended badly.
const coursesMost = 400;  // paths that a browser draws at once without delay

class StudyMap extends MissionMap {
  drawWorld() {
    super.drawWorld();
    this.courses = draw('g', {class: 'courses'});
    this.chosenCourse = draw('g');
    this.world.insertBefore(this.courses, this.layers[0] || null);
    this.drawCourses();
    const line = {fill: 'none', 'vector-effect': 'non-scaling-stroke'};
    const ellipse = (of, more) => draw('ellipse', {
      rx: of.semi_major_m, ry: of.semi_minor_m, transform: `translate(${of.x_m} ${of.y_m}) rotate(${(of.angle_rad * 180) / Math.PI})`, ...line, ...more,
    });
    this.ellipses = study.arrivals.filter(arrival => arrival.ellipse && roverOf(arrival.rover_id)).map(arrival => {
      const {ink} = roverOf(arrival.rover_id);
      const mark = draw('g', {}, ellipse(arrival.ellipse, {stroke: '#fff', 'stroke-width': 3.2, 'stroke-opacity': 0.8}),
        ellipse(arrival.ellipse, {stroke: ink, 'stroke-width': 1.4, fill: ink, 'fill-opacity': 0.12}));
      return {rover: roverOf(arrival.rover_id), mark};
    });
    this.spreads = study.courses.map(of => {
      const spread = {rover: roverOf(of.rover_id), interval: of.spreads.interval_s, mark: draw('ellipse', {...line, stroke: chosenInk, 'stroke-width': 1.6, 'stroke-dasharray': '4 3'})};
      for (const name of ['x_m', 'y_m', 'semi_major_m', 'semi_minor_m', 'angle_rad']) spread[name] = unpack(of.spreads[name], Float32Array);
      return spread;
    });
    this.world.append(...this.ellipses.map(({mark}) => mark), ...this.spreads.map(({mark}) => mark), this.chosenCourse);
  }
  // Points of a course in metres; those that lie together are one.
  pathOf(of, row) {
    const x = courseOf(of, 'x_m', row), y = courseOf(of, 'y_m', row);
    if (!x || !y) return '';
    let path = '', lastX = NaN, lastY = NaN;
    x.v.forEach((east, k) => {
      const north = y.v[k];
      if (Math.hypot(east - lastX, north - lastY) < 0.3) return;
      path += `${path ? 'L' : 'M'}${east.toFixed(1)} ${north.toFixed(1)}`;
      lastX = east;
      lastY = north;
    });
    return path;
  }
  drawCourses() {
    const rows = [];
    for (let row = 0; row < study.shown && rows.length < coursesMost; ++row) if (choice.passes[row]) rows.push(row);
    const opacity = Math.max(0.07, Math.min(0.5, 12 / Math.max(1, rows.length)));
    this.courses.replaceChildren(...unpackedCourses.filter(of => of.rover).flatMap(of => rows.map(row => {
      const path = draw('path', {d: this.pathOf(of, row) || 'M0 0', fill: 'none', stroke: of.rover.ink, 'stroke-width': 1.4, 'stroke-opacity': opacity, 'vector-effect': 'non-scaling-stroke'});
      path.rover = of.rover;
      return path;
    })));
  }
  drawMarks() {
    super.drawMarks();
    this.ends = study.ends.filter(end => end.x_m !== undefined && roverOf(end.rover_id)).map(end => {
      const ink = outcomeInk(end.status);
      const mark = draw('g', {style: 'cursor:pointer', class: 'end-mark'},
        draw('path', {d: 'M-4 -4 L4 4 M-4 4 L4 -4', stroke: '#fff', 'stroke-width': 4.4, 'stroke-linecap': 'round'}),
        draw('path', {d: 'M-4 -4 L4 4 M-4 4 L4 -4', stroke: ink, 'stroke-width': 2.2, 'stroke-linecap': 'round'}),
        draw('title', {}, `Case ${end.case}, ${end.rover_id} ${end.label}: ${statusText(end.status)}${end.reason ? ', ' + end.reason : ''}${end.time_s === null ? '' : ', ' + elapsedText(end.time_s)}`));
      mark.addEventListener('click', () => chooseCase(rowOfCase.get(end.case)));
      return {rover: roverOf(end.rover_id), row: rowOfCase.get(end.case), x: end.x_m, y: end.y_m, mark};
    });
    this.arrivals = study.arrivals.filter(arrival => roverOf(arrival.rover_id)).flatMap(arrival => {
      const at = arrival.ellipse || (arrival.x_m === undefined ? null : arrival);
      if (!at) return [];
      const rover = roverOf(arrival.rover_id), share = arrival.share_reached;
      const mark = draw('g', {}, ...sharePie(share, rover.ink),
        draw('title', {}, `${arrival.rover_id} ${arrival.label} (${arrival.type}): completed in ${percentOf(share, 1)} of ${arrival.cases} cases${arrival.end_s ? `; end ${elapsedText(arrival.end_s[1])} (${elapsedText(arrival.end_s[0])} to ${elapsedText(arrival.end_s[2])})` : ''}`));
      const text = `${arrival.label.length > 22 ? arrival.label.slice(0, 21) + '…' : arrival.label} ${percentOf(share)}`;
      return [{rover, x: at.x_m, y: at.y_m, mark, label: draw('text', {y: 4}, text), text, share}];
    }).sort((a, b) => b.share - a.share);
    this.marks.prepend(...this.ends.map(({mark}) => mark), ...this.arrivals.flatMap(({mark, label}) => [mark, label]));
    this.named.push(...[...this.arrivals].reverse());
  }
  legend() {
    const legend = make('div', {class: 'map-legend'});
    const line = (text, more) => legend.append(make('span', {}, draw('svg', {viewBox: '0 0 26 10'}, draw('line', {x1: 0, x2: 26, y1: 5, y2: 5, stroke: '#44515d', ...more})), text));
    const small = (text, ...parts) => legend.append(make('span', {}, draw('svg', {viewBox: '-6 -6 12 12', style: 'width:13px!important;height:13px!important'}, ...parts), text));
    line(study.shown > coursesMost ? `courses of ${coursesMost} cases` : 'courses of the cases', {'stroke-width': 1.4, 'stroke-opacity': 0.45});
    line('at the median of places', {'stroke-width': 2.2});
    if (rovers.some(rover => rover.drawn.length > 0)) line('drawn in the plan', {'stroke-width': 7, 'stroke-opacity': 0.28});
    small(`ends of an event: ellipse of ${percentOf(study.spread_share)} of the cases`, draw('ellipse', {rx: 5.4, ry: 3.4, fill: '#44515d', 'fill-opacity': 0.15, stroke: '#44515d', 'stroke-width': 1.2}));
    small('share of cases that completed it', ...sharePie(0.7, '#44515d'));
    small(`at the time of the cursor: ${percentOf(study.spread_share)} of the cases`, draw('ellipse', {rx: 5.4, ry: 3.4, fill: 'none', stroke: chosenInk, 'stroke-width': 1.3, 'stroke-dasharray': '2.4 1.6'}));
    if (study.ends.length > 0) small('a mission ended badly', draw('path', {d: 'M-3.5 -3.5 L3.5 3.5 M-3.5 3.5 L3.5 -3.5', stroke: outcomeInks.failed, 'stroke-width': 2}));
    if (page.map?.shadow) {
      const box = make('input', {type: 'checkbox', checked: '', id: 'shadow-on'});
      box.addEventListener('change', () => this.svg.querySelector('#shadow').setAttribute('visibility', box.checked ? 'visible' : 'hidden'));
      legend.append(make('label', {}, box, `shadow at ${utcText(page.map.shadow_s)}`));
    }
    if (page.map?.missing_share > 0) legend.append(make('span', {}, make('i', {class: 'no-ground'}), 'no ground is known'));
    return legend;
  }
  update() {
    const visibility = isOn => (isOn ? 'visible' : 'hidden');
    for (const {rover, row, x, y, mark} of this.ends) {
      mark.setAttribute('transform', `translate(${this.screen(x, y).join(' ')})`);
      mark.setAttribute('visibility', visibility(rover.isShown && (row === undefined || choice.passes[row])));
    }
    for (const {rover, mark} of this.ellipses) mark.setAttribute('visibility', visibility(rover.isShown));
    for (const path of this.courses.children) path.setAttribute('visibility', visibility(path.rover.isShown));
    super.update();
  }
  cursorChanged() {
    super.cursorChanged();
    for (const spread of this.spreads) {
      const at = Math.min(spread.x_m.length - 1, Math.round(view.cursor / spread.interval));
      const isOn = spread.rover?.isShown && at >= 0 && spread.semi_major_m[at] >= 0;
      spread.mark.setAttribute('visibility', isOn ? 'visible' : 'hidden');
      if (!isOn) continue;
      // An ellipse smaller than a few pixels would not be seen.
      const least = 4 / this.scale;
      spread.mark.setAttribute('rx', Math.max(least, spread.semi_major_m[at]));
      spread.mark.setAttribute('ry', Math.max(least / 2, spread.semi_minor_m[at]));
      spread.mark.setAttribute('transform', `translate(${spread.x_m[at]} ${spread.y_m[at]}) rotate(${(spread.angle_rad[at] * 180) / Math.PI})`);
    }
  }
  caseChanged() {
    const paths = choice.row === null ? [] : unpackedCourses.filter(of => of.rover).map(of => this.pathOf(of, choice.row)).filter(path => path);
    this.chosenCourse.replaceChildren(...paths.flatMap(d => [['#fff', 5, ''], [chosenInk, 2.4, '6 3']].map(([stroke, width, dash]) => draw('path', {
      d, stroke, 'stroke-width': width, 'stroke-dasharray': dash, fill: 'none', 'vector-effect': 'non-scaling-stroke'}))));
  }
  filterChanged() {
    this.drawCourses();
    this.update();
  }
}

// A disc of which the share is filled.
function sharePie(share, ink) {
  const radius = 5.2, turn = 2 * Math.PI * Math.min(share, 0.99999);
  const x = radius * Math.sin(turn), y = -radius * Math.cos(turn);
  const slice = share > 0 ? [draw('path', {d: `M0 0 L0 ${-radius} A${radius} ${radius} 0 ${turn > Math.PI ? 1 : 0} 1 ${x.toFixed(3)} ${y.toFixed(3)} Z`, fill: ink})] : [];
  return [draw('circle', {r: radius + 1.6, fill: '#fff'}), draw('circle', {r: radius, fill: '#fff', stroke: ink, 'stroke-width': 1.2}), ...slice];
}
