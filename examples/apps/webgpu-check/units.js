// SPDX-License-Identifier: MIT
// The texture unit of a WebGPU device: a compute shader makes one lookup per invocation.

export const MAX_ANISOTROPY = 8;

/** The adapter's device, or null with a reason. */
export async function openDevice() {
  if (!navigator.gpu) return { device: null, reason: "this browser has no WebGPU" };
  const adapter = await navigator.gpu.requestAdapter();
  if (!adapter) return { device: null, reason: "WebGPU has no adapter" };
  const info = adapter.info ?? {};
  const name = [info.vendor, info.architecture, info.device, info.description].filter(Boolean).join(" ");
  return { device: await adapter.requestDevice(), name: name || "a nameless adapter" };
}

const FORMATS = { rgba8: "rgba8unorm", rgba8_srgb: "rgba8unorm-srgb" };
const MODES = { repeat: "repeat", clamp: "clamp-to-edge", mirror: "mirror-repeat" };
const WORKGROUP = 64;

/** The texture with all of its levels, which are lists of bytes. */
function makeTexture(device, { format, width, height, levels }) {
  const texture = device.createTexture({
    size: [width, height], format: FORMATS[format], mipLevelCount: levels.length,
    usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
  });
  levels.forEach((bytes, mipLevel) => {
    const size = [Math.max(width >> mipLevel, 1), Math.max(height >> mipLevel, 1)];
    device.queue.writeTexture({ texture, mipLevel }, bytes, { bytesPerRow: 4 * size[0] }, size);
  });
  return texture;
}

/** Samplers of the filters. */
const FILTERS = {
  nearest: { magFilter: "nearest", minFilter: "nearest", lodMaxClamp: 0 },
  bilinear: { magFilter: "linear", minFilter: "linear", lodMaxClamp: 0 },
  "nearest-mip": { magFilter: "nearest", minFilter: "nearest", mipmapFilter: "nearest" },
  "bilinear-mip": { magFilter: "linear", minFilter: "linear", mipmapFilter: "nearest" },
  trilinear: { magFilter: "linear", minFilter: "linear", mipmapFilter: "linear" },
  anisotropic: { magFilter: "linear", minFilter: "linear", mipmapFilter: "linear", maxAnisotropy: MAX_ANISOTROPY },
};

/**
 * Faults that a unit can have, to see how shd-check explains them: other settings of the sampler, other coordinates, or
 * other results.
 */
export const FAULTS = {
  "clamp": { sampler: { addressModeU: "clamp-to-edge", addressModeV: "clamp-to-edge" } },
  "nearest": { sampler: { magFilter: "nearest", minFilter: "nearest", maxAnisotropy: 1 } },
  "half-texel": { lookup: "q.uv += 0.5 / vec2f(textureDimensions(image));" },
  "flip-v": { lookup: "q.uv.y = 1 - q.uv.y; q.dx.y = -q.dx.y; q.dy.y = -q.dy.y;" },
  "coarse": { lookup: "q.dx *= 2; q.dy *= 2; q.lod += 1;" },
  "bgra": { result: "c = c.bgra;" },
  "srgb-twice": { result: "c = vec4f(select(pow((c.rgb + 0.055) / 1.055, vec3f(2.4)), c.rgb / 12.92, "
    + "c.rgb <= vec3f(0.04045)), c.a);" },
};

const shaderOf = (expression, { lookup = "", result = "" }) => `
  struct Lookup { uv: vec2f, dx: vec2f, dy: vec2f, lod: f32, unused: f32 }
  @group(0) @binding(0) var image: texture_2d<f32>;
  @group(0) @binding(1) var unit: sampler;
  @group(0) @binding(2) var<storage, read> lookups: array<Lookup>;
  @group(0) @binding(3) var<storage, read_write> results: array<vec4f>;
  @compute @workgroup_size(${WORKGROUP}) fn main(@builtin(global_invocation_id) id: vec3u) {
    if (id.x >= arrayLength(&lookups)) { return; }
    var q = lookups[id.x];
    ${lookup}
    var c = ${expression};
    ${result}
    results[id.x] = c;
  }`;

/** Numbers of a lookup in the buffer of the shader. */
const STRIDE = 8;

/**
 * The columns r, g, b and a of lookups { u, v, dudx, dvdx, dudy, dvdy, lod }, Float32Array each; lod replaces the
 * derivatives if it is there. `fault` is one of FAULTS or undefined.
 */
export async function sampleOnDevice(device, image, { filter, wrap, fault }, lookups) {
  const count = lookups.u.length;
  const rows = new Float32Array(STRIDE * count);
  const columns = [lookups.u, lookups.v, lookups.dudx, lookups.dvdx, lookups.dudy, lookups.dvdy, lookups.lod];
  columns.forEach((column, c) => column?.forEach((value, i) => { rows[STRIDE * i + c] = value; }));
  const texture = makeTexture(device, image);
  const modes = { addressModeU: MODES[wrap[0]], addressModeV: MODES[wrap[1]] };
  const changes = FAULTS[fault] ?? {};
  const sampler = device.createSampler({ ...FILTERS[filter], ...modes, ...changes.sampler });
  const { STORAGE, COPY_DST, COPY_SRC, MAP_READ } = GPUBufferUsage;
  const input = device.createBuffer({ size: rows.byteLength, usage: STORAGE | COPY_DST });
  const output = device.createBuffer({ size: 16 * count, usage: STORAGE | COPY_SRC });
  const readable = device.createBuffer({ size: 16 * count, usage: MAP_READ | COPY_DST });
  device.queue.writeBuffer(input, 0, rows);
  const expression = lookups.lod ? "textureSampleLevel(image, unit, q.uv, q.lod)"
    : "textureSampleGrad(image, unit, q.uv, q.dx, q.dy)";
  device.pushErrorScope("validation");
  const module = device.createShaderModule({ code: shaderOf(expression, changes) });
  const pipeline = device.createComputePipeline({ layout: "auto", compute: { module, entryPoint: "main" } });
  const resources = [texture.createView(), sampler, { buffer: input }, { buffer: output }];
  const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
                                         entries: resources.map((resource, binding) => ({ binding, resource })) });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  pass.setBindGroup(0, group);
  pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
  pass.end();
  encoder.copyBufferToBuffer(output, 0, readable, 0, 16 * count);
  device.queue.submit([encoder.finish()]);
  const problem = await device.popErrorScope();
  if (problem) throw new Error(problem.message);
  await readable.mapAsync(GPUMapMode.READ);
  const texels = new Float32Array(readable.getMappedRange().slice(0));
  for (const object of [texture, input, output, readable]) object.destroy();
  return Array.from({ length: 4 }, (_, c) => Float32Array.from({ length: count }, (__, i) => texels[4 * i + c]));
}
