// Which parameter moves which result: a table of rank correlations and first-order shares, and a plot
// of one pair.

// From purple (falls) over white to orange (rises); the number stands in each cell.
function correlationInk(rho) {
  const [r, g, b] = rho < 0 ? [94, 60, 153] : [230, 97, 1], part = 0.75 * Math.min(1, Math.abs(rho));
  const mixed = [r, g, b].map(channel => Math.round(255 + part * (channel - 255)));
  return {fill: `rgb(${mixed.join(' ')})`, text: part > 0.5 && rho < 0 ? '#fff' : '#17212b'};
}
const chanceText = p => (p === null || p === undefined ? `fewer than ${study.significance_cases_min} cases: chance is not known` : p < 0.001 ? 'p < 0.001' : `p = ${p.toFixed(3)}`);

function influenceCell(cell, number, parameter, show) {
  const parts = [], notes = [];
  let style = '';
  if (cell.rho !== null) {
    const ink = correlationInk(cell.rho);
    style = `background:${ink.fill};color:${ink.text}`;
    parts.push(make(cell.is_found ? 'b' : 'span', {}, placesText(cell.rho, 2)));
    notes.push(`rank correlation ${placesText(cell.rho, 3)}, ${chanceText(cell.p)}, ${cell.cases} cases`);
  } else parts.push(make('span', {}, '–'));
  if (study.has_shares) {
    const text = cell.share === null ? '–' : percentOf(cell.share);
    parts.push(make(cell.is_share_found ? 'b' : 'span', {class: 'share'}, text));
    if (cell.share !== null) notes.push(`first-order share ${percentOf(cell.share, 1)}, ${chanceText(cell.share_p)}, ${cell.classes} classes`);
  }
  const button = make('button', {type: 'button', style, title: `${numberTitle(number)} against ${parameter}: ${notes.join('; ') || 'it does not vary'}`}, ...parts);
  button.addEventListener('click', () => show());
  return button;
}

// One parameter against one number, a mark a case.
class PairPlot {
  constructor() {
    this.marks = draw('g');
    this.axes = draw('g');
    this.ring = draw('circle', {r: 7, fill: 'none', stroke: chosenInk, 'stroke-width': 2, visibility: 'hidden'});
    this.svg = draw('svg', {viewBox: '0 0 640 360', role: 'img', 'aria-label': 'A parameter against a result'}, this.axes, this.marks, this.ring);
    this.title = make('h3', {});
    this.about = make('p', {class: 'note'});
    this.element = make('figure', {id: 'pair'}, this.title, this.svg, this.about);
    viewers.push(this);
  }
  show(numberAt, parameterAt) {
    const number = study.numbers[numberAt], parameter = columnOf(study.parameters[parameterAt]), cell = study.influence[numberAt][parameterAt];
    const texts = parameter.is_text && !parameter.times ? [...new Set(parameter.values)].filter(value => value !== null).sort() : null;
    this.x = parameter.times || parameter.values.map(value => (value === null ? null : texts ? texts.indexOf(value) : value * parameter.shown.scale));
    this.y = valuesOf(number).map(value => (value === null ? null : value * shownOf(number).scale));
    this.title.replaceChildren(`${numberTitle(number)}${unitText(shownOf(number))}`, make('span', {}, ` against ${parameter.name}${unitText(parameter.times ? {unit: parameter.timeUnit} : parameter.shown)}`));
    this.about.textContent = [cell.rho === null ? '' : `Rank correlation ${placesText(cell.rho, 2)} (${chanceText(cell.p)}).`,
      cell.share === null ? '' : `First-order share ${percentOf(cell.share)} (${chanceText(cell.share_p)}).`].join(' ');
    this.scaleX = this.axis(this.x, 56, 626, texts);
    this.scaleY = this.axis(this.y, 330, 12, null);
    this.drawAxes(texts);
    this.drawMarks();
    for (const button of document.querySelectorAll('#influence-table button')) button.classList.remove('is-shown');
    document.querySelector(`#influence-table tbody tr:nth-child(${numberAt + 1}) td:nth-child(${parameterAt + 2}) button`)?.classList.add('is-shown');
  }
  axis(values, from, to, texts) {
    const known = values.filter(value => value !== null);
    let low = known.reduce((a, b) => Math.min(a, b), Infinity), high = known.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(low < high)) [low, high] = [low - 0.5, high + 0.5];
    const pad = texts ? 0.5 : 0.04 * (high - low);
    low -= pad;
    high += pad;
    const place = value => from + ((value - low) / (high - low)) * (to - from);
    return Object.assign(place, {low, high});
  }
  drawAxes(texts) {
    const parts = [draw('path', {d: 'M56 12 V330 H626', fill: 'none', stroke: '#8b97a3'})];
    const text = (x, y, anchor, words) => draw('text', {x, y, 'text-anchor': anchor}, words);
    const ticks = scale => valueTicks(scale.low, scale.high, 360, name => ({pixelsPerLabel: 60, axisLabelFormatter: String}[name]), null).filter(tick => tick.v >= scale.low && tick.v <= scale.high);
    for (const tick of texts ? texts.map((label, v) => ({v, label})) : ticks(this.scaleX)) {
      const x = this.scaleX(tick.v);
      parts.push(draw('line', {x1: x, x2: x, y1: 330, y2: 334, stroke: '#8b97a3'}), text(x, 347, 'middle', tick.label));
    }
    for (const tick of ticks(this.scaleY)) {
      const y = this.scaleY(tick.v);
      parts.push(draw('line', {x1: 56, x2: 626, y1: y, y2: y, stroke: '#e6eaee'}), text(50, y + 4, 'end', tick.label));
    }
    this.axes.replaceChildren(...parts);
  }
  drawMarks() {
    const marks = [];
    for (let row = 0; row < study.shown; ++row) {
      if (this.x[row] === null || this.y[row] === null) continue;
      const x = this.scaleX(this.x[row]), y = this.scaleY(this.y[row]), ink = outcomeInk(caseStatuses[row]), isIn = choice.passes[row];
      const mark = caseStatuses[row] === 'completed'
        ? draw('circle', {cx: x, cy: y, r: 3.2, fill: ink, 'fill-opacity': isIn ? 0.6 : 0.08})
        : draw('path', {d: `M${x - 3.2} ${y - 3.2}l6.4 6.4m0 -6.4l-6.4 6.4`, stroke: ink, 'stroke-width': 1.8, 'stroke-opacity': isIn ? 0.9 : 0.1});
      mark.append(draw('title', {}, `case ${caseNumbers[row]}, ${outcomeText(caseStatuses[row])}`));
      mark.addEventListener('click', () => chooseCase(row));
      marks.push(mark);
    }
    this.marks.replaceChildren(...marks);
    this.caseChanged();
  }
  caseChanged() {
    const row = choice.row, isOn = row !== null && this.x && this.x[row] !== null && this.y[row] !== null;
    this.ring.setAttribute('visibility', isOn ? 'visible' : 'hidden');
    if (!isOn) return;
    this.ring.setAttribute('cx', this.scaleX(this.x[row]));
    this.ring.setAttribute('cy', this.scaleY(this.y[row]));
  }
  filterChanged() { if (this.x) this.drawMarks(); }
}

function influenceNote() {
  const {has_shares: hasShares, false_rate: rate, first_order_cases_min: casesMin, significance_cases_min: knownMin} = study;
  const ran = study.counts.run;
  const few = ran < knownMin ? `With ${ran} cases nothing can be told from chance. ` : ran < 30 ? `${ran} cases are few: only strong effects can be told from chance. ` : '';
  return `${few}Above: Spearman’s rank correlation, −1 (falls) to 1 (rises); equal values share ranks. `
    + (hasShares
      ? `Below: first-order share, how much of the variance would go if the parameter were held: the correlation ratio over classes of about equal numbers of cases, corrected for their number (Plischke, Borgonovo and Smith 2013), from ${casesMin} cases on. Shares need not add up to 100 %: what is left comes of parameters together. `
      : 'First-order shares are left out: on a part of a grid parameters are not drawn independently. ')
    + `Bold: more than chance, so that at most ${percentOf(rate)} of the bold ones are expected to be chance (Benjamini and Hochberg 1995; Student’s and Fisher’s distributions). Cases without a value are left out of it.`;
}

function fillInfluence(place) {
  if (study.parameters.length === 0 || study.influence.length === 0) return place.remove();
  const pair = new PairPlot();
  const strength = cells => Math.max(...cells.map(cell => Math.max(Math.abs(cell.rho ?? 0), cell.share ?? 0)));
  const head = make('tr', {}, make('th', {}, 'Result'), ...study.parameters.map(name => make('th', {class: 'number'}, name)));
  const lines = study.numbers.map((number, k) => make('tr', {}, make('td', {title: number.sentence}, numberTitle(number)),
    ...study.influence[k].map((cell, i) => make('td', {}, influenceCell(cell, number, study.parameters[i], () => pair.show(k, i))))));
  place.append(make('h2', {}, 'What moves what'), make('p', {class: 'note'}, influenceNote()),
    make('div', {class: 'influence'}, make('div', {class: 'wide', id: 'influence-table'}, make('table', {}, make('thead', {}, head), make('tbody', {}, ...lines))), pair.element));
  // The strongest of what was gathered, or of all.
  const order = study.numbers.map((number, k) => k).sort((a, b) => (study.numbers[b].kind === 'gathered') - (study.numbers[a].kind === 'gathered') || strength(study.influence[b]) - strength(study.influence[a]));
  const best = order[0], cells = study.influence[best];
  pair.show(best, cells.reduce((most, cell, i) => (strength([cell]) > strength([cells[most]]) ? i : most), 0));
}
