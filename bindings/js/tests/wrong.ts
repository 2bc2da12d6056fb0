// SPDX-License-Identifier: MIT
// Programs that must not compile: types.sh compares the errors of tsc with the numbers in the comments.
import { load, type Shd } from "shd";
import { Pool } from "shd/pool";

const shd: Shd = await load();
const context = new shd.Context();
const texels = new Uint8Array(4);
new shd.Sampler(context, { fliter: "ewa" });                                           // TS2561
new shd.Sampler(context, { anisotropy: 8 });                                           // TS2561
new shd.Sampler(context, { filter: "ewwa" });                                          // TS2820
new shd.Sampler(context, { wrapU: "loop" });                                           // TS2322
new shd.Texture(context, { format: "rgba8", width: 1, height: 1, texels, tables: "mipmaps" });      // TS2820
new shd.Texture(context, { format: "r8", width: 1, height: 1, texels, tables: "mipmap|rip" });      // TS2820
new shd.Framebuffer(context, { width: 1, height: 1, aovs: "uv|normals" });             // TS2820
new shd.Framebuffer(context, { width: 1, height: 1, aovs: ["uv", "normals"] });        // TS2820
new shd.Framebuffer(context, { width: "1", height: 1 });                               // TS2322
new shd.Texture({ format: "r8", width: 1, height: 1, texels });                        // TS2353
shd.Mesh.shape(context, { kind: "kettle" });                                           // TS2322
shd.render(context, { draws: [], framebufer: null });                                  // TS2561
const byte: string = new shd.Framebuffer(context, { width: 1, height: 1 }).readColor()[0];          // TS2322
type Functions = { draw(rows: [number, number], angle: number): number };
const pool = new Pool<Functions>(() => new Worker("worker.js"));
await pool.call("drow", [0, 1], 2);                                                    // TS2345
await pool.bands(100, "draw", "2");                                                    // TS2345
const text: string = await pool.call("draw", [0, 1], 2);                               // TS2322
new shd.Scene(context, "model.glb");                                                   // TS2345
new shd.Scene(context, texels, { find: async () => texels });                          // TS2322
new shd.Scene(context, texels, { maxTriangle: 5 });                                    // TS2561
