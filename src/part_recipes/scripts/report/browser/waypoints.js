// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The table of waypoints: sorted by any column, filtered, and gone through by keys.
'use strict';

(() => {
  const table = document.getElementById('waypoints');
  if (!table) return;
  const NUMBER = 0, SEGMENT = 1, STATE = 2, NAMED = 3, FIRST_VALUE = 4, SHIFT = 4;
  // Of each value [m, rad]: factor to mm or degrees, and decimals (waypoints.py writes the same on paper).
  const WRITTEN = [[1e3, 3], [1e3, 3], [1e3, 3], [1e3, 3], [180 / Math.PI, 2], [180 / Math.PI, 2], [1e3, 3]];
  const form = document.getElementById('filters'), body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  let column = NUMBER, falling = false;

  function written(value, i) {
    return value === null ? '–' : (value * WRITTEN[i][0]).toFixed(WRITTEN[i][1]);
  }

  // What is not known stands last, whichever way.
  function compare(one, other) {
    const a = one[column], b = other[column];
    if (a === null || b === null) return (a === null) - (b === null) || one[NUMBER] - other[NUMBER];
    const order = typeof a === 'string' ? a.localeCompare(b, 'en', {numeric: true}) : a - b;
    return (falling ? -order : order) || one[NUMBER] - other[NUMBER];
  }

  function wanted() {
    const state = document.getElementById('filter-state').value;
    const segment = document.getElementById('filter-segment').value.toLowerCase();
    const shift = parseFloat(document.getElementById('filter-shift').value);
    return (row) => (state === '' || (state === 'named' ? row[NAMED] : row[STATE] === state)) &&
        row[SEGMENT].toLowerCase().includes(segment) &&
        (Number.isNaN(shift) || (row[SHIFT] !== null && row[SHIFT] * 1e3 >= shift));
  }

  function rowOf(values) {
    const row = document.createElement('tr');
    row.tabIndex = -1;
    row.dataset.number = values[NUMBER];
    if (values[NAMED]) row.className = 'named';
    const texts = [values[NUMBER], values[SEGMENT], values[STATE], values[NAMED] ? '✖ named' : ''];
    values.slice(FIRST_VALUE).forEach((value, i) => texts.push(typeof value === 'string' ? value : written(value, i)));
    texts.forEach((text, i) => {
      const cell = row.insertCell();
      cell.textContent = text;
      if (i === NUMBER || (i >= FIRST_VALUE && i < FIRST_VALUE + WRITTEN.length)) cell.className = 'number';
    });
    return row;
  }

  function fill() {
    const rows = pageData.waypoints.filter(wanted()).sort(compare);
    body.replaceChildren(...rows.map(rowOf));
    if (body.rows.length) body.rows[0].tabIndex = 0;
    heads.forEach((head, i) => head.setAttribute('aria-sort', i !== column ? 'none' : falling ? 'descending' : 'ascending'));
    document.getElementById('row-count').textContent = `${rows.length} of ${pageData.waypoints.length} waypoints`;
  }

  function choose(row) {
    for (const other of body.querySelectorAll('[aria-selected]')) other.removeAttribute('aria-selected');
    row.setAttribute('aria-selected', 'true');
    reportView.show(Number(row.dataset.number));
  }

  function go(from, to) {
    if (!to) return;
    from.tabIndex = -1;
    to.tabIndex = 0;
    to.focus();
  }

  table.tHead.addEventListener('click', (event) => {
    const button = event.target.closest('button');
    if (!button) return;
    const clicked = Number(button.dataset.column);
    // Numbers of a finding: the largest first
    falling = clicked === column ? !falling : clicked >= NAMED;
    column = clicked;
    fill();
  });
  body.addEventListener('keydown', (event) => {
    const row = event.target.closest('tr');
    const to = {ArrowDown: row.nextElementSibling, ArrowUp: row.previousElementSibling,
                Home: body.firstElementChild, End: body.lastElementChild}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    go(row, to);
  });
  body.addEventListener('focusin', (event) => choose(event.target.closest('tr')));
  body.addEventListener('click', (event) => event.target.closest('tr').focus());
  form.addEventListener('input', fill);
  form.addEventListener('submit', (event) => event.preventDefault());
  form.addEventListener('reset', () => setTimeout(fill));
  fill();
})();
