// The list of plots. They are drawn when they come onto the screen.
function linesOf(name, change = v => v) {
  return rovers.filter(rover => rover[name]).map(rover => ({
    t: rover[name].t, v: change(rover[name].v), name: rover.name, colour: rover.ink, dash: rover.dash, rovers: [rover],
  }));
}
function greatest(lines) {
  let most = 0;
  for (const line of lines) for (const v of line.v) if (Math.abs(v) > most) most = Math.abs(v);
  return most;
}
const relative = v => {
  const first = v.find(value => !Number.isNaN(value)) ?? 0;
  return v.map(value => value - first);
};
const metres = lines => (greatest(lines) >= 10000 ? {unit: 'km', scale: 1e-3} : {unit: 'm', scale: 1});

// Energy in the batteries, with lines at full and reserve. The axis runs from empty to full if all
// rovers have a battery; of several runs it shows how they differ.
function energyPlot() {
  const lines = linesOf('energy_j').map(line => ({...line, full: line.rovers[0].battery?.capacity_j}));
  const most = greatest(lines), fulls = lines.map(line => line.full || 0), fullest = Math.max(...fulls, 0);
  const unit = Math.max(most, fullest) >= 3.6e6 ? {unit: 'kWh', scale: 1 / 3.6e6} : {unit: 'Wh', scale: 1 / 3600};
  // Rovers with the same level share one line.
  const levels = new Map();
  for (const {rovers: [rover]} of lines) {
    const {capacity_j: full, reserve_j: reserve} = rover.battery || {};
    for (const [value, word] of [[full, 'full'], [reserve, 'reserve']]) {
      if (!(value > 0)) continue;
      const level = levels.get(`${word} ${value}`) || {value, word, rovers: []};
      level.rovers.push(rover);
      levels.set(`${word} ${value}`, level);
    }
  }
  const isShared = word => [...levels.values()].filter(level => level.word === word).length === 1;
  return {
    key: 'energy', title: 'Energy', lines, digits: 5, ...unit,
    range: fulls.every(full => full > 0) && !page.runs ? [0, 1.12 * fullest * unit.scale] : null,
    levels: [...levels.values()].map(level => ({
      ...level, colour: level.word === 'reserve' ? '#b3261e' : '#55626f',
      text: isShared(level.word) ? level.word : `${level.word} of ${level.rovers.map(rover => rover.name).join(', ')}`,
    })),
  };
}

// Solar power in use and, dashed, the power available where a full battery left much of it unused.
function solarPlot() {
  const given = linesOf('solar_w').filter(({rovers: [rover]}) => rover.sun_fraction);
  const offered = given.flatMap(line => {
    if (page.runs) return [];  // several runs have enough lines
    const [rover] = line.rovers, series = rover.solar_available_w, much = 0.05 * greatest([line]) + 1;
    if (!series || !series.v.some((value, k) => value - line.v[nearest(line.t, series.t[k])] > much)) return [];
    return [{...series, name: `${rover.name} available`, colour: rover.ink, dash: [2, 3], rovers: [rover]}];
  });
  const lines = [...given, ...offered];
  return {key: 'solar', title: 'Solar power', lines, includesZero: true, ...(greatest(lines) >= 2000 ? {unit: 'kW', scale: 1e-3} : {unit: 'W', scale: 1})};
}

// East and north of each rover in one plot; of several runs in two, which would have too many lines.
function positionPlots() {
  const along = axis => rovers.map(r => ({t: r.position.t, v: r.position[axis], name: r.name, colour: r.ink, dash: r.dash, rovers: [r]}));
  const east = along('x'), north = along('y');
  if (page.runs) {
    return [{key: 'east', title: 'Position, east', lines: east, ...metres(east)},
      {key: 'north', title: 'Position, north', lines: north, ...metres(north)}];
  }
  const lines = rovers.flatMap((r, k) => [
    {...east[k], name: `${r.name} east`}, {...north[k], name: `${r.name} north`, dash: [5, 3]}]);
  return [{key: 'position', title: 'Position', lines, ...metres(lines)}];
}

function plotSpecs() {
  const elevation = linesOf('elevation_m', relative);
  const rate = linesOf('energy_rate_w'), speed = linesOf('speed_mps');
  const inks = ['#35424f', '#8a6d3b', '#5f4b8b', '#1f7a78', '#a04668', '#6b7783'];
  const distance = page.distances.filter(pair => pair.series).map((pair, k) => ({
    ...unpackSeries(pair.series), name: `${pair.from} – ${pair.to}`, colour: inks[k % inks.length],
    rovers: [roverOf(pair.from), roverOf(pair.to)],
  }));
  const isSlow = greatest(speed) < 0.2;
  return [
    energyPlot(),
    solarPlot(),
    {key: 'elevation', title: 'Relative elevation', lines: elevation, unit: 'm', scale: 1},
    ...positionPlots(),
    {key: 'rate', title: 'Energy rate', lines: rate, includesZero: true, ...(greatest(rate) >= 2000 ? {unit: 'kW', scale: 1e-3} : {unit: 'W', scale: 1})},
    {key: 'speed', title: 'Speed', lines: speed, unit: isSlow ? 'cm/s' : 'm/s', scale: isSlow ? 100 : 1, includesZero: true},
    {key: 'slip', title: 'Slip', lines: linesOf('slip'), unit: '%', scale: 100, includesZero: true},
    {key: 'sun', title: 'Sun on the panels', lines: linesOf('sun_fraction'), unit: '% of their area', scale: 100, includesZero: true},
    {key: 'distance', title: 'Distance between rovers', lines: distance, includesZero: true, ...metres(distance)},
  ].filter(spec => spec.lines.length > 0);
}

const plots = [];

function showPlots(shown) {
  plots.push(...shown);
  const place = document.getElementById('plots');
  const watcher = new IntersectionObserver(entries => {
    for (const entry of entries) {
      const plot = plots.find(p => p.element === entry.target);
      plot.isSeen = entry.isIntersecting;
      if (plot.isSeen && plot.isDirty) plot.update();
      else if (plot.isSeen) plot.moveCursor();
    }
  }, {rootMargin: '200px'});
  for (const plot of plots) {
    place.append(plot.element);
    viewers.push(plot);
    watcher.observe(plot.element);
  }
  let timer = 0;
  window.addEventListener('resize', () => {
    clearTimeout(timer);
    timer = setTimeout(() => [map, ...plots].forEach(part => part.resized()), 120);
  });
  // Plots are drawn anew for paper, which is narrower than most screens and of finer resolution.
  const drawAll = scale => {
    printScale = scale;
    map.resized();
    for (const plot of plots) {
      plot.isSeen = true;
      plot.resized();
    }
  };
  window.addEventListener('beforeprint', () => {
    document.body.classList.add('printing');
    drawAll(3);
  });
  window.addEventListener('afterprint', () => {
    document.body.classList.remove('printing');
    drawAll(1);
  });
  const used = kinds.filter(kind => page.events.some(event => event.start_s !== null && kindOf(event) === kind));
  const failed = page.events.some(event => event.status === 'failed' && event.start_s !== null);
  document.getElementById('kinds').append(
    ...used.map(kind => make('span', {}, make('i', {style: `background:${kind.colour}`}), kind.name)),
    ...(failed ? [make('span', {}, make('i', {style: 'background:repeating-linear-gradient(135deg,#c62828 0 1.5px,#fff 1.5px 4px)'}), 'failed')] : []));
}
