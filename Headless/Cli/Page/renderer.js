// Draws points by WebGL 2: into a texture with depth, then a pass that darkens what lies behind a near edge (eye-dome lighting:
// Boucheny 2009), and lights where colours are not the scanner's, as FastPoints.Picture.DepthNormals does. No library: a page has to work without a network in ten years.
"use strict";

const pointShader = `#version 300 es
  uniform mat4 toClip; uniform float size, least, most; uniform vec3 low, high; in vec3 position; in vec4 color; out vec4 shown;
  void main() {
    bool isShown = color.a > 0. && all(greaterThanEqual(position, low)) && all(lessThanEqual(position, high));
    gl_Position = isShown ? toClip * vec4(position, 1) : vec4(2, 2, 2, 1);
    gl_PointSize = clamp(size / gl_Position.w, least, most);
    shown = vec4(color.rgb, max(1., gl_PointSize / 2.) / 255.);
  }`;
const fragmentShader = `#version 300 es
  precision highp float; in vec4 shown; out vec4 color;
  void main() { vec2 p = gl_PointCoord - .5; if (dot(p, p) > .25) discard; color = shown; }`;
const screenShader = `#version 300 es
  void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;
const shadeShader = `#version 300 es
  precision highp float; uniform sampler2D colors; uniform highp sampler2D depths;
  uniform vec2 range, perPixel; uniform float strength, radius, isFlat, share; uniform vec3 background, light, up; out vec4 color;
  float distanceAt(ivec2 at) {
    float d = texelFetch(depths, clamp(at, ivec2(0), textureSize(depths, 0) - 1), 0).r;
    float z = 2. * d - 1.;
    return isFlat > 0. ? range.x + d * (range.y - range.x)
      : 2. * range.x * range.y / (range.y + range.x - z * (range.y - range.x));
  }
  vec3 placeOf(ivec2 at) {
    float d = distanceAt(at);
    return vec3((vec2(at) + .5 - .5 * vec2(textureSize(depths, 0))) * perPixel * (isFlat > 0. ? 1. : d), -d);
  }
  vec3 along(ivec2 at, ivec2 step, vec3 here, float edge) {
    vec3 sum = vec3(0);
    for (int side = 1; side >= -1; side -= 2) {
      ivec2 there = at + side * step;
      if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, textureSize(depths, 0))) ||
        texelFetch(depths, there, 0).r == 1.) continue;
      vec3 way = placeOf(there) - here;
      sum += way * float(side) / (edge * edge + way.z * way.z);
    }
    return sum * edge * edge;
  }
  vec3 lit(vec3 shown, ivec2 at, int apart) {
    vec3 here = placeOf(at);
    float edge = float(apart) * perPixel.y * (isFlat > 0. ? 1. : -here.z);
    vec3 n = cross(along(at, ivec2(apart, 0), here, edge), along(at, ivec2(0, apart), here, edge));
    n = dot(n, n) > 0. ? normalize(n) : vec3(0);
    n = dot(n, isFlat > 0. ? vec3(0, 0, -1) : here) > 0. ? -n : n;
    float on = dot(n, n) > 0. ? max(0., dot(n, light)) : .5;
    vec3 linear = pow(shown, vec3(2.2)) * (1. - share + share * (.175 + .075 * dot(n, up) + 1.06 * on));
    return pow(min(linear, 1.), vec3(1. / 2.2));
  }
  void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    if (texelFetch(depths, at, 0).r == 1.) { color = vec4(background, 1); return; }
    float here = log2(distanceAt(at)), behind = 0.;
    for (int i = 0; strength > 0. && i < 8; i++) {
      float a = float(i) * 0.785398;
      behind += clamp(here - log2(distanceAt(at + ivec2(round(radius * vec2(cos(a), sin(a)))))), 0., .06);
    }
    vec4 shown = texelFetch(colors, at, 0);
    if (share > 0.) shown.rgb = lit(shown.rgb, at, int(round(shown.a * 255.)));
    color = vec4(shown.rgb * exp(-strength * behind), 1);
  }`;

class Renderer {
  /** Points of a scattered cloud are dots, not discs, until one comes near. In pixels of the page. */
  static mostAtHomePx = 5;
  static mostPx = 48;

  constructor(canvas, data, sets) {
    const gl = this.gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) return;
    Object.assign(this, { canvas, data, sets, target: null, framebuffer: gl.createFramebuffer() });
    this.points = this.program(pointShader, fragmentShader);
    this.shade = this.program(screenShader, shadeShader);
    for (const set of sets) {
      set.array = gl.createVertexArray();
      gl.bindVertexArray(set.array);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, set.places, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(0);
      gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 12, 0);
      gl.bindBuffer(gl.ARRAY_BUFFER, set.colorBuffer = gl.createBuffer());
      gl.enableVertexAttribArray(1);
      gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 4, 0);
    }
  }

  program(vertex, fragment) {
    const gl = this.gl, made = gl.createProgram();
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
    const places = { program: made };
    for (let i = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS) - 1; i >= 0; i--) {
      const { name } = gl.getActiveUniform(made, i);
      places[name] = gl.getUniformLocation(made, name);
    }
    return places;
  }

  setColors() {
    const gl = this.gl;
    for (const set of this.sets) {
      gl.bindBuffer(gl.ARRAY_BUFFER, set.colorBuffer);
      gl.bufferData(gl.ARRAY_BUFFER, set.colors, gl.STATIC_DRAW);
    }
  }

  get ratio() { return Math.min(window.devicePixelRatio || 1, 2); }

  resize(camera) {
    const gl = this.gl, canvas = this.canvas;
    const width = Math.max(1, Math.round(canvas.clientWidth * this.ratio));
    const height = Math.max(1, Math.round(canvas.clientHeight * this.ratio));
    Object.assign(camera, { width, height });
    if (this.target && canvas.width === width && canvas.height === height) return;
    [canvas.width, canvas.height] = [width, height];
    if (this.target) this.target.forEach(t => gl.deleteTexture(t));
    const parts = [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]];
    this.target = parts.map(([format, place]) => {
      const texture = gl.createTexture();
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, place, gl.TEXTURE_2D, texture, 0);
      return texture;
    });
  }

  /** Of a set's first points; the box is in places. */
  draw(camera, set, count, { sizeFactor, isShaded, isLit, box }) {
    const { gl, points, shade, data, sets, ratio } = this, background = [24 / 255, 26 / 255, 30 / 255];
    const { m, near, far } = camera.projection();
    // Points are as large as their distance from one another, which grows where fewer are shown.
    const world = data.spacing * sizeFactor * Math.sqrt(sets[sets.length - 1].count / Math.max(1, count));
    const perLength = camera.height / 2 / camera.tan / (camera.isFlat ? camera.distance : 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, camera.width, camera.height);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(...background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(points.program);
    gl.uniformMatrix4fv(points.toClip, false, new Float32Array(m));
    gl.uniform1f(points.size, world * perLength);
    gl.uniform1f(points.least, Math.max(1, Math.min(Renderer.mostAtHomePx, 100 / Math.sqrt(count))) * Math.max(1, sizeFactor) * ratio);
    const near0 = Math.max(1, 2.5 * camera.reach / camera.distance);
    gl.uniform1f(points.most, Math.min(Renderer.mostPx, Renderer.mostAtHomePx * near0 * Math.max(1, sizeFactor)) * ratio);
    gl.uniform3fv(points.low, box ? box.low : [-1, -1, -1]);
    gl.uniform3fv(points.high, box ? box.high : [2, 2, 2]);
    gl.bindVertexArray(set.array);
    gl.drawArrays(gl.POINTS, 0, count);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(shade.program);
    this.target.forEach((texture, i) => { gl.activeTexture(gl.TEXTURE0 + i); gl.bindTexture(gl.TEXTURE_2D, texture); });
    gl.uniform1i(shade.colors, 0);
    gl.uniform1i(shade.depths, 1);
    gl.uniform2f(shade.range, near, far);
    gl.uniform1f(shade.isFlat, camera.isFlat ? 1 : 0);
    gl.uniform1f(shade.strength, isShaded ? 4 : 0);
    gl.uniform1f(shade.radius, 1.5 * ratio);
    gl.uniform3fv(shade.background, background);
    const { light, up } = camera.light();
    gl.uniform1f(shade.share, isLit ? 0.7 : 0);
    gl.uniform2f(shade.perPixel, 1 / perLength, 1 / perLength);
    gl.uniform3fv(shade.light, light);
    gl.uniform3fv(shade.up, up);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
