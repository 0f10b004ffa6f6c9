// Controls: everything that a user moves ends in redraw().
function drawBar() {
  const bar = $("bar-colours"), p = bar.getContext("2d"), field = view.field, map = mapOf(field, view.range);
  $("bar").hidden = categories(field);
  bar.style.width = "96px"; bar.style.height = "220px";
  fitCanvas(bar, p);
  p.clearRect(0, 0, 96, 220);
  const [low, high] = view.range, [factor, unit] = shownUnit(field.array.unit, Math.max(Math.abs(low), Math.abs(high)));
  for (let k = 0; k < 200; ++k) {
    p.fillStyle = map[levelOf(field, map, view.range, low + (high - low)*(k + 0.5)/200)];
    p.fillRect(4, 209 - k, 16, 1.5);
  }
  p.fillStyle = "#222"; p.font = "12px DejaVu Sans, sans-serif"; p.textBaseline = "middle";
  for (const tick of ticks([low/factor, high/factor], 5)) {
    const y = 210 - 200*(tick*factor - low)/(high - low);
    p.fillRect(20, y - 0.5, 4, 1);
    p.fillText(digits(tick), 28, y);
  }
  $("bar-label").textContent = field.symbol + (unit ? ` / ${unit}` : "");
  $("low").value = digits(low/factor); $("high").value = digits(high/factor);
  $("range-unit").textContent = unit;
  view.factor = factor;
}

function drawLegend() {
  const legend = $("legend"), mode = arrayNamed("joints", "mode");
  legend.textContent = "";
  if (!mode) return;
  const count = [0, 0, 0, 0], from = offset(mode, view.frame);
  for (let j = 0; j < meta.joints; ++j) ++count[mode.values[from + j]];
  for (const k of [1, 2, 3]) {
    if (count[k] === 0) continue;
    const swatch = document.createElement("i");
    swatch.style.background = crackColours[k];
    legend.append(swatch, `${crackNames[k]}: ${count[k]}`);
  }
}

function namesOf(array, value) {
  const names = meta.names[array.name + "_names"];
  return names && names[value] !== undefined ? `${value}: ${names[value]}` : String(value);
}

// Values of what was clicked, in the frame that is shown.
async function describe() {
  const picked = view.picked, box = $("picked");
  if (!picked) return;
  for (const field of fields) if (field.array.of === picked.of) await valuesOf(field.array);
  if (picked !== view.picked) return;  // another one in the meantime
  const rows = [[picked.of === "blocks" ? "block" : "joint", String(picked.item + 1)]];
  if (picked.of === "joints") rows.push(["between blocks", `${model.jointBlocks[2*picked.item] + 1}, ${model.jointBlocks[2*picked.item + 1] + 1}`]);
  const at = corners(view.frame, 1), place = picked.of === "blocks" ? middle(at, picked.item) : jointEnd(at, picked.item, 0);
  rows.push([picked.of === "blocks" ? "middle, m" : "from, m", `${digits(meta.centre_x + place[0], 6)}, ${digits(meta.centre_y + place[1], 6)}`]);
  for (const field of fields) {
    if (field.array.of !== picked.of) continue;
    const value = valueAt(field, view.frame, picked.item);
    rows.push([field.name, field.array.whole ? namesOf(field.array, value) : quantity(value, field.array.unit)]);
  }
  const table = document.createElement("table");
  for (const row of rows) for (const tr of [table.insertRow()]) for (const text of row) tr.insertCell().textContent = text;
  box.replaceChildren(table);
}

let waiting = false;
function redraw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    drawScene();
    drawChart();
    drawLegend();
    $("time").textContent = "t = " + quantity(meta.times[view.frame], "s");
    $("frame").value = view.frame;
    describe();
  });
}

function setFrame(frame) {
  view.frame = Math.max(0, Math.min(meta.times.length - 1, frame));
  redraw();
}

async function setField(index) {
  const field = fields[index];
  await valuesOf(field.array);
  view.field = field;
  view.range = rangeOf(field);
  $("field").value = index;
  const unit = field.array.unit ? ` [${raised(field.array.unit)}]` : "";
  $("meaning").textContent = field.array.meaning + unit;
  drawBar();
  redraw();
}

function takeRange() {
  const low = view.factor*Number($("low").value), high = view.factor*Number($("high").value);
  if (Number.isFinite(low) && low < high) view.range = [low, high];
  drawBar();
  redraw();
}

const playing = { on: false, since: 0, from: 0 };
function play(on) {
  playing.on = on;
  $("play").textContent = on ? "❚❚" : "▶";
  if (!on) return;
  if (view.frame + 1 === meta.times.length) view.frame = 0;
  playing.from = view.frame;
  playing.since = performance.now();
  const tick = now => {
    if (!playing.on) return;
    const rate = Math.max(0.1, Number($("fps").value) || 10);
    const frame = playing.from + Math.floor((now - playing.since)/1000*rate);
    if (frame !== view.frame) setFrame(frame);
    if (frame >= meta.times.length - 1) return play(false);
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

function pick(px, py) {
  const x = fromX(px), y = fromY(py);
  const joint = view.field.array.of === "joints" ? jointAt(x, y) : -1, block = joint < 0 ? blockAt(x, y) : -1;
  view.picked = joint >= 0 ? { of: "joints", item: joint } : block >= 0 ? { of: "blocks", item: block } : null;
  if (!view.picked) $("picked").textContent = "";
  redraw();
}

function zoom(px, py, factor) {
  const x = fromX(px), y = fromY(py);
  view.px *= factor;
  view.x += x - fromX(px);
  view.y += y - fromY(py);
  redraw();
}

function listenToCanvas() {
  let drag = null;
  canvas.addEventListener("pointerdown", e => { drag = { x: e.offsetX, y: e.offsetY, moved: false }; });
  canvas.addEventListener("pointermove", e => {
    if (!drag || !(e.buttons & 1)) return;
    if (Math.hypot(e.offsetX - drag.x, e.offsetY - drag.y) > 3) drag.moved = true;
    if (!drag.moved) return;
    view.x -= (e.offsetX - drag.x)/view.px;
    view.y += (e.offsetY - drag.y)/view.px;
    drag.x = e.offsetX; drag.y = e.offsetY;
    redraw();
  });
  canvas.addEventListener("pointerup", e => { if (drag && !drag.moved) pick(e.offsetX, e.offsetY); drag = null; });
  canvas.addEventListener("wheel", e => { e.preventDefault(); zoom(e.offsetX, e.offsetY, Math.exp(-e.deltaY/400)); }, { passive: false });
  canvas.addEventListener("dblclick", () => { showAll(); redraw(); });
}

function listen() {
  $("frame").max = meta.times.length - 1;
  $("frame").addEventListener("input", () => { play(false); setFrame(Number($("frame").value)); });
  $("field").addEventListener("change", () => setField(Number($("field").value)));
  $("column").addEventListener("change", () => { chart.column = Number($("column").value); redraw(); });
  for (const id of ["edges", "cracks", "gas", "arrows"]) $(id).addEventListener("change", redraw);
  for (const id of ["low", "high"]) $(id).addEventListener("change", takeRange);
  $("auto").addEventListener("click", () => { view.range = rangeOf(view.field); drawBar(); redraw(); });
  $("scale").addEventListener("change", () => { view.scale = Number($("scale").value) || 1; redraw(); });
  $("play").addEventListener("click", () => play(!playing.on));
  chartCanvas.addEventListener("click", e => { play(false); setFrame(frameOfChart(e.offsetX)); });
  window.addEventListener("resize", redraw);
  window.addEventListener("keydown", e => {
    if (/INPUT|SELECT/.test(e.target.tagName) && e.target.id !== "frame") return;
    if (e.key === " ") { play(!playing.on); e.preventDefault(); }
    if (e.key === "ArrowRight" && e.target.id !== "frame") setFrame(view.frame + 1);
    if (e.key === "ArrowLeft" && e.target.id !== "frame") setFrame(view.frame - 1);
  });
  listenToCanvas();
}

function fillLists() {
  for (const of of ["blocks", "joints"]) {
    const group = document.createElement("optgroup");
    group.label = of;
    fields.forEach((field, k) => { if (field.array.of === of) group.append(new Option(field.name, k)); });
    if (group.children.length > 0) $("field").append(group);
  }
  $("counts").textContent = `${meta.blocks} blocks, ${meta.joints} joints, ${meta.times.length} frames`;
  const has = { cracks: arrayNamed("joints", "mode"), gas: arrayNamed("joints", "gas"), arrows: arrayNamed("blocks", "velocity") };
  for (const name in has) document.querySelector("." + name).hidden = !has[name];
}

async function start() {
  await readModel();
  await readHistory();
  fillLists();
  listen();
  showAll();
  await setField(Math.max(0, fields.findIndex(f => f.name === "s1")));
  setFrame(meta.times.length - 1);  // what came of it; playing begins at the first
}

// For tests: when it is ready, and how long a frame takes to draw (ms).
window.talus = { ready: start(), view, drawScene, setFrame };
window.talus.ready.catch(error => {
  $("trouble").hidden = false;
  $("trouble").textContent = typeof DecompressionStream === "undefined"
    ? "This browser is too old for the page: it needs DecompressionStream (Chrome 80, Firefox 113, Safari 16.4)." : String(error);
});
