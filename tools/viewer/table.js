// The table of loops: sorted by a click on a column's head, walked by the arrow keys.

const rowsAtOnce = 250;

const columns = [
  { name: 'loop', value: (l) => [l.kind, l.id], text: null },
  { name: 'size', isLength: true, value: (l) => l.size, text: (l, d) => number(l.size, d.decimals) },
  { name: 'length', isLength: true, value: (l) => l.length, text: (l, d) => number(l.length, d.decimals) },
  { name: 'centre (world)', value: (l) => l.world, text: (l, d) => point(l.world, d.decimals) },
  { name: 'voxel', value: (l) => l.index, text: (l) => point(l.index, 0) },
];

export function number(x, decimals) {
  return Number.isFinite(x) ? x.toFixed(decimals) : '\u221e';
}

/// The same with the unit that the file states.
export function length(x, data, power = '') {
  return Number.isFinite(x) ? `${number(x, data.decimals)} ${data.unit ? data.unit + power : ''}`.trim()
                            : '\u221e';
}

export function point(p, decimals) {
  return p.map((x) => x.toFixed(decimals)).join(', ');
}

function compare(a, b) {
  if (!Array.isArray(a)) return a < b ? -1 : a > b ? 1 : 0;
  for (let i = 0; i < a.length; ++i) if (compare(a[i], b[i]) !== 0) return compare(a[i], b[i]);
  return 0;
}

export class LoopTable {
  constructor(data, choose) {
    this.data = data;
    this.choose = choose;
    this.visible = data.loops;
    this.sort = { column: 0, down: false };
    this.shown = 0;
    this.rows = new Map(); // by the loop's number
    this.body = document.getElementById('rows');
    this.moreButton = document.getElementById('more');
    this.moreButton.addEventListener('click', () => this.addRows());
    this.makeHead();
    this.body.addEventListener('click', (event) => {
      const row = event.target.closest('tr');
      if (row) this.choose(Number(row.dataset.loop));
    });
    this.body.addEventListener('keydown', (event) => this.walk(event));
  }

  makeHead() {
    const head = document.getElementById('head');
    columns.forEach((column, i) => {
      const cell = document.createElement('th');
      cell.scope = 'col';
      const button = document.createElement('button');
      button.type = 'button';
      const unit = column.isLength && this.data.unit;
      button.textContent = unit ? `${column.name} (${unit})` : column.name;
      button.addEventListener('click', () => {
        this.sort = { column: i, down: this.sort.column === i && !this.sort.down };
        this.update();
      });
      cell.append(button);
      head.append(cell);
    });
  }

  /// Shows these loops.
  filter(loops) {
    this.visible = loops;
    this.update();
  }

  update() {
    const { column, down } = this.sort;
    const value = columns[column].value;
    const sign = down ? -1 : 1;
    this.order = [...this.visible].sort(
      (a, b) => sign * compare(value(a), value(b)) || a.number - b.number,
    );
    [...document.getElementById('head').children].forEach((cell, i) => {
      if (i === column) cell.setAttribute('aria-sort', down ? 'descending' : 'ascending');
      else cell.removeAttribute('aria-sort');
    });
    this.body.replaceChildren();
    this.rows.clear();
    this.shown = 0;
    this.addRows();
    this.mark(this.chosen);
  }

  addRows() {
    const end = Math.min(this.shown + rowsAtOnce, this.order.length);
    const rows = document.createDocumentFragment();
    for (; this.shown < end; ++this.shown) rows.append(this.rowOf(this.order[this.shown]));
    this.body.append(rows);
    const left = this.order.length - this.shown;
    this.moreButton.hidden = left === 0;
    this.moreButton.textContent = `Show ${Math.min(left, rowsAtOnce)} more of ${left}`;
  }

  rowOf(loop) {
    const row = document.createElement('tr');
    row.dataset.loop = loop.number;
    row.setAttribute('aria-selected', loop.number === this.chosen);
    columns.forEach((column, i) => {
      const cell = row.insertCell();
      if (i > 0) {
        cell.textContent = column.text(loop, this.data);
        return;
      }
      const button = document.createElement('button');
      button.type = 'button';
      button.className = loop.kind;
      button.textContent = `${loop.kind} ${loop.id}`;
      cell.append(button);
    });
    this.rows.set(loop.number, row);
    return row;
  }

  /// Marks the row of the chosen loop, if any, and brings it into sight.
  mark(number) {
    this.rows.get(this.chosen)?.setAttribute('aria-selected', 'false');
    this.chosen = number;
    if (number === undefined || !this.order.some((loop) => loop.number === number)) return;
    while (!this.rows.has(number)) this.addRows();
    const row = this.rows.get(number);
    row.setAttribute('aria-selected', 'true');
    const list = document.getElementById('list');
    const head = list.querySelector('thead').offsetHeight;
    if (row.offsetTop < list.scrollTop + head) list.scrollTop = row.offsetTop - head;
    const bottom = row.offsetTop + row.offsetHeight - list.clientHeight;
    if (bottom > list.scrollTop) list.scrollTop = bottom;
  }

  walk(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    const row = event.target.closest('tr');
    if (!step || !row) return;
    event.preventDefault();
    const at = this.order.findIndex((loop) => loop.number === Number(row.dataset.loop));
    const next = this.order[at + step];
    if (!next) return;
    this.choose(next.number);
    this.rows.get(next.number).querySelector('button').focus();
  }
}
