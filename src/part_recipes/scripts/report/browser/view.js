// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The view that turns. Until it is drawn, a fixed picture stands in its place. It draws only when something changes.
// `reportView` is for tests and for the table; times in ms since the page was opened.
'use strict';

const reportView = {ready: false, waiting: false, frames: 0, firstPicture: null, firstView: null, show: () => {}};

function startView() {
  const data = pageData.view, canvas = document.getElementById('view'), poster = document.getElementById('poster');
  if (!data || !canvas) return;

  function missing(why) {
    const note = document.getElementById('view-missing');
    note.textContent = why + ' The pictures below show the same.';
    note.hidden = false;
    canvas.hidden = true;
    if (poster) poster.hidden = true;
    for (const id of ['layers', 'views']) document.getElementById(id).disabled = true;
  }

  if (typeof THREE === 'undefined') return missing('The library for the view (three.js) is not in this page.');
  let renderer;
  try {
    const context = canvas.getContext('webgl', {antialias: true, preserveDrawingBuffer: true});
    if (!context) return missing('This browser has no WebGL.');
    renderer = new THREE.WebGLRenderer({canvas, context});
  } catch (error) {
    return missing('The view cannot be drawn: ' + error.message + '.');
  }
  renderer.setClearColor('#14171b');
  const scene = new THREE.Scene();

  function draw() {
    reportView.waiting = false;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return;
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height, false);
    orbit.camera.aspect = width / height;
    orbit.camera.updateProjectionMatrix();
    const picture = height * renderer.getPixelRatio() / (2 * Math.tan(orbit.camera.fov * Math.PI / 360));
    scene.traverse((object) => {
      if (object.material && object.material.uniforms && object.material.uniforms.picture)
        object.material.uniforms.picture.value = picture;
    });
    renderer.render(scene, orbit.camera);
    ++reportView.frames;
    if (reportView.firstView === null) reportView.firstView = performance.now();
    if (poster) poster.hidden = true;
  }

  function redraw() {
    if (reportView.waiting) return;
    reportView.waiting = true;
    requestAnimationFrame(draw);
  }

  const orbit = new OrbitCamera(canvas, redraw);

  function addSwitch(name, object, shown) {
    const label = document.createElement('label'), box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = object.visible = shown;
    box.addEventListener('change', () => { object.visible = box.checked; redraw(); });
    label.append(box, ' ' + name);
    document.getElementById('layers').append(label);
  }

  layers.all(data).forEach(([name, object, shown], order) => {
    object.renderOrder = order;
    scene.add(object);
    addSwitch(name, object, shown);
  });
  for (const name of Object.keys(OrbitCamera.views())) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = name;
    button.addEventListener('click', () => orbit.lookFrom(name));
    document.getElementById('views').append(button, ' ');
  }
  if (data.object) {
    const of = data.object.of, drawn = data.object.points;
    document.getElementById('view-points').textContent =
        drawn < of ? `${drawn} of ${of} points of the object are drawn.` : `${of} points of the object.`;
  }

  // Marks one waypoint, by its number.
  let chosen = null;
  reportView.show = (number) => {
    if (chosen) scene.remove(chosen);
    chosen = null;
    const paths = data.paths;
    if (paths) {
      const path = paths.adapted || paths.reference;
      const places = packed.numbers(path.places, Float32Array);
      const at = packed.numbers(path.numbers, Uint32Array).indexOf(number);
      if (at >= 0) {
        chosen = layers.marks(places.slice(3 * at, 3 * at + 3), [layers.GLYPH.ring], ['#ffe600'], 26);
        chosen.renderOrder = 99;
        scene.add(chosen);
      }
    }
    redraw();
  };
  reportView.orbit = orbit;
  reportView.ready = true;
  new ResizeObserver(redraw).observe(canvas);
  canvas.addEventListener('webglcontextlost', () => missing('The browser lost the view; reload the page.'));
  redraw();
}

new PerformanceObserver((list) => {
  reportView.firstPicture = list.getEntries()[0].renderTime;
}).observe({type: 'element', buffered: true});
// The fixed picture first: to draw the view may take seconds.
requestAnimationFrame(() => setTimeout(startView, 0));
