// SPDX-License-Identifier: MIT
// Objects of the library and their references.
import { invoke } from "./call.js";
import { refuse } from "./error.js";

/** One reference to an object of C. Functions of JavaScript live until the last object that was made with them ends. */
class Reference {
  constructor(module, kind, handle, { keep, groups, pinned }) {
    Object.assign(this, { module, kind, handle, keep, groups, pinned, users: 1 });
    for (const other of keep) other.users += 1;
  }
  /** Ends functions that only the call that made the object used. */
  endFunctions() {
    for (const id of this.groups.splice(0)) this.module.callbacks.remove(id);
  }
  /** Gives the object back. C keeps it as long as other objects of C need it. */
  close() {
    this.module.raw[`shd_${this.kind}_release`](this.handle);
    this.handle = 0;
    this.drop();
  }
  drop() {
    this.users -= 1;
    if (this.users) return;
    for (const id of this.groups) this.module.callbacks.remove(id);
    for (const other of this.keep) other.drop();
  }
}

/** Base of the objects. close() gives the memory back; so does the garbage collector, at an unknown time. */
export class SharedObject {
  #reference = null;
  /** `create` is the function of C that makes the object, or the address of one that gets another reference. */
  constructor(module, kind, create, values) {
    Object.defineProperty(this, "module", { value: module });  // consoles do not print it
    this.kind = kind;
    let made = { keep: [], groups: [], pinned: [] }, handle = create;
    if (typeof create === "string") handle = invoke(module, create, values, (call) => { made = call; });
    else module.raw[`shd_${kind}_retain`](handle);
    this.#reference = new Reference(module, kind, handle, made);
    module.registry.register(this, this.#reference, this);
  }
  /** The reference, for a call. */
  reference(label) {
    if (!this.#reference) refuse(label, `the ${this.kind} is closed`);
    return this.#reference;
  }
  get isClosed() {
    return this.#reference === null;
  }
  /** Drops the reference. Later uses throw; closing again has no effect. */
  close() {
    const reference = this.#reference;
    if (!reference) return;
    this.#reference = null;
    this.module.registry.unregister(this);
    this.module.release(reference);
  }
}
/** What consoles of Node print: the class, and what its getters return. */
function printed(depth, options, inspect) {
  const name = this.kind.replace(/(^|_)[a-z]/g, (part) => part.at(-1).toUpperCase());
  const values = {};
  let made = Object.getPrototypeOf(this);
  for (; !this.isClosed && made !== SharedObject.prototype; made = Object.getPrototypeOf(made)) {
    const own = Object.getOwnPropertyDescriptors(made);
    for (const key of Object.keys(own)) if (own[key].get) values[key] = this[key];
  }
  return `${name} ${inspect(this.isClosed ? { isClosed: true } : values, options)}`;
}
Object.defineProperty(SharedObject.prototype, Symbol.for("nodejs.util.inspect.custom"), { value: printed });
if (Symbol.dispose) {
  SharedObject.prototype[Symbol.dispose] = function dispose() { this.close(); };
}
