// Columns of history.csv over time, with the time that is shown.
const chart = { columns: [], rows: 0, column: 1 }, chartCanvas = $("chart"), chartPen = chartCanvas.getContext("2d");
const room = { left: 62, right: 16, top: 8, bottom: 24 };

async function readHistory() {
  const values = await floats(meta.history.data, 4);
  chart.rows = meta.history.rows;
  chart.columns = meta.history.columns.map((c, k) => ({ ...c, values: values.subarray(k*chart.rows, (k + 1)*chart.rows) }));
  $("history").hidden = chart.rows < 2;
  chart.columns.forEach((column, k) => {
    if (k > 0) $("column").add(new Option(column.unit ? `${column.name} [${column.unit}]` : column.name, k));
  });
  const wanted = ["kinetic_energy", "total_energy"].map(name => chart.columns.findIndex(c => c.name === name)).find(k => k > 0);
  if (chart.columns.length > 1) $("column").value = chart.column = wanted || 1;
}

function span(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) if (Number.isFinite(value)) { low = Math.min(low, value); high = Math.max(high, value); }
  if (!(low <= high)) return [0, 1];
  if (low === high) { const half = Math.abs(low)/10 || 1; return [low - half, high + half]; }
  return [low, high];
}

// Round values inside, about `wanted` of them.
function ticks([low, high], wanted) {
  const raw = (high - low)/wanted, power = 10**Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(k => k*power).find(s => s >= raw), out = [];
  for (let value = Math.ceil(low/step)*step; value <= high + 1e-9*step; value += step) out.push(Number(value.toPrecision(10)));
  return out;
}

function drawChart() {
  if ($("history").hidden) return;
  fitCanvas(chartCanvas, chartPen);
  const width = chartCanvas.clientWidth, height = chartCanvas.clientHeight, p = chartPen;
  p.clearRect(0, 0, width, height);
  const xs = chart.columns[0].values, column = chart.columns[chart.column], ys = column.values;
  const x = span(xs), y = span(ys), [fx, xUnit] = shownUnit("s", x[1]), [fy, yUnit] = shownUnit(column.unit, Math.max(Math.abs(y[0]), Math.abs(y[1])));
  const inner = [width - room.left - room.right, height - room.top - room.bottom];
  const atX = v => room.left + inner[0]*(v - x[0])/(x[1] - x[0]), atY = v => room.top + inner[1]*(1 - (v - y[0])/(y[1] - y[0]));
  p.font = "11px DejaVu Sans, sans-serif"; p.fillStyle = "#444"; p.strokeStyle = "#ddd"; p.lineWidth = 1;
  p.textAlign = "right"; p.textBaseline = "middle";
  for (const t of ticks([y[0]/fy, y[1]/fy], 4)) {
    p.beginPath(); p.moveTo(room.left, atY(t*fy)); p.lineTo(width - room.right, atY(t*fy)); p.stroke();
    p.fillText(digits(t), room.left - 4, atY(t*fy));
  }
  p.textAlign = "center"; p.textBaseline = "top";
  for (const t of ticks([x[0]/fx, x[1]/fx], 5)) p.fillText(digits(t), atX(t*fx), height - room.bottom + 4);
  p.textAlign = "right"; p.fillText(`t / ${xUnit}`, width - room.right, height - 11);
  p.textAlign = "left"; p.fillText(yUnit, 2, height - 12);
  p.strokeStyle = "#0072b2"; p.lineWidth = 1.6; p.beginPath();
  let pen = false;
  for (let k = 0; k < chart.rows; ++k) {
    if (!Number.isFinite(ys[k])) { pen = false; continue; }
    pen ? p.lineTo(atX(xs[k]), atY(ys[k])) : p.moveTo(atX(xs[k]), atY(ys[k]));
    pen = true;
  }
  p.stroke();
  const now = atX(meta.times[view.frame]);
  p.strokeStyle = "#d55e00"; p.beginPath(); p.moveTo(now, room.top); p.lineTo(now, height - room.bottom); p.stroke();
}

// The frame nearest to where the chart was clicked.
function frameOfChart(px) {
  const xs = span(chart.columns[0].values), inner = chartCanvas.clientWidth - room.left - room.right;
  const time = xs[0] + (xs[1] - xs[0])*(px - room.left)/inner;
  let best = 0;
  meta.times.forEach((t, k) => { if (Math.abs(t - time) < Math.abs(meta.times[best] - time)) best = k; });
  return best;
}
