'use strict';
// A comparison's pictures: linear pixels exposed in the browser, and one view that all of them share.
const comparison = (() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const {width, height} = data;
  const element = id => document.getElementById(id);

  // Base64 of 16-bit floating point numbers, low byte first.
  const half_values = new Float32Array(65536);
  for (let i = 0; i < 65536; ++i) {
    const exponent = i >> 10 & 31, fraction = i & 1023;
    const size = exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15);
    half_values[i] = i & 32768 ? -size : size;
  }
  function decoded(text) {
    const bytes = atob(text), values = new Float32Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i)
      values[i] = half_values[bytes.charCodeAt(2 * i) | bytes.charCodeAt(2 * i + 1) << 8];
    return values;
  }
  const a = data.a.map(decoded), b = data.b.map(decoded);
  const z = data.z && decoded(data.z), flip = decoded(data.flip);
  const luminance = (planes, i) => 0.2126 * planes[0][i] + 0.7152 * planes[1][i] + 0.0722 * planes[2][i];

  // sRGB codes of linear values in steps of 1/4095.
  const codes = new Uint8ClampedArray(4096);
  for (let i = 0; i < 4096; ++i) {
    const x = i / 4095;
    codes[i] = 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055) + 0.5;
  }

  // A canvas of the image's own size for each picture.
  function picture() {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    return canvas;
  }
  function painted(canvas, colour) {
    const context = canvas.getContext('2d'), image = context.createImageData(width, height);
    for (let i = 0; i < width * height; ++i) {
      colour(i, image.data, 4 * i);
      image.data[4 * i + 3] = 255;
    }
    context.putImageData(image, 0, 0);
  }
  // As PNGs of the program: a colour above 1 is divided by its largest channel.
  const exposed = (planes, gain) => (i, out, at) => {
    const r = planes[0][i] * gain, g = planes[1][i] * gain, blue = planes[2][i] * gain;
    const scale = 4095 / Math.max(1, r, g, blue);
    out[at] = codes[Math.max(0, r * scale + 0.5) | 0];
    out[at + 1] = codes[Math.max(0, g * scale + 0.5) | 0];
    out[at + 2] = codes[Math.max(0, blue * scale + 0.5) | 0];
  };
  // White at 0, red towards 1, blue towards −1.
  function signed(x, out, at) {
    const t = Math.min(1, Math.abs(x)), fade = 1 - t;
    out[at] = x >= 0 ? 255 - 77 * t * t : 255 * fade + 33 * t;
    out[at + 1] = 255 * fade + (x >= 0 ? 24 : 102) * t;
    out[at + 2] = x >= 0 ? 255 * fade + 43 * t : 255 - 83 * t * t;
  }

  const pictures = {a: picture(), b: picture(), difference: picture(), flip: picture()};
  painted(pictures.flip, (i, out, at) => { out[at] = out[at + 1] = out[at + 2] = codes[flip[i] * 4095 | 0]; });
  if (z) {
    pictures.z = picture();
    painted(pictures.z, (i, out, at) => signed(z[i] / 5, out, at));
  }
  let mean = 0;
  for (let i = 0; i < width * height; ++i) mean += luminance(a, i) / (width * height);

  function expose() {
    const stops = Number(element('exposure').value), gain = 2 ** stops;
    painted(pictures.a, exposed(a, gain));
    painted(pictures.b, exposed(b, gain));
    const range = (mean > 0 ? mean : 1) / gain;
    painted(pictures.difference, (i, out, at) => signed((luminance(b, i) - luminance(a, i)) / range, out, at));
    element('exposure-value').textContent = `${stops >= 0 ? '+' : ''}${stops.toFixed(1)} EV`;
    element('difference-range').textContent =
        `red where B is brighter, blue where darker; full colour at ±${range.toPrecision(3)}`;
    draw();
  }

  // What every canvas shows: image pixels (x, y) at its centre, and canvas widths an image width. 1 is the whole image.
  const view = {x: width / 2, y: height / 2, zoom: 1};
  const panels = ['split', 'a', 'b', 'difference', 'z', 'flip'].filter(id => element(id));
  const scale_of = canvas => view.zoom * Math.min(canvas.width / width, canvas.height / height);

  function place(canvas, id, context) {
    const scale = scale_of(canvas);
    context.imageSmoothingEnabled = scale < 1;
    context.setTransform(scale, 0, 0, scale, canvas.width / 2 - view.x * scale, canvas.height / 2 - view.y * scale);
    context.drawImage(pictures[id], 0, 0);
  }
  function draw_split(canvas, context) {
    const edge = Number(element('divider').value) * canvas.width;
    const halves = [['a', 0, edge], ['b', edge, canvas.width]];
    for (const [id, from, to] of halves) {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, canvas.height);
      context.clip();
      place(canvas, id, context);
      context.restore();
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = '#ffffff';
    context.fillRect(edge - 1, 0, 2, canvas.height);
  }
  function draw_labels(canvas, context) {
    const scale = scale_of(canvas), pixels = devicePixelRatio || 1;
    context.setTransform(1, 0, 0, 1, canvas.width / 2 - view.x * scale, canvas.height / 2 - view.y * scale);
    context.font = `${12 * pixels}px system-ui, sans-serif`;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    for (const {name, text, box} of data.labels) {
      const [x0, y0, x1, y1] = box.map(v => v * scale);
      context.lineWidth = pixels;
      context.strokeStyle = 'rgba(255, 255, 255, 0.6)';
      context.strokeRect(x0, y0, x1 - x0, y1 - y0);
      context.lineWidth = 3 * pixels;
      context.strokeStyle = 'rgba(0, 0, 0, 0.75)';
      context.fillStyle = '#ffffff';
      const fits = context.measureText(text).width < x1 - x0;
      for (const [line, offset] of [[name, -8], [fits ? text : text.split(' ±')[0], 8]]) {
        context.strokeText(line, (x0 + x1) / 2, (y0 + y1) / 2 + offset * pixels);
        context.fillText(line, (x0 + x1) / 2, (y0 + y1) / 2 + offset * pixels);
      }
    }
  }
  function draw() {
    for (const id of panels) {
      const canvas = element(id), context = canvas.getContext('2d');
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, canvas.width, canvas.height);
      if (id === 'split')
        draw_split(canvas, context);
      else
        place(canvas, id, context);
      if (element('show-labels').checked) draw_labels(canvas, context);
    }
  }

  function resize() {
    const pixels = devicePixelRatio || 1;
    for (const id of panels) {
      const canvas = element(id), shown = canvas.clientWidth;
      // The image's shape, but never taller than most of the window.
      const tall = Math.min(shown * height / width, id === 'split' ? 0.7 * innerHeight : 0.6 * innerHeight);
      canvas.style.height = `${tall}px`;
      canvas.width = Math.max(1, Math.round(shown * pixels));
      canvas.height = Math.max(1, Math.round(tall * pixels));
    }
    draw();
  }

  // The image pixel under a pointer.
  function under(canvas, event) {
    const box = canvas.getBoundingClientRect(), pixels = canvas.width / box.width, scale = scale_of(canvas);
    return [view.x + ((event.clientX - box.left) * pixels - canvas.width / 2) / scale,
            view.y + ((event.clientY - box.top) * pixels - canvas.height / 2) / scale];
  }
  // Zooms and keeps image pixel (x, y) where it is.
  function zoom(factor, x = view.x, y = view.y) {
    const before = view.zoom;
    view.zoom = Math.min(256, Math.max(0.5, view.zoom * factor));
    view.x = x + (view.x - x) * before / view.zoom;
    view.y = y + (view.y - y) * before / view.zoom;
    draw();
  }
  function fit() {
    Object.assign(view, {x: width / 2, y: height / 2, zoom: 1});
    draw();
  }

  function tell(x, y) {
    if (x < 0 || y < 0 || x >= width || y >= height) return;
    const i = Math.floor(y) * width + Math.floor(x);
    const rgb = planes => planes.map(p => p[i].toPrecision(3)).join(' ');
    element('readout').textContent = `${Math.floor(x)}, ${Math.floor(y)}   A ${rgb(a)}   B ${rgb(b)}` +
        (z ? `   z ${z[i].toFixed(1)}` : '') + `   FLIP ${flip[i].toFixed(3)}`;
  }

  for (const id of panels) {
    const canvas = element(id);
    let grabbed = null;
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      zoom(Math.exp(-event.deltaY / 400), ...under(canvas, event));
    }, {passive: false});
    canvas.addEventListener('pointerdown', event => {
      grabbed = under(canvas, event);
      try { canvas.setPointerCapture(event.pointerId); } catch { /* a pointer that is gone */ }
    });
    canvas.addEventListener('pointermove', event => {
      const [x, y] = under(canvas, event);
      tell(x, y);
      if (!grabbed) return;
      view.x += grabbed[0] - x;
      view.y += grabbed[1] - y;
      draw();
    });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => { grabbed = null; });
    canvas.addEventListener('dblclick', fit);
    canvas.addEventListener('keydown', event => {
      const step = 0.1 * width / view.zoom;
      const moves = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]};
      if (event.key === '+') zoom(1.5);
      else if (event.key === '-') zoom(1 / 1.5);
      else if (event.key === '0') fit();
      else if (moves[event.key]) {
        view.x += moves[event.key][0];
        view.y += moves[event.key][1];
        draw();
      } else return;
      event.preventDefault();
    });
  }
  element('exposure').value = data.exposure;
  element('exposure').addEventListener('input', expose);
  element('divider').addEventListener('input', draw);
  element('show-labels').addEventListener('input', draw);
  element('fit').addEventListener('click', fit);
  element('one').addEventListener('click', () => {
    const canvas = element('split');
    zoom((devicePixelRatio || 1) / scale_of(canvas));
  });
  element('zoom-in').addEventListener('click', () => zoom(1.5));
  element('zoom-out').addEventListener('click', () => zoom(1 / 1.5));
  addEventListener('resize', resize);

  // Where nothing differs all bars are about as high as the line.
  function histogram() {
    const bins = 20, counts = new Array(bins).fill(0);
    for (const p of data.p) ++counts[Math.min(bins - 1, Math.floor(p * bins))];
    const expected = data.p.length / bins, top = Math.max(...counts, expected);
    const make = (tag, attributes, text = '') => {
      const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
      for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
      node.textContent = text;
      return node;
    };
    const svg = make('svg', {viewBox: '0 0 420 170', role: 'img',
                             'aria-label': `p-values of tiles in ${bins} bins: ${counts.join(', ')}`});
    counts.forEach((count, i) => {
      const tall = 130 * count / top;
      const bar = make('rect', {class: 'bar', x: 10.5 + 20 * i, y: 140 - tall, width: 19, height: tall,
                                fill: 'var(--series-1)'});
      bar.append(make('title', {}, `${i / bins} to ${(i + 1) / bins}: ${count}`));
      svg.append(bar);
    });
    const level = 140 - 130 * expected / top;
    svg.append(make('line', {x1: 10, x2: 410, y1: level, y2: level, stroke: 'var(--series-2)',
                             'stroke-dasharray': '5 4', 'stroke-width': 1.5}),
               make('line', {x1: 10, x2: 410, y1: 140, y2: 140, stroke: 'var(--rule)'}));
    for (const [x, text] of [[10, '0'], [210, 'p'], [410, '1']])
      svg.append(make('text', {x, y: 158, 'text-anchor': 'middle', 'font-size': 12, fill: 'var(--muted)'}, text));
    const caption = document.createElement('figcaption');
    caption.textContent = `${data.p.length} tests. Dashed: what equal images give, on average. ` +
        'Much at the left: they differ. Much at the right: error bars are too wide.';
    element('p-values').append(svg, caption);
  }
  if (element('p-values')) histogram();

  resize();
  expose();
  return {view, zoom, fit, draw, pictures, planes: {a, b, z, flip}};
})();
