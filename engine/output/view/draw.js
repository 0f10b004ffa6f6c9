// The scene on its canvas.
const view = { frame: 0, field: null, range: [0, 1], scale: 1, px: 1, x: 0, y: 0, picked: null };  // px per m; x, y: m in the middle
const canvas = $("view"), pen = canvas.getContext("2d");
const crackColours = { 1: "#000000", 2: "#d6008a", 3: "#7a5c3a" }, crackNames = { 1: "tension", 2: "shear", 3: "real joint" };

const toX = x => canvas.clientWidth/2 + view.px*(x - view.x);
const toY = y => canvas.clientHeight/2 - view.px*(y - view.y);
const fromX = x => view.x + (x - canvas.clientWidth/2)/view.px;
const fromY = y => view.y - (y - canvas.clientHeight/2)/view.px;

// Sizes a canvas for its place and the screen's pixels.
function fitCanvas(element, context) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(element.clientWidth*ratio), height = Math.round(element.clientHeight*ratio);
  if (element.width !== width || element.height !== height) { element.width = width; element.height = height; }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
}

// All blocks of the first frame, with room for as far again: one flying chip must not shrink all the rest.
function showAll() {
  const at = corners(view.frame, view.scale), box = [Infinity, Infinity, -Infinity, -Infinity], first = box.slice();
  for (let i = 0; i < at.length; ++i) {
    const k = i % 2;
    first[k] = Math.min(first[k], model.start[i]); first[2 + k] = Math.max(first[2 + k], model.start[i]);
    if (!Number.isFinite(at[i])) continue;
    box[k] = Math.min(box[k], at[i]); box[2 + k] = Math.max(box[2 + k], at[i]);
  }
  const reach = Math.max(first[2] - first[0], first[3] - first[1]);
  for (const k of [0, 1]) {
    box[k] = Math.max(box[k], first[k] - reach); box[2 + k] = Math.min(box[2 + k], first[2 + k] + reach);
  }
  const barRoom = 130;  // px at the right
  view.px = Math.min((canvas.clientWidth - barRoom - 30)/(box[2] - box[0]), (canvas.clientHeight - 40)/(box[3] - box[1]));
  view.x = (box[0] + box[2])/2 + barRoom/2/view.px; view.y = (box[1] + box[3])/2;
}

function trace(at, block) {
  const begin = model.begin[block], end = model.begin[block + 1];
  pen.moveTo(toX(at[2*begin]), toY(at[2*begin + 1]));
  for (let v = begin + 1; v < end; ++v) pen.lineTo(toX(at[2*v]), toY(at[2*v + 1]));
  pen.closePath();
}

function sorted(count, groups, groupOf) {
  const out = Array.from({ length: groups }, () => []);
  for (let i = 0; i < count; ++i) { const group = groupOf(i); if (group >= 0) out[group].push(i); }
  return out;
}

// One path of thousands of blocks takes much longer than many of some.
function inChunks(at, blocks, paint) {
  const chunk = 50;
  for (let first = 0; first < blocks.length; first += chunk) {
    pen.beginPath();
    for (let k = first; k < Math.min(blocks.length, first + chunk); ++k) trace(at, blocks[k]);
    paint();
  }
}

function drawBlocks(at, map) {
  const field = view.field, ofBlocks = field.array.of === "blocks", grey = map.length, pale = grey + 1;
  const greyHeld = ofBlocks && !field.array.whole;
  const groups = sorted(meta.blocks, pale + 1, block => {
    if (!ofBlocks) return pale;
    if (greyHeld && held(view.frame, block)) return grey;
    const value = valueAt(field, view.frame, block);
    return Number.isFinite(value) ? levelOf(field, map, view.range, value) : -1;
  });
  const edges = $("edges").checked;
  groups.forEach((blocks, level) => {
    if (blocks.length === 0) return;
    pen.fillStyle = pen.strokeStyle = level === grey ? "#b4b4b4" : level === pale ? "#eeeeee" : map[level];
    pen.lineWidth = 0.7;
    inChunks(at, blocks, () => { pen.fill(); if (!edges) pen.stroke(); });  // the stroke closes the seams
  });
  if (!edges) return;
  pen.strokeStyle = ofBlocks ? "#2228" : "#bbb";
  pen.lineWidth = 0.6;
  inChunks(at, Array.from({ length: meta.blocks }, (_, block) => block), () => pen.stroke());
}

function strokeJoints(at, joints, colour, width) {
  if (joints.length === 0) return;
  pen.beginPath();
  for (const j of joints) {
    const from = jointEnd(at, j, 0), to = jointEnd(at, j, 1);
    pen.moveTo(toX(from[0]), toY(from[1]));
    pen.lineTo(toX(to[0]), toY(to[1]));
  }
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.lineCap = "round";
  pen.stroke();
}

function drawCracks(at) {
  const mode = arrayNamed("joints", "mode"), gas = arrayNamed("joints", "gas");
  if (gas && $("gas").checked) {
    const from = offset(gas, view.frame);
    strokeJoints(at, sorted(meta.joints, 1, j => gas.values[from + j] > 0 ? 0 : -1)[0], "#ff7f0e", 5);
  }
  if (!mode || !$("cracks").checked) return;
  const from = offset(mode, view.frame), byMode = sorted(meta.joints, 4, j => mode.values[from + j]);
  for (const k of [3, 2, 1]) strokeJoints(at, byMode[k], crackColours[k], k === 3 ? 1.2 : 1.8);
}

function drawArrows(at) {
  const velocity = arrayNamed("blocks", "velocity");
  if (!velocity || !$("arrows").checked) return;
  let largest = 0;
  const from = offset(velocity, view.frame), values = velocity.values;
  for (let b = 0; b < meta.blocks; ++b) largest = Math.max(largest, Math.hypot(values[from + 2*b], values[from + 2*b + 1]));
  pen.strokeStyle = "#c1121f";
  pen.lineWidth = 1.5;
  pen.beginPath();
  for (let b = 0; b < meta.blocks && largest > 0; ++b) {
    const vx = 46*values[from + 2*b]/largest, vy = -46*values[from + 2*b + 1]/largest, size = Math.hypot(vx, vy);
    if (size < 3) continue;
    const [x, y] = middle(at, b), ex = toX(x) + vx, ey = toY(y) + vy, head = Math.min(7, 0.45*size)/size;
    pen.moveTo(toX(x), toY(y)); pen.lineTo(ex, ey);
    pen.moveTo(ex - head*(vx - 0.5*vy), ey - head*(vy + 0.5*vx)); pen.lineTo(ex, ey);
    pen.lineTo(ex - head*(vx + 0.5*vy), ey - head*(vy - 0.5*vx));
  }
  pen.stroke();
}

function middle(at, block) {
  let x = 0, y = 0;
  const begin = model.begin[block], end = model.begin[block + 1];
  for (let v = begin; v < end; ++v) { x += at[2*v]; y += at[2*v + 1]; }
  return [x/(end - begin), y/(end - begin)];
}

function drawPicked(at) {
  if (!view.picked) return;
  if (view.picked.of === "joints") return strokeJoints(at, [view.picked.item], "#00a8ff", 4);
  pen.beginPath();
  trace(at, view.picked.item);
  pen.strokeStyle = "#00a8ff";
  pen.lineWidth = 3;
  pen.stroke();
}

function drawScene() {
  fitCanvas(canvas, pen);
  pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  const at = corners(view.frame, view.scale), map = mapOf(view.field, view.range);
  drawBlocks(at, map);
  if (view.field.array.of === "joints") {
    const mode = ["gas", "gas_pressure", "failed_at", "mode"].includes(view.field.name) ? arrayNamed("joints", "mode") : null;
    const from = mode ? offset(mode, view.frame) : 0;  // these say nothing of intact joints
    const groups = sorted(meta.joints, map.length, j => mode && mode.values[from + j] === 0 ? -1
      : levelOf(view.field, map, view.range, valueAt(view.field, view.frame, j)));
    groups.forEach((joints, level) => strokeJoints(at, joints, map[level], 3));
  } else {
    drawCracks(at);
  }
  drawArrows(at);
  drawPicked(at);
}

// The block under a point (m): the last drawn of those that contain it.
function blockAt(x, y) {
  const at = corners(view.frame, view.scale);
  for (let block = meta.blocks - 1; block >= 0; --block) {
    let inside = false;
    const begin = model.begin[block], end = model.begin[block + 1];
    for (let v = begin, w = end - 1; v < end; w = v++) {
      const ax = at[2*v], ay = at[2*v + 1], bx = at[2*w], by = at[2*w + 1];
      if (ay > y !== by > y && x < ax + (y - ay)*(bx - ax)/(by - ay)) inside = !inside;
    }
    if (inside) return block;
  }
  return -1;
}

// The joint within 6 px of a point (m).
function jointAt(x, y) {
  const at = corners(view.frame, view.scale);
  let best = -1, least = 6/view.px;
  for (let j = 0; j < meta.joints; ++j) {
    const [ax, ay] = jointEnd(at, j, 0), [bx, by] = jointEnd(at, j, 1), dx = bx - ax, dy = by - ay;
    const t = Math.min(1, Math.max(0, ((x - ax)*dx + (y - ay)*dy)/(dx*dx + dy*dy)));
    const far = Math.hypot(ax + t*dx - x, ay + t*dy - y);
    if (far < least) { least = far; best = j; }
  }
  return best;
}
