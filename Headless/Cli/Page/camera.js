// The camera of the 3D view: around a target, upright. Lengths are the file's units from the middle of the bounds (metres for
// degrees): small numbers, which single precision holds.
"use strict";

const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

class Camera {
  constructor(data) {
    [this.east, this.north, this.up] = data.axes;
    this.extent = [0, 1, 2].map(k => data.size[k] * data.lengths[k]);
    this.reach = Math.max(Math.hypot(...this.extent) / 2, Math.hypot(...data.camera.eye) / 100) || 1;
    Object.assign(this, { target: [0, 0, 0], yaw: 0, pitch: 0.6, distance: 2 * this.reach, tangent: Math.tan(Math.PI / 8),
      isFlat: false, width: 16, height: 9 });
  }

  /** What the command line frames for 16 to 9 is to be seen in narrower views, too. */
  get tan() { return this.tangent * Math.max(1, 16 / 9 * this.height / this.width); }

  /** Takes over a camera as the command line has it. */
  look(from) {
    const f = from.forward, isDown = Math.abs(dot(f, this.up)) > 0.999, ahead = isDown ? from.up : f;
    this.yaw = Math.atan2(dot(ahead, this.east), dot(ahead, this.north));
    this.pitch = isDown ? -Math.sign(dot(f, this.up)) * Math.PI / 2 : Math.asin(Math.max(-1, Math.min(1, -dot(f, this.up))));
    this.isFlat = from.height > 0;
    this.tangent = from.fov > 0 ? Math.tan(from.fov / 2) : Math.tan(Math.PI / 8);
    const distance = Math.max(-dot(from.eye, f), this.reach / 50);
    this.distance = this.isFlat ? from.height / 2 / this.tangent : distance;
    this.target = add(from.eye, f, distance);
  }

  /** All of the bounds, without perspective: plans and elevations that can be measured on. */
  fit(yaw, pitch) {
    Object.assign(this, { yaw, pitch, isFlat: true, target: [0, 0, 0] });
    const { right, above } = this.axes();
    const span = axis => this.extent.reduce((sum, v, k) => sum + Math.abs(v * axis[k]), 0);
    this.distance = 1.04 * Math.max(span(above), span(right) * this.height / this.width, this.reach * 1e-3) / 2 / this.tan;
  }

  axes() {
    const cy = Math.cos(this.yaw), sy = Math.sin(this.yaw), cp = Math.cos(this.pitch), sp = Math.sin(this.pitch);
    const right = add(this.east.map(v => v * cy), this.north, -sy);
    const forward = add(add(this.east.map(v => v * sy * cp), this.north, cy * cp), this.up, -sp);
    return { right, forward, above: cross(right, forward) };
  }

  /** From the left and above, from behind the camera too, but of maps from their upper left; in right, above and behind of
   * the view, as the command line's pictures have it. */
  light() {
    const { right, forward, above } = this.axes(), back = add(forward, this.up, -dot(forward, this.up)), far = Math.hypot(...back);
    const from = add(far > 0.3 ? back.map(v => -0.6 * v / far) : above, right, -1), long = Math.hypot(...from) * Math.SQRT2;
    const seen = v => [dot(v, right), dot(v, above), -dot(v, forward)];
    return { light: seen(add(from.map(v => v / long), this.up, Math.SQRT1_2)), up: seen(this.up) };
  }

  turn(dx, dy) {
    this.yaw += dx;
    this.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.pitch + dy));
  }

  /** By pixels of a view that is so many high. */
  pan(dx, dy, heightPx) {
    const { right, above } = this.axes(), scale = 2 * this.tan * this.distance / heightPx;
    this.target = add(add(this.target, right, -dx * scale), above, dy * scale);
  }

  zoom(by) { this.distance = Math.max(this.reach * 1e-4, Math.min(this.reach * 50, this.distance * by)); }

  /** Pixels of a unit of length at the target's distance. */
  pxPerLength(heightPx) { return heightPx / 2 / this.tan / this.distance; }

  /** From a place in the bounds (0 to 1) to clip space, by columns; in doubles, for picking too. */
  projection() {
    const { right, forward, above } = this.axes(), d = this.distance, far = d + this.reach + Math.hypot(...this.target);
    const near = this.isFlat ? 2 * d - far : Math.max(2 * d - far, far * 2e-4);
    const y = 1 / this.tan, x = y * this.height / this.width, span = far - near;
    const rows = this.isFlat
      ? [[right, x / d, 0], [above, y / d, 0], [forward, 2 / span, -(far + near) / span], [forward, 0, 1]]
      : [[right, x, 0], [above, y, 0], [forward, (far + near) / span, -2 * far * near / span], [forward, 1, 0]];
    const eye = add(this.target, forward, -d), m = new Float64Array(16);
    rows.forEach(([axis, scale, shift], r) => {
      let constant = shift;
      for (let k = 0; k < 3; k++) {
        m[4 * k + r] = axis[k] * scale * this.extent[k];
        constant -= axis[k] * scale * (eye[k] + this.extent[k] / 2);
      }
      m[12 + r] = constant;
    });
    return { m, near, far };
  }

  /** A place in pixels from the upper left, and its depth; null where it is not before the camera. */
  project(m, p, widthPx, heightPx) {
    const w = m[3] * p[0] + m[7] * p[1] + m[11] * p[2] + m[15];
    const z = (m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]) / w;
    if (!(w > 0 && z > -1 && z < 1)) return null;
    return [((m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) / w + 1) * widthPx / 2,
      (1 - (m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) / w) * heightPx / 2, z];
  }

  toText() {
    return [this.yaw, this.pitch, this.distance, ...this.target, this.tangent].map(v => Number(v.toPrecision(8))).join()
      + (this.isFlat ? ",flat" : "");
  }

  fromText(text) {
    const values = text.split(",").slice(0, 7).map(Number);
    if (values.length < 7 || !values.every(Number.isFinite) || !(values[2] > 0) || !(values[6] > 0)) return;
    [this.yaw, this.pitch, this.distance] = values;
    this.target = values.slice(3, 6);
    this.tangent = values[6];
    this.isFlat = text.endsWith(",flat");
  }
}
