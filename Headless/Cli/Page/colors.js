// What the points of a page are coloured by, and which of them are hidden for their values. Found here once for all points of a
// choice, so that the shaders know nothing of attributes.
"use strict";

const elevationMode = -1, colorsOfPointsMode = -2;

class Coloring {
  constructor(data, sets) {
    Object.assign(this, { data, sets, hidden: new Set(), hidesRest: false, ranges: new Map() });
    const rgb = hex => 0xff000000 | parseInt(hex.slice(4, 6), 16) << 16 | parseInt(hex.slice(2, 4), 16) << 8
      | parseInt(hex.slice(0, 2), 16);
    this.rgb = rgb;
    this.tables = Object.fromEntries(Object.entries(data.ramps).map(([name, text]) => [name, text.match(/.{6}/g).map(rgb)]));
    this.modes = data.rgb ? [{ id: colorsOfPointsMode, name: "Colour" }] : [];
    this.modes.push({ id: elevationMode, name: "Elevation" });
    data.columns.forEach((c, id) => { if (c.kind === "amount" || c.kind === "category") this.modes.push({ id, name: c.name }); });
    this.setMode(this.modes.some(m => m.id === data.mode) ? data.mode : elevationMode);
  }

  setMode(mode) {
    this.mode = mode;
    this.hidden.clear();
    this.hidesRest = false;
  }

  get name() { return this.modes.find(m => m.id === this.mode).name; }
  get column() { return this.data.columns[this.mode]; }
  get isRgb() { return this.mode === colorsOfPointsMode; }
  /** Colours that are no scanner's, and show no amount by how bright they are, have light on them. */
  get isLit() { return !this.data.rgb && (this.mode === elevationMode || this.column?.name === "Classification"); }
  get isCategory() { return this.column?.kind === "category"; }

  /** How a point's value of the mode comes from what is stored. */
  source(set) {
    const { data, mode } = this;
    if (mode !== elevationMode) return { values: set.columns[mode], scale: this.column.scale, offset: this.column.offset };
    const { scale, offset } = data.position[data.up], sign = data.axes[2][data.up];
    return { values: set.positions[data.up], scale: sign * scale, offset: sign * offset };
  }

  /** Of an amount: all that there is (min, max), what the colours span (low, high) and how fine that is; null for others. */
  get range() {
    const { mode, data } = this;
    if (this.isRgb || this.isCategory) return null;
    if (!this.ranges.has(mode)) {
      const set = this.sets[this.sets.length - 1], { values, scale, offset } = this.source(set);
      let min = Infinity, max = -Infinity;
      for (let i = 0; i < set.count; i++) {
        const v = values[i] * scale + offset;
        if (v < min) min = v;
        if (v > max) max = v;
      }
      const [low, high] = mode === elevationMode ? data.elevation : [this.column.low, this.column.high];
      const isWhole = mode !== elevationMode && this.column.decimals === 0;
      [min, max] = [Math.min(min, low), Math.max(max, high)];
      this.ranges.set(mode, { min, max, low, high, isWhole, unit: mode === elevationMode ? data.unit : this.column.unit,
        table: this.tables[mode === elevationMode ? "viridis" : this.column.ramp] });
    }
    const range = this.ranges.get(mode);
    range.step = range.isWhole ? 1 : (range.high - range.low || range.max - range.min) / 256;
    return range;
  }

  apply() { for (const set of this.sets) this.colorsOf(set); }

  colorsOf(set) {
    const { data } = this, { colors, count } = set;
    if (this.isRgb) {
      const { scale, bias, columns } = data.rgb, [r, g, b] = columns.map(c => set.columns[c]);
      const byte = v => { const scaled = v * scale + bias; return scaled > 255 ? 255 : scaled > 0 ? scaled | 0 : 0; };
      for (let i = 0; i < count; i++) colors[i] = 0xff000000 | byte(b[i]) << 16 | byte(g[i]) << 8 | byte(r[i]);
      return;
    }
    const { values, scale, offset } = this.source(set);
    if (this.isCategory) {
      const colorOf = new Map(this.column.categories.map(c => [c.value, this.hidden.has(c.value) ? 0 : this.rgb(c.color)]));
      for (let i = 0; i < count; i++) colors[i] = colorOf.get(values[i] * scale + offset) ?? 0xff808080;
      return;
    }
    const { low, high, table } = this.range, perStep = high > low ? 255 / (high - low) : 0, hides = this.hidesRest;
    for (let i = 0; i < count; i++) {
      const v = values[i] * scale + offset, t = perStep ? (v - low) * perStep : 127;
      colors[i] = hides && !(v >= low && v <= high) ? 0 : table[t > 255 ? 255 : t > 0 ? t | 0 : 0];
    }
  }

  /** What differs from the page as it is opened, for a link. */
  toParameters(parameters) {
    if (this.mode !== this.data.mode) parameters.set("color", this.name);
    if (this.hidden.size) parameters.set("hide", [...this.hidden].join());
    const range = this.ranges.get(this.mode), first = this.mode === elevationMode ? this.data.elevation
      : [this.column?.low, this.column?.high];
    if (range && (range.low !== first[0] || range.high !== first[1])) parameters.set("range", range.low + "," + range.high);
    if (this.hidesRest) parameters.set("rest", "hidden");
  }

  fromParameters(parameters) {
    const named = this.modes.find(m => m.name === parameters.get("color"));
    this.setMode(named ? named.id : this.modes.some(m => m.id === this.data.mode) ? this.data.mode : elevationMode);
    if (this.isCategory && parameters.get("hide")) parameters.get("hide").split(",").forEach(v => this.hidden.add(Number(v)));
    const [low, high] = (parameters.get("range") ?? "").split(",").map(Number);
    if (this.range && high >= low) Object.assign(this.range, { low, high });
    this.hidesRest = !!this.range && parameters.get("rest") === "hidden";
  }
}
