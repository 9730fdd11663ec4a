// Convenience only: without it every test is shown, one below the other, tables keep their order, figures stand still.
var texts = document.body.dataset;
// The language of the figures, named once by each of them.
var SVG = (document.querySelector('svg') || {}).namespaceURI;
document.querySelectorAll('.choices').forEach(function (choices) {
  var parts = Array.prototype.slice.call(choices.children);
  if (parts.length < 2) { return; }
  var bar = document.createElement('div');
  bar.className = 'chooser';
  var select = document.createElement('select');
  select.setAttribute('aria-label', texts.shown);
  select.add(new Option(texts.all, ''));
  parts.forEach(function (part) { select.add(new Option(part.querySelector('h3').textContent, part.id)); });
  function show(id) {
    select.value = id;
    parts.forEach(function (part) { part.style.display = !id || part.id === id ? '' : 'none'; });
  }
  function button(text, step) {
    var made = document.createElement('button');
    made.type = 'button';
    made.textContent = text;
    made.addEventListener('click', function () {
      var next = (select.selectedIndex - 1 + step + parts.length) % parts.length;
      show(parts[next].id);
    });
    return made;
  }
  select.addEventListener('change', function () { show(select.value); });
  bar.append(button(texts.previous, -1), ' ', select, ' ', button(texts.next, 1));
  choices.before(bar);
  show(parts[0].id);
});

// Typographic minus and raised powers of ten back to what a number parser reads.
function plain(text) {
  var raised = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
  return text.replace(/\u00a0/g, ' ').replace(/\u2212/g, '-').replace(/\u00b710([\u207b\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+)/, function (_, power) {
    return 'e' + power.replace('\u207b', '-').replace(/[^-]/g, function (c) { return raised.indexOf(c); });
  });
}
// A number with the language's decimal sign as a number parser reads it.
function parsed(text) {
  text = plain(text);
  return texts.decimal === '.' ? text : text.replace(/^(-?\d+),(\d)/, '$1.$2');
}
document.querySelectorAll('table.sortable').forEach(function (table) {
  var heads = table.querySelectorAll('.headings th');
  heads.forEach(function (head, column) {
    head.tabIndex = 0;
    function sort() {
      var up = head.getAttribute('aria-sort') !== 'ascending';
      var body = table.tBodies[0];
      var rows = Array.prototype.slice.call(body.rows);
      rows.sort(function (a, b) {
        var p = parsed(a.cells[column].textContent), q = parsed(b.cells[column].textContent);
        var order = isNaN(p) || isNaN(q) ? p.localeCompare(q, 'en', { numeric: true }) : p - q;
        return up ? order : -order;
      });
      heads.forEach(function (other) { other.removeAttribute('aria-sort'); });
      head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
      rows.forEach(function (row) { body.append(row); });
    }
    head.addEventListener('click', sort);
    head.addEventListener('keydown', function (event) { if (event.key === 'Enter') { sort(); } });
  });
});

// Every table as a file that a spreadsheet opens in columns: where the decimal sign is a comma, a semicolon stands between them.
var between = texts.decimal === ',' ? ';' : ',';
document.querySelectorAll('.table').forEach(function (frame, number) {
  var table = frame.querySelector('table');
  var save = document.createElement('button');
  save.type = 'button';
  save.className = 'save';
  save.textContent = texts.save;
  save.title = texts.about;
  save.addEventListener('click', function () {
    var groups = [];
    table.querySelectorAll('thead tr:not(.headings) th').forEach(function (group) {
      for (var i = 0; i < group.colSpan; i += 1) { groups.push(group.textContent); }
    });
    function cell(text) {
      text = plain(text);
      return /["\n]/.test(text) || text.indexOf(between) >= 0 ? '"' + text.replace(/"/g, '""') + '"' : text;
    }
    var lines = [Array.prototype.map.call(table.querySelectorAll('.headings th'), function (head, i) {
      return cell((groups[i] ? groups[i] + ': ' : '') + head.textContent);
    })];
    Array.prototype.forEach.call(table.tBodies[0].rows, function (row) {
      lines.push(Array.prototype.map.call(row.cells, function (one) { return cell(one.textContent); }));
    });
    // The mark at the front tells spreadsheets that the text is UTF-8.
    var text = '\ufeff' + lines.map(function (line) { return line.join(between); }).join('\r\n') + '\r\n';
    var link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type: 'text/csv' }));
    link.download = (frame.closest('section').id || 'table') + '-' + (number + 1) + '.csv';
    link.click();
    URL.revokeObjectURL(link.href);
  });
  frame.before(save);
});

// How an axis spreads its values, as the figure was drawn.
var scales = {
  linear: [function (v) { return v; }, function (p) { return p; }],
  log: [Math.log, Math.exp],
  root: [function (v) { return Math.sign(v) * Math.sqrt(Math.abs(v)); }, function (p) { return p * Math.abs(p); }]
};
function element(name, attributes) {
  var made = document.createElementNS(SVG, name);
  Object.keys(attributes).forEach(function (key) { made.setAttribute(key, attributes[key]); });
  return made;
}
function label(value, step) {
  var decimals = Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
  return value.toFixed(decimals).replace(/^-(0(\.0*)?)$/, '$1').replace('-', '\u2212').replace('.', texts.decimal);
}
// A figure's place under the cursor, in its own coordinates.
function place(svg, event) {
  return new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
}
// Lets the reader drag a rectangle; `done` gets its corners.
function drag(svg, inside, done) {
  var start = null, mark = null;
  svg.addEventListener('pointerdown', function (event) {
    if (event.button !== 0) { return; }
    start = inside(place(svg, event));
    if (start) { svg.setPointerCapture(event.pointerId); }
  });
  svg.addEventListener('pointermove', function (event) {
    if (!start) { return; }
    var end = place(svg, event);
    mark = mark || svg.appendChild(element('rect', { class: 'marked' }));
    mark.setAttribute('x', Math.min(start.x, end.x));
    mark.setAttribute('y', Math.min(start.y, end.y));
    mark.setAttribute('width', Math.abs(end.x - start.x));
    mark.setAttribute('height', Math.abs(end.y - start.y));
  });
  function finish(event) {
    if (!start) { return; }
    var end = place(svg, event), from = start;
    start = null;
    if (mark) { mark.remove(); mark = null; }
    if (event.type === 'pointerup' && Math.abs(end.x - from.x) > 5 && Math.abs(end.y - from.y) > 5) { done(from, end); }
  }
  svg.addEventListener('pointerup', finish);
  svg.addEventListener('pointercancel', finish);
}
function resetButton(figure, reset) {
  var button = document.createElement('button');
  button.type = 'button';
  button.textContent = texts.reset;
  button.hidden = true;
  button.addEventListener('click', reset);
  figure.append(button);
  return button;
}
document.querySelectorAll('figure > svg').forEach(function (svg) {
  if (svg.dataset.plane) { plane(svg); } else { whole(svg); }
});
// A figure with axes: the area inside them zooms, the axes follow.
function plane(svg) {
  var said = svg.dataset.plane.split(' ');
  var left = +said[0], top = +said[1], right = +said[2], bottom = +said[3];
  function axis(at, text) {
    var scale = scales[said[at + 2]], low = scale[0](+said[at]), high = scale[0](+said[at + 1]);
    var cut = text.lastIndexOf(', ');
    return {
      value: function (p) { return scale[1](low + p * (high - low)); },
      place: function (v) { return (scale[0](v) - low) / (high - low); },
      name: cut < 0 ? text : text.slice(0, cut),
      unit: cut < 0 ? '' : ' ' + text.slice(cut + 2)
    };
  }
  var x = axis(4, svg.dataset.x), y = axis(7, svg.dataset.y);
  var area = svg.querySelector('svg.area'), figure = svg.parentNode;
  var groups = ['grid-x', 'grid-y', 'ticks-x', 'ticks-y'].map(function (name) { return svg.querySelector('.' + name); });
  var drawn = groups.map(function (group) { return group.innerHTML; });
  var styles = ['.ticks-x text', '.ticks-y text', '.grid-x path'].map(function (name) { return svg.querySelector(name); });
  // What is shown, as shares of the whole: left, right, lower, upper.
  var view = [0, 1, 0, 1];
  var button = resetButton(figure, function () { set([0, 1, 0, 1]); });
  var cross = null, out = null;
  function inside(p) { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom ? p : null; }
  function across(p) { return view[0] + (p.x - left) / (right - left) * (view[1] - view[0]); }
  function up(p) { return view[2] + (bottom - p.y) / (bottom - top) * (view[3] - view[2]); }
  function set(to) {
    view = to;
    var wide = right - left, tall = bottom - top, is = to[0] <= 0 && to[1] >= 1 && to[2] <= 0 && to[3] >= 1;
    area.setAttribute('viewBox', [left + to[0] * wide, bottom - to[3] * tall, (to[1] - to[0]) * wide, (to[3] - to[2]) * tall].join(' '));
    groups.forEach(function (group, i) { group.innerHTML = is ? drawn[i] : ''; });
    button.hidden = is;
    if (is) { return; }
    ticks(x, to[0], to[1], function (share, text) {
      var at = left + share * wide;
      groups[0].append(grid('M' + at + ' ' + top + 'V' + bottom));
      groups[2].append(tick(0, at, bottom + 15, text));
    });
    ticks(y, to[2], to[3], function (share, text) {
      var at = bottom - share * tall;
      groups[1].append(grid('M' + left + ' ' + at + 'H' + right));
      groups[3].append(tick(1, left - 6, at + 4, text));
    });
  }
  function grid(data) {
    var line = styles[2] ? styles[2].cloneNode() : element('path', { class: 'l grid' });
    line.setAttribute('d', data);
    return line;
  }
  function tick(which, px, py, text) {
    var made = styles[which] ? styles[which].cloneNode() : element('text', {});
    made.setAttribute('x', px);
    made.setAttribute('y', py);
    made.textContent = text;
    return made;
  }
  function ticks(axis, from, to, draw) {
    var low = axis.value(from), high = axis.value(to), rough = (high - low) / 6;
    var decade = Math.pow(10, Math.floor(Math.log10(rough)));
    var step = decade * [1, 2, 5, 10].find(function (f) { return f * decade >= 0.999 * rough; });
    for (var k = Math.ceil(low / step); k * step <= high; k += 1) {
      draw((axis.place(k * step) - from) / (to - from), label(k * step, step));
    }
  }
  drag(svg, inside, function (a, b) {
    var u = [across(a), across(b)].sort(function (p, q) { return p - q; });
    var w = [up(a), up(b)].sort(function (p, q) { return p - q; });
    var to = [Math.max(u[0], 0), Math.min(u[1], 1), Math.max(w[0], 0), Math.min(w[1], 1)];
    if (to[1] - to[0] > 1e-5 && to[3] - to[2] > 1e-5) { set(to); }
  });
  svg.addEventListener('dblclick', function () { set([0, 1, 0, 1]); });
  svg.addEventListener('pointermove', function (event) {
    var p = inside(place(svg, event));
    if (!cross) {
      cross = svg.appendChild(element('path', { class: 'cross' }));
      out = document.createElement('span');
      out.className = 'readout';
      figure.append(out);
    }
    out.hidden = !p;
    cross.setAttribute('d', p ? 'M' + p.x + ' ' + top + 'V' + bottom + 'M' + left + ' ' + p.y + 'H' + right : '');
    if (!p) { return; }
    // As many digits as a pixel is worth.
    function read(axis, share, pixel) {
      var value = axis.value(share), near = Math.abs(axis.value(share + pixel) - value);
      return axis.name + ' ' + label(value, Math.pow(10, Math.floor(Math.log10(near || 1)))) + axis.unit;
    }
    out.textContent = read(x, across(p), (view[1] - view[0]) / (right - left)) + ' · ' + read(y, up(p), (view[3] - view[2]) / (bottom - top));
  });
  svg.addEventListener('pointerleave', function () {
    if (cross) { cross.setAttribute('d', ''); out.hidden = true; }
  });
}
// A figure without axes: it zooms as a picture; its marks tell their values by themselves.
function whole(svg) {
  var box = svg.getAttribute('viewBox');
  var button = resetButton(svg.parentNode, reset);
  function reset() { svg.setAttribute('viewBox', box); button.hidden = true; }
  drag(svg, function (p) { return p; }, function (a, b) {
    svg.setAttribute('viewBox', [Math.min(a.x, b.x), Math.min(a.y, b.y), Math.abs(a.x - b.x), Math.abs(a.y - b.y)].join(' '));
    button.hidden = false;
  });
  svg.addEventListener('dblclick', reset);
}

// A whole print shows what is folded on the screen.
addEventListener("beforeprint", () => {
  if (document.body.classList.contains("whole")) document.querySelectorAll("details").forEach((one) => { one.open = true; });
});
