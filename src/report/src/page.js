// Convenience only: without it every test is shown, one below the other, and tables keep their order.
document.querySelectorAll('.choices').forEach(function (choices) {
  var parts = Array.prototype.slice.call(choices.children);
  if (parts.length < 2) { return; }
  var bar = document.createElement('div');
  bar.className = 'chooser';
  var select = document.createElement('select');
  select.setAttribute('aria-label', 'Test shown');
  select.add(new Option('all tests', ''));
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
  bar.append(button('previous', -1), ' ', select, ' ', button('next', 1));
  choices.before(bar);
  show(parts[0].id);
});
document.querySelectorAll('table.sortable').forEach(function (table) {
  var heads = table.querySelectorAll('.headings th');
  heads.forEach(function (head, column) {
    head.addEventListener('click', function () {
      var up = head.getAttribute('aria-sort') !== 'ascending';
      var body = table.tBodies[0];
      var rows = Array.prototype.slice.call(body.rows);
      // Typographic minus and raised powers of ten back to what a number parser reads.
      var raised = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
      function value(row) {
        return row.cells[column].textContent.replace(/\u2212/g, '-').replace(/\u00b710(\S+)/, function (_, power) {
          return 'e' + power.replace('\u207b', '-').replace(/[^-]/g, function (c) { return raised.indexOf(c); });
        });
      }
      rows.sort(function (a, b) {
        var p = value(a), q = value(b);
        var order = isNaN(p) || isNaN(q) ? p.localeCompare(q, 'en', { numeric: true }) : p - q;
        return up ? order : -order;
      });
      heads.forEach(function (other) { other.removeAttribute('aria-sort'); });
      head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
      rows.forEach(function (row) { body.append(row); });
    });
  });
});
