// What can be coloured, its range over the run, and how its numbers are written.
const fields = [];
for (const array of meta.arrays) {
  if (array.of === "corners") continue;
  if (array.components === 1) {
    fields.push({ name: array.name, symbol: array.symbol || array.name, array, part: 0 });
  } else {
    const letter = array.name === "displacement" ? "u" : array.name === "velocity" ? "v" : array.name;
    for (const [part, name, symbol] of [[-1, array.name, `|${letter}|`], [0, array.name + " x", letter + "_x"], [1, array.name + " y", letter + "_y"]]) {
      fields.push({ name, symbol, array, part });
    }
  }
}
const categories = field => ["fragment", "region", "material", "property"].includes(field.array.name);

function valueAt(field, frame, item) {
  const array = field.array, at = offset(array, frame) + item*array.components;
  if (field.part < 0) return Math.hypot(array.values[at], array.values[at + 1]);
  return array.values[at + field.part];
}

// Held blocks: their stress and motion say nothing.
function held(frame, block) {
  const fixed = arrayNamed("blocks", "fixed");
  return fixed && fixed.values[offset(fixed, frame) + block] !== 0;
}

// Range of the whole run: 2 % at either end are left out where they would flatten the rest, as in the engine's pictures.
function rangeOf(field) {
  if (field.range) return field.range;
  const frames = field.array.constant ? 1 : meta.times.length, items = itemsOf(field.array.of);
  const stride = Math.max(1, Math.floor(frames*items/100000)), sample = [];
  for (let i = 0; i < frames*items; i += stride) {
    const frame = Math.floor(i/items), item = i % items;
    const value = valueAt(field, frame, item);
    if (Number.isFinite(value) && !(field.array.of === "blocks" && !field.array.whole && held(frame, item))) sample.push(value);
  }
  if (sample.length === 0) sample.push(0);
  sample.sort((a, b) => a - b);
  let low = sample[0], high = sample[sample.length - 1];
  const cut = Math.floor(0.02*sample.length), a = sample[cut], b = sample[sample.length - 1 - cut];
  if (!field.array.whole && b > a && high - low > 2.5*(b - a)) {
    if (a - low > (b - a)/2) low = a;
    if (high - b > (b - a)/2) high = b;
  }
  if (!field.array.whole && low > 0 && low < 0.2*high) low = 0;
  if (!field.array.whole && high < 0 && high > 0.2*low) high = 0;
  if (!(high > low)) { const half = Math.abs(low)/10 || 1; low -= half; high += half; }
  return field.range = [low, high];
}

function mapOf(field, [low, high]) {
  if (categories(field)) return meta.colours.categories;
  const both = !field.array.whole && Math.min(-low, high) > 0.05*Math.max(-low, high);
  return both ? meta.colours.diverging : meta.colours.sequential;
}

// Which of the map's colours a value has.
function levelOf(field, map, [low, high], value) {
  const count = map.length;
  if (map === meta.colours.categories) return Math.floor(count*((Math.abs(value)*0.6180339887498949) % 1));
  const largest = Math.max(-low, high), clamped = Math.min(high, Math.max(low, value));
  const t = map === meta.colours.diverging ? 0.5 + 0.5*clamped/largest : (clamped - low)/(high - low);
  return Math.min(count - 1, Math.floor(count*t));
}

// A unit with the prefix that suits numbers up to `largest`: [factor, name].
const prefixes = { "-4": "p", "-3": "n", "-2": "µ", "-1": "m", 0: "", 1: "k", 2: "M", 3: "G", 4: "T" };
const raised = unit => unit.replace(/([a-z])2/g, "$1²").replace(/([a-z])3/g, "$1³");
function shownUnit(unit, largest) {
  const prefixed = /^(Pa|m|s|N|J|m\/s|N\/m|J\/m)$/.test(unit);
  if (!prefixed || !(largest > 0)) return [1, raised(unit)];
  let power = Math.floor(Math.log10(largest)/3 + 1e-9);
  if (unit === "s" && power > 0) power = 0;
  power = Math.max(-4, Math.min(4, power));
  return [10**(3*power), prefixes[power] + unit];
}
function digits(value, count = 4) {
  if (!Number.isFinite(value)) return "—";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e6 ? String(Number(value.toPrecision(count))) : value.toExponential(count - 1);
}
function quantity(value, unit) {
  const [factor, name] = shownUnit(unit, Math.abs(value));
  return digits(value/factor) + (name ? " " + name : "");
}
