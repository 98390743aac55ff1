// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The page's data, and the numbers that are packed in it (view_data.py).
'use strict';

const pageData = JSON.parse(document.getElementById('page-data').textContent);

const packed = {
  STEPS: 32767,
  NOT_KNOWN: -32768,

  bytes(text) {
    const raw = atob(text);
    const bytes = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
    return bytes;
  },

  // Little endian, as every machine with a browser is.
  numbers(text, Kind) {
    return new Kind(packed.bytes(text).buffer);
  },

  // Places in halves of the box from its middle.
  places(text) {
    return Float32Array.from(packed.numbers(text, Int16Array), (step) => step / packed.STEPS);
  },

  // [m]; where nothing is known a number beyond all scales, which a shader can compare.
  deviations(text, step) {
    return Float32Array.from(packed.numbers(text, Int16Array),
                             (value) => value === packed.NOT_KNOWN ? 1e6 : value * step);
  },
};
