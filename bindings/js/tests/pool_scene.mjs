// SPDX-License-Identifier: MIT
// A picture that one thread draws whole and workers draw in bands of rows.

export const WIDTH = 200;
export const HEIGHT = 150;

/** A function that draws rows first..last - 1 and returns their bytes. */
export function makeScene(shd) {
  const context = new shd.Context();
  const texels = Uint8Array.from({ length: 64 * 64 * 4 }, (_, i) => (i * 7919) % 251);
  const texture = new shd.Texture(context, { format: "rgba8_srgb", width: 64, height: 64, texels, tables: "mipmap" });
  const sampler = new shd.Sampler(context, { filter: "ewa", maxAnisotropy: 16 });
  const slots = [{ target: "diffuse", texture, sampler }];
  const material = new shd.Material(context, { model: "blinn_phong", slots });
  const framebuffer = new shd.Framebuffer(context, { width: WIDTH, height: HEIGHT, sampleCount: 4 });
  const draws = [{ mesh: shd.Mesh.shape(context, { kind: "torus" }), material },
                 { mesh: shd.Mesh.shape(context, { kind: "plane", size: [40, 1, 40] }), material }];
  const lights = [new shd.Light(context, { kind: "directional", direction: [-0.5, -1, -0.25] })];
  return ([first, last]) => {
    const scissor = { x: 0, y: first, width: WIDTH, height: last - first };
    shd.render(context, { framebuffer, draws, lights, camera: { eye: [0.5, 1.5, 2] }, scissor });
    return framebuffer.readColor().slice(4 * WIDTH * first, 4 * WIDTH * last);
  };
}
