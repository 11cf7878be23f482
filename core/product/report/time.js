// The time window that all plots share, and the time cursor that they share with the map.
const view = {from: 0, to: endS, cursor: endS, isPinned: false, isUtc: false};
const viewers = [];  // objects with windowChanged(), cursorChanged(), roversChanged()
const shortestS = Math.min(endS, 1);

function setWindow(from, to) {
  const middle = (from + to) / 2, half = Math.max(to - from, shortestS) / 2;
  from = Math.max(0, Math.min(middle - half, endS - 2 * half));
  view.from = from;
  view.to = Math.min(endS, from + 2 * half);
  for (const viewer of viewers) viewer.windowChanged?.();
}
let cursorFrame = 0;
function setCursor(time) {
  view.cursor = Math.max(0, Math.min(endS, time));
  if (cursorFrame) return;
  cursorFrame = requestAnimationFrame(() => {
    cursorFrame = 0;
    for (const viewer of viewers) viewer.cursorChanged?.();
  });
}
function showRovers() {
  for (const viewer of viewers) viewer.roversChanged?.();
}

const steps = [
  1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 10800, 21600, 43200,
  86400, 172800, 604800, 1209600, 2592000,
];
// Times to label between `from` and `to`, at least `apart` pixels apart.
function timeTicks(from, to, width, apart = 84) {
  const least = (to - from) / Math.max(2, width / apart);
  const step = steps.find(s => s >= least) || steps[steps.length - 1];
  const shift = view.isUtc ? (startMs / 1000) % 86400 : 0;
  const ticks = [];
  for (let k = Math.ceil((from + shift) / step); k * step - shift <= to + 1e-6; ++k) {
    const even = k * step - shift, time = view.isUtc ? even + leapsBefore(even) : even;
    ticks.push({v: time, label: tickText(time, step)});
  }
  return ticks;
}
function tickText(time, step) {
  if (view.isUtc) {
    const iso = new Date(1000 * utcSeconds(time)).toISOString();
    if (step >= 86400) return iso.slice(5, 10);
    if (step >= 60) return iso.slice(11, 16) === '00:00' ? iso.slice(5, 10) : iso.slice(11, 16);
    return iso.slice(11, 19);
  }
  const d = Math.floor(Math.round(time) / 86400), s = Math.round(time) - d * 86400;
  if (step >= 86400) return `${d} d`;
  const clock = `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}`;
  const day = endS > 86400 && d > 0;
  if (step >= 60) return day ? (s === 0 ? `${d} d` : `${d} d ${clock}`) : clock;
  return `${clock}:${two(s % 60)}`;
}

// Captures the pointer, so that a drag continues outside of the element where it began.
function hold(element, event) {
  try {
    element.setPointerCapture(event.pointerId);
  } catch {
    // The pointer has gone, which does not matter.
  }
}
// Handles hovering, dragging and clicking over an element with a time axis: `left()` is its left edge
// in the element, `width()` its width.
function followPointer(element, left, width, chosen) {
  const timeAt = event => {
    const x = event.clientX - element.getBoundingClientRect().left - left();
    return view.from + Math.max(0, Math.min(1, x / width())) * (view.to - view.from);
  };
  let begin = null;
  element.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    begin = {x: event.clientX, time: timeAt(event)};
    hold(element, event);
    event.preventDefault();
  });
  element.addEventListener('pointermove', event => {
    const time = timeAt(event);
    if (begin && Math.abs(event.clientX - begin.x) > 4) chosen(begin.time, time);
    if (!view.isPinned || begin) setCursor(time);
  });
  element.addEventListener('pointerup', event => {
    if (!begin) return;
    const was = begin, time = timeAt(event);
    begin = null;
    chosen(null);
    if (Math.abs(event.clientX - was.x) > 4) {
      setWindow(Math.min(was.time, time), Math.max(was.time, time));
    } else {
      view.isPinned = !view.isPinned;
      setCursor(time);
    }
  });
  element.addEventListener('pointercancel', () => {
    begin = null;
    chosen(null);
  });
  element.addEventListener('dblclick', () => setWindow(0, endS));
}
