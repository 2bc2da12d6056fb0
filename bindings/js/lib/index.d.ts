// SPDX-License-Identifier: MIT
// Types of the module. Descs, enums and the functions of C are in api.d.ts, which is generated.
/// <reference lib="esnext.disposable" />
import type * as api from "./api.js";

export type * from "./api.js";

export type TypedArray = Int8Array | Uint8Array | Uint8ClampedArray | Int16Array | Uint16Array | Int32Array | Uint32Array
  | Float32Array | Float64Array;
export type Numbers = ArrayLike<number> | ArrayLike<number>[] | Allocation;
export type Pixels = TypedArray | ArrayBuffer | Allocation;
/** Elements of an array: `offset` and `stride` count elements. */
export interface Strided<T> { data: T | Allocation; offset?: number; stride?: number }
type Single<F extends string> = Exclude<F, "none" | "all">;
/** Flags: a name, two or three names joined by "|" such as "uv|normal", or a list of names. */
export type Flags<F extends string> = F | F[] | `${Single<F>}|${Single<F>}` | `${Single<F>}|${Single<F>}|${Single<F>}`;
/** New arrays. Since TypeScript 5.7 the types say that their memory is not shared, as ImageData requires. */
type Bytes = ReturnType<typeof Uint8ClampedArray.of>;
type Halves = ReturnType<typeof Uint16Array.of>;
type Words = ReturnType<typeof Uint32Array.of>;
type Floats = ReturnType<typeof Float32Array.of>;
/** Results, with the number of rows whose inputs were not finite. */
type Counted<T> = T & { nonfiniteCount: number };
type Array32 = Float32Array | Uint32Array | Uint16Array;
/** Arrays of other elements, which are converted: Float64Array to floats, integers to integers. */
type Convertible = Float64Array | Int8Array | Uint8Array | Int16Array | Int32Array;
/** A column of numbers. Arrays in the memory of WebAssembly are used in place, others are copied. */
export type Column = Array32 | Convertible | number[] | Allocation | Strided<Array32 | Convertible>;
export type OutColumn = Array32 | Allocation | Strided<Array32>;
/** Columns of a vector: one interleaved array, or one column for each component. */
export type Columns = Column | (Column | null)[];
export type OutColumns = OutColumn | (OutColumn | null)[];

/** A call of the library failed. The message names the argument, its value and its range. */
export class ShdError extends Error {
  constructor(result: string | number, message: string);
  readonly result: "invalid_argument" | "out_of_memory" | "unsupported" | "not_found" | "io" | "corrupt" | "limit"
    | "cancelled" | "callback" | "internal";
}

/** An array in the memory of WebAssembly. */
export class Allocation<T extends TypedArray = any> {
  readonly address: number;
  readonly length: number;
  /** The elements. The array becomes empty when the memory grows; take it anew after calls that make objects. */
  readonly array: T;
  close(): void;
  [Symbol.dispose](): void;
}

interface SharedObject {
  readonly kind: string;
  readonly isClosed: boolean;
  /** Drops the reference. Later uses throw; closing again has no effect. */
  close(): void;
  [Symbol.dispose](): void;
}

export interface Context extends SharedObject {
  readonly simdTarget: string;
  readonly workerCount: number;
  /** Frees memory that is kept for later calls. */
  trim(): void;
}

/** The bytes of a file. */
export type FileBytes = Uint8Array | ArrayBuffer | ArrayBufferView | Allocation;
/** Files of a model by their names, or a function that answers a name. It cannot wait for a promise. */
export type Find = ((name: string) => FileBytes | null | undefined) | Map<string, FileBytes>
  | { [name: string]: FileBytes };

/** The pixels of an image file, without conversion. */
export interface Bitmap extends SharedObject {
  readonly format: "rgba8_srgb" | "rgba8" | "rgba16" | "rgba16f" | "rgba32f";
  readonly width: number;
  readonly height: number;
  readonly info: api.BitmapInfo;
  /** The colour space of the pixels, such as "sRGB". */
  readonly colorSpace: string;
  /** A copy of the pixels, [height][width][4]: Uint8ClampedArray, Uint16Array or Float32Array, as `format` states. */
  readPixels(): Bytes | Halves | Floats;
}

/** Options of a model, and its name, for formats without a mark of their own. */
export interface SceneOptions extends api.SceneDesc { name?: string }

/** The contents of a model file. Its meshes, materials, textures and lights close with it. */
export interface Scene extends SharedObject {
  readonly info: api.SceneInfo;
  /** Parts of the file that were left out or changed, one text each. */
  readonly warnings: string[];
  /** The box around all instances, its centre, and half of its diagonal. */
  readonly bounds: { min: number[]; max: number[]; center: number[]; radius: number };
  readonly meshes: Mesh[];
  readonly materials: Material[];
  readonly textures: Texture[];
  readonly lights: Light[];
  readonly cameras: (api.Camera & { eye: number[]; target: number[]; up: number[] })[];
  readonly instances: (api.SceneInstance & { objectToWorld: number[] })[];
  /** The instances as draws of a frame. */
  readonly draws: api.Draw[];
  /** Sets the draws and lights of a frame to those of the file, and returns it. */
  fillRender<T extends object>(frame: T): T & { draws: api.Draw[]; lights: Light[] };
  names(part: api.ScenePart): string[];
  /** The first and the last key of an animation [s]. */
  animationTimes(index: number): [number, number];
  /** A scene of the file at a time of an animation, given by its number or its name. */
  pose(animation: number | string, seconds: number): Scene;
}

export interface Texture extends SharedObject {
  readonly info: api.TextureInfo;
  /** Filtered values of lookups, as columns r, g, b and a. */
  sample(sampler: Sampler, lookups: api.Lookups): Counted<{ channel: Floats[] }>;
  sample<T extends api.Texels>(sampler: Sampler, lookups: api.Lookups, out: T): Counted<T>;
  /** Lookups that can be run many times. All columns must be in the memory of WebAssembly. */
  lookup(sampler: Sampler, lookups: api.Lookups, out: api.Texels): Lookup;
  queryLevels(sampler: Sampler, lookups: api.Lookups): Counted<{ lod: Floats; level: Words }>;
  queryLevels<T extends api.Levels>(sampler: Sampler, lookups: api.Lookups, out: T): Counted<T>;
  /** How the lookup `index` was filtered, with all of its taps and blends. */
  explain(sampler: Sampler, lookups: api.Lookups, index?: number): Explained;
  readLevel(layer: number, level: number, image: api.Image): api.Image;
  /** Size and levels of what readTable() returns. */
  tableInfo(desc: api.TableDesc): api.TableInfo;
  /** A level, the sums or the picture of a table: linear r, g, b, a as one array [height][width][4]. */
  readTable(desc: api.TableDesc): Floats;
  update(layer: number, x: number, y: number, image: api.Image): void;
  loadTiles(region: api.TileRegion): void;
  /** Loads the tiles of a region and keeps them until unpinTiles(). */
  pinTiles(region: api.TileRegion): void;
  unpinTiles(region: api.TileRegion): void;
  /** Drops the tiles of a region, and the coarser tiles that cover it: their source has changed. */
  dropTiles(region: api.TileRegion): void;
}

/** How a lookup was filtered: the texels that it read, and the blends that combined them. */
export interface Explained extends Required<Omit<api.Explanation, "taps" | "blends">> {
  readonly taps: Required<api.Tap>[];
  readonly blends: Required<api.BlendStep>[];
}

/** Memory of a fixed size for the tiles of textures whose desc has `tiles: { cache, load }`. */
export interface TileCache extends SharedObject {
  readonly stats: api.TileCacheStats;
  /** Loads tiles that lookups with missingTiles: "coarser" did not find, 0 = all of them. Returns their number. */
  loadRequested(maxTiles?: number): number;
}

/** A tile that a function fills, valid until the function returns. */
export interface Tile {
  readonly layer: number; readonly level: number;
  /** Texels of the level to fill. */
  readonly area: Readonly<Required<api.Region>>;
  /** Bytes between rows. */
  readonly rowStride: number;
  /** Bytes of the rows, in the format of the texture. */
  readonly texels: Uint8Array;
}

export interface Lookup {
  run(): void;
  close(): void;
  [Symbol.dispose](): void;
}

export interface Sampler extends SharedObject {}
export interface Material extends SharedObject {}
export interface Light extends SharedObject {}
export interface Volume extends SharedObject {}

/** A closed mesh of triangles as a cage. */
export interface Polyhedron extends SharedObject {
  readonly vertexCount: number;
  /** The coordinates of points: `out.weight` has a column for each vertex. */
  evaluate<T extends api.PolyhedronWeights>(points: api.PolyhedronPoints, out: T): T;
  /** Values of the vertices at points: `out.vertexValue` are read, and `out.value` is written. */
  interpolate<T extends api.PolyhedronValues>(points: api.PolyhedronPoints, out: T): T;
}

export interface Mesh extends SharedObject {
  readonly info: api.MeshInfo;
  /** Columns of the vertices as one interleaved array. */
  read(part: "positions" | "normals" | "tangents" | "uv" | "uv1"): Floats;
  readAttribute(index: number): Floats;
  readIndices(): Words;
  tessellate(context: Context, desc: api.TessellationDesc): Mesh;
}

export interface Framebuffer extends SharedObject {
  readonly info: api.FramebufferInfo;
  /** Pixels [height][width][4]. Bytes suit ImageData; 16-bit floats are Uint16Array. */
  readColor(format?: "rgba8_srgb" | "rgba8"): Bytes;
  readColor(format: "rgba32f"): Floats;
  readColor(format: "rgba16" | "rgba16f"): Halves;
  /** Writes to an array of an earlier call, and returns it. */
  readColor<T extends Uint8ClampedArray>(format: "rgba8_srgb" | "rgba8", out: T): T;
  readColor<T extends Float32Array>(format: "rgba32f", out: T): T;
  readColor<T extends Uint16Array>(format: "rgba16" | "rgba16f", out: T): T;
  /** A copy of a plane, [height][width]. */
  readPlane(plane: "triangle" | "level" | "draw" | "overdraw"): Words;
  readPlane(plane: api.Plane): Floats;
  /** A plane without a copy, valid until the memory grows or the framebuffer closes. `rowStride` counts elements. */
  viewPlane(plane: api.Plane): { array: Float32Array | Uint32Array; rowStride: number };
}

export interface Environment extends SharedObject {
  readonly info: api.EnvironmentInfo;
  sampleIrradiance<T extends api.EnvironmentValues>(lookups: api.EnvironmentLookups, out: T): Counted<T>;
  sampleRadiance<T extends api.EnvironmentValues>(lookups: api.EnvironmentLookups, out: T): Counted<T>;
}

export interface Shadow extends SharedObject {
  readonly info: api.ShadowInfo;
  /** A face of the map: depths [height][width], or moments or sums [height][width][2]. */
  readMap(face?: number): Floats;
  render(context: Context, desc: api.ShadowRenderDesc): void;
  sample<T extends api.ShadowValues>(lookups: api.ShadowLookups, out: T): Counted<T>;
}

/** Columns of fragments, valid until the program returns. */
export interface Fragments {
  readonly draw: number;
  readonly instance: number;
  readonly count: number;
  readonly triangle: Uint32Array;
  readonly attribute: (Float32Array | null)[];
  readonly varying: Float32Array[];
  readonly x: Float32Array; readonly y: Float32Array; readonly depth: Float32Array;
  readonly px: Float32Array; readonly py: Float32Array; readonly pz: Float32Array;
  readonly nx: Float32Array; readonly ny: Float32Array; readonly nz: Float32Array;
  readonly ox: Float32Array; readonly oy: Float32Array; readonly oz: Float32Array;
  readonly tx: Float32Array | null; readonly ty: Float32Array | null; readonly tz: Float32Array | null;
  readonly tw: Float32Array | null;
  readonly u: Float32Array; readonly v: Float32Array; readonly u1: Float32Array; readonly v1: Float32Array;
  readonly dudx: Float32Array; readonly dvdx: Float32Array; readonly dudy: Float32Array; readonly dvdy: Float32Array;
}

/** Columns that a fragment program writes. */
export interface Radiance {
  readonly r: Float32Array; readonly g: Float32Array; readonly b: Float32Array; readonly a: Float32Array;
  readonly discard: Uint32Array | null;
  readonly target: (Float32Array | null)[][];
}

export interface Vertices {
  readonly draw: number;
  readonly instance: number;
  readonly first: number;
  readonly count: number;
  readonly attribute: (Float32Array | null)[];
  readonly px: Float32Array; readonly py: Float32Array; readonly pz: Float32Array;
  readonly nx: Float32Array; readonly ny: Float32Array; readonly nz: Float32Array;
  readonly u: Float32Array; readonly v: Float32Array;
  readonly u1: Float32Array | null; readonly v1: Float32Array | null;
  readonly objectToWorld: Float32Array; readonly worldToView: Float32Array; readonly viewToClip: Float32Array;
  readonly eye: Float32Array;
}

export interface VertexOutputs {
  readonly x: Float32Array; readonly y: Float32Array; readonly z: Float32Array; readonly w: Float32Array;
  readonly px: Float32Array; readonly py: Float32Array; readonly pz: Float32Array;
  readonly nx: Float32Array; readonly ny: Float32Array; readonly nz: Float32Array;
  readonly u: Float32Array; readonly v: Float32Array;
  readonly varying: Float32Array[];
}

export interface Rays {
  readonly count: number;
  readonly ox: Float32Array; readonly oy: Float32Array; readonly oz: Float32Array;
  readonly dx: Float32Array; readonly dy: Float32Array; readonly dz: Float32Array;
  readonly length: Float32Array;
}

/** A finished tile. `rowStride` is in bytes. */
export interface PresentTile {
  readonly worker: number;
  /** Pixels of the framebuffer. */
  readonly area: Readonly<Required<api.Region>>;
  readonly rowStride: number;
  readonly channel: Float32Array[];
}

interface Constructor<T, Desc> { new (context: Context, desc?: Desc): T }

export interface Memory {
  /** Shared if the instance has threads. */
  readonly buffer: ArrayBufferLike;
  readonly view: DataView;
  text(address: number): string;
}

export interface Shd {
  readonly version: string;
  /** Threads that contexts use, at most: 1, or those of load() of "shd/threads". */
  readonly threadCount: number;
  /** Ends the threads. Later calls of an instance with threads throw. */
  close(): void;
  readonly Context: { new (desc?: api.ContextDesc): Context };
  readonly Texture: Constructor<Texture, api.TextureDesc> & {
    /** A texture of an image file, or of a KTX2 or DDS file as it is stored. */
    load(context: Context, bytes: FileBytes, desc?: api.LoadDesc): Texture;
  };
  readonly Bitmap: { new (context: Context, bytes: FileBytes, desc?: api.LoadDesc): Bitmap };
  readonly Scene: { new (context: Context, bytes: FileBytes, options?: SceneOptions): Scene };
  readonly Sampler: Constructor<Sampler, api.SamplerDesc>;
  readonly Mesh: Constructor<Mesh, api.MeshDesc> & {
    shape(context: Context, desc: api.ShapeDesc, flags?: Flags<api.MeshFlag> | number): Mesh;
  };
  readonly Material: Constructor<Material, api.MaterialDesc>;
  readonly Light: Constructor<Light, api.LightDesc>;
  readonly Framebuffer: Constructor<Framebuffer, api.FramebufferDesc>;
  readonly Environment: Constructor<Environment, api.EnvironmentDesc>;
  readonly Shadow: Constructor<Shadow, api.ShadowDesc>;
  readonly TileCache: Constructor<TileCache, api.TileCacheDesc>;
  readonly Volume: Constructor<Volume, api.VolumeDesc>;
  readonly Polyhedron: Constructor<Polyhedron, api.PolyhedronDesc & { vertexCount: number }>;
  readonly ShdError: typeof ShdError;
  /** The functions of C, with addresses for pointers. */
  readonly raw: api.Raw;
  readonly memory: Memory;
  /** An array in the memory of WebAssembly, which calls use without a copy. */
  allocate<T extends TypedArray>(type: { new (length: number): T; readonly BYTES_PER_ELEMENT: number }, length: number): Allocation<T>;
  /** Renders a frame, and returns its statistics. */
  render(context: Context, desc: api.RenderDesc): api.RenderStats;
  /** Calls a function of C by its name with JavaScript values; returns what it writes through `out_` parameters. */
  call(name: keyof api.Raw, ...values: unknown[]): any;
}

/** Loads shd.wasm, by default the file beside this module. */
export function load(source?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module): Promise<Shd>;
