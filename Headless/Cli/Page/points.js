// The points of a page: every attribute with the file's own values. Each column is written as differences from one value to the
// next, those of small size as small numbers of no sign, byte by byte, because that is what deflate makes least of.
"use strict";

const columnTypes = { UInt8: Uint8Array, Int8: Int8Array, UInt16: Uint16Array, Int16: Int16Array, UInt32: Uint32Array,
  Int32: Int32Array, Float32: Float32Array, Float64: Float64Array };

async function inflate(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Places are from 0 to 1 in the bounds that are shown: what single precision can hold of any coordinates. */
async function unpackSet(data, set) {
  const n = set.count, bytes = await inflate(set.data), differences = set.differences[Symbol.iterator]();
  let at = 0;
  function column(description) {
    const Type = columnTypes[description.type], values = new Type(n), isDouble = Type === Float64Array;
    const words = values.BYTES_PER_ELEMENT < 4 ? values : new Int32Array(values.buffer);
    for (let number = 0; number < (isDouble ? 2 : 1); number++) {
      const [count, first, step] = differences.next().value, stride = isDouble ? 2 : 1;
      for (let i = 0, v = first; i < n; i++) {
        let difference = 0;
        for (let plane = 0; plane < count; plane++) difference |= bytes[at + plane * n + i] << 8 * plane;
        v = v + Math.imul(step, difference >>> 1 ^ -(difference & 1)) | 0;
        words[stride * i + number] = v;
      }
      at += count * n;
    }
    return values;
  }
  const positions = data.position.map(column), places = new Float32Array(3 * n);
  positions.forEach((values, axis) => {
    const { scale, offset } = data.position[axis], low = data.origin[axis], size = data.size[axis] || 1;
    for (let i = 0; i < n; i++) places[3 * i + axis] = (values[i] * scale + offset - low) / size;
  });
  return { count: n, positions, places, columns: data.columns.map(c => c.kind === "constant" ? null : column(c)),
    colors: new Uint32Array(n) };
}

const grouped = (v, decimals) => v.toLocaleString("en", { minimumFractionDigits: decimals, maximumFractionDigits: decimals });

/** A value as the file has it: in full. */
function exactText(description, stored) {
  if (description.type === "Float32" && description.scale === 1 && description.offset === 0)
    for (let digits = 6; digits <= 9; digits++) {
      const text = stored.toPrecision(digits);
      if (Math.fround(text) === stored) return String(Number(text));
    }
  const value = stored * description.scale + description.offset;
  return description.decimals === undefined ? String(value) : value.toFixed(description.decimals);
}

/** An end of a range: whole numbers as they are, others to a step. */
function endText(value, step) {
  const decimals = Number.isInteger(value) || !(step > 0) ? 0 : Math.max(0, Math.min(12, Math.ceil(-Math.log10(step))));
  return Math.abs(value) >= 1e15 ? value.toPrecision(6) : grouped(value, decimals);
}
