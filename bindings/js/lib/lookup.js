// SPDX-License-Identifier: MIT
import { Call, check } from "./call.js";
import { refuse } from "./error.js";

/** Lookups whose structs are written once. Columns lie in the memory of WebAssembly; run() filters and writes them. */
export class Lookup {
  #run;
  #blocks = [];
  #module;
  constructor(texture, sampler, lookups, out) {
    const module = texture.module;
    const { memory, raw } = module;
    this.#module = module;
    const call = new Call(module, (size) => {
      const address = memory.allocate(size);
      this.#blocks.push(address);
      return address;
    });
    try {
      const words = [call.handle(texture, "texture", "texture"), call.handle(sampler, "sampler", "sampler"),
                     call.struct("lookups", lookups, "lookups")];
      call.isOut = true;
      words.push(call.struct("texels", out, "out"));
      const sample = raw.shd_texture_sample;
      const [textureHandle, samplerHandle, lookupsAddress, texelsAddress] = words;
      raw.shd_texture_retain(textureHandle);
      raw.shd_sampler_retain(samplerHandle);
      this.keep = [lookups, out];  // arrays whose memory is used
      const references = call.keep;  // of functions that load tiles
      for (const reference of references) reference.users += 1;
      this.#run = () => sample(textureHandle, samplerHandle, lookupsAddress, texelsAddress);
      this.end = () => {
        raw.shd_texture_release(textureHandle);
        raw.shd_sampler_release(samplerHandle);
        for (const reference of references) reference.drop();
      };
    } catch (problem) {
      this.#free();
      throw problem;
    }
  }
  /** Runs the lookups. */
  run() {
    if (!this.#run) refuse("lookup", "it is closed");
    if (this.#module.failure) throw this.#module.failure;
    let result;
    try {
      result = this.#run();
    } catch (problem) {
      throw this.#module.failure ?? problem;
    }
    if (result) check(this.#module, result, "shd_texture_sample");
  }
  #free() {
    for (const address of this.#blocks.splice(0)) this.#module.memory.free(address);
  }
  close() {
    if (!this.#run) return;
    this.#run = null;
    this.keep = null;
    if (this.#module.failure) return;
    this.end();
    this.#free();
  }
}
if (Symbol.dispose) Lookup.prototype[Symbol.dispose] = Lookup.prototype.close;
