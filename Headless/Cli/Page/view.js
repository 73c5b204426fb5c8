// The 3D view of a page. Plain WebGL 2 without a library: a page is one file, and has to work without a network in ten years.
"use strict";
(async () => {
  const $ = id => document.getElementById(id);
  const data = JSON.parse($("view-data").textContent);
  const canvas = $("view"), stage = $("view-stage"), say = text => { $("view-status").textContent = text; };
  const still = text => { stage.classList.add("still"); say(text + ": the picture above stands in for the 3D view."); };
  const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
  if (!gl || !window.DecompressionStream) return still("This browser draws no WebGL 2");

  // ---- Points: 16 bits a coordinate, 8 bits an attribute, each column as differences from point to point, low and high bytes
  // apart, because that is what deflate makes least of.
  async function inflate(base64) {
    const text = atob(base64), bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  async function unpack(set) {
    const n = set.count, bytes = await inflate(set.data), positions = new Uint16Array(4 * n), columns = [];
    let at = 0;
    for (let axis = 0; axis < 3; axis++, at += 2 * n)
      for (let i = 0, v = 0; i < n; i++)
        positions[4 * i + axis] = v = (v + (bytes[at + i] | bytes[at + n + i] << 8)) & 65535;
    for (const column of data.columns) {
      const values = new Uint8Array(column.planes * n);
      for (let plane = 0; plane < column.planes; plane++, at += n)
        for (let i = 0, v = 0; i < n; i++) values[plane * n + i] = v = (v + bytes[at + i]) & 255;
      columns.push(values);
    }
    return { count: n, positions, columns };
  }

  let sets;
  try {
    sets = await Promise.all(data.sets.map(unpack));
  } catch {
    return still("The points of this page cannot be read");
  }

  // ---- Colours: found here once for all points of a mode, so that the shaders know nothing of attributes.
  const tables = {};
  for (const name in data.ramps) tables[name] = data.ramps[name].match(/.{6}/g).map(rgb);
  function rgb(hex) {
    return 0xff000000 | parseInt(hex.slice(4, 6), 16) << 16 | parseInt(hex.slice(2, 4), 16) << 8 | parseInt(hex.slice(0, 2), 16);
  }
  const css = color => "#" + [0, 8, 16].map(s => (color >> s & 255).toString(16).padStart(2, "0")).join("");
  const hidden = new Set();   // Values of the category that is shown.
  let mode = data.mode;       // A column, or -1 for elevation.

  function colorsOf(set) {
    const colors = new Uint32Array(set.count), n = set.count, column = data.columns[mode], values = set.columns[mode];
    if (mode < 0) {
      const axis = data.up, sign = data.axes[2][axis], table = tables.viridis;
      const scale = sign * data.size[axis] / 65535, low = data.elevation[0] - sign * data.origin[axis];
      const span = data.elevation[1] - data.elevation[0], perStep = span > 0 ? 255 / span : 0;
      for (let i = 0; i < n; i++) {
        const t = perStep ? (set.positions[4 * i + axis] * scale - low) * perStep : 127;
        colors[i] = table[t > 255 ? 255 : t > 0 ? t | 0 : 0];
      }
    } else if (column.kind === "rgb")
      for (let i = 0; i < n; i++) colors[i] = 0xff000000 | values[2 * n + i] << 16 | values[n + i] << 8 | values[i];
    else {
      const table = column.kind === "category" ? column.colors.map((c, i) => hidden.has(i) ? 0 : rgb(c)) : tables[column.ramp];
      for (let i = 0; i < n; i++) colors[i] = table[values[i]];
    }
    return colors;
  }

  // ---- Drawing: points into a texture with depth, then a pass that darkens what lies behind a near edge (eye-dome lighting:
  // Boucheny 2009), by which shapes can be read without normals.
  const pointShader = `#version 300 es
    uniform mat4 toClip; uniform float size, least; in vec3 position; in vec4 color; out vec3 shown;
    void main() {
      gl_Position = color.a > 0. ? toClip * vec4(position, 1) : vec4(2, 2, 2, 1);
      gl_PointSize = clamp(size / gl_Position.w, least, 48.);
      shown = color.rgb;
    }`;
  const fragmentShader = `#version 300 es
    precision highp float; in vec3 shown; out vec4 color;
    void main() { vec2 p = gl_PointCoord - .5; if (dot(p, p) > .25) discard; color = vec4(shown, 1); }`;
  const screenShader = `#version 300 es
    void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;
  const shadeShader = `#version 300 es
    precision highp float; uniform sampler2D colors; uniform highp sampler2D depths;
    uniform vec2 range; uniform float strength, radius, isFlat; uniform vec3 background; out vec4 color;
    float distanceAt(ivec2 at) {
      float d = texelFetch(depths, clamp(at, ivec2(0), textureSize(depths, 0) - 1), 0).r;
      float z = 2. * d - 1.;
      return isFlat > 0. ? range.x + d * (range.y - range.x)
        : 2. * range.x * range.y / (range.y + range.x - z * (range.y - range.x));
    }
    void main() {
      ivec2 at = ivec2(gl_FragCoord.xy);
      if (texelFetch(depths, at, 0).r == 1.) { color = vec4(background, 1); return; }
      float here = log2(distanceAt(at)), behind = 0.;
      for (int i = 0; i < 8; i++) {
        float a = float(i) * 0.785398;
        behind += clamp(here - log2(distanceAt(at + ivec2(round(radius * vec2(cos(a), sin(a)))))), 0., .06);
      }
      color = vec4(texelFetch(colors, at, 0).rgb * exp(-strength * behind), 1);
    }`;

  function program(vertex, fragment) {
    const made = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
    }
    gl.bindAttribLocation(made, 0, "position");
    gl.bindAttribLocation(made, 1, "color");
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error("a shader of the view does not compile");
    return new Proxy(made, { get: (of, name) => name === "program" ? of : gl.getUniformLocation(of, name) });
  }

  let points, shade, target = null, width = 0, height = 0;
  try {
    [points, shade] = [program(pointShader, fragmentShader), program(screenShader, shadeShader)];
  } catch {
    return still("This browser cannot compile the 3D view");
  }
  for (const set of sets) {
    set.array = gl.createVertexArray();
    gl.bindVertexArray(set.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, set.positions, gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.UNSIGNED_SHORT, true, 8, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, set.colorBuffer = gl.createBuffer());
    gl.enableVertexAttribArray(1);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 4, 0);
  }

  function recolor() {
    for (const set of sets) {
      gl.bindBuffer(gl.ARRAY_BUFFER, set.colorBuffer);
      gl.bufferData(gl.ARRAY_BUFFER, colorsOf(set), gl.STATIC_DRAW);
    }
    redraw();
  }

  // ---- The camera: around a target, upright. Lengths are the file's units from the middle of the bounds (metres for degrees):
  // small numbers, which single precision holds.
  const [east, north, up] = data.axes;
  const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const extent = [0, 1, 2].map(k => data.size[k] * data.lengths[k]);
  const reach = Math.max(Math.hypot(...extent) / 2, Math.hypot(...data.camera.eye) / 100) || 1;
  // What the command line frames for 16 to 9 is to be seen in narrower views, too.
  const tan = () => camera.tan * Math.max(1, 16 / 9 * height / width);
  const camera = { target: [0, 0, 0], yaw: 0, pitch: 0.6, distance: 2 * reach, tan: Math.tan(Math.PI / 8), isFlat: false };
  let frame = 0, sizeFactor = 1, isShaded = false, wave = data.waves.length - 1;

  /** Takes over a camera as the command line has it. */
  function look(from) {
    const f = from.forward, isDown = Math.abs(dot(f, up)) > 0.999, ahead = isDown ? from.up : f;
    camera.yaw = Math.atan2(dot(ahead, east), dot(ahead, north));
    camera.pitch = isDown ? -Math.sign(dot(f, up)) * Math.PI / 2 : Math.asin(Math.max(-1, Math.min(1, -dot(f, up))));
    camera.isFlat = from.height > 0;
    camera.tan = from.fov > 0 ? Math.tan(from.fov / 2) : Math.tan(Math.PI / 8);
    const ahead0 = Math.max(-dot(from.eye, f), reach / 50);
    camera.distance = camera.isFlat ? from.height / 2 / camera.tan : ahead0;
    camera.target = add(from.eye, f, ahead0);
    redraw();
  }

  function axes() {
    const cy = Math.cos(camera.yaw), sy = Math.sin(camera.yaw), cp = Math.cos(camera.pitch), sp = Math.sin(camera.pitch);
    const right = add(east.map(v => v * cy), north, -sy);
    const forward = add(add(east.map(v => v * sy * cp), north, cy * cp), up, -sp);
    return { right, forward, above: cross(right, forward) };
  }

  /** From a place in the bounds (0 to 1) to clip space, by columns; in doubles, for picking too. */
  function projection() {
    const { right, forward, above } = axes(), far = camera.distance + reach + Math.hypot(...camera.target);
    const near = camera.isFlat ? 2 * camera.distance - far : Math.max(camera.distance - (far - camera.distance), far * 2e-4);
    const y = 1 / tan(), x = y * height / width, d = camera.distance, span = far - near;
    const rows = camera.isFlat
      ? [[right, x / d, 0], [above, y / d, 0], [forward, 2 / span, -(far + near) / span], [forward, 0, 1]]
      : [[right, x, 0], [above, y, 0], [forward, (far + near) / span, -2 * far * near / span], [forward, 1, 0]];
    const eye = add(camera.target, forward, -d), m = new Float64Array(16);
    rows.forEach(([axis, scale, shift], r) => {
      let constant = shift;
      for (let k = 0; k < 3; k++) {
        m[4 * k + r] = axis[k] * scale * extent[k];
        constant -= axis[k] * scale * (eye[k] + extent[k] / 2);
      }
      m[12 + r] = constant;
    });
    return { m, near, far };
  }

  function resize() {
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (target && canvas.width === width && canvas.height === height) return;
    [canvas.width, canvas.height] = [width, height];
    if (target) target.forEach(t => gl.deleteTexture(t));
    target = [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].map(([format, place]) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture, 0);
      return texture;
    });
  }
  const framebuffer = gl.createFramebuffer(), background = [24 / 255, 26 / 255, 30 / 255];

  const shownWave = () => data.waves[wave] ?? { set: 0, shown: sets[0].count };

  function draw() {
    frame = 0;
    resize();
    const { m, near, far } = projection(), { set: number, shown: count } = shownWave(), set = sets[number];
    // Points are as large as their distance from one another, which grows where fewer are shown.
    const world = data.spacing * sizeFactor * Math.sqrt(sets[sets.length - 1].count / Math.max(1, count));
    const perLength = height / 2 / tan() / (camera.isFlat ? camera.distance : 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.viewport(0, 0, width, height);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(...background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(points.program);
    gl.uniformMatrix4fv(points.toClip, false, new Float32Array(m));
    gl.uniform1f(points.size, world * perLength);
    const least = Math.max(1, Math.min(12, 200 / Math.sqrt(count))) * Math.max(1, sizeFactor);
    gl.uniform1f(points.least, least * Math.min(window.devicePixelRatio || 1, 2));
    gl.bindVertexArray(set.array);
    gl.drawArrays(gl.POINTS, 0, count);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(shade.program);
    target.forEach((texture, i) => { gl.activeTexture(gl.TEXTURE0 + i); gl.bindTexture(gl.TEXTURE_2D, texture); });
    gl.uniform1i(shade.colors, 0);
    gl.uniform1i(shade.depths, 1);
    gl.uniform2f(shade.range, near, far);
    gl.uniform1f(shade.isFlat, camera.isFlat ? 1 : 0);
    gl.uniform1f(shade.strength, isShaded ? 4 : 0);
    gl.uniform1f(shade.radius, 1.5 * Math.min(window.devicePixelRatio || 1, 2));
    gl.uniform3fv(shade.background, background);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    drawMarks(m);
    canvas.dataset.frames = 1 + Number(canvas.dataset.frames || 0);
  }
  function redraw() { if (!frame) frame = requestAnimationFrame(draw); }

  // ---- Measuring: the front point near the pointer, by projecting all of them; its coordinates are the file's, in doubles.
  let measuring = false, picked = [];
  const project = (m, p) => {
    const w = m[3] * p[0] + m[7] * p[1] + m[11] * p[2] + m[15];
    return [(m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12]) / w, (m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13]) / w,
      (m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14]) / w, w];
  };
  const isSeen = p => p[3] > 0 && p[2] > -1 && p[2] < 1;
  function pick(x, y) {
    const { m } = projection(), { set: number, shown: count } = shownWave(), set = sets[number];
    const w = canvas.clientWidth / 2, h = canvas.clientHeight / 2, p = [0, 0, 0];
    let found = -1, depth = Infinity;
    for (let i = 0; i < count; i++) {
      for (let k = 0; k < 3; k++) p[k] = set.positions[4 * i + k] / 65535;
      const at = project(m, p);
      if (!isSeen(at) || at[2] >= depth || Math.hypot((at[0] + 1) * w - x, (1 - at[1]) * h - y) > 6) continue;
      if (hidden.size && hidden.has(set.columns[mode][i])) continue;
      found = i;
      depth = at[2];
    }
    if (found < 0) return say("No point there.");
    const place = [0, 1, 2].map(k => set.positions[4 * found + k] / 65535);
    if (picked.length === 2) picked = [];
    picked.push({ place, geo: place.map((v, k) => data.origin[k] + v * data.size[k]) });
    describe(set, found);
    redraw();
  }

  const fixed = v => v.toLocaleString("en", { minimumFractionDigits: data.decimals, maximumFractionDigits: data.decimals });
  const between = (a, b) => a.geo.map((v, k) => (b.geo[k] - v) * data.lengths[k]);
  function describe(set, index) {
    const rows = picked.map((p, i) => ["AB"[i], p.geo.map((v, k) => "xyz"[k] + " " + fixed(v)).join("  ")]);
    if (picked.length === 2) {
      const d = between(...picked), rise = dot(d, up);
      rows.push(["distance", fixed(Math.hypot(...d)) + " " + data.unit]);
      rows.push(["level", fixed(Math.sqrt(Math.max(0, dot(d, d) - rise * rise))) + " " + data.unit]);
      rows.push(["rise", fixed(rise) + " " + data.unit]);
    } else {
      data.columns.forEach((c, k) => {
        const v = set.columns[k][index], n = set.count;
        rows.push([c.name, c.kind === "rgb" ? [v, set.columns[k][n + index], set.columns[k][2 * n + index]].join(" ")
          : c.kind === "category" ? c.names[v] : "about " + Number((c.low + (c.high - c.low) * v / 255).toPrecision(4))]);
      });
    }
    $("view-measured").replaceChildren(...rows.flatMap(row => row.map((text, i) =>
      Object.assign(document.createElement(i ? "dd" : "dt"), { textContent: text }))));
    say(picked.length === 1 ? "Point A is set; choose another point." : "Distance " + rows[2][1] + ".");
  }

  function drawMarks(m) {
    const w = canvas.clientWidth / 2, h = canvas.clientHeight / 2;
    const at = picked.map(p => project(m, p.place)).filter(isSeen).map(p => [(p[0] + 1) * w, (1 - p[1]) * h]);
    let svg = at.length === 2 ? `<path d="M${at[0]}L${at[1]}"/>` : "";
    at.forEach(([x, y], i) => { svg += `<circle cx="${x}" cy="${y}" r="5"/><text x="${x + 9}" y="${y - 7}">${"AB"[i]}</text>`; });
    if (measuring) svg += `<path class="cross" d="M${w - 8} ${h}h16M${w} ${h - 8}v16"/>`;
    $("view-marks").innerHTML = svg;
  }

  function setMeasuring(on) {
    $("view-measure").setAttribute("aria-pressed", measuring = on);
    canvas.classList.toggle("picks", on);
    if (!on) { picked = []; $("view-measured").replaceChildren(); }
    say(on ? "Click a point, or turn it under the cross and press Enter." : "");
    redraw();
  }

  // ---- Input: one pointer turns (shifted or by another button: moves), two pinch. The wheel zooms once the view was clicked, so
  // that a reader scrolls past it.
  const pointers = new Map();
  let moved = 0;
  const turn = (dx, dy) => {
    camera.yaw += dx;
    camera.pitch = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, camera.pitch + dy));
    redraw();
  };
  const pan = (dx, dy) => {
    const { right, above } = axes(), scale = 2 * tan() * camera.distance / canvas.clientHeight;
    camera.target = add(add(camera.target, right, -dx * scale), above, dy * scale);
    redraw();
  };
  const zoom = by => { camera.distance = Math.max(reach * 1e-4, Math.min(reach * 50, camera.distance * by)); redraw(); };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
  };
  canvas.addEventListener("pointerdown", e => {
    if (data.path) stop();
    canvas.setPointerCapture(e.pointerId);
    pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    moved = pointers.size > 1 ? 99 : 0;
  });
  canvas.addEventListener("pointermove", e => {
    const before = pointers.get(e.pointerId);
    if (!before) return;
    const two = pointers.size === 2 ? spread() : null, dx = e.offsetX - before.x, dy = e.offsetY - before.y;
    pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    moved += Math.abs(dx) + Math.abs(dy);
    if (two) {
      const now = spread();
      zoom(two.apart / Math.max(1, now.apart));
      pan(now.x - two.x, now.y - two.y);
    } else if (e.shiftKey || e.buttons & 6) pan(dx, dy);
    else turn(dx * 0.006, dy * 0.006);
  });
  for (const type of ["pointerup", "pointercancel"])
    canvas.addEventListener(type, e => {
      if (pointers.delete(e.pointerId) && type === "pointerup" && measuring && moved < 5) pick(e.offsetX, e.offsetY);
    });
  canvas.addEventListener("contextmenu", e => e.preventDefault());
  canvas.addEventListener("wheel", e => {
    if (document.activeElement !== canvas && !document.fullscreenElement) return;
    e.preventDefault();
    zoom(Math.exp(Math.max(-1, Math.min(1, e.deltaY / 400))));
  }, { passive: false });

  const views = {
    home: () => look(data.camera),
    top: () => fit(0, Math.PI / 2),
    front: () => fit(0, 0), side: () => fit(-Math.PI / 2, 0),
  };
  /** All of the bounds, without perspective: plans and elevations that can be measured on. */
  function fit(yaw, pitch) {
    resize();
    Object.assign(camera, { yaw, pitch });
    const { right, above } = axes(), span = axis => extent.reduce((sum, v, k) => sum + Math.abs(v * axis[k]), 0);
    camera.isFlat = true;
    camera.target = [0, 0, 0];
    camera.distance = 1.04 * Math.max(span(above), span(right) * height / width, reach * 1e-3) / 2 / tan();
    redraw();
  }
  for (const name in views) $("view-" + name).addEventListener("click", () => { if (data.path) stop(); views[name](); });
  canvas.addEventListener("keydown", e => {
    const key = e.key, step = 0.1, move = canvas.clientHeight / 12;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (arrows[key]) e.shiftKey ? pan(-arrows[key][0] * move, -arrows[key][1] * move)
      : turn(arrows[key][0] * step, arrows[key][1] * step);
    else if (key === "+" || key === "=") zoom(0.8);
    else if (key === "-") zoom(1.25);
    else if (key === "Home" || key === "h") views.home();
    else if (key === "t" || key === "f" || key === "s") views[{ t: "top", f: "front", s: "side" }[key]]();
    else if (key === "m") setMeasuring(!measuring);
    else if (key === "Escape" && measuring) setMeasuring(false);
    else if (key === "Enter" && measuring) pick(canvas.clientWidth / 2, canvas.clientHeight / 2);
    else return;
    e.preventDefault();
  });

  // ---- What to colour by, and its legend.
  const short = v => Math.abs(v) >= 1e5 || v !== 0 && Math.abs(v) < 1e-3 ? Number(v.toPrecision(6)).toLocaleString("en")
    : Number(v.toPrecision(5)).toLocaleString("en", { maximumFractionDigits: 6 });
  function legend() {
    const list = $("view-legend"), column = data.columns[mode];
    list.replaceChildren();
    if (column?.kind === "rgb") return;
    if (column?.kind === "category")
      return column.names.forEach((name, i) => {
        if (!column.counts[i]) return;
        const button = document.createElement("button"), swatch = document.createElement("i");
        swatch.style.background = "#" + column.colors[i];
        button.append(swatch, name);
        button.title = column.counts[i].toLocaleString("en") + " of the points here";
        button.setAttribute("aria-pressed", !hidden.has(i));
        button.addEventListener("click", () => {
          if (!hidden.delete(i)) hidden.add(i);
          button.setAttribute("aria-pressed", !hidden.has(i));
          recolor();
        });
        list.append(button);
      });
    const bar = document.createElement("b"), [low, high] = mode < 0 ? data.elevation : [column.low, column.high];
    const table = tables[mode < 0 ? "viridis" : column.ramp];
    bar.style.background = "linear-gradient(90deg," + [0, 51, 102, 153, 204, 255].map(i => css(table[i])).join() + ")";
    list.append(short(low), bar, short(high) + (mode < 0 ? " " + data.unit : ""));
  }
  const choice = $("view-color");
  choice.append(...["Elevation", ...data.columns.map(c => c.name)].map((name, i) => new Option(name, i - 1)));
  choice.value = mode;
  choice.addEventListener("change", () => {
    mode = Number(choice.value);
    hidden.clear();
    // The file's own colours have light in them already.
    setShaded(data.columns[mode]?.kind !== "rgb");
    legend();
    recolor();
  });
  function setShaded(on) {
    $("view-shade").setAttribute("aria-pressed", isShaded = on);
    redraw();
  }
  $("view-shade").addEventListener("click", () => setShaded(!isShaded));
  $("view-measure").addEventListener("click", () => { setMeasuring(!measuring); canvas.focus(); });
  $("view-size").addEventListener("input", e => { sizeFactor = 2 ** Number(e.target.value); redraw(); });
  $("view-full").addEventListener("click", () =>
    document.fullscreenElement ? document.exitFullscreen() : $("view-figure").requestFullscreen());
  $("view-save").addEventListener("click", () => canvas.toBlob(blob => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = document.title.replace(/[^\w.-]+/g, "-") + ".png";
    link.click();
    URL.revokeObjectURL(link.href);
  }));

  // ---- Playing: the waves of a preview, or a flight along its path; both are a slider with steps.
  const time = $("view-time"), steps = data.path ? data.path.cameras.length : data.waves.length;
  let timer = 0;
  function show(step) {
    time.value = step;
    if (data.path) look(data.path.cameras[step]);
    else wave = step;
    const text = data.path ? "frame " + step * data.path.every : data.waves[step].text;
    $("view-time-text").textContent = text;
    time.setAttribute("aria-valuetext", text);
    document.querySelectorAll("#error-chart .mark").forEach((mark, i) => mark.classList.toggle("now", i === step));
    redraw();
  }
  function stop() {
    timer = clearInterval(timer);
    $("view-play").textContent = "▶ Play";
  }
  $("view-play").addEventListener("click", () => {
    if (timer) return stop();
    let step = Number(time.value) + 1 < steps ? Number(time.value) + (data.path ? 1 : 0) : 0;
    $("view-play").textContent = "❚❚ Pause";
    show(step);
    timer = setInterval(() => {
      if (++step >= steps) return stop();
      show(step);
    }, data.path ? 1000 / 60 * data.path.every : 900);
  });
  time.addEventListener("input", () => { stop(); show(Number(time.value)); });
  time.max = steps - 1;
  $("view-player").hidden = steps < 2;

  canvas.addEventListener("webglcontextlost", () => still("The graphics card was lost (reload the page)"));
  new ResizeObserver(redraw).observe(canvas);
  stage.classList.add("live");
  $("view-tools").disabled = false;
  setShaded(data.shaded);
  legend();
  if (steps > 1) show(data.path ? 0 : steps - 1);
  if (!data.path) look(data.camera);
  recolor();
})();
