// SPDX-License-Identifier: MIT
// The worker of test_pool.mjs and of the page of browser.mjs: it draws rows of a picture.
import { serve } from "../lib/pool.js";
import { makeScene } from "./pool_scene.mjs";

serve((shd) => {
  const draw = makeScene(shd);
  const kept = shd.allocate(Float32Array, 4);
  let calls = 0;
  return {
    draw,
    echo: (...values) => values,
    count: () => ++calls,
    /** Views of the memory of WebAssembly, and an array that is moved. */
    memory() {
      kept.array.set([1, 2, 3, 4]);
      const { buffer, byteOffset, byteLength } = kept.array;
      return { view: kept.array, list: [Uint8Array.of(5)], text: "text",
               data: new DataView(buffer, byteOffset, byteLength),
               bytes: globalThis.Buffer?.from(buffer, byteOffset, byteLength),
               small: globalThis.Buffer?.from("small") };
    },
    refuse: () => new shd.Sampler(new shd.Context(), { maxAnisotropy: 99 }),
    end() {
      setTimeout(() => { throw new Error("this worker breaks"); });
    },
  };
});
