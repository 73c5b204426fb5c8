// What is done with points in the 3D view: picking and measuring, a clip box, a height profile along a line. Coordinates are the
// file's, in doubles; lengths are in the units that the page names.
"use strict";

const tools = {
  point: { most: 1, text: "Click a point" }, distance: { most: Infinity, text: "Click points, one after the other" },
  height: { most: 2, text: "Click two points" }, angle: { most: 3, text: "Click three points: the angle is at the second" },
  area: { most: Infinity, text: "Click the corners, one after the other" },
  profile: { most: 2, text: "Click both ends of the line" },
};

/** The front point near a place in pixels, of those that are shown; -1 for none. */
function frontPoint(view, x, y, radius = 8) {
  const { camera, canvas, box } = view, { set, count } = view.shown, { places, colors } = set, { m } = camera.projection();
  const w = canvas.clientWidth / 2, h = canvas.clientHeight / 2;
  let found = -1, depth = Infinity;
  for (let i = 0, at = 0; i < count; i++, at += 3) {
    const a = places[at], b = places[at + 1], c = places[at + 2];
    const clip = m[3] * a + m[7] * b + m[11] * c + m[15];
    if (!(clip > 0)) continue;
    const dx = ((m[0] * a + m[4] * b + m[8] * c + m[12]) / clip + 1) * w - x;
    if (dx > radius || dx < -radius) continue;
    const dy = (1 - (m[1] * a + m[5] * b + m[9] * c + m[13]) / clip) * h - y;
    if (dx * dx + dy * dy > radius * radius) continue;
    const z = (m[2] * a + m[6] * b + m[10] * c + m[14]) / clip;
    if (z >= depth || z <= -1 || z >= 1 || !(colors[i] >>> 24) || box && !isInBox(box, a, b, c)) continue;
    found = i;
    depth = z;
  }
  return found;
}

const isInBox = ({ low, high }, a, b, c) =>
  a >= low[0] && a <= high[0] && b >= low[1] && b <= high[1] && c >= low[2] && c <= high[2];

/** A point's coordinates as the file has them, as numbers and as texts. */
function pointOf(data, set, index) {
  const texts = data.position.map((description, axis) => exactText(description, set.positions[axis][index]));
  return { ...placeOf(data, texts), set, index };
}

function placeOf(data, texts) {
  const geo = texts.map(Number);
  return { texts, geo, place: geo.map((v, k) => (v - data.origin[k]) / (data.size[k] || 1)) };
}

const coordinates = texts => texts.map((t, k) => "xyz"[k] + " " + withGroups(t)).join("  ");
const withGroups = text => text.includes("e") ? text : text.replace(/^(-?)(\d+)/, (_, sign, whole) =>
  sign + whole.replace(/\B(?=(\d{3})+$)/g, ","));

/** All attributes of a point, as the file has them. */
function attributesOf(data, { set, index }) {
  return data.columns.map((c, k) => {
    const text = c.kind === "constant" ? c.value : exactText(c, set.columns[k][index]);
    const category = c.categories?.find(v => v.value === Number(text));
    return [c.name, category ? category.name : text + (c.unit ? " " + c.unit : "")];
  });
}

/** What a tool says of the points that were chosen: names and values. */
function measure(data, tool, picked) {
  const up = data.axes[2], steps = picked.slice(1).map((p, i) => between(data, picked[i], p));
  const length = v => grouped(v, data.lengthDecimals) + " " + data.unit;
  const level = d => Math.sqrt(Math.max(0, dot(d, d) - dot(d, up) ** 2)), sum = values => values.reduce((a, b) => a + b, 0);
  const degrees = radians => grouped(radians * 180 / Math.PI, 2) + "°";
  if (!steps.length) return [];
  const whole = between(data, picked[0], picked[picked.length - 1]), rise = dot(whole, up);
  if (tool === "height")
    return [["rise", length(rise)], ["level", length(level(whole))], ["slope", degrees(Math.atan2(rise, level(whole)))]];
  if (tool === "distance" || tool === "profile")
    return [["distance", length(sum(steps.map(d => Math.hypot(...d))))], ["level", length(sum(steps.map(level)))],
      ["rise", length(rise)]];
  if (tool === "angle" && steps.length === 2) {
    const [a, b] = [steps[0].map(v => -v), steps[1]];
    return [["angle", degrees(Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)))]];
  }
  if (tool === "area" && steps.length > 1) {
    const corners = picked.map(p => between(data, picked[0], p));
    const twice = corners.reduce((total, p, i) => add(total, cross(p, corners[(i + 1) % corners.length])), [0, 0, 0]);
    const square = v => grouped(v, data.lengthDecimals) + " " + data.unit + "²";
    return [["area", square(Math.hypot(...twice) / 2)], ["seen from above", square(Math.abs(dot(twice, up)) / 2)],
      ["edge", length(sum(steps.map(d => Math.hypot(...d))) + Math.hypot(...whole))]];
  }
  return [];
}

const between = (data, a, b) => a.geo.map((v, k) => (b.geo[k] - v) * data.lengths[k]);

/** Points near a line, seen from its side: those that are shown, in a strip of some width. */
function profileOf(view, [a, b], width) {
  const { data, box } = view, { set, count } = view.shown, up = data.axes[2], line = between(data, a, b);
  const ahead = add(line, up, -dot(line, up)), length = Math.hypot(...ahead), along = ahead.map(v => v / (length || 1));
  const aside = cross(up, along), found = [];
  const scale = data.position.map((p, k) => data.lengths[k]);
  for (let i = 0; i < count; i++) {
    if (!(set.colors[i] >>> 24) || box && !isInBox(box, ...set.places.subarray(3 * i, 3 * i + 3))) continue;
    const d = [0, 1, 2].map(k => (set.positions[k][i] * data.position[k].scale + data.position[k].offset - a.geo[k]) * scale[k]);
    const distance = dot(d, along);
    if (distance < 0 || distance > length || Math.abs(dot(d, aside)) > width / 2) continue;
    found.push({ index: i, distance, height: dot(d, up) });
  }
  // Heights are of the axis, in lengths: of degrees in metres, as distances are.
  const base = a.geo[data.up] * data.lengths[data.up] * up[data.up];
  for (const p of found) p.height += base;
  return { points: found.sort((p, q) => p.distance - q.distance), length, set };
}

function profileCsv(view, { points, set }) {
  const { data } = view, cell = text => /[",\n]/.test(text) ? "\"" + text.replace(/"/g, "\"\"") + "\"" : text;
  const columns = data.columns.map((c, k) => ({ ...c, k }));
  const head = ["distance", "height", "X", "Y", "Z", ...columns.map(c => c.name)].map(cell).join();
  return head + "\n" + points.map(({ index, distance, height }) => [distance.toFixed(4), height.toFixed(4),
    ...data.position.map((p, axis) => exactText(p, set.positions[axis][index])),
    ...columns.map(c => c.kind === "constant" ? c.value.split(" ")[0] : exactText(c, set.columns[c.k][index]))]
    .map(cell).join() + "\n").join("");
}

/** Draws a profile with its axes; heights are as much larger than distances as the picture's shape has it. */
function drawProfile(canvas, { points, set }, length, unit) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2), width = canvas.clientWidth, height = canvas.clientHeight;
  [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  const context = canvas.getContext("2d"), left = 62, right = 14, top = 12, bottom = 40;
  context.scale(ratio, ratio);
  context.fillStyle = "#181a1e";
  context.fillRect(0, 0, width, height);
  let low = Infinity, high = -Infinity;
  for (const p of points) [low, high] = [Math.min(low, p.height), Math.max(high, p.height)];
  if (!points.length) [low, high] = [0, 1];
  const spare = (high - low || 1) * 0.05;
  [low, high] = [low - spare, high + spare];
  const x = v => left + v / (length || 1) * (width - left - right);
  const y = v => height - bottom - (v - low) / (high - low) * (height - top - bottom);
  context.font = "12px system-ui, sans-serif";
  const ticks = (from, to, most) => {
    const raw = (to - from) / most || 1, ten = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].find(s => s * ten >= raw) * ten;
    const found = [];
    for (let v = Math.ceil(from / step) * step; v <= to + step * 1e-6; v += step) found.push([v, endText(v + 0, step * 0.99)]);
    return found;
  };
  context.strokeStyle = "#343a42";
  context.fillStyle = "#c4cad2";
  context.textBaseline = "middle";
  const line = (...ends) => { context.beginPath(); context.moveTo(ends[0], ends[1]); context.lineTo(ends[2], ends[3]); context.stroke(); };
  for (const [v, text] of ticks(low, high, height / 50)) {
    line(left, y(v), width - right, y(v));
    context.textAlign = "right";
    context.fillText(text, left - 6, y(v));
  }
  for (const [v, text] of ticks(0, length, width / 90)) {
    line(x(v), top, x(v), height - bottom);
    context.textAlign = "center";
    context.fillText(text, x(v), height - bottom + 12);
  }
  const exaggeration = (height - top - bottom) / (high - low) / ((width - left - right) / (length || 1));
  context.fillText("distance, " + unit + "   (heights × " + Number(exaggeration.toPrecision(2)) + ")", (left + width - right) / 2,
    height - 10);
  for (const p of points) {
    const c = set.colors[p.index];
    context.fillStyle = `rgb(${c & 255},${c >> 8 & 255},${c >> 16 & 255})`;
    context.fillRect(x(p.distance) - 1, y(p.height) - 1, 2, 2);
  }
}
