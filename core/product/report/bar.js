// The bar that all pages have: the time under the cursor, and the window and axis of the plots.
const clock = {
  elapsed: document.getElementById('clock-elapsed'),
  utc: document.getElementById('clock-utc'),
  cursorChanged() {
    this.elapsed.textContent = `${elapsedText(view.cursor)}${view.isPinned ? ' (held)' : ''}`;
    this.utc.textContent = utcText(view.cursor);
  },
};

const wholeButton = document.getElementById('whole');
wholeButton.addEventListener('click', () => setWindow(0, endS));
const axisButton = document.getElementById('axis');
const tools = {
  windowChanged() { wholeButton.disabled = view.from <= 0 && view.to >= endS; },
  nameAxis() { axisButton.textContent = view.isUtc ? 'Axis: UTC' : 'Axis: elapsed'; },
};
axisButton.addEventListener('click', () => {
  view.isUtc = !view.isUtc;
  tools.nameAxis();
  for (const plot of plots) plot.refresh();
});
tools.nameAxis();

document.addEventListener('keydown', event => {
  if (event.target.closest('input, textarea, select')) return;
  const step = (view.to - view.from) / (event.shiftKey ? 20 : 200);
  if (event.key === 'ArrowRight') setCursor(view.cursor + step);
  else if (event.key === 'ArrowLeft') setCursor(view.cursor - step);
  else if (event.key === 'Escape') {
    view.isPinned = false;
    setWindow(0, endS);
    setCursor(view.cursor);
  } else return;
  event.preventDefault();
});

viewers.push(clock, tools);

// A button a rover, which shows or hides it everywhere, with the event that it is in.
function showChips() {
  const chips = {
    list: rovers.map(rover => {
      const now = make('span', {}, '');
      const chip = make('button', {class: 'chip', type: 'button', 'aria-pressed': 'true', title: `Show or hide ${rover.id}`},
        make('i', {style: `background:${rover.ink}`}), make('b', {}, rover.id), now);
      chip.addEventListener('click', () => {
        rover.isShown = !rover.isShown;
        chip.setAttribute('aria-pressed', String(rover.isShown));
        showRovers();
      });
      document.getElementById('chips').append(chip);
      return {rover, now};
    }),
    cursorChanged() {
      for (const {rover, now} of this.list) {
        const event = rover.events.findLast(e => e.start_s !== null && e.start_s <= view.cursor && (e.end_s === null || e.end_s >= view.cursor));
        now.textContent = event ? `${event.label}` : page.study ? rover.type : 'no event';
      }
    },
  };
  viewers.push(chips);
}
