// The page's data, unpacked, and the formats of numbers and times.
const page = JSON.parse(document.getElementById('data').textContent);

function unpack(text, Type) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  return new Type(bytes.buffer);
}
const unpackTimes = text => unpack(text, Float64Array);
const unpackSeries = packed =>
  packed && {t: unpackTimes(packed.t), v: unpack(packed.v, Float32Array)};

const rovers = page.rovers.map(packed => {
  const p = packed.position;
  const rover = {
    ...packed, name: packed.name || packed.id, isShown: true, ink: legible(packed.colour),
    position: {
      t: unpackTimes(p.t), x: unpack(p.x_m, Float32Array), y: unpack(p.y_m, Float32Array),
      lon: unpack(p.lon_e7deg, Int32Array), lat: unpack(p.lat_e7deg, Int32Array),
      heading: unpack(p.heading_rad, Float32Array),
    },
    events: page.events.filter(event => event.rover_id === packed.id && event.run === packed.run),
  };
  for (const name of page.quantities) rover[name] = unpackSeries(packed[name]);
  return rover;
});
// `run`: of a page of several runs, in which each run has its own rovers.
const roverOf = (id, run) => rovers.find(rover => rover.id === id && rover.run === run);

// A rover's colour, darkened until its contrast with white is at least 3 : 1.
function legible(colour) {
  let rgb = [1, 3, 5].map(at => parseInt(colour.slice(at, at + 2), 16) / 255);
  const light = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
  const luminance = () => 0.2126 * light(rgb[0]) + 0.7152 * light(rgb[1]) + 0.0722 * light(rgb[2]);
  while (1.05 / (luminance() + 0.05) < 3) rgb = rgb.map(c => c * 0.96);
  return '#' + rgb.map(c => Math.round(c * 255).toString(16).padStart(2, '0')).join('');
}

// The index of the sample nearest to a time.
function nearest(times, time) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] < time) low = middle + 1;
    else high = middle;
  }
  return low > 0 && time - times[low - 1] <= times[low] - time ? low - 1 : low;
}

// A leap second is shown as the one after it.
const leaps = page.start_utc.includes(':60');
const startMs = Date.parse(page.start_utc.replace(':60', ':59')) + (leaps ? 1000 : 0);
const endS = Math.max(page.end_s, 1e-3);
const two = n => String(n).padStart(2, '0');

function elapsedText(time) {
  const s = Math.round(time), d = Math.floor(s / 86400);
  return `${d > 0 ? d + ' d ' : ''}${two(Math.floor(s / 3600) % 24)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}
// UTC stands still during each leap second; `leap_ends_s` has the times at which they end.
function leapsBefore(time) {
  return page.leap_ends_s.filter(end => time >= end - 1e-6).length;
}
function utcSeconds(time) {
  return startMs / 1000 + time - leapsBefore(time);
}
function utcText(time) {
  return new Date(1000 * Math.round(utcSeconds(time))).toISOString().slice(0, 19).replace('T', ' ') + ' UTC';
}
function durationText(time) {
  if (time === null || time === undefined) return '';
  if (time < 60) return `${+time.toFixed(1)} s`;
  const s = Math.round(time), m = Math.floor(s / 60), h = Math.floor(m / 60), d = Math.floor(h / 24);
  if (m < 60) return `${m} min ${two(s % 60)} s`;
  if (h < 24) return `${h} h ${two(m % 60)} min`;
  return `${d} d ${two(h % 24)} h`;
}

// About four significant digits, with a true minus sign.
function numberText(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  const size = Math.abs(value);
  const places = size === 0 ? 0 : Math.max(0, Math.min(6, digits - 1 - Math.floor(Math.log10(size))));
  const text = size >= 1e6 || (size > 0 && size < 1e-4) ? value.toExponential(2) : value.toFixed(places);
  return text.replace('-', '−');
}
const placesText = (value, places) =>
  Number.isNaN(value) ? '–' : (Math.abs(value) < 0.5 * 10 ** -places ? 0 : value).toFixed(places).replace('-', '−');
function distanceText(value) {
  if (value === null || value === undefined) return '–';
  return Math.abs(value) >= 10000 ? `${(value / 1000).toFixed(2)} km` : `${value.toFixed(1)} m`;
}
const energyText = value =>
  value === null || value === undefined ? '–'
    : Math.abs(value) >= 1.8e6 ? `${placesText(value / 3.6e6, 2)} kWh`
      : `${placesText(value / 3600, 1)} Wh`;

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'style') element.style.cssText = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}
function draw(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

// Kinds of events in the bars; the last holds all other types.
const kinds = page.kinds;
const kindOf = event => kinds.find(kind => kind.types.includes(event.type)) || kinds[kinds.length - 1];
const statusMarks = {
  completed: '✓', failed: '✕', incomplete: '…', running: '▸', waiting: '…', skipped: '↷', disabled: '–', not_started: '○',
};
const statusColours = {
  completed: '#2a7d3c', failed: '#c62828', incomplete: '#e08a00', running: '#e08a00', waiting: '#e08a00',
  skipped: '#8a949e', disabled: '#8a949e', not_started: '#8a949e',
};
const statusText = status => status.replace('_', ' ');
