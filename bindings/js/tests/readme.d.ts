// SPDX-License-Identifier: MIT
// What programs of README.md and docs/bindings.md leave to their reader.
declare const texels: Uint8Array;
declare const target: CanvasRenderingContext2D;
declare const u: Float32Array;
declare const v: Float32Array;
declare const dudx: Float32Array;
declare const dvdx: Float32Array;
declare const dudy: Float32Array;
declare const dvdy: Float32Array;
