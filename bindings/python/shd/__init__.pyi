# SPDX-License-Identifier: MIT
# Types of the module's descs and enums. Written by generate.py; do not edit.
import enum
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np

from ._api import Error as Error, InvalidArgument as InvalidArgument, OutOfMemory as OutOfMemory
from . import color as color, embree as embree, io as io, pyrender as pyrender, renderer as renderer, scene as scene
from ._bake import (bake as bake, bake_occlusion as bake_occlusion, occlusion as occlusion,
                    vertex_occlusion as vertex_occlusion)
from ._desc import Desc as Desc
from ._environment import Environment as Environment
from ._frame import Framebuffer as Framebuffer, render as render
from ._png import save_png as save_png
from ._objects import (Context as Context, Light as Light, Material as Material, Mesh as Mesh, Object as Object,
                       Sampler as Sampler, slot as slot)
from ._projection import convert_projection as convert_projection, project as project, unproject as unproject
from ._shadow import Shadow as Shadow
from ._solid import evaluate_solid as evaluate_solid
from ._texture import Lookup as Lookup, Texture as Texture
from ._tiles import TileCache as TileCache
from ._volume import Volume as Volume
from .color import Color as Color
from .renderer import Renderer as Renderer
from .scene import Scene as Scene

_Array = Union[np.ndarray, Sequence[Any]]

def version() -> tuple[int, int, int]: ...

class TexelState(enum.IntEnum):
    EMPTY = 0
    CENTRE = 1
    TOUCHED = 2
    DILATED = 3

class LevelRule(enum.IntFlag):
    LENGTHS = 1
    ELLIPSE = 2
    VULKAN = 4
    OPENGL = 8
    PROFILE = 16

class Rules(enum.IntEnum):
    VULKAN = 0
    D3D11 = 1
    WEBGPU = 2
    OPENGL = 3

class DisplayPrecision(enum.IntEnum):
    BAKED = 0
    EXACT = 1

class LogLevel(enum.IntEnum):
    DEBUG = 0
    INFO = 1
    WARNING = 2
    ERROR = 3

class Simd(enum.IntEnum):
    BEST = 0
    BASELINE = 1
    SCALAR = 2
    SSE2 = 3
    SSSE3 = 4
    SSE4 = 5
    AVX2 = 6
    AVX512 = 7
    NEON = 8
    WASM = 9

class ContextFlag(enum.IntFlag):
    DEFAULT = 0
    RETURN_MEMORY = 1

class DescKind(enum.IntEnum):
    NONE = 0
    CONTEXT_DESC = 1
    IMAGE = 2
    TEXTURE_DESC = 3
    TEXTURE_INFO = 4
    MIP_DESC = 5
    SAMPLER_DESC = 6
    LOOKUPS = 7
    TEXELS = 8
    LEVELS = 9
    EXPLANATION = 10
    RAY_DIFFERENTIALS = 11
    RAY_CONES = 12
    DERIVATIVES = 13
    MESH_DESC = 14
    MESH_INFO = 15
    EDGES_DESC = 16
    EDGES = 17
    TESSELLATION_DESC = 18
    MATERIAL_DESC = 19
    SLOT = 20
    LIGHT_DESC = 21
    SHADOW_DESC = 22
    SHADOW_RENDER_DESC = 23
    SHADOW_LOOKUPS = 24
    FRAMEBUFFER_DESC = 25
    FRAMEBUFFER_INFO = 26
    PLANE_VIEW = 27
    CAMERA = 28
    DRAW = 29
    RENDER_DESC = 30
    RENDER_STATS = 31
    COLOR_DESC = 32
    LOAD_DESC = 33
    SAVE_DESC = 34
    BITMAP_INFO = 35
    SHAPE_DESC = 36
    SHAPE_COLUMNS = 37
    SCENE_DESC = 38
    SCENE_INFO = 39
    SCENE_INSTANCE = 40
    SOLID_DESC = 41
    SOLID_POINTS = 42
    SOLID_VALUES = 43
    DIRECTIONS = 44
    PROJECTED_POINTS = 45
    IMAGE_POINTS = 46
    POINT_DIRECTIONS = 47
    VOLUME_DESC = 48
    VOLUME_DRAW = 49
    ENVIRONMENT_DESC = 50
    ENVIRONMENT_INFO = 51
    ENVIRONMENT_LOOKUPS = 52
    ENVIRONMENT_LIGHT = 53
    DIRECTION_IMAGES = 54
    POLYGON_DESC = 55
    POLYGON_POINTS = 56
    POLYGON_WEIGHTS = 57
    RAW_DESC = 58
    STACK_DESC = 59
    VDB_DESC = 60
    VDB_INFO = 61
    BAKE_DESC = 62
    BAKE_STATS = 63
    OCCLUSION_DESC = 64
    OCCLUSION_POINTS = 65
    OCCLUSION_ATLAS = 66
    BOUNDS_DESC = 67
    TEXTURE_FILE_INFO = 68
    KTX2_DESC = 69
    TILE_REGION = 70
    TILE_CACHE_DESC = 71
    TILE_CACHE_STATS = 72
    TILE_FILE_DESC = 73
    TILE_FILE_INFO = 74

class Edge(enum.IntFlag):
    NONE = 0
    SILHOUETTE = 1
    CREASE = 2
    BORDER = 4
    NONMANIFOLD = 8
    ALL = 15

class Irradiance(enum.IntEnum):
    HARMONICS = 0
    CONVOLVED = 1

class EnvironmentTable(enum.IntFlag):
    NONE = 0
    RADIANCE = 1
    GGX = 2
    PHONG = 4
    ALL = 7

class Aov(enum.IntFlag):
    NONE = 0
    UV = 1
    NORMAL = 2
    TRIANGLE = 4
    POSITION = 8
    DERIVATIVES = 16
    BARYCENTRICS = 32
    LEVEL = 64
    DRAW = 128
    OVERDRAW = 256
    TARGET1 = 512
    TARGET2 = 1024
    TARGET3 = 2048

class Plane(enum.IntEnum):
    R = 0
    G = 1
    B = 2
    A = 3
    DEPTH = 4
    U = 5
    V = 6
    NX = 7
    NY = 8
    NZ = 9
    TRIANGLE = 10
    PX = 11
    PY = 12
    PZ = 13
    DUDX = 14
    DVDX = 15
    DUDY = 16
    DVDY = 17
    B0 = 18
    B1 = 19
    B2 = 20
    LOD = 21
    LEVEL = 22
    DRAW = 23
    OVERDRAW = 24
    TARGET1_R = 25
    TARGET1_G = 26
    TARGET1_B = 27
    TARGET1_A = 28
    TARGET2_R = 29
    TARGET2_G = 30
    TARGET2_B = 31
    TARGET2_A = 32
    TARGET3_R = 33
    TARGET3_G = 34
    TARGET3_B = 35
    TARGET3_A = 36

class Format(enum.IntEnum):
    NONE = 0
    R8 = 1
    RGBA8 = 2
    RGBA8_SRGB = 3
    RGBA16F = 4
    RGBA32F = 5
    RGBA16 = 6
    RG8 = 7
    RGB8 = 8
    R8_SRGB = 9
    RG8_SRGB = 10
    RGB8_SRGB = 11
    R16 = 12
    RG16 = 13
    RGB16 = 14
    R16F = 15
    RG16F = 16
    RGB16F = 17
    R32F = 18
    RG32F = 19
    RGB32F = 20
    BC1_RGB = 21
    BC1_RGB_SRGB = 22
    BC1_RGBA = 23
    BC1_RGBA_SRGB = 24
    BC2 = 25
    BC2_SRGB = 26
    BC3 = 27
    BC3_SRGB = 28
    BC4 = 29
    BC4_SNORM = 30
    BC5 = 31
    BC5_SNORM = 32
    BC6H_UFLOAT = 33
    BC6H_SFLOAT = 34
    BC7 = 35
    BC7_SRGB = 36
    RGB9E5 = 37

class FileFormat(enum.IntFlag):
    NONE = 0
    PNG = 1
    JPEG = 2
    EXR = 4
    TIFF = 8
    HDR = 16
    TGA = 32
    BMP = 64
    DDS = 128
    WEBP = 256
    PNM = 512
    PSD = 1024
    DPX = 2048
    GIF = 4096
    KTX2 = 8192
    VDB = 16384
    DEFAULT = 25599
    ANY = 1073741824

class ColorEncoding(enum.IntEnum):
    AUTO = 0
    SRGB = 1
    LINEAR = 2
    DATA = 3

class LoadFlag(enum.IntFlag):
    DEFAULT = 0
    IN_PROCESS = 1
    PARTIAL = 2
    FLIP_V = 4
    FILE_LEVELS = 8
    LINEAR = 16
    ALPHA_WEIGHTED = 32
    PREMULTIPLY = 64

class BitmapFlag(enum.IntFlag):
    NONE = 0
    PARTIAL = 1
    PREMULTIPLIED = 2

class Dither(enum.IntEnum):
    NONE = 0
    ORDERED = 1

class LightKind(enum.IntEnum):
    POINT = 0
    DIRECTIONAL = 1
    AMBIENT = 2
    SPOT = 3

class Model(enum.IntEnum):
    LAMBERT = 0
    BLINN_PHONG = 1
    PROGRAM = 2
    UNLIT = 3
    PHONG = 4
    BLINN_PHONG_NORMALIZED = 5
    COMBINED = 6
    GOOCH = 7
    TOON = 8
    METALLIC_ROUGHNESS = 9
    MATCAP = 10
    GLASS = 11

class DebugView(enum.IntEnum):
    NONE = 0
    NORMAL = 1
    UV = 2
    LEVEL = 3
    BARYCENTRICS = 4

class NormalEncoding(enum.IntEnum):
    XYZ = 0
    XY = 1
    TOKSVIG = 2
    MOMENTS = 3

class Bump(enum.IntEnum):
    NONE = 0
    GRADIENT = 1
    TEXEL = 2

class Blend(enum.IntEnum):
    OPAQUE = 0
    PREMULTIPLIED = 1
    STRAIGHT = 2
    ADD = 3
    MULTIPLY = 4
    WEIGHTED = 5
    SORTED = 6

class MaterialFlag(enum.IntFlag):
    NONE = 0
    SPECULAR_UNGATED = 1
    AMBIENT_PER_LIGHT = 2
    DISCARDS = 4
    ALPHA_TO_COVERAGE = 8
    DOUBLE_SIDED = 16
    NORMAL_Y_DOWN = 32

class NormalWeight(enum.IntEnum):
    AREA = 0
    UNIFORM = 1
    ANGLE = 2

class Topology(enum.IntEnum):
    TRIANGLES = 0
    STRIP = 1
    FAN = 2

class MeshFlag(enum.IntFlag):
    NONE = 0
    KEEP_NONFINITE = 1
    TANGENTS = 2
    ADJACENCY = 4

class MipKernel(enum.IntEnum):
    BOX = 0
    TRIANGLE = 1
    KAISER = 2
    LANCZOS = 3

class MipSource(enum.IntEnum):
    BASE = 0
    PREVIOUS = 1

class TexelContent(enum.IntEnum):
    COLOR = 0
    DATA = 1
    NORMAL = 2
    HEIGHT = 3
    ALPHA_COVERAGE = 4
    ALPHA_WEIGHTED = 5

class Barycentric(enum.IntEnum):
    WACHSPRESS = 0
    MEAN_VALUE = 1
    DISCRETE_HARMONIC = 2
    HARMONIC = 3

class Projection(enum.IntEnum):
    NONE = 0
    LAT_LONG = 1
    MIRROR_BALL = 2
    ANGULAR = 3
    CUBE = 4
    OCTAHEDRAL = 5

class CubeLayout(enum.IntEnum):
    FACES = 0
    ROW = 1
    COLUMN = 2
    HORIZONTAL_CROSS = 3
    VERTICAL_CROSS = 4

class Frequency(enum.IntEnum):
    PHONG = 0
    GOURAUD = 1
    FLAT = 2

class Cull(enum.IntEnum):
    NONE = 0
    BACK = 1
    FRONT = 2

class DrawFlag(enum.IntFlag):
    NONE = 0
    KEEP_DEPTH = 1
    SAMPLE_SHADING = 2

class Fill(enum.IntEnum):
    SOLID = 0
    WIREFRAME = 1
    POINTS = 2
    LINES = 3

class RenderFlag(enum.IntFlag):
    NONE = 0
    COUNT_HIDDEN = 1
    LOAD = 2

class Visibility(enum.IntEnum):
    DEPTH = 0
    PAINTER = 1
    NEWELL = 2

class Background(enum.IntEnum):
    CLEAR = 0
    ENVIRONMENT = 1

class Result(enum.IntEnum):
    OK = 0
    ERROR_INVALID_ARGUMENT = 1
    ERROR_OUT_OF_MEMORY = 2
    ERROR_UNSUPPORTED = 3
    ERROR_NOT_FOUND = 4
    ERROR_IO = 5
    ERROR_CORRUPT = 6
    ERROR_LIMIT = 7
    ERROR_CANCELLED = 8
    ERROR_CALLBACK = 9
    ERROR_INTERNAL = 10

class Filter(enum.IntEnum):
    TRILINEAR = 0
    NEAREST = 1
    BILINEAR = 2
    BICUBIC = 3
    NEAREST_MIP = 4
    BILINEAR_MIP = 5
    RIPMAP = 6
    SUMMED_AREA = 7
    ANISOTROPIC = 8
    EWA = 9
    STOCHASTIC = 10
    EXACT = 11
    NEAREST_MIP_LINEAR = 12

class Magnification(enum.IntEnum):
    DEFAULT = 0
    NEAREST = 1
    BILINEAR = 2
    BICUBIC = 3

class Cubic(enum.IntEnum):
    CATMULL_ROM = 0
    B_SPLINE = 1
    MITCHELL = 2

class ProbeWeights(enum.IntEnum):
    EQUAL = 0
    GAUSSIAN = 1

class Box(enum.IntEnum):
    BOUNDING = 0
    ORIENTED = 1

class Profile(enum.IntEnum):
    LEAST_ERROR = 0
    VULKAN = 1
    D3D11 = 2
    OIIO = 3
    EXACT = 4

class Precision(enum.IntEnum):
    FULL = 0
    FAST = 1

class Stochastic(enum.IntEnum):
    TEXEL = 0
    QUAD = 1

class MissingTiles(enum.IntEnum):
    WAIT = 0
    COARSER = 1

class Compare(enum.IntEnum):
    LESS = 0
    LESS_EQUAL = 1
    EQUAL = 2
    GREATER_EQUAL = 3
    GREATER = 4
    NOT_EQUAL = 5
    ALWAYS = 6
    NEVER = 7

class SceneFlag(enum.IntFlag):
    NONE = 0
    REQUIRE_TEXTURES = 1
    HOST_FILTERS = 2
    IN_PROCESS = 4
    ANY_FOLDER = 8

class ScenePart(enum.IntEnum):
    MESH = 0
    MATERIAL = 1
    TEXTURE = 2
    LIGHT = 3
    CAMERA = 4
    ANIMATION = 5

class ShadowFilter(enum.IntEnum):
    HARD = 0
    PCF = 1
    VARIANCE = 2
    SUMMED_AREA_VARIANCE = 3
    PCSS = 4

class Shape(enum.IntEnum):
    SPHERE = 0
    BOX = 1
    PLANE = 2
    TORUS = 3
    TEAPOT = 4

class SlotTarget(enum.IntEnum):
    DIFFUSE = 0
    AMBIENT = 1
    SPECULAR = 2
    EXPONENT = 3
    OPACITY = 4
    EMISSION = 5
    METALLIC = 6
    ROUGHNESS = 7
    OCCLUSION = 8
    NORMAL = 9
    HEIGHT = 10
    MATCAP = 11
    NORMAL_MIXED = 12
    CLEARCOAT = 13
    CLEARCOAT_ROUGHNESS = 14
    CLEARCOAT_NORMAL = 15
    TINT = 16

class SlotSource(enum.IntEnum):
    CONSTANT = 0
    TEXTURE = 1
    VERTEX = 2
    PROCEDURE = 3
    SOLID = 4

class PlaceSpace(enum.IntEnum):
    OBJECT = 0
    WORLD = 1

class Solid(enum.IntEnum):
    STRIPES = 0
    CHECKER = 1
    PERLIN = 2
    VALUE = 3
    SIMPLEX = 4
    WORLEY = 5
    MARBLE = 6
    WOOD = 7

class SolidSum(enum.IntEnum):
    FBM = 0
    TURBULENCE = 1

class SolidGradients(enum.IntEnum):
    HASHED = 0
    TABLE = 1

class SolidFade(enum.IntEnum):
    QUINTIC = 0
    CUBIC = 1

class SolidDistance(enum.IntEnum):
    F1 = 0
    F2 = 1
    F2_F1 = 2

class TessellationMode(enum.IntEnum):
    UNIFORM = 0
    ADAPTIVE = 1

class DisplacedNormals(enum.IntEnum):
    TILTED = 0
    KEPT = 1
    FACES = 2

class Table(enum.IntFlag):
    NONE = 0
    MIPMAP = 1
    RIPMAP = 2
    SUMMED_AREA = 4

class Channel(enum.IntEnum):
    DEFAULT = 0
    R = 1
    G = 2
    B = 3
    A = 4
    FILL = 5

class TextureFlag(enum.IntFlag):
    NONE = 0
    BORROW = 1
    BORROW_LEVELS = 2
    PREMULTIPLIED = 4

class TextureFileKind(enum.IntEnum):
    NONE = 0
    KTX2 = 1
    DDS = 2

class Supercompression(enum.IntEnum):
    NONE = 0
    BASIS_LZ = 1
    ZSTD = 2
    ZLIB = 3

class TextureFileFlag(enum.IntFlag):
    NONE = 0
    PREMULTIPLIED = 1
    ARRAY = 2
    BOTTOM_UP = 4
    RIGHT_TO_LEFT = 8

class DepthOrder(enum.IntEnum):
    FORWARD = 0
    REVERSED = 1

class Interpolation(enum.IntEnum):
    PERSPECTIVE = 0
    AFFINE = 1
    FLAT = 2

class RawSample(enum.IntEnum):
    U8 = 0
    U16 = 1
    F16 = 2
    F32 = 3
    I8 = 4
    I16 = 5
    U32 = 6
    I32 = 7

class ByteOrder(enum.IntEnum):
    LITTLE = 0
    BIG = 1

class VdbFlag(enum.IntFlag):
    DEFAULT = 0
    BOX = 1

class VdbClass(enum.IntEnum):
    UNKNOWN = 0
    LEVEL_SET = 1
    FOG_VOLUME = 2

class Wrap(enum.IntEnum):
    REPEAT = 0
    CLAMP = 1
    MIRROR = 2
    BORDER = 3
    MIRROR_ONCE = 4

class BakeStats(Desc):
    triangles: int
    zero_area_triangles: int
    nonfinite_triangles: int
    outside_triangles: int
    centre_texels: int
    touched_texels: int
    dilated_texels: int
    overlapping_texels: int
    nonfinite_texels: int
    def __init__(self, *,
                 triangles: int = ...,
                 zero_area_triangles: int = ...,
                 nonfinite_triangles: int = ...,
                 outside_triangles: int = ...,
                 centre_texels: int = ...,
                 touched_texels: int = ...,
                 dilated_texels: int = ...,
                 overlapping_texels: int = ...,
                 nonfinite_texels: int = ...,
                 ) -> None: ...

class BakeDesc(Desc):
    uv_set: int
    dilation: int
    flags: int
    states: _Array
    stats: Union[BakeStats, Mapping[str, Any]]
    def __init__(self, *,
                 uv_set: int = ...,
                 dilation: int = ...,
                 flags: int = ...,
                 states: _Array = ...,
                 stats: Union[BakeStats, Mapping[str, Any]] = ...,
                 ) -> None: ...

class BoundsDesc(Desc):
    level_rules: Union[int, str]
    subtexel_bits: int
    level_bits: int
    weight_bits: int
    result_bits: int
    coordinate_error: float
    derivative_error: float
    level_error: float
    relative_error: float
    srgb_error: float
    def __init__(self, *,
                 level_rules: Union[int, str] = ...,
                 subtexel_bits: int = ...,
                 level_bits: int = ...,
                 weight_bits: int = ...,
                 result_bits: int = ...,
                 coordinate_error: float = ...,
                 derivative_error: float = ...,
                 level_error: float = ...,
                 relative_error: float = ...,
                 srgb_error: float = ...,
                 ) -> None: ...

class ColorDesc(Desc):
    display_precision: Union[int, str]
    config_path: str
    config_text: str
    working_space: str
    def __init__(self, *,
                 display_precision: Union[int, str] = ...,
                 config_path: str = ...,
                 config_text: str = ...,
                 working_space: str = ...,
                 ) -> None: ...

class ColorView(Desc):
    color: Color
    display: str
    view: str
    def __init__(self, *,
                 color: Color = ...,
                 display: str = ...,
                 view: str = ...,
                 ) -> None: ...

class F32In(Desc):
    data: _Array
    stride: int
    def __init__(self, *,
                 data: _Array = ...,
                 stride: int = ...,
                 ) -> None: ...

class F32Out(Desc):
    data: _Array
    stride: int
    def __init__(self, *,
                 data: _Array = ...,
                 stride: int = ...,
                 ) -> None: ...

class U32In(Desc):
    data: _Array
    stride: int
    def __init__(self, *,
                 data: _Array = ...,
                 stride: int = ...,
                 ) -> None: ...

class U32Out(Desc):
    data: _Array
    stride: int
    def __init__(self, *,
                 data: _Array = ...,
                 stride: int = ...,
                 ) -> None: ...

class U16In(Desc):
    data: _Array
    stride: int
    def __init__(self, *,
                 data: _Array = ...,
                 stride: int = ...,
                 ) -> None: ...

class Allocator(Desc):
    allocate: Callable[..., object]
    free: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 allocate: Callable[..., object] = ...,
                 free: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class Executor(Desc):
    parallel_for: Callable[..., object]
    user_data: _Array
    worker_count: int
    def __init__(self, *,
                 parallel_for: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 worker_count: int = ...,
                 ) -> None: ...

class Log(Desc):
    write: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 write: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class ContextDesc(Desc):
    flags: Union[int, str]
    worker_count: int
    simd: Union[int, str]
    allocator: Union[Allocator, Mapping[str, Any]]
    executor: Union[Executor, Mapping[str, Any]]
    log: Union[Log, Mapping[str, Any]]
    def __init__(self, *,
                 flags: Union[int, str] = ...,
                 worker_count: int = ...,
                 simd: Union[int, str] = ...,
                 allocator: Union[Allocator, Mapping[str, Any]] = ...,
                 executor: Union[Executor, Mapping[str, Any]] = ...,
                 log: Union[Log, Mapping[str, Any]] = ...,
                 ) -> None: ...

class EdgesDesc(Desc):
    edges: Union[int, str]
    eye: _Array
    crease_cosine: float
    def __init__(self, *,
                 edges: Union[int, str] = ...,
                 eye: _Array = ...,
                 crease_cosine: float = ...,
                 ) -> None: ...

class Edges(Desc):
    vertex: _Array
    triangle: _Array
    kinds: _Array
    def __init__(self, *,
                 vertex: _Array = ...,
                 triangle: _Array = ...,
                 kinds: _Array = ...,
                 ) -> None: ...

class EnvironmentDesc(Desc):
    projection: Union[int, str]
    image: Union[Image, Mapping[str, Any]]
    irradiance: Union[int, str]
    tables: Union[int, str]
    def __init__(self, *,
                 projection: Union[int, str] = ...,
                 image: Union[Image, Mapping[str, Any]] = ...,
                 irradiance: Union[int, str] = ...,
                 tables: Union[int, str] = ...,
                 ) -> None: ...

class EnvironmentInfo(Desc):
    projection: Union[int, str]
    irradiance: Union[int, str]
    tables: Union[int, str]
    map_size: int
    mean: _Array
    replaced_count: int
    byte_size: int
    def __init__(self, *,
                 projection: Union[int, str] = ...,
                 irradiance: Union[int, str] = ...,
                 tables: Union[int, str] = ...,
                 map_size: int = ...,
                 mean: _Array = ...,
                 replaced_count: int = ...,
                 byte_size: int = ...,
                 ) -> None: ...

class EnvironmentLookups(Desc):
    count: int
    direction: _Array
    roughness: _Array
    exponent: _Array
    def __init__(self, *,
                 count: int = ...,
                 direction: _Array = ...,
                 roughness: _Array = ...,
                 exponent: _Array = ...,
                 ) -> None: ...

class EnvironmentLight(Desc):
    rgb: _Array
    def __init__(self, *,
                 rgb: _Array = ...,
                 ) -> None: ...

class Tap(Desc):
    layer: int
    level_u: int
    level_v: int
    x: int
    y: int
    border: int
    weight: float
    value: _Array
    z: int
    def __init__(self, *,
                 layer: int = ...,
                 level_u: int = ...,
                 level_v: int = ...,
                 x: int = ...,
                 y: int = ...,
                 border: int = ...,
                 weight: float = ...,
                 value: _Array = ...,
                 z: int = ...,
                 ) -> None: ...

class BlendStep(Desc):
    a: int
    b: int
    s: float
    def __init__(self, *,
                 a: int = ...,
                 b: int = ...,
                 s: float = ...,
                 ) -> None: ...

class Explanation(Desc):
    taps: Union[Tap, Sequence[Union[Tap, Mapping[str, Any]]]]
    blends: Union[BlendStep, Sequence[Union[BlendStep, Mapping[str, Any]]]]
    tap_size: int
    tap_capacity: int
    tap_count: int
    blend_size: int
    blend_capacity: int
    blend_count: int
    filter: Union[int, str]
    result: _Array
    lod: float
    scale_high: _Array
    scale_low: _Array
    channel_source: _Array
    longer_axis: _Array
    shorter_axis: _Array
    def __init__(self, *,
                 taps: Union[Tap, Sequence[Union[Tap, Mapping[str, Any]]]] = ...,
                 blends: Union[BlendStep, Sequence[Union[BlendStep, Mapping[str, Any]]]] = ...,
                 tap_size: int = ...,
                 tap_capacity: int = ...,
                 tap_count: int = ...,
                 blend_size: int = ...,
                 blend_capacity: int = ...,
                 blend_count: int = ...,
                 filter: Union[int, str] = ...,
                 result: _Array = ...,
                 lod: float = ...,
                 scale_high: _Array = ...,
                 scale_low: _Array = ...,
                 channel_source: _Array = ...,
                 longer_axis: _Array = ...,
                 shorter_axis: _Array = ...,
                 ) -> None: ...

class Derivatives(Desc):
    dudx: _Array
    dvdx: _Array
    dudy: _Array
    dvdy: _Array
    def __init__(self, *,
                 dudx: _Array = ...,
                 dvdx: _Array = ...,
                 dudy: _Array = ...,
                 dvdy: _Array = ...,
                 ) -> None: ...

class RayDifferentials(Desc):
    count: int
    dpdu: _Array
    dpdv: _Array
    direction: _Array
    distance: _Array
    origin_dx: _Array
    origin_dy: _Array
    direction_dx: _Array
    direction_dy: _Array
    def __init__(self, *,
                 count: int = ...,
                 dpdu: _Array = ...,
                 dpdv: _Array = ...,
                 direction: _Array = ...,
                 distance: _Array = ...,
                 origin_dx: _Array = ...,
                 origin_dy: _Array = ...,
                 direction_dx: _Array = ...,
                 direction_dy: _Array = ...,
                 ) -> None: ...

class RayCones(Desc):
    count: int
    dpdu: _Array
    dpdv: _Array
    direction: _Array
    width: _Array
    def __init__(self, *,
                 count: int = ...,
                 dpdu: _Array = ...,
                 dpdv: _Array = ...,
                 direction: _Array = ...,
                 width: _Array = ...,
                 ) -> None: ...

class Fragments(Desc):
    draw: int
    instance: int
    varying_count: int
    attribute_count: int
    count: int
    uniforms: _Array
    x: _Array
    y: _Array
    depth: _Array
    triangle: _Array
    px: _Array
    py: _Array
    pz: _Array
    nx: _Array
    ny: _Array
    nz: _Array
    ox: _Array
    oy: _Array
    oz: _Array
    tx: _Array
    ty: _Array
    tz: _Array
    tw: _Array
    u: _Array
    v: _Array
    u1: _Array
    v1: _Array
    dudx: _Array
    dvdx: _Array
    dudy: _Array
    dvdy: _Array
    attribute: _Array
    varying: _Array
    def __init__(self, *,
                 draw: int = ...,
                 instance: int = ...,
                 varying_count: int = ...,
                 attribute_count: int = ...,
                 count: int = ...,
                 uniforms: _Array = ...,
                 x: _Array = ...,
                 y: _Array = ...,
                 depth: _Array = ...,
                 triangle: _Array = ...,
                 px: _Array = ...,
                 py: _Array = ...,
                 pz: _Array = ...,
                 nx: _Array = ...,
                 ny: _Array = ...,
                 nz: _Array = ...,
                 ox: _Array = ...,
                 oy: _Array = ...,
                 oz: _Array = ...,
                 tx: _Array = ...,
                 ty: _Array = ...,
                 tz: _Array = ...,
                 tw: _Array = ...,
                 u: _Array = ...,
                 v: _Array = ...,
                 u1: _Array = ...,
                 v1: _Array = ...,
                 dudx: _Array = ...,
                 dvdx: _Array = ...,
                 dudy: _Array = ...,
                 dvdy: _Array = ...,
                 attribute: _Array = ...,
                 varying: _Array = ...,
                 ) -> None: ...

class Radiance(Desc):
    target_count: int
    r: _Array
    g: _Array
    b: _Array
    a: _Array
    discard: _Array
    target: _Array
    def __init__(self, *,
                 target_count: int = ...,
                 r: _Array = ...,
                 g: _Array = ...,
                 b: _Array = ...,
                 a: _Array = ...,
                 discard: _Array = ...,
                 target: _Array = ...,
                 ) -> None: ...

class FramebufferDesc(Desc):
    width: int
    height: int
    samples: int
    aovs: Union[int, str]
    color_format: Union[int, str]
    def __init__(self, *,
                 width: int = ...,
                 height: int = ...,
                 samples: int = ...,
                 aovs: Union[int, str] = ...,
                 color_format: Union[int, str] = ...,
                 ) -> None: ...

class FramebufferInfo(Desc):
    width: int
    height: int
    samples: int
    aovs: Union[int, str]
    color_format: Union[int, str]
    byte_size: int
    def __init__(self, *,
                 width: int = ...,
                 height: int = ...,
                 samples: int = ...,
                 aovs: Union[int, str] = ...,
                 color_format: Union[int, str] = ...,
                 byte_size: int = ...,
                 ) -> None: ...

class PlaneView(Desc):
    f32: _Array
    u32: _Array
    row_stride: int
    def __init__(self, *,
                 f32: _Array = ...,
                 u32: _Array = ...,
                 row_stride: int = ...,
                 ) -> None: ...

class Display(Desc):
    apply: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 apply: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class Image(Desc):
    format: Union[int, str]
    width: int
    height: int
    pixels: _Array
    row_stride: int
    def __init__(self, *,
                 format: Union[int, str] = ...,
                 width: int = ...,
                 height: int = ...,
                 pixels: _Array = ...,
                 row_stride: int = ...,
                 ) -> None: ...

class LoadDesc(Desc):
    formats: Union[int, str]
    flags: Union[int, str]
    color_space: Union[int, str]
    tables: Union[int, str]
    subimage: int
    max_file_bytes: int
    max_pixels: int
    max_bytes: int
    max_ratio: float
    time_limit: float
    worker_path: str
    raw: Union[RawDesc, Mapping[str, Any]]
    stack: Union[StackDesc, Mapping[str, Any]]
    vdb: Union[VdbDesc, Mapping[str, Any]]
    info: Union[TextureFileInfo, Mapping[str, Any]]
    vdb_info: Union[VdbInfo, Mapping[str, Any]]
    def __init__(self, *,
                 formats: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 color_space: Union[int, str] = ...,
                 tables: Union[int, str] = ...,
                 subimage: int = ...,
                 max_file_bytes: int = ...,
                 max_pixels: int = ...,
                 max_bytes: int = ...,
                 max_ratio: float = ...,
                 time_limit: float = ...,
                 worker_path: str = ...,
                 raw: Union[RawDesc, Mapping[str, Any]] = ...,
                 stack: Union[StackDesc, Mapping[str, Any]] = ...,
                 vdb: Union[VdbDesc, Mapping[str, Any]] = ...,
                 info: Union[TextureFileInfo, Mapping[str, Any]] = ...,
                 vdb_info: Union[VdbInfo, Mapping[str, Any]] = ...,
                 ) -> None: ...

class BitmapInfo(Desc):
    file_format: Union[int, str]
    channels: int
    flags: Union[int, str]
    def __init__(self, *,
                 file_format: Union[int, str] = ...,
                 channels: int = ...,
                 flags: Union[int, str] = ...,
                 ) -> None: ...

class SaveDesc(Desc):
    bit_depth: int
    color_space: Union[int, str]
    dither: Union[int, str]
    display: Union[Display, Mapping[str, Any]]
    def __init__(self, *,
                 bit_depth: int = ...,
                 color_space: Union[int, str] = ...,
                 dither: Union[int, str] = ...,
                 display: Union[Display, Mapping[str, Any]] = ...,
                 ) -> None: ...

class LightDesc(Desc):
    kind: Union[int, str]
    intensity: _Array
    position: _Array
    direction: _Array
    range: float
    inner_angle: float
    outer_angle: float
    up: _Array
    extent: _Array
    texture: Texture
    sampler: Sampler
    def __init__(self, *,
                 kind: Union[int, str] = ...,
                 intensity: _Array = ...,
                 position: _Array = ...,
                 direction: _Array = ...,
                 range: float = ...,
                 inner_angle: float = ...,
                 outer_angle: float = ...,
                 up: _Array = ...,
                 extent: _Array = ...,
                 texture: Texture = ...,
                 sampler: Sampler = ...,
                 ) -> None: ...

class Lookups(Desc):
    count: int
    u: _Array
    v: _Array
    dudx: _Array
    dvdx: _Array
    dudy: _Array
    dvdy: _Array
    lod: _Array
    layer: _Array
    random: _Array
    w: _Array
    dwdx: _Array
    dwdy: _Array
    reference: _Array
    def __init__(self, *,
                 count: int = ...,
                 u: _Array = ...,
                 v: _Array = ...,
                 dudx: _Array = ...,
                 dvdx: _Array = ...,
                 dudy: _Array = ...,
                 dvdy: _Array = ...,
                 lod: _Array = ...,
                 layer: _Array = ...,
                 random: _Array = ...,
                 w: _Array = ...,
                 dwdx: _Array = ...,
                 dwdy: _Array = ...,
                 reference: _Array = ...,
                 ) -> None: ...

class Texels(Desc):
    channel: _Array
    du: _Array
    dv: _Array
    nonfinite_count: int
    dw: _Array
    coarser: _Array
    def __init__(self, *,
                 channel: _Array = ...,
                 du: _Array = ...,
                 dv: _Array = ...,
                 nonfinite_count: int = ...,
                 dw: _Array = ...,
                 coarser: _Array = ...,
                 ) -> None: ...

class Levels(Desc):
    lod: _Array
    level: _Array
    def __init__(self, *,
                 lod: _Array = ...,
                 level: _Array = ...,
                 ) -> None: ...

class MaterialProgram(Desc):
    fragment: Callable[..., object]
    vertex: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 fragment: Callable[..., object] = ...,
                 vertex: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class MaterialDesc(Desc):
    model: Union[int, str]
    debug_view: Union[int, str]
    flags: Union[int, str]
    ambient: _Array
    ambient_share: float
    diffuse: _Array
    specular: _Array
    exponent: float
    metallic: float
    roughness: float
    ior: float
    emission: _Array
    opacity: float
    occlusion_strength: float
    slots: Union[Slot, Sequence[Union[Slot, Mapping[str, Any]]]]
    slot_count: int
    normal_encoding: Union[int, str]
    normal_scale: float
    bump: Union[int, str]
    bump_scale: float
    parallax_depth: float
    parallax_steps: int
    warm: _Array
    cool: _Array
    warm_mix: float
    cool_mix: float
    toon_steps: int
    blend: Union[int, str]
    alpha_cutoff: float
    program: Union[MaterialProgram, Mapping[str, Any]]
    interpolation: _Array
    varying_count: int
    clearcoat: float
    clearcoat_roughness: float
    def __init__(self, *,
                 model: Union[int, str] = ...,
                 debug_view: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 ambient: _Array = ...,
                 ambient_share: float = ...,
                 diffuse: _Array = ...,
                 specular: _Array = ...,
                 exponent: float = ...,
                 metallic: float = ...,
                 roughness: float = ...,
                 ior: float = ...,
                 emission: _Array = ...,
                 opacity: float = ...,
                 occlusion_strength: float = ...,
                 slots: Union[Slot, Sequence[Union[Slot, Mapping[str, Any]]]] = ...,
                 slot_count: int = ...,
                 normal_encoding: Union[int, str] = ...,
                 normal_scale: float = ...,
                 bump: Union[int, str] = ...,
                 bump_scale: float = ...,
                 parallax_depth: float = ...,
                 parallax_steps: int = ...,
                 warm: _Array = ...,
                 cool: _Array = ...,
                 warm_mix: float = ...,
                 cool_mix: float = ...,
                 toon_steps: int = ...,
                 blend: Union[int, str] = ...,
                 alpha_cutoff: float = ...,
                 program: Union[MaterialProgram, Mapping[str, Any]] = ...,
                 interpolation: _Array = ...,
                 varying_count: int = ...,
                 clearcoat: float = ...,
                 clearcoat_roughness: float = ...,
                 ) -> None: ...

class MeshDesc(Desc):
    vertex_count: int
    position: _Array
    normal: _Array
    normal_weight: Union[int, str]
    flags: Union[int, str]
    tangent: _Array
    uv: _Array
    uv1: _Array
    attributes: _Array
    attribute_count: int
    topology: Union[int, str]
    indices: _Array
    indices16: _Array
    index_count: int
    def __init__(self, *,
                 vertex_count: int = ...,
                 position: _Array = ...,
                 normal: _Array = ...,
                 normal_weight: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 tangent: _Array = ...,
                 uv: _Array = ...,
                 uv1: _Array = ...,
                 attributes: _Array = ...,
                 attribute_count: int = ...,
                 topology: Union[int, str] = ...,
                 indices: _Array = ...,
                 indices16: _Array = ...,
                 index_count: int = ...,
                 ) -> None: ...

class MeshInfo(Desc):
    vertex_count: int
    triangle_count: int
    bounds_min: _Array
    bounds_max: _Array
    nonfinite_count: int
    normalless_count: int
    tangentless_count: int
    split_count: int
    def __init__(self, *,
                 vertex_count: int = ...,
                 triangle_count: int = ...,
                 bounds_min: _Array = ...,
                 bounds_max: _Array = ...,
                 nonfinite_count: int = ...,
                 normalless_count: int = ...,
                 tangentless_count: int = ...,
                 split_count: int = ...,
                 ) -> None: ...

class MipDesc(Desc):
    content: Union[int, str]
    kernel: Union[int, str]
    source: Union[int, str]
    wrap_u: Union[int, str]
    wrap_v: Union[int, str]
    alpha_cutoff: float
    def __init__(self, *,
                 content: Union[int, str] = ...,
                 kernel: Union[int, str] = ...,
                 source: Union[int, str] = ...,
                 wrap_u: Union[int, str] = ...,
                 wrap_v: Union[int, str] = ...,
                 alpha_cutoff: float = ...,
                 ) -> None: ...

class Rays(Desc):
    count: int
    ox: _Array
    oy: _Array
    oz: _Array
    dx: _Array
    dy: _Array
    dz: _Array
    length: _Array
    def __init__(self, *,
                 count: int = ...,
                 ox: _Array = ...,
                 oy: _Array = ...,
                 oz: _Array = ...,
                 dx: _Array = ...,
                 dy: _Array = ...,
                 dz: _Array = ...,
                 length: _Array = ...,
                 ) -> None: ...

class Tracer(Desc):
    trace: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 trace: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class OcclusionDesc(Desc):
    rays: int
    seed: int
    radius: float
    bias: float
    map_size: int
    tracer: Union[Tracer, Mapping[str, Any]]
    draws: Union[Draw, Mapping[str, Any]]
    draw_count: int
    def __init__(self, *,
                 rays: int = ...,
                 seed: int = ...,
                 radius: float = ...,
                 bias: float = ...,
                 map_size: int = ...,
                 tracer: Union[Tracer, Mapping[str, Any]] = ...,
                 draws: Union[Draw, Mapping[str, Any]] = ...,
                 draw_count: int = ...,
                 ) -> None: ...

class OcclusionPoints(Desc):
    count: int
    position: _Array
    normal: _Array
    def __init__(self, *,
                 count: int = ...,
                 position: _Array = ...,
                 normal: _Array = ...,
                 ) -> None: ...

class OcclusionAtlas(Desc):
    width: int
    height: int
    uv_set: int
    dilation: int
    empty: float
    draws: Union[Draw, Sequence[Union[Draw, Mapping[str, Any]]]]
    draw_count: int
    states: _Array
    stats: Union[BakeStats, Mapping[str, Any]]
    def __init__(self, *,
                 width: int = ...,
                 height: int = ...,
                 uv_set: int = ...,
                 dilation: int = ...,
                 empty: float = ...,
                 draws: Union[Draw, Sequence[Union[Draw, Mapping[str, Any]]]] = ...,
                 draw_count: int = ...,
                 states: _Array = ...,
                 stats: Union[BakeStats, Mapping[str, Any]] = ...,
                 ) -> None: ...

class PolygonDesc(Desc):
    kind: Union[int, str]
    vertex: _Array
    vertex_count: int
    segments: int
    def __init__(self, *,
                 kind: Union[int, str] = ...,
                 vertex: _Array = ...,
                 vertex_count: int = ...,
                 segments: int = ...,
                 ) -> None: ...

class PolygonPoints(Desc):
    count: int
    position: _Array
    def __init__(self, *,
                 count: int = ...,
                 position: _Array = ...,
                 ) -> None: ...

class PolygonWeights(Desc):
    weight_count: int
    weight: _Array
    outside_count: int
    nonfinite_count: int
    def __init__(self, *,
                 weight_count: int = ...,
                 weight: _Array = ...,
                 outside_count: int = ...,
                 nonfinite_count: int = ...,
                 ) -> None: ...

class PresentTile(Desc):
    worker: int
    x: int
    y: int
    width: int
    height: int
    channel: _Array
    row_stride: int
    def __init__(self, *,
                 worker: int = ...,
                 x: int = ...,
                 y: int = ...,
                 width: int = ...,
                 height: int = ...,
                 channel: _Array = ...,
                 row_stride: int = ...,
                 ) -> None: ...

class Present(Desc):
    tile: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 tile: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class Directions(Desc):
    projection: Union[int, str]
    count: int
    direction: _Array
    direction_dx: _Array
    direction_dy: _Array
    def __init__(self, *,
                 projection: Union[int, str] = ...,
                 count: int = ...,
                 direction: _Array = ...,
                 direction_dx: _Array = ...,
                 direction_dy: _Array = ...,
                 ) -> None: ...

class ProjectedPoints(Desc):
    u: _Array
    v: _Array
    face: _Array
    dudx: _Array
    dvdx: _Array
    dudy: _Array
    dvdy: _Array
    nonfinite_count: int
    def __init__(self, *,
                 u: _Array = ...,
                 v: _Array = ...,
                 face: _Array = ...,
                 dudx: _Array = ...,
                 dvdx: _Array = ...,
                 dudy: _Array = ...,
                 dvdy: _Array = ...,
                 nonfinite_count: int = ...,
                 ) -> None: ...

class ImagePoints(Desc):
    projection: Union[int, str]
    count: int
    u: _Array
    v: _Array
    face: _Array
    def __init__(self, *,
                 projection: Union[int, str] = ...,
                 count: int = ...,
                 u: _Array = ...,
                 v: _Array = ...,
                 face: _Array = ...,
                 ) -> None: ...

class PointDirections(Desc):
    direction: _Array
    solid_angle: _Array
    nonfinite_count: int
    def __init__(self, *,
                 direction: _Array = ...,
                 solid_angle: _Array = ...,
                 nonfinite_count: int = ...,
                 ) -> None: ...

class DirectionImages(Desc):
    projection: Union[int, str]
    layout: Union[int, str]
    images: Union[Image, Mapping[str, Any]]
    def __init__(self, *,
                 projection: Union[int, str] = ...,
                 layout: Union[int, str] = ...,
                 images: Union[Image, Mapping[str, Any]] = ...,
                 ) -> None: ...

class Draw(Desc):
    mesh: Mesh
    material: Material
    uniforms: _Array
    object_to_world: _Array
    instances: _Array
    instance_count: int
    frequency: Union[int, str]
    flags: Union[int, str]
    cull: Union[int, str]
    compare: Union[int, str]
    depth_bias: float
    depth_bias_slope: float
    fill: Union[int, str]
    fill_width: float
    edges: Union[int, str]
    crease_cosine: float
    def __init__(self, *,
                 mesh: Mesh = ...,
                 material: Material = ...,
                 uniforms: _Array = ...,
                 object_to_world: _Array = ...,
                 instances: _Array = ...,
                 instance_count: int = ...,
                 frequency: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 cull: Union[int, str] = ...,
                 compare: Union[int, str] = ...,
                 depth_bias: float = ...,
                 depth_bias_slope: float = ...,
                 fill: Union[int, str] = ...,
                 fill_width: float = ...,
                 edges: Union[int, str] = ...,
                 crease_cosine: float = ...,
                 ) -> None: ...

class RenderStats(Desc):
    triangles: int
    nonfinite: int
    outside: int
    culled: int
    empty: int
    rasterised: int
    clipped: int
    fragments: int
    nonfinite_fragments: int
    hidden_samples: int
    order_conflicts: int
    splits: int
    scratch_bytes: int
    vertex_seconds: float
    assembly_seconds: float
    binning_seconds: float
    tile_seconds: float
    def __init__(self, *,
                 triangles: int = ...,
                 nonfinite: int = ...,
                 outside: int = ...,
                 culled: int = ...,
                 empty: int = ...,
                 rasterised: int = ...,
                 clipped: int = ...,
                 fragments: int = ...,
                 nonfinite_fragments: int = ...,
                 hidden_samples: int = ...,
                 order_conflicts: int = ...,
                 splits: int = ...,
                 scratch_bytes: int = ...,
                 vertex_seconds: float = ...,
                 assembly_seconds: float = ...,
                 binning_seconds: float = ...,
                 tile_seconds: float = ...,
                 ) -> None: ...

class Progress(Desc):
    report: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 report: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class Region(Desc):
    x: int
    y: int
    width: int
    height: int
    def __init__(self, *,
                 x: int = ...,
                 y: int = ...,
                 width: int = ...,
                 height: int = ...,
                 ) -> None: ...

class RenderDesc(Desc):
    framebuffer: Framebuffer
    clear_color: _Array
    clear_depth: float
    flags: Union[int, str]
    camera: Union[Camera, Mapping[str, Any]]
    view: Union[View, Mapping[str, Any]]
    visibility: Union[int, str]
    draws: Union[Draw, Sequence[Union[Draw, Mapping[str, Any]]]]
    draw_count: int
    lights: Sequence[Union[Light, None]]
    shadows: Sequence[Union[Shadow, None]]
    light_count: int
    picture_width: int
    picture_height: int
    crop_x: int
    crop_y: int
    viewport: Union[Region, Mapping[str, Any]]
    scissor: Union[Region, Mapping[str, Any]]
    supersampling: int
    pass_triangles: int
    stats: Union[RenderStats, Mapping[str, Any]]
    progress: Union[Progress, Mapping[str, Any]]
    present: Union[Present, Mapping[str, Any]]
    environment: Environment
    environment_intensity: float
    environment_to_world: _Array
    background: Union[int, str]
    background_roughness: float
    volumes: Union[VolumeDraw, Sequence[Union[VolumeDraw, Mapping[str, Any]]]]
    volume_count: int
    def __init__(self, *,
                 framebuffer: Framebuffer = ...,
                 clear_color: _Array = ...,
                 clear_depth: float = ...,
                 flags: Union[int, str] = ...,
                 camera: Union[Camera, Mapping[str, Any]] = ...,
                 view: Union[View, Mapping[str, Any]] = ...,
                 visibility: Union[int, str] = ...,
                 draws: Union[Draw, Sequence[Union[Draw, Mapping[str, Any]]]] = ...,
                 draw_count: int = ...,
                 lights: Sequence[Union[Light, None]] = ...,
                 shadows: Sequence[Union[Shadow, None]] = ...,
                 light_count: int = ...,
                 picture_width: int = ...,
                 picture_height: int = ...,
                 crop_x: int = ...,
                 crop_y: int = ...,
                 viewport: Union[Region, Mapping[str, Any]] = ...,
                 scissor: Union[Region, Mapping[str, Any]] = ...,
                 supersampling: int = ...,
                 pass_triangles: int = ...,
                 stats: Union[RenderStats, Mapping[str, Any]] = ...,
                 progress: Union[Progress, Mapping[str, Any]] = ...,
                 present: Union[Present, Mapping[str, Any]] = ...,
                 environment: Environment = ...,
                 environment_intensity: float = ...,
                 environment_to_world: _Array = ...,
                 background: Union[int, str] = ...,
                 background_roughness: float = ...,
                 volumes: Union[VolumeDraw, Sequence[Union[VolumeDraw, Mapping[str, Any]]]] = ...,
                 volume_count: int = ...,
                 ) -> None: ...

class SamplerDesc(Desc):
    filter: Union[int, str]
    magnification: Union[int, str]
    wrap_u: Union[int, str]
    wrap_v: Union[int, str]
    border: _Array
    profile: Union[int, str]
    lod_bias: float
    lod_min: float
    lod_max: float
    width_x: float
    width_y: float
    blur_u: float
    blur_v: float
    max_anisotropy: float
    probe_weights: Union[int, str]
    cubic: Union[int, str]
    box: Union[int, str]
    tolerance: float
    stochastic_filter: Union[int, str]
    seed: int
    precision: Union[int, str]
    max_texels: int
    probe_slack: float
    level_blend: float
    stochastic: Union[int, str]
    wrap_w: Union[int, str]
    missing_tiles: Union[int, str]
    compares: int
    compare: Union[int, str]
    def __init__(self, *,
                 filter: Union[int, str] = ...,
                 magnification: Union[int, str] = ...,
                 wrap_u: Union[int, str] = ...,
                 wrap_v: Union[int, str] = ...,
                 border: _Array = ...,
                 profile: Union[int, str] = ...,
                 lod_bias: float = ...,
                 lod_min: float = ...,
                 lod_max: float = ...,
                 width_x: float = ...,
                 width_y: float = ...,
                 blur_u: float = ...,
                 blur_v: float = ...,
                 max_anisotropy: float = ...,
                 probe_weights: Union[int, str] = ...,
                 cubic: Union[int, str] = ...,
                 box: Union[int, str] = ...,
                 tolerance: float = ...,
                 stochastic_filter: Union[int, str] = ...,
                 seed: int = ...,
                 precision: Union[int, str] = ...,
                 max_texels: int = ...,
                 probe_slack: float = ...,
                 level_blend: float = ...,
                 stochastic: Union[int, str] = ...,
                 wrap_w: Union[int, str] = ...,
                 missing_tiles: Union[int, str] = ...,
                 compares: int = ...,
                 compare: Union[int, str] = ...,
                 ) -> None: ...

class SceneDesc(Desc):
    flags: Union[int, str]
    mesh_flags: Union[int, str]
    sampler: Union[SamplerDesc, Mapping[str, Any]]
    texture: Union[LoadDesc, Mapping[str, Any]]
    max_file_bytes: int
    max_vertices: int
    max_triangles: int
    max_nodes: int
    max_instances: int
    max_texture_bytes: int
    time_limit: float
    max_reader_bytes: int
    find: Callable[..., object]
    find_user_data: _Array
    def __init__(self, *,
                 flags: Union[int, str] = ...,
                 mesh_flags: Union[int, str] = ...,
                 sampler: Union[SamplerDesc, Mapping[str, Any]] = ...,
                 texture: Union[LoadDesc, Mapping[str, Any]] = ...,
                 max_file_bytes: int = ...,
                 max_vertices: int = ...,
                 max_triangles: int = ...,
                 max_nodes: int = ...,
                 max_instances: int = ...,
                 max_texture_bytes: int = ...,
                 time_limit: float = ...,
                 max_reader_bytes: int = ...,
                 find: Callable[..., object] = ...,
                 find_user_data: _Array = ...,
                 ) -> None: ...

class SceneInfo(Desc):
    mesh_count: int
    material_count: int
    texture_count: int
    light_count: int
    camera_count: int
    instance_count: int
    warning_count: int
    vertex_count: int
    triangle_count: int
    bounds_min: _Array
    bounds_max: _Array
    origin: _Array
    animation_count: int
    deformed_mesh_count: int
    def __init__(self, *,
                 mesh_count: int = ...,
                 material_count: int = ...,
                 texture_count: int = ...,
                 light_count: int = ...,
                 camera_count: int = ...,
                 instance_count: int = ...,
                 warning_count: int = ...,
                 vertex_count: int = ...,
                 triangle_count: int = ...,
                 bounds_min: _Array = ...,
                 bounds_max: _Array = ...,
                 origin: _Array = ...,
                 animation_count: int = ...,
                 deformed_mesh_count: int = ...,
                 ) -> None: ...

class SceneInstance(Desc):
    mesh: int
    material: int
    object_to_world: _Array
    cull: Union[int, str]
    def __init__(self, *,
                 mesh: int = ...,
                 material: int = ...,
                 object_to_world: _Array = ...,
                 cull: Union[int, str] = ...,
                 ) -> None: ...

class ShadowDesc(Desc):
    size: int
    filter: Union[int, str]
    taps: int
    filter_size: float
    light_size: float
    bias: float
    bias_slope: float
    normal_offset: float
    caster_cull: Union[int, str]
    bleed: float
    min_variance: float
    def __init__(self, *,
                 size: int = ...,
                 filter: Union[int, str] = ...,
                 taps: int = ...,
                 filter_size: float = ...,
                 light_size: float = ...,
                 bias: float = ...,
                 bias_slope: float = ...,
                 normal_offset: float = ...,
                 caster_cull: Union[int, str] = ...,
                 bleed: float = ...,
                 min_variance: float = ...,
                 ) -> None: ...

class ShadowRenderDesc(Desc):
    light: Light
    draws: Union[Draw, Mapping[str, Any]]
    draw_count: int
    near_plane: float
    far_plane: float
    bounds_min: _Array
    bounds_max: _Array
    def __init__(self, *,
                 light: Light = ...,
                 draws: Union[Draw, Mapping[str, Any]] = ...,
                 draw_count: int = ...,
                 near_plane: float = ...,
                 far_plane: float = ...,
                 bounds_min: _Array = ...,
                 bounds_max: _Array = ...,
                 ) -> None: ...

class ShadowLookups(Desc):
    count: int
    position: _Array
    normal: _Array
    def __init__(self, *,
                 count: int = ...,
                 position: _Array = ...,
                 normal: _Array = ...,
                 ) -> None: ...

class ShapeDesc(Desc):
    shape: Union[int, str]
    radius: float
    tube_radius: float
    size: _Array
    segments: _Array
    def __init__(self, *,
                 shape: Union[int, str] = ...,
                 radius: float = ...,
                 tube_radius: float = ...,
                 size: _Array = ...,
                 segments: _Array = ...,
                 ) -> None: ...

class ShapeColumns(Desc):
    vertex_count: int
    index_count: int
    position: _Array
    normal: _Array
    uv: _Array
    indices: _Array
    def __init__(self, *,
                 vertex_count: int = ...,
                 index_count: int = ...,
                 position: _Array = ...,
                 normal: _Array = ...,
                 uv: _Array = ...,
                 indices: _Array = ...,
                 ) -> None: ...

class Slot(Desc):
    target: Union[int, str]
    source: Union[int, str]
    attribute: int
    texture: Texture
    sampler: Sampler
    procedure: Callable[..., object]
    user_data: _Array
    channel: int
    uv_set: int
    uv_transform: _Array
    solid: Union[SolidDesc, Mapping[str, Any]]
    place_transform: _Array
    place_space: Union[int, str]
    place_width: float
    def __init__(self, *,
                 target: Union[int, str] = ...,
                 source: Union[int, str] = ...,
                 attribute: int = ...,
                 texture: Texture = ...,
                 sampler: Sampler = ...,
                 procedure: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 channel: int = ...,
                 uv_set: int = ...,
                 uv_transform: _Array = ...,
                 solid: Union[SolidDesc, Mapping[str, Any]] = ...,
                 place_transform: _Array = ...,
                 place_space: Union[int, str] = ...,
                 place_width: float = ...,
                 ) -> None: ...

class SolidDesc(Desc):
    kind: Union[int, str]
    seed: int
    size: float
    octaves: int
    lacunarity: float
    gain: float
    sum: Union[int, str]
    gradients: Union[int, str]
    fade: Union[int, str]
    distance: Union[int, str]
    distortion: float
    range: _Array
    color_count: int
    colors: _Array
    def __init__(self, *,
                 kind: Union[int, str] = ...,
                 seed: int = ...,
                 size: float = ...,
                 octaves: int = ...,
                 lacunarity: float = ...,
                 gain: float = ...,
                 sum: Union[int, str] = ...,
                 gradients: Union[int, str] = ...,
                 fade: Union[int, str] = ...,
                 distance: Union[int, str] = ...,
                 distortion: float = ...,
                 range: _Array = ...,
                 color_count: int = ...,
                 colors: _Array = ...,
                 ) -> None: ...

class SolidPoints(Desc):
    count: int
    position: _Array
    width: _Array
    def __init__(self, *,
                 count: int = ...,
                 position: _Array = ...,
                 width: _Array = ...,
                 ) -> None: ...

class SolidValues(Desc):
    value: _Array
    gradient: _Array
    color: _Array
    nonfinite_count: int
    def __init__(self, *,
                 value: _Array = ...,
                 gradient: _Array = ...,
                 color: _Array = ...,
                 nonfinite_count: int = ...,
                 ) -> None: ...

class TessellationDesc(Desc):
    mode: Union[int, str]
    segments: int
    max_segments: int
    edge_length: float
    width: int
    height: int
    max_triangles: int
    view: Union[View, Mapping[str, Any]]
    object_to_world: _Array
    displacement: Texture
    sampler: Sampler
    lod: float
    amplitude: float
    offset: float
    normals: Union[int, str]
    def __init__(self, *,
                 mode: Union[int, str] = ...,
                 segments: int = ...,
                 max_segments: int = ...,
                 edge_length: float = ...,
                 width: int = ...,
                 height: int = ...,
                 max_triangles: int = ...,
                 view: Union[View, Mapping[str, Any]] = ...,
                 object_to_world: _Array = ...,
                 displacement: Texture = ...,
                 sampler: Sampler = ...,
                 lod: float = ...,
                 amplitude: float = ...,
                 offset: float = ...,
                 normals: Union[int, str] = ...,
                 ) -> None: ...

class TextureDesc(Desc):
    format: Union[int, str]
    width: int
    height: int
    texels: _Array
    row_stride: int
    layer_stride: int
    layers: int
    flags: Union[int, str]
    swizzle: _Array
    fill: _Array
    tables: Union[int, str]
    level_count: int
    levels: Union[Image, Sequence[Union[Image, Mapping[str, Any]]]]
    depth: int
    projection: Union[int, str]
    tiles: Union[TileSource, Mapping[str, Any]]
    def __init__(self, *,
                 format: Union[int, str] = ...,
                 width: int = ...,
                 height: int = ...,
                 texels: _Array = ...,
                 row_stride: int = ...,
                 layer_stride: int = ...,
                 layers: int = ...,
                 flags: Union[int, str] = ...,
                 swizzle: _Array = ...,
                 fill: _Array = ...,
                 tables: Union[int, str] = ...,
                 level_count: int = ...,
                 levels: Union[Image, Sequence[Union[Image, Mapping[str, Any]]]] = ...,
                 depth: int = ...,
                 projection: Union[int, str] = ...,
                 tiles: Union[TileSource, Mapping[str, Any]] = ...,
                 ) -> None: ...

class TextureInfo(Desc):
    format: Union[int, str]
    width: int
    height: int
    layers: int
    level_count: int
    tables: Union[int, str]
    flags: Union[int, str]
    byte_size: int
    depth: int
    projection: Union[int, str]
    def __init__(self, *,
                 format: Union[int, str] = ...,
                 width: int = ...,
                 height: int = ...,
                 layers: int = ...,
                 level_count: int = ...,
                 tables: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 byte_size: int = ...,
                 depth: int = ...,
                 projection: Union[int, str] = ...,
                 ) -> None: ...

class TextureFileInfo(Desc):
    kind: Union[int, str]
    file_code: int
    supercompression: Union[int, str]
    flags: Union[int, str]
    format: Union[int, str]
    width: int
    height: int
    depth: int
    layers: int
    faces: int
    level_count: int
    def __init__(self, *,
                 kind: Union[int, str] = ...,
                 file_code: int = ...,
                 supercompression: Union[int, str] = ...,
                 flags: Union[int, str] = ...,
                 format: Union[int, str] = ...,
                 width: int = ...,
                 height: int = ...,
                 depth: int = ...,
                 layers: int = ...,
                 faces: int = ...,
                 level_count: int = ...,
                 ) -> None: ...

class Ktx2Desc(Desc):
    supercompression: Union[int, str]
    effort: int
    channels: int
    def __init__(self, *,
                 supercompression: Union[int, str] = ...,
                 effort: int = ...,
                 channels: int = ...,
                 ) -> None: ...

class TileCacheDesc(Desc):
    tile_bytes: int
    budget_bytes: int
    def __init__(self, *,
                 tile_bytes: int = ...,
                 budget_bytes: int = ...,
                 ) -> None: ...

class Tile(Desc):
    layer: int
    level: int
    x: int
    y: int
    width: int
    height: int
    texels: _Array
    row_stride: int
    def __init__(self, *,
                 layer: int = ...,
                 level: int = ...,
                 x: int = ...,
                 y: int = ...,
                 width: int = ...,
                 height: int = ...,
                 texels: _Array = ...,
                 row_stride: int = ...,
                 ) -> None: ...

class TileSource(Desc):
    cache: TileCache
    load: Callable[..., object]
    release: Callable[..., object]
    user_data: _Array
    def __init__(self, *,
                 cache: TileCache = ...,
                 load: Callable[..., object] = ...,
                 release: Callable[..., object] = ...,
                 user_data: _Array = ...,
                 ) -> None: ...

class TileCacheStats(Desc):
    tile_bytes: int
    budget_bytes: int
    allocated_bytes: int
    tile_count: int
    resident_tiles: int
    pinned_tiles: int
    requested_tiles: int
    loads: int
    loaded_tiles: int
    failed_tiles: int
    evicted_tiles: int
    waits: int
    def __init__(self, *,
                 tile_bytes: int = ...,
                 budget_bytes: int = ...,
                 allocated_bytes: int = ...,
                 tile_count: int = ...,
                 resident_tiles: int = ...,
                 pinned_tiles: int = ...,
                 requested_tiles: int = ...,
                 loads: int = ...,
                 loaded_tiles: int = ...,
                 failed_tiles: int = ...,
                 evicted_tiles: int = ...,
                 waits: int = ...,
                 ) -> None: ...

class TileFileDesc(Desc):
    color_space: Union[int, str]
    cache: TileCache
    max_readers: int
    fill: _Array
    def __init__(self, *,
                 color_space: Union[int, str] = ...,
                 cache: TileCache = ...,
                 max_readers: int = ...,
                 fill: _Array = ...,
                 ) -> None: ...

class TileFileInfo(Desc):
    columns: int
    rows: int
    files: int
    tile_width: int
    tile_height: int
    def __init__(self, *,
                 columns: int = ...,
                 rows: int = ...,
                 files: int = ...,
                 tile_width: int = ...,
                 tile_height: int = ...,
                 ) -> None: ...

class TileRegion(Desc):
    layer: int
    level: int
    x: int
    y: int
    width: int
    height: int
    def __init__(self, *,
                 layer: int = ...,
                 level: int = ...,
                 x: int = ...,
                 y: int = ...,
                 width: int = ...,
                 height: int = ...,
                 ) -> None: ...

class Vertices(Desc):
    draw: int
    instance: int
    first: int
    attribute_count: int
    count: int
    px: _Array
    py: _Array
    pz: _Array
    nx: _Array
    ny: _Array
    nz: _Array
    tx: _Array
    ty: _Array
    tz: _Array
    tw: _Array
    u: _Array
    v: _Array
    u1: _Array
    v1: _Array
    attribute: _Array
    object_to_world: _Array
    world_to_view: _Array
    view_to_clip: _Array
    eye: _Array
    uniforms: _Array
    def __init__(self, *,
                 draw: int = ...,
                 instance: int = ...,
                 first: int = ...,
                 attribute_count: int = ...,
                 count: int = ...,
                 px: _Array = ...,
                 py: _Array = ...,
                 pz: _Array = ...,
                 nx: _Array = ...,
                 ny: _Array = ...,
                 nz: _Array = ...,
                 tx: _Array = ...,
                 ty: _Array = ...,
                 tz: _Array = ...,
                 tw: _Array = ...,
                 u: _Array = ...,
                 v: _Array = ...,
                 u1: _Array = ...,
                 v1: _Array = ...,
                 attribute: _Array = ...,
                 object_to_world: _Array = ...,
                 world_to_view: _Array = ...,
                 view_to_clip: _Array = ...,
                 eye: _Array = ...,
                 uniforms: _Array = ...,
                 ) -> None: ...

class VertexOutputs(Desc):
    varying_count: int
    x: _Array
    y: _Array
    z: _Array
    w: _Array
    px: _Array
    py: _Array
    pz: _Array
    nx: _Array
    ny: _Array
    nz: _Array
    u: _Array
    v: _Array
    varying: _Array
    def __init__(self, *,
                 varying_count: int = ...,
                 x: _Array = ...,
                 y: _Array = ...,
                 z: _Array = ...,
                 w: _Array = ...,
                 px: _Array = ...,
                 py: _Array = ...,
                 pz: _Array = ...,
                 nx: _Array = ...,
                 ny: _Array = ...,
                 nz: _Array = ...,
                 u: _Array = ...,
                 v: _Array = ...,
                 varying: _Array = ...,
                 ) -> None: ...

class View(Desc):
    world_to_view: _Array
    view_to_clip: _Array
    eye: _Array
    def __init__(self, *,
                 world_to_view: _Array = ...,
                 view_to_clip: _Array = ...,
                 eye: _Array = ...,
                 ) -> None: ...

class Camera(Desc):
    eye: _Array
    target: _Array
    up: _Array
    fov_y: float
    aspect: float
    near_plane: float
    far_plane: float
    def __init__(self, *,
                 eye: _Array = ...,
                 target: _Array = ...,
                 up: _Array = ...,
                 fov_y: float = ...,
                 aspect: float = ...,
                 near_plane: float = ...,
                 far_plane: float = ...,
                 ) -> None: ...

class VolumeDesc(Desc):
    point_count: int
    texture: Texture
    density: _Array
    extinction: _Array
    color: _Array
    material: Material
    box_min: _Array
    box_max: _Array
    step: float
    jitter: float
    seed: int
    flags: int
    def __init__(self, *,
                 point_count: int = ...,
                 texture: Texture = ...,
                 density: _Array = ...,
                 extinction: _Array = ...,
                 color: _Array = ...,
                 material: Material = ...,
                 box_min: _Array = ...,
                 box_max: _Array = ...,
                 step: float = ...,
                 jitter: float = ...,
                 seed: int = ...,
                 flags: int = ...,
                 ) -> None: ...

class VolumeDraw(Desc):
    volume: Volume
    object_to_world: _Array
    def __init__(self, *,
                 volume: Volume = ...,
                 object_to_world: _Array = ...,
                 ) -> None: ...

class RawDesc(Desc):
    width: int
    height: int
    depth: int
    sample: Union[int, str]
    channels: int
    byte_order: Union[int, str]
    flags: int
    header_bytes: int
    def __init__(self, *,
                 width: int = ...,
                 height: int = ...,
                 depth: int = ...,
                 sample: Union[int, str] = ...,
                 channels: int = ...,
                 byte_order: Union[int, str] = ...,
                 flags: int = ...,
                 header_bytes: int = ...,
                 ) -> None: ...

class StackDesc(Desc):
    path_count: int
    paths: _Array
    pattern: str
    first: int
    last: int
    def __init__(self, *,
                 path_count: int = ...,
                 paths: _Array = ...,
                 pattern: str = ...,
                 first: int = ...,
                 last: int = ...,
                 ) -> None: ...

class VdbDesc(Desc):
    flags: Union[int, str]
    grid: str
    box_min: _Array
    box_max: _Array
    def __init__(self, *,
                 flags: Union[int, str] = ...,
                 grid: str = ...,
                 box_min: _Array = ...,
                 box_max: _Array = ...,
                 ) -> None: ...

class VdbInfo(Desc):
    grid_class: Union[int, str]
    index_min: _Array
    background: float
    active_voxels: int
    object_to_world: _Array
    grid: _Array
    def __init__(self, *,
                 grid_class: Union[int, str] = ...,
                 index_min: _Array = ...,
                 background: float = ...,
                 active_voxels: int = ...,
                 object_to_world: _Array = ...,
                 grid: _Array = ...,
                 ) -> None: ...
