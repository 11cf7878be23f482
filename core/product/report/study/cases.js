// The table of cases: sorted by a click on a heading, filtered by words and comparisons.
const rowsAtOnce = 120;  // that are drawn, and added when the last is scrolled to

function cellText(column, value) {
  if (value === null) return '–';
  if (typeof value !== 'number') return String(value);
  return Number.isInteger(value) && column.unit === '' ? String(value) : numberText(value * column.shown.scale, 5);
}

// "failed speed>1.5 case<=20": a test of a row, or the part that cannot be read.
function readFilter(text) {
  const tests = [];
  for (const part of text.match(/(?:"[^"]*"|[^\s"])+/g) || []) {
    const [, name, sign, limit] = part.match(/^(.+?)(<=|>=|<|>|=)(.*)$/) || [];
    if (sign) {
      const wanted = name.replaceAll('"', '').toLowerCase(), value = limit.trim() === '' ? NaN : Number(limit.replace('−', '-'));
      const column = study.columns.find(c => c.name.toLowerCase() === wanted) || study.columns.find(c => c.name.toLowerCase().includes(wanted));
      if (!column || (Number.isNaN(value) && sign !== '=') || (!column.is_text && Number.isNaN(value))) return {wrong: part};
      const compare = {'<': (a, b) => a < b, '>': (a, b) => a > b, '<=': (a, b) => a <= b, '>=': (a, b) => a >= b,
        '=': (a, b) => (column.is_text ? String(a) === limit : Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b)))}[sign];
      tests.push(row => column.values[row] !== null && compare(column.is_text ? column.values[row] : column.values[row] * column.shown.scale, value));
    } else {
      const words = part.replaceAll('"', '').toLowerCase();
      const texts = study.columns.filter(column => column.is_text || column.name === 'case');
      tests.push(row => texts.some(column => column.values[row] !== null && String(column.values[row]).toLowerCase().includes(words)));
    }
  }
  return {test: row => tests.every(test => test(row))};
}

class CaseTable {
  constructor(place) {
    this.hasAll = false;
    this.sort = {column: columnOf('case'), isDown: false};
    this.input = make('input', {type: 'search', id: 'case-filter', placeholder: 'failed  SEV1_distance_m>900  case<50', 'aria-label': 'Filter of cases', spellcheck: 'false'});
    this.told = make('output', {id: 'case-count'});
    this.more = make('button', {type: 'button', id: 'all-columns'}, 'All columns');
    this.open = make('span', {id: 'case-open'});
    this.place = make('div', {class: 'wide', id: 'case-table'});
    const {shown, counts} = study;
    place.append(make('h2', {}, 'Cases'), make('div', {class: 'case-tools'}, this.input, this.more, this.told, this.open), this.place,
      make('p', {class: 'note'}, `Words are looked for in texts; COLUMN<NUMBER, >, <=, >= and = compare in the units of the headings. Click a heading to sort, a row to show the case in all plots and on the map. Names with blanks stand in quotes: "Rover A.InitialCharge"<0.5.${shown < counts.gathered ? ` The first ${shown.toLocaleString('en')} of ${counts.gathered.toLocaleString('en')} cases are shown; all numbers above are of all, and study.gpkg has all.` : ''}`));
    this.input.addEventListener('input', () => this.filter());
    this.more.addEventListener('click', () => {
      this.hasAll = !this.hasAll;
      this.more.textContent = this.hasAll ? 'Fewer columns' : 'All columns';
      this.fill();
    });
    this.place.addEventListener('scroll', () => {
      if (this.place.scrollTop + this.place.clientHeight > this.place.scrollHeight - 400) this.addRows();
    });
    // On paper are the rows that are drawn; the rest is told.
    const onPaper = make('p', {class: 'note on-paper'});
    place.append(onPaper);
    addEventListener('beforeprint', () => {
      const drawn = Math.min(this.next, this.rows.length);
      onPaper.textContent = drawn < this.rows.length ? `The first ${drawn} of ${this.rows.length.toLocaleString('en')} cases; study.gpkg has all.` : '';
    });
    viewers.push(this);
    this.filter();
  }
  columns() {
    if (this.hasAll) return study.columns;
    const isBrief = column => ['case', 'status', 'reason'].includes(column.name) || column.kind === 'parameter' || column.kind === 'gathered'
      || /_(distance_m|duration_s|energy_end_j)$/.test(column.name);
    return study.columns.filter(isBrief);
  }
  filter() {
    const {test, wrong} = readFilter(this.input.value);
    this.input.classList.toggle('is-wrong', wrong !== undefined);
    this.input.title = wrong === undefined ? '' : `${wrong}: there is no such column, or no number after it`;
    if (wrong !== undefined) return;
    for (let row = 0; row < study.shown; ++row) choice.passes[row] = test(row) ? 1 : 0;
    this.fill();
    for (const viewer of viewers) viewer.filterChanged?.();
  }
  fill() {
    const {column, isDown} = this.sort, sign = isDown ? -1 : 1;
    this.rows = [];
    for (let row = 0; row < study.shown; ++row) if (choice.passes[row]) this.rows.push(row);
    const values = column.values;
    // What is absent comes last, whichever way the column is sorted.
    this.rows.sort((a, b) => {
      const x = values[a], y = values[b];
      if (x === null || y === null) return (x === null) - (y === null) || a - b;
      return sign * (typeof x === 'string' ? (x < y ? -1 : x > y ? 1 : 0) : x - y) || a - b;
    });
    this.told.textContent = this.rows.length === study.shown ? `${study.shown.toLocaleString('en')} cases` : `${this.rows.length.toLocaleString('en')} of ${study.shown.toLocaleString('en')} cases`;
    const heads = this.columns().map(each => {
      const isSorted = each === column;
      const head = make('th', {class: each.is_text ? '' : 'number', title: each.sentence, 'aria-sort': isSorted ? (isDown ? 'descending' : 'ascending') : 'none'},
        make('button', {type: 'button'}, each.name.replace(/_(m|s|j|rad)$/, '').replaceAll('_', ' '), make('small', {}, unitText(each.shown)), isSorted ? (isDown ? ' ▾' : ' ▴') : ''));
      head.addEventListener('click', () => {
        this.sort = {column: each, isDown: isSorted ? !isDown : false};
        this.fill();
      });
      return head;
    });
    this.body = make('tbody', {});
    this.place.replaceChildren(make('table', {}, make('thead', {}, make('tr', {}, ...heads)), this.body));
    this.place.scrollTop = 0;
    this.next = 0;
    this.lines = new Map();
    this.addRows();
  }
  addRows() {
    const columns = this.columns();
    for (const row of this.rows.slice(this.next, this.next + rowsAtOnce)) {
      const line = make('tr', row === choice.row ? {class: 'is-chosen'} : {}, ...columns.map(column => {
        const value = column.values[row];
        if (column.name === 'status') return make('td', {}, make('span', {class: 'result', style: `color:${outcomeInk(value)}`}, `${outcomeMarks[value] || ''} ${outcomeText(value)}`));
        return make('td', {class: column.name === 'reason' ? 'reason' : column.is_text ? '' : 'number'}, cellText(column, value));
      }));
      line.addEventListener('click', () => chooseCase(row));
      this.lines.set(row, line);
      this.body.append(line);
    }
    this.next += rowsAtOnce;
  }
  caseChanged() {
    for (const [row, line] of this.lines) line.classList.toggle('is-chosen', row === choice.row);
    this.lines.get(choice.row)?.scrollIntoView({block: 'nearest'});
  }
}
