// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// What the view draws, as objects of three.js. Lengths are halves of the box.
'use strict';

const layers = (() => {
  // Marks drawn in a point: the number is that of colours.py, and beyond those of waypoints.
  const GLYPH = {within: 0, plus: 1, minus: 2, cross: 3, square: 4, ring: 5, named: 6, disc: 7};

  function geometry(places) {
    const shape = new THREE.BufferGeometry();
    shape.setAttribute('position', new THREE.BufferAttribute(places, 3));
    return shape;
  }

  function points(shape, material) {
    const cloud = new THREE.Points(shape, material);
    cloud.frustumCulled = false;
    return cloud;
  }

  // Points as large as their spacing, but never smaller than a pixel.
  const CLOUD_VERTEX = `
    attribute float deviation;
    uniform float spacing, picture, most;
    varying float value;
    void main() {
      value = deviation;
      vec4 seen = modelViewMatrix * vec4(position, 1.0);
      gl_Position = projectionMatrix * seen;
      gl_PointSize = clamp(spacing * picture / -seen.z, 1.5, most);
    }`;
  const CLOUD_FRAGMENT = `
    uniform sampler2D colours;
    uniform vec3 unknown, plain;
    uniform float reach;
    varying float value;
    void main() {
      if (reach == 0.0) { gl_FragColor = vec4(plain, 1.0); return; }
      if (value > 1e5) { gl_FragColor = vec4(unknown, 1.0); return; }
      gl_FragColor = texture2D(colours, vec2(clamp(value / reach, -1.0, 1.0) * 0.498 + 0.5, 0.5));
    }`;

  function cloudMaterial(data, spacing, most, plain, reach) {
    const bytes = packed.bytes(data.colours);
    const map = new THREE.DataTexture(bytes, bytes.length / 3, 1, THREE.RGBFormat);
    map.unpackAlignment = 1;
    map.magFilter = map.minFilter = THREE.LinearFilter;
    map.needsUpdate = true;
    return new THREE.ShaderMaterial({
      vertexShader: CLOUD_VERTEX, fragmentShader: CLOUD_FRAGMENT,
      uniforms: {colours: {value: map}, unknown: {value: new THREE.Color(data.unknown)},
                 plain: {value: new THREE.Color(plain)}, reach: {value: reach},
                 spacing: {value: spacing / data.half}, picture: {value: 1}, most: {value: most}}});
  }

  function objectCloud(data) {
    const shape = geometry(packed.places(data.object.places));
    const known = data.object.deviations !== null;
    shape.setAttribute('deviation', new THREE.BufferAttribute(
        known ? packed.deviations(data.object.deviations, data.object.step) : new Float32Array(data.object.points), 1));
    return points(shape, cloudMaterial(data, data.object.spacing, 14, data.plain, known ? data.span * data.tolerance : 0));
  }

  function greyCloud(data, places, colour, share, most) {
    const shape = geometry(packed.places(places));
    shape.setAttribute('deviation', new THREE.BufferAttribute(new Float32Array(shape.attributes.position.count), 1));
    return points(shape, cloudMaterial(data, share * data.reference_spacing, most, colour, 0));
  }

  const MARK_VERTEX = `
    attribute float kind;
    attribute vec3 colour;
    uniform float size, lift;
    varying float glyph;
    varying vec3 ink;
    void main() {
      glyph = kind;
      ink = colour;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      gl_Position.z -= lift * gl_Position.w;
      gl_PointSize = size * (kind > 5.5 && kind < 6.5 ? 1.6 : 1.0);
    }`;
  // Distance to the glyph in shares of the point: ink inside, a white or black border about it.
  const MARK_FRAGMENT = `
    varying float glyph;
    varying vec3 ink;
    void main() {
      vec2 at = gl_PointCoord * 2.0 - 1.0;
      vec2 turned = vec2(at.x + at.y, at.x - at.y) * 0.7071;
      float across = max(abs(at.y), abs(at.x) - 0.8), along = max(abs(at.x), abs(at.y) - 0.8);
      float cross1 = max(abs(turned.y), abs(turned.x) - 0.8), cross2 = max(abs(turned.x), abs(turned.y) - 0.8);
      float box = max(abs(at.x), abs(at.y)), width = 0.17, far = 9.0;
      if (glyph < 0.5) { far = length(at); width = 0.26; }
      else if (glyph < 1.5) far = min(across, along);
      else if (glyph < 2.5) far = across;
      else if (glyph < 3.5) far = min(cross1, cross2);
      else if (glyph < 4.5) { far = box; width = 0.42; }
      else if (glyph < 5.5) far = abs(length(at) - 0.6);
      else if (glyph < 6.5) { far = min(cross1, cross2); width = 0.24; }
      else { far = length(at); width = 0.55; }
      if (far > width + 0.16) discard;
      float bright = dot(ink, vec3(0.3, 0.6, 0.1));
      gl_FragColor = vec4(far <= width ? ink : vec3(bright > 0.5 ? 0.0 : 1.0), 1.0);
    }`;

  // lift: by how much they lie before what they mark, as a share of the depth that is in sight
  function marks(places, kinds, colours, size, lift = 0.008) {
    const shape = geometry(places);
    const inks = new Float32Array(3 * kinds.length);
    for (let i = 0; i < kinds.length; ++i) new THREE.Color(colours[i]).toArray(inks, 3 * i);
    shape.setAttribute('kind', new THREE.BufferAttribute(Float32Array.from(kinds), 1));
    shape.setAttribute('colour', new THREE.BufferAttribute(inks, 3));
    return points(shape, new THREE.ShaderMaterial({
      vertexShader: MARK_VERTEX, fragmentShader: MARK_FRAGMENT,
      uniforms: {lift: {value: lift}, size: {value: size * (window.devicePixelRatio || 1)}}}));
  }

  function signMarks(data) {
    const kinds = packed.bytes(data.marks.kinds);
    return marks(packed.places(data.marks.places), kinds, new Array(kinds.length).fill('#000000'), 11, 0.004);
  }

  // Before the cloud that they lie on, as marks are.
  function lineMaterial(colour) {
    return new THREE.ShaderMaterial({
      vertexShader: `void main() {
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          gl_Position.z -= 0.006 * gl_Position.w;
        }`,
      fragmentShader: 'uniform vec3 ink; void main() { gl_FragColor = vec4(ink, 1.0); }',
      uniforms: {ink: {value: new THREE.Color(colour)}}});
  }

  // A segment's waypoints are joined; segments are not.
  function pathLines(places, segments, colour) {
    const ends = [];
    for (let i = 1; i < segments.length; ++i)
      if (segments[i] === segments[i - 1]) ends.push(i - 1, i);
    const shape = geometry(places);
    shape.setIndex(ends);
    const lines = new THREE.LineSegments(shape, lineMaterial(colour));
    lines.frustumCulled = false;
    return lines;
  }

  function joins(from, to) {
    const ends = new Float32Array(from.length * 2);
    for (let i = 0; i < from.length / 3; ++i) {
      ends.set(from.subarray(3 * i, 3 * i + 3), 6 * i);
      ends.set(to.subarray(3 * i, 3 * i + 3), 6 * i + 3);
    }
    const lines = new THREE.LineSegments(geometry(ends), lineMaterial('#4ade80'));
    lines.frustumCulled = false;
    return lines;
  }

  function waypointMarks(places, states) {
    const look = [[GLYPH.disc, '#ffe600'], [GLYPH.square, '#ffe600'], [GLYPH.ring, '#00e5ff'], [GLYPH.disc, '#aab2bd']];
    const kinds = Array.from(states, (state) => look[state][0]);
    return marks(places, kinds, Array.from(states, (state) => look[state][1]), 8);
  }

  function addPaths(paths, add) {
    const line = (path, colour) => pathLines(packed.numbers(path.places, Float32Array), packed.numbers(path.segments, Uint32Array), colour);
    const places = (path) => packed.numbers(path.places, Float32Array);
    add('Path on the reference', line(paths.reference, '#c7ccd4'));
    if (paths.adapted) add('Adapted path', line(paths.adapted, '#ffe600'));
    if (paths.paired) add('Lines between corresponding waypoints', joins(places(paths.reference), places(paths.adapted)));
    if (paths.states)
      add('Waypoints: • measured, ■ inferred, ○ in the air', waypointMarks(places(paths.adapted || paths.reference), packed.bytes(paths.states)));
    const named = packed.numbers(paths.concerned, Float32Array), count = named.length / 3;
    if (count)
      add('Waypoints that the verdict names: ✖', marks(named, new Array(count).fill(GLYPH.named), new Array(count).fill('#ff3b30'), 12));
  }

  // [name, object, whether it is shown at first], in the order in which they are drawn
  function all(data) {
    const list = [], add = (name, object, shown = true) => list.push([name, object, shown]);
    if (data.reference) add('Reference', greyCloud(data, data.reference.places, '#6f7782', 0.35, 3), !data.mapped || !data.object);
    if (data.unscanned) add('Surface that was not scanned', greyCloud(data, data.unscanned.places, '#8d95a1', 0.9, 12));
    if (data.rim) add('Outline of the reference', greyCloud(data, data.rim.places, '#d8dde4', 0.3, 3));
    if (data.object) add(data.marks ? 'Object, coloured by deviation' : 'Object', objectCloud(data));
    if (data.marks) add('Marks of the deviation: + − • ×', signMarks(data));
    if (data.paths) addPaths(data.paths, add);
    return list;
  }

  return {all, marks, GLYPH};
})();
