// The numbers of the page: each array is a <script id="a…"> of base64, zlib and bytes sorted by weight, made by view_pack.cpp.
"use strict";
const $ = id => document.getElementById(id);
const meta = JSON.parse($("meta").textContent);

async function unpacked(id) {
  const text = atob($("a" + id).textContent), bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

async function words(id, width) {
  const planes = await unpacked(id), count = planes.length / width, out = new Uint32Array(count);
  for (let k = 0; k < width; ++k)
    for (let i = 0, shift = 24 - 8*k; i < count; ++i) out[i] |= planes[k*count + i] << shift;
  return out.buffer;
}
const floats = async (id, width) => new Float32Array(await words(id, width));
const whole = async id => new Int32Array(await words(id, 4));

// Values of an array, all frames; unpacked when first asked for.
const unpacking = new Map();
function valuesOf(array) {
  if (!unpacking.has(array)) {
    unpacking.set(array, (array.whole ? whole(array.data) : floats(array.data, array.bytes)).then(values => array.values = values));
  }
  return unpacking.get(array);
}

const arrayNamed = (of, name) => meta.arrays.find(a => a.of === of && a.name === name);
const itemsOf = of => of === "blocks" ? meta.blocks : of === "joints" ? meta.joints : meta.corners;

// Where the values of one frame begin.
const offset = (array, frame) => array.constant ? 0 : frame*itemsOf(array.of)*array.components;

const model = {};  // begin, start, jointBlocks, edge, along: what never changes
async function readModel() {
  [model.begin, model.start, model.jointBlocks, model.edge, model.along] = await Promise.all([
    whole(meta.begin), floats(meta.start, 4), whole(meta.joint_blocks), whole(meta.edge), floats(meta.along, 4)]);
  await valuesOf(arrayNamed("corners", "displacement"));
  for (const [of, name] of [["blocks", "fixed"], ["joints", "mode"], ["joints", "gas"], ["blocks", "velocity"]]) {
    const array = arrayNamed(of, name);
    if (array) await valuesOf(array);
  }
}

// Corners as drawn in a frame, x and y by turns, m from the scene's centre.
let placed = { frame: -1 };
function corners(frame, scale) {
  if (placed.frame === frame && placed.scale === scale) return placed.at;
  const moved = arrayNamed("corners", "displacement"), from = offset(moved, frame);
  const at = new Float32Array(model.start.length);
  for (let i = 0; i < at.length; ++i) at[i] = model.start[i] + scale*moved.values[from + i];
  placed = { frame, scale, at };
  return at;
}

// End k of joint j: half-way between its two blocks.
function jointEnd(at, j, k) {
  let x = 0, y = 0;
  for (let side = 0; side < 2; ++side) {
    const i = 4*j + 2*k + side, edge = model.edge[i], t = model.along[i], block = model.jointBlocks[2*j + side];
    const next = edge + 1 < model.begin[block + 1] ? edge + 1 : model.begin[block];
    x += ((1 - t)*at[2*edge] + t*at[2*next])/2;
    y += ((1 - t)*at[2*edge + 1] + t*at[2*next + 1])/2;
  }
  return [x, y];
}
