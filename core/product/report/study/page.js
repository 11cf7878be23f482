// Assembles the page of a study.
function fillStudyHead() {
  const {counts, name} = study, plan = page.plan.replace(/^.*\//, '');
  document.title = `${name}: study of ${plan}`;
  document.getElementById('title').textContent = name;
  const start = page.start_utc.slice(0, 16).replace('T', ' ');
  document.getElementById('subtitle').textContent = `${study.doc} (${plan}, ${page.body}, ${study.has_one_start ? `${start} UTC` : 'starts vary'})`;
  const interval = `${percentOf(counts.completed_low)} to ${percentOf(counts.completed_high)}`;
  const facts = [
    ['Cases', counts.gathered === counts.wanted ? `${counts.wanted.toLocaleString('en')}` : `${counts.gathered.toLocaleString('en')} of ${counts.wanted.toLocaleString('en')}`],
    ['Missions completed', counts.run > 0 ? percentOf(counts.completed / counts.run, counts.completed < counts.run ? 1 : 0) : '–', counts.completed === counts.run ? 'completed' : ''],
    ['95 % interval of it', counts.run > 0 ? interval : '–'],
    ['Sampling', `${study.sampling.replaceAll('_', ' ')}, seed ${study.seed}`],
    ['Varied', `${study.parameters.length}`],
  ];
  document.getElementById('facts').append(...facts.map(([term, text, kind]) => make('div', {}, make('dt', {}, term), make('dd', kind ? {class: kind} : {}, text))));
}

// How missions ended: a bar of all cases, and reasons with the cases that have them.
function fillOutcomes() {
  const place = document.getElementById('findings'), {gathered, wanted} = study.counts;
  if (gathered < wanted) place.append(make('div', {class: 'finding warn'}, make('h3', {}, `${wanted - gathered} of ${wanted} cases have not run yet`), make('p', {}, 'The same sweep goes on with them; this page shows those that have.')));
  if (study.stopped) place.append(make('div', {class: 'finding good'}, make('h3', {}, 'Stopped early'), make('p', {}, `${study.stopped}.`)));
  const byStatus = new Map();
  for (const {status, cases} of study.outcomes) byStatus.set(status, (byStatus.get(status) || 0) + cases.length);
  const bar = make('div', {class: 'outcome-bar'}, ...[...byStatus].map(([status, count]) => make('span', {
    style: `flex:${count} 0 0;background:${outcomeInk(status)}`, title: `${count} ${outcomeText(status)}`})));
  const keys = make('p', {class: 'outcome-keys'}, ...[...byStatus].map(([status, count]) => make('span', {}, make('i', {style: `background:${outcomeInk(status)}`}), `${outcomeMarks[status] || ''} ${count.toLocaleString('en')} ${outcomeText(status)} (${percentOf(count / gathered, 1)})`)));
  const bad = study.outcomes.filter(outcome => outcome.status !== 'completed');
  const line = ({status, reason, cases}) => {
    const shown = cases.slice(0, 12);
    return make('li', {}, make('b', {style: `color:${outcomeInk(status)}`}, `${cases.length} `), `${reason || outcomeText(status)}: case${cases.length > 1 ? 's' : ''} `,
      ...shown.flatMap((number, k) => [k > 0 ? ', ' : '', caseButton(number)]), cases.length > shown.length ? ` and ${cases.length - shown.length} more` : '');
  };
  const first = 12;
  const rest = bad.slice(first);
  const box = make('div', {class: `finding ${bad.length > 0 ? 'bad' : 'good'}`}, make('h3', {}, bad.length > 0 ? 'How missions ended' : 'All missions completed'), bar, keys, make('ul', {}, ...bad.slice(0, first).map(line)));
  if (rest.length > 0) {
    const folded = make('details', {}, make('summary', {}, `${rest.length} more reasons`), make('ul', {}, ...rest.map(line)));
    openOnPaper(folded);
    box.append(folded);
  }
  place.append(box);
  if (page.left_out.length > 0) place.append(make('div', {class: 'finding warn'}, make('h3', {}, 'Not in this page'), make('ul', {}, ...page.left_out.map(item => make('li', {}, item)))));
}

function fillStudyOrigins() {
  document.getElementById('thinned').append(
    make('span', {class: 'hint'}, 'Move over a plot for values, drag to zoom, double-click for the whole time, click to hold the cursor (arrow keys move it). '),
    'Quantiles lie between two of the cases’ values (Hyndman and Fan’s type 7). A band at a time is of the cases whose missions then go on.');
  const rows = [['plan', page.plan], ['sampling', study.sampling], ['seed', String(study.seed)], ['cases', String(study.counts.wanted)]];
  document.getElementById('made').append(make('details', {}, make('summary', {}, 'What this study was made of'),
    make('table', {}, make('tbody', {}, ...rows.map(([key, value]) => make('tr', {}, make('td', {}, key), make('td', {}, value)))))));
}

// What can be opened of the chosen case, and how the choice is undone.
const chosenCase = {
  place: make('span', {id: 'chosen-case'}),
  caseChanged() {
    this.place.replaceChildren();
    if (choice.row === null) return;
    const number = caseNumbers[choice.row], file = study.files[choice.row];
    const none = make('button', {type: 'button', title: 'Show no case'}, '×');
    none.addEventListener('click', () => chooseCase());
    this.place.append(make('b', {style: `color:${outcomeInk(caseStatuses[choice.row])}`}, `Case ${number} `), `${outcomeText(caseStatuses[choice.row])} `,
      ...(file ? [make('a', {href: `cases/${caseName(number)}/${file}`, id: 'open-case', target: '_blank', rel: 'noopener'}, file === 'report.html' ? 'open its report' : 'open its plan'), ' '] : []), none);
  },
};

fillStudyHead();
fillOutcomes();
fillStudyOrigins();
for (const id of ['summary', 'notes', 'pictures']) document.getElementById(id).remove();
const sections = ['numbers', 'influence', 'cases'].map(id => make('section', {id}));
document.getElementById('made').before(...sections);
showChips();
document.querySelector('#bar .tools').prepend(chosenCase.place);
if (!study.has_one_start) {
  axisButton.remove();
  clock.utc.remove();
}
viewers.push(chosenCase);
const map = new StudyMap(document.getElementById('map'));
showPlots(studyPlots());
fillNumbers(sections[0]);
fillInfluence(sections[1]);
new CaseTable(sections[2]);
// Where half of the missions have ended, bands and ellipses are still of many cases.
setCursor(Math.min(endS, ...study.arrivals.filter(arrival => arrival.end_s).slice(-1).map(arrival => arrival.end_s[1])));
