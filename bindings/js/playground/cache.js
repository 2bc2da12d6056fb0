// SPDX-License-Identifier: MIT
/** Objects by the descs that they were made from; objects of older frames are closed. */
export class Cache {
  #made = new Map();
  #used = new Set();
  get(kind, desc, make) {
    const key = kind + JSON.stringify(desc);
    this.#used.add(key);
    if (!this.#made.has(key)) this.#made.set(key, make());
    return this.#made.get(key);
  }
  /** Closes what was not used since the last call. */
  sweep() {
    for (const [key, object] of this.#made) {
      if (this.#used.has(key)) continue;
      object.close();
      this.#made.delete(key);
    }
    this.#used.clear();
  }
}
