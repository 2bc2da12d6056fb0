// SPDX-License-Identifier: MIT
import { structs } from "./api.js";

/** An executor of C with a number of workers. */
export class Executor {
  constructor(address, workers) {
    this.address = address;
    this.workers = workers;
  }
  write(view, address) {
    const { fields } = structs.executor;
    view.setUint32(address + fields.parallelFor[0], this.address, true);
    view.setUint32(address + fields.userData[0], this.workers, true);
    view.setUint32(address + fields.workerCount[0], this.workers, true);
  }
}
