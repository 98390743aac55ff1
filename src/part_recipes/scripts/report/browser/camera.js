// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// An eye that turns about what it looks at; z stays up. Calls `changed` after each move.
'use strict';

class OrbitCamera {
  constructor(canvas, changed) {
    this.canvas = canvas;
    this.changed = changed;
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.pointers = new Map();
    this.lookFrom('Oblique');
    canvas.addEventListener('pointerdown', (event) => this.press(event));
    canvas.addEventListener('pointermove', (event) => this.drag(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), {passive: false});
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  // Azimuth about z and height over the x-y plane [rad].
  static views() {
    return {Top: [-Math.PI / 2, Math.PI / 2 - 0.001], Front: [-Math.PI / 2, 0], Right: [0, 0],
            Back: [Math.PI / 2, 0], Below: [-Math.PI / 2, 0.001 - Math.PI / 2], Oblique: [-1.05, 0.75]};
  }

  lookFrom(name) {
    [this.azimuth, this.height] = OrbitCamera.views()[name];
    this.target = new THREE.Vector3();
    this.distance = 3.5;  // halves of the box: all of it is in sight
    this.move();
  }

  turn(azimuth, height) {
    this.azimuth += azimuth;
    this.height = Math.max(-1.5697, Math.min(1.5697, this.height + height));
    this.move();
  }

  // By shares of the picture's height.
  shift(right, up) {
    const reach = 2 * this.distance * Math.tan(this.camera.fov * Math.PI / 360);
    const across = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    const above = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    this.target.addScaledVector(across, -right * reach).addScaledVector(above, -up * reach);
    this.move();
  }

  zoom(factor) {
    this.distance = Math.max(0.05, Math.min(20, this.distance * factor));
    this.move();
  }

  move() {
    const level = Math.cos(this.height);
    this.camera.position.set(level * Math.cos(this.azimuth), level * Math.sin(this.azimuth), Math.sin(this.height))
        .multiplyScalar(this.distance).add(this.target);
    this.camera.near = this.distance / 100;
    this.camera.far = this.distance + 20;
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(this.target);
    this.camera.updateMatrix();
    this.changed();
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const height = this.canvas.clientHeight;
    const right = (event.clientX - before[0]) / height, down = (event.clientY - before[1]) / height;
    if (this.pointers.size === 2) this.pinch(event, before);
    this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (event.shiftKey || (event.buttons & 6) || this.pointers.size === 2) this.shift(right / this.pointers.size, -down / this.pointers.size);
    else this.turn(-right * Math.PI, down * Math.PI);
  }

  // Two fingers.
  pinch(event, before) {
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
    const apart = Math.hypot(before[0] - other[0], before[1] - other[1]);
    const now = Math.hypot(event.clientX - other[0], event.clientY - other[1]);
    if (apart > 0 && now > 0) this.zoom(apart / now);
  }

  wheel(event) {
    event.preventDefault();
    this.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 500))));
  }

  key(event) {
    const step = 0.12, ways = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key in ways) {
      const [azimuth, height] = ways[event.key];
      if (event.shiftKey) this.shift(-azimuth * step / 2, height * step / 2);
      else this.turn(azimuth * step, height * step);
    } else if (event.key === '+' || event.key === '=') this.zoom(0.85);
    else if (event.key === '-') this.zoom(1 / 0.85);
    else if (event.key === 'Home') this.lookFrom('Oblique');
    else return;
    event.preventDefault();
  }
}
