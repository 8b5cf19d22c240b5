"""What a browser adds to a report's page: tables sort and filter, figures show values and zoom. The page is whole without it.

Zooming is D3's (d3js.org, Debian's node-d3-zoom), written into the page so that nothing is loaded; where it is not installed the
page has no script."""

import glob

FOLDERS = ["/usr/share/nodejs", "/usr/local/share/nodejs"]
MODULES = ["dispatch", "selection", "drag", "color", "interpolate", "ease", "timer", "transition", "zoom"]  # each needs those before it


def library():
    """The modules in one text; None where one is missing."""
    texts = []
    for module in MODULES:
        found = [path for folder in FOLDERS for path in glob.glob(f"{folder}/d3-{module}/dist/d3-{module}.min.js")]
        if not found:
            return None
        with open(found[0], encoding="utf-8") as file:
            texts.append(file.read().replace("</script", "<\\/script"))
    return "\n".join(texts)


def script():
    """The element for the end of the page; empty without the library."""
    needed = library()
    return "" if needed is None else f"<script>{needed}\n{SCRIPT}</script>\n"


SCRIPT = r"""
(() => {
  'use strict';
  const NEAR = 14;       // of the pointer [px]
  const MOST_ZOOM = 40;
  const FEW_ROWS = 8;    // are not filtered

  // Boxes that do not scroll are no stop of the keyboard.
  const stops = () => d3.selectAll('.scroll, .fold').each(function () {
    if (this.scrollWidth > this.clientWidth + 1 || this.scrollHeight > this.clientHeight + 1) this.tabIndex = 0;
    else this.removeAttribute('tabindex');
  });
  stops();
  addEventListener('resize', stops);

  // The number that a cell begins with; a dash is below all of them.
  const value = text => {
    const found = /[-+\u2212]?\d+(?:\.\d+)?(?:e[-+]?\d+)?/i.exec(text);
    return found && found.index < 12 ? Number(found[0].replace('\u2212', '-')) : null;
  };
  const compare = (a, b) => {
    const x = value(a), y = value(b);
    return x !== null && y !== null ? x - y : x !== null ? 1 : y !== null ? -1 : a.localeCompare(b);
  };

  const sortable = table => {
    const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
    heads.forEach((head, column) => {
      const button = d3.select(head).text('').append('button').attr('type', 'button').text(head.dataset.title);
      button.on('click', () => {
        const up = head.getAttribute('aria-sort') !== 'ascending';
        heads.forEach(other => other.removeAttribute('aria-sort'));
        head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
        const words = column === 0;
        const key = row => row.cells[column].textContent;
        [...body.rows].sort((a, b) => (up ? 1 : -1) * (words ? key(a).localeCompare(key(b), undefined, {numeric: true})
                                                             : compare(key(a), key(b))))
          .forEach(row => body.append(row));
      });
    });
    if (body.rows.length <= FEW_ROWS) return;
    const name = table.caption.textContent;
    d3.select(table.closest('.fold') || table.parentElement).node().insertAdjacentHTML('beforebegin',
      '<p class=filter><label>filter rows <input type=search></label> <span role=status></span></p>');
    const line = (table.closest('.fold') || table.parentElement).previousElementSibling;
    const input = line.querySelector('input');
    input.setAttribute('aria-label', 'filter rows: ' + name);
    input.addEventListener('input', () => {
      const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const row of body.rows) {
        const text = row.textContent.toLowerCase();
        row.hidden = !words.every(word => text.includes(word));
        shown += !row.hidden;
      }
      line.querySelector('span').textContent = words.length ? shown + ' of ' + body.rows.length : '';
    });
  };
  document.querySelectorAll('table.sortable').forEach(table => {
    [...table.tHead.rows[0].cells].forEach(head => { head.dataset.title = head.textContent; });
    sortable(table);
  });

  // Vertices of the drawn lines and markers of an axes, in the figure's own units.
  const vertices = (svg, place) => {
    const group = svg.querySelectorAll('g[id^="axes_"]')[place], found = [];
    if (!group) return found;
    for (const drawn of group.querySelectorAll(':scope > g[id^="line2d_"] > path, :scope > g[id^="line2d_"] use')) {
      if (drawn.tagName === 'use') found.push([+drawn.getAttribute('x'), +drawn.getAttribute('y')]);
      else for (const at of (drawn.getAttribute('d') || '').matchAll(/[ML] (-?[\d.]+) (-?[\d.]+)/g)) found.push([+at[1], +at[2]]);
    }
    return found;
  };
  const invert = (share, [low, high], log) => log ? low * (high / low) ** share : low + share * (high - low);
  const shown = number => {
    const size = Math.abs(number);
    return number === 0 ? '0' : size >= 1e5 || size < 1e-3 ? number.toExponential(2) : String(+number.toPrecision(4));
  };

  const tip = d3.select('body').append('div').attr('class', 'tip').attr('aria-hidden', 'true');

  document.querySelectorAll('figure svg[data-axes]').forEach(node => {
    const svg = d3.select(node), all = JSON.parse(node.dataset.axes), inner = svg.select('g'), points = new Map();
    let transform = d3.zoomIdentity;
    const zoom = d3.zoom().scaleExtent([1, MOST_ZOOM])
      .extent([[0, 0], [node.viewBox.baseVal.width, node.viewBox.baseVal.height]])
      .translateExtent([[0, 0], [node.viewBox.baseVal.width, node.viewBox.baseVal.height]])
      .filter(() => d3.event.type === 'wheel' ? d3.event.ctrlKey || d3.event.metaKey
                  : d3.event.type.startsWith('touch') ? d3.event.touches.length > 1 || transform.k > 1 : true)
      .on('zoom', () => { transform = d3.event.transform; inner.attr('transform', transform); });
    svg.call(zoom);
    const buttons = d3.select(node.closest('figure')).append('p').attr('class', 'zoom');
    const add = (text, label, act) => buttons.append('button').attr('type', 'button').attr('aria-label', label).text(text).on('click', act);
    add('+', 'zoom in', () => zoom.scaleBy(svg, 1.5));
    add('\u2212', 'zoom out', () => zoom.scaleBy(svg, 1 / 1.5));
    add('\u21ba', 'reset zoom', () => zoom.transform(svg, d3.zoomIdentity));
    node.addEventListener('pointermove', event => {
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(inner.node().getScreenCTM().inverse());
      const place = all.findIndex(a => at.x >= a.box[0] && at.x <= a.box[2] && at.y >= a.box[1] && at.y <= a.box[3]);
      if (place < 0) { tip.style('display', 'none'); return; }
      if (!points.has(place)) points.set(place, vertices(node, place));
      const axes = all[place], scale = inner.node().getScreenCTM().a;
      let best = null, least = NEAR / scale;
      for (const point of points.get(place)) {
        const far = Math.hypot(point[0] - at.x, point[1] - at.y);
        if (far < least) { least = far; best = point; }
      }
      const [x, y] = best || [at.x, at.y], [x0, y0, x1, y1] = axes.box;
      const values = [invert((x - x0) / (x1 - x0), axes.x, axes.xlog), invert((y1 - y) / (y1 - y0), axes.y, axes.ylog)];
      tip.text((axes.names[0] || 'x') + ': ' + shown(values[0]) + '\n' + (axes.names[1] || 'y') + ': ' + shown(values[1]))
        .style('display', 'block').style('left', Math.min(event.pageX + 12, scrollX + innerWidth - 200) + 'px')
        .style('top', event.pageY + 12 + 'px').classed('on', best !== null);
    });
    node.addEventListener('pointerleave', () => tip.style('display', 'none'));
  });
})();
"""
