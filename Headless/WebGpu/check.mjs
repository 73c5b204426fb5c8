// Makes WGSL of SPIR-V by naga and has Tint, the compiler of Chrome's WebGPU, take it, without a card: with the limits that every
// WebGPU has. Arguments: files, whose last extension but one is the stage (7.vert.spv). For each a line: its name, a tab, what is
// wrong; nothing where all is well.
import { readFileSync } from 'node:fs';
import { parseSpirv, validate, writeWgsl } from 'naga-wasm';
import { create } from 'webgpu';

// Named, since what is collected takes the device with it.
const gpu = create(['backend=null']);
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();

function wgslOf(file) {
  const module = parseSpirv(readFileSync(file));
  return writeWgsl(module, validate(module));
}

// A pipeline as well, since it is what limits are held against. A vertex shader may be alone in one.
function makePipeline(stage, module) {
  if (stage === 'comp') device.createComputePipeline({ layout: 'auto', compute: { module } });
  if (stage === 'vert') {
    const depthStencil = { format: 'depth32float', depthWriteEnabled: true, depthCompare: 'always' };
    device.createRenderPipeline({ layout: 'auto', vertex: { module }, depthStencil });
  }
}

async function faultOf(file) {
  try {
    device.pushErrorScope('validation');
    const module = device.createShaderModule({ code: wgslOf(file) });
    const said = [...(await module.getCompilationInfo()).messages].filter(m => m.type !== 'info').map(m => m.message);
    makePipeline(file.split('.').at(-2), module);
    const error = await device.popErrorScope();
    return [...said, ...(error ? [error.message] : [])].join(' ');
  } catch (error) {
    return error.formatted ?? String(error);
  }
}

for (const file of process.argv.slice(2)) {
  const fault = await faultOf(file);
  console.log(`${file.split('/').at(-1)}\t${fault.replace(/\s+/g, ' ').trim()}`);
}
process.exit(0);
