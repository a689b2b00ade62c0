'use strict';
// Draws the page from the data in it: a section a study, a plot, a table and pictures a case.

const data = JSON.parse(document.getElementById('data').textContent);

function make(name, attributes = {}, ...children) {
  const isSvg = ['svg', 'g', 'line', 'circle', 'path', 'text', 'title'].includes(name);
  const node = isSvg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children.filter(child => child !== null));
  return node;
}

const shown = value => {
  if (value === 0) return '0';
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(3))) : value.toExponential(2);
};
const tickText = value => {
  const decade = Math.round(Math.log10(value));
  const isDecade = Math.abs(value / 10 ** decade - 1) < 1e-9;
  return isDecade && Math.abs(decade) > 3 ? '1e' + decade : shown(value);
};
const titled = metric => metric.title + (metric.unit && metric.unit !== '1' ? ', ' + metric.unit : '');
// An error, or the bound of one that the reference does not resolve.
const errorText = (point, metric) =>
    point.bounds[metric] === null ? shown(point.errors[metric]) : '\u2264 ' + shown(point.bounds[metric]);
const isMeasured = point => point.errors.length > 0 && point.ms.repeats.length > 0;

// A logarithmic axis over positive values, whole decades wide.
function logScale(values, from, to) {
  const positive = values.filter(value => value > 0);
  let low = Math.floor(Math.log10(Math.min(...positive)));
  let high = Math.ceil(Math.log10(Math.max(...positive)));
  if (!positive.length) [low, high] = [0, 1];
  if (high === low) high += 1;
  const at = value => from + (Math.log10(value) - low) / (high - low) * (to - from);
  const ticks = [];
  const every = Math.ceil((high - low) / 8);
  for (let decade = low; decade <= high; decade += every) ticks.push(10 ** decade);
  if (high - low <= 1) for (const step of [2, 5]) ticks.push(step * 10 ** low);
  return {at, ticks, floor: 10 ** low};
}

// Labels of shipped points move down until they are clear of those drawn before.
function clearOf(placed, x, y) {
  while (placed.some(other => Math.abs(other.y - y) < 13 && Math.abs(other.x - x) < 90)) y += 13;
  placed.push({x, y});
  return y;
}

function plot(of, metric, choose) {
  const width = 620, height = 380, left = 66, right = 604, top = 14, bottom = 330;
  const svg = make('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img'});
  svg.append(make('title', {}, `${of.title}: ${of.case}, ${of.metrics[metric].title} against time`));
  const points = of.points.map((point, index) => ({point, index})).filter(({point}) => isMeasured(point));
  if (!points.length) return svg;
  const error = ({point}) => point.bounds[metric] ?? Math.abs(point.errors[metric]);
  const x = logScale(points.flatMap(({point}) => [point.ms.least, point.ms.most]), left, right);
  const y = logScale(points.map(error), bottom, top);
  // An error of 0 has no place on a logarithmic axis: it lies on its lower end.
  const placed = entry => [x.at(entry.point.ms.median), y.at(Math.max(error(entry), y.floor))];
  for (const tick of x.ticks) {
    const at = x.at(tick);
    svg.append(make('line', {x1: at, x2: at, y1: top, y2: bottom, class: 'grid'}),
               make('text', {x: at, y: bottom + 17, 'text-anchor': 'middle', class: 'tick'}, tickText(tick)));
  }
  for (const tick of y.ticks) {
    const at = y.at(tick);
    svg.append(make('line', {x1: left, x2: right, y1: at, y2: at, class: 'grid'}),
               make('text', {x: left - 7, y: at + 4, 'text-anchor': 'end', class: 'tick'}, tickText(tick)));
  }
  svg.append(make('line', {x1: left, x2: right, y1: bottom, y2: bottom, class: 'axis'}),
             make('line', {x1: left, x2: left, y1: top, y2: bottom, class: 'axis'}),
             make('text', {x: (left + right) / 2, y: height - 8, 'text-anchor': 'middle'}, of.timeUnit),
             make('text', {x: 14, y: (top + bottom) / 2, 'text-anchor': 'middle',
                           transform: `rotate(-90 14 ${(top + bottom) / 2})`}, titled(of.metrics[metric])));
  const front = points.filter(({point}) => point.onFront[metric])
                    .sort((a, b) => a.point.ms.median - b.point.ms.median);
  if (front.length > 1)
    svg.append(make('path', {class: 'front', d: 'M' + front.map(entry => placed(entry).join(' ')).join('L')}));
  const labels = [];
  for (const entry of points) {
    const {point, index} = entry;
    const [px, py] = placed(entry);
    svg.append(make('line', {x1: x.at(point.ms.least), x2: x.at(point.ms.most), y1: py, y2: py, class: 'spread'}));
    const circle = make('circle', {cx: px, cy: py, r: 5, class: 'point' + (point.onFront[metric] ? ' on-front' : '') +
                                              (point.bounds[metric] === null ? '' : ' bound'),
                                   'data-index': index},
                        make('title', {}, `${point.label}: ${errorText(point, metric)}, ${shown(point.ms.median)} ms`));
    circle.addEventListener('click', () => choose(index));
    svg.append(circle);
    if (point.shipped.length) {
      const atEnd = px > right - 110;
      const ly = clearOf(labels, px, py + 4);
      svg.append(make('circle', {cx: px, cy: py, r: 9, class: 'ring'}),
                 make('text', {x: atEnd ? px - 13 : px + 13, y: ly, 'text-anchor': atEnd ? 'end' : 'start',
                               class: 'shipped'}, point.shipped.join(', ')));
    }
  }
  return svg;
}

function table(of, choose) {
  const columns = [
    {title: 'setting', key: point => point.label, words: true},
    {title: of.timeUnit, key: point => point.ms.median, time: true},
    ...of.metrics.map((metric, m) => ({title: titled(metric), key: point => point.errors[m], error: true, metric: m})),
    {title: 'front', key: point => point.onFront[0] ? 0 : 1},
    {title: 'shipped', key: point => point.shipped.join(', '), words: true},
  ];
  const body = make('tbody');
  const rows = of.points.map((point, index) => {
    const cells = columns.map(column => {
      if (column.title === 'front')
        return make('td', {}, point.onFront[0] ? make('span', {class: 'front-mark'}, '\u25CF') : '');
      if (column.title === 'shipped')
        return make('td', {class: 'words'}, make('span', {class: 'shipped-mark'}, column.key(point)));
      const value = column.key(point);
      if (column.words) return make('td', {}, value);
      if (!isMeasured(point)) return make('td', {}, '');
      const text = column.error ? errorText(point, column.metric) : shown(value);
      return make('td', column.time ? {title: `${shown(point.ms.least)} to ${shown(point.ms.most)}`} : {}, text);
    });
    const row = make('tr', {'data-index': index}, ...cells);
    row.addEventListener('click', () => choose(index));
    body.append(row);
    return {row, point};
  });
  const heads = columns.map(column => {
    const button = make('button', {type: 'button'}, column.title);
    const head = make('th', {scope: 'col'}, button);
    button.addEventListener('click', () => {
      const ascending = head.getAttribute('aria-sort') !== 'ascending';
      heads.forEach(other => other.removeAttribute('aria-sort'));
      head.setAttribute('aria-sort', ascending ? 'ascending' : 'descending');
      const value = ({point}) => column.error ? Math.abs(column.key(point)) : column.key(point);
      const compare = (a, b) => value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0;
      rows.sort((a, b) => ascending ? compare(a, b) : compare(b, a));
      body.append(...rows.map(entry => entry.row));
    });
    return head;
  });
  return make('table', {}, make('thead', {}, make('tr', {}, ...heads)), body);
}

// Frame over reference with a slider between them; the error map beside.
function pictures(of, point) {
  const reference = of.references[point.reference].picture;
  if (!point.picture || !reference) return make('div');
  const over = make('img', {src: point.picture, class: 'over', alt: `frame with ${point.label}`});
  const divider = make('div', {class: 'divider'});
  const slider = make('input', {type: 'range', min: 0, max: 100, value: 50, 'aria-label': 'frame against reference'});
  const move = () => {
    over.style.clipPath = `inset(0 ${100 - slider.value}% 0 0)`;
    divider.style.left = slider.value + '%';
  };
  slider.addEventListener('input', move);
  move();
  return make('div', {class: 'pictures'},
              make('figure', {},
                   make('div', {class: 'compare'}, make('img', {src: reference, alt: 'reference'}), over, divider),
                   slider, make('figcaption', {}, `Left of the line ${point.label}, right of it the reference.`)),
              make('figure', {},
                   make('div', {class: 'compare'}, make('img', {src: point.heat, alt: 'FLIP error map'})),
                   make('figcaption', {}, 'FLIP error map: black 0, pale yellow 1.')));
}

function caseView(of) {
  const holder = make('div', {class: 'plot'}), viewer = make('div');
  const view = make('div', {class: 'case', 'data-case': of.case}, make('h3', {}, of.case));
  let metric = 0;
  let chosen = -1;
  const mark = () => {
    for (const node of view.querySelectorAll('[data-index]')) {
      const isChosen = Number(node.dataset.index) === chosen;
      node.classList.toggle(node.tagName === 'tr' || node.tagName === 'TR' ? 'chosen' : 'selected', isChosen);
    }
  };
  const choose = index => {
    chosen = index;
    viewer.replaceChildren(pictures(of, of.points[index]));
    mark();
  };
  const select = make('select', {'aria-label': 'error on the plot'});
  of.metrics.forEach((column, index) => select.append(make('option', {value: index}, titled(column))));
  const draw = () => {
    holder.replaceChildren(make('label', {class: 'faint'}, 'Error: ', select), plot(of, metric, choose));
    mark();
  };
  select.addEventListener('change', () => {
    metric = Number(select.value);
    draw();
  });
  if (of.failure) view.append(make('p', {class: 'doubt'}, 'Failed: ' + of.failure));
  for (const doubt of of.doubts) view.append(make('p', {class: 'doubt'}, 'Not justified: ' + doubt + '.'));
  for (const order of of.orders) {
    const series = order.series ? ` of ${order.series}` : '';
    view.append(make('p', {class: 'faint'}, `Observed order${series} in steps of ${order.path}: ${shown(order.order)}`));
  }
  const changes = of.references.flatMap(reference => reference.changes.length ? [reference.changes[0]] : []);
  if (changes.length)
    view.append(make('p', {class: 'faint'},
                     `Doubling the reference changes ${of.metrics[0].title} by ${shown(Math.max(...changes))} at most.`));
  view.append(make('div', {class: 'pair'}, holder, make('div', {class: 'scroll'}, table(of, choose))), viewer);
  draw();
  const first = of.points.findIndex(point => point.picture && point.onFront[0]);
  if (first >= 0) choose(first);
  return view;
}

function build() {
  const quick = data.quick ? ', a quick run: small pictures, three repeats' : '';
  document.getElementById('run').textContent = `${data.program}${quick}. ${data.studies.length} of ${data.cases} cases.`;
  document.getElementById('run').className = 'faint';
  const contents = document.getElementById('contents'), main = document.getElementById('studies');
  let section = null;
  for (const of of data.studies) {
    if (!section || section.id !== of.study) {
      section = make('section', {id: of.study}, make('h2', {}, of.title), make('p', {}, of.method),
                     make('p', {class: 'faint'}, `Study ${of.study}, timed by ${of.clock || 'nothing yet'} on ${of.machine}.`));
      main.append(section);
      contents.append(make('a', {href: '#' + of.study}, of.title));
    }
    section.append(caseView(of));
  }
  document.body.dataset.ready = 'true';
}

build();
