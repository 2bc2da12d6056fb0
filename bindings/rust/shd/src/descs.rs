// SPDX-License-Identifier: MIT
// Descs and enums of the safe crate. Written by generate.py; do not edit.
use crate::sys;

#[doc(inline)]
pub use sys::shd_aov as Aov;
#[doc(inline)]
pub use sys::shd_background as Background;
#[doc(inline)]
pub use sys::shd_barycentric as Barycentric;
#[doc(inline)]
pub use sys::shd_bitmap_flag as BitmapFlag;
#[doc(inline)]
pub use sys::shd_blend as Blend;
#[doc(inline)]
pub use sys::shd_box as FilterBox;
#[doc(inline)]
pub use sys::shd_bump as Bump;
#[doc(inline)]
pub use sys::shd_byte_order as ByteOrder;
#[doc(inline)]
pub use sys::shd_channel as Channel;
#[doc(inline)]
pub use sys::shd_color_encoding as ColorEncoding;
#[doc(inline)]
pub use sys::shd_compare as Compare;
#[doc(inline)]
pub use sys::shd_context_flag as ContextFlag;
#[doc(inline)]
pub use sys::shd_cube_layout as CubeLayout;
#[doc(inline)]
pub use sys::shd_cubic as Cubic;
#[doc(inline)]
pub use sys::shd_cull as Cull;
#[doc(inline)]
pub use sys::shd_debug_view as DebugView;
#[doc(inline)]
pub use sys::shd_depth_order as DepthOrder;
#[doc(inline)]
pub use sys::shd_displaced_normals as DisplacedNormals;
#[doc(inline)]
pub use sys::shd_display_precision as DisplayPrecision;
#[doc(inline)]
pub use sys::shd_dither as Dither;
#[doc(inline)]
pub use sys::shd_draw_flag as DrawFlag;
#[doc(inline)]
pub use sys::shd_edge as Edge;
#[doc(inline)]
pub use sys::shd_environment_table as EnvironmentTable;
#[doc(inline)]
pub use sys::shd_file_format as FileFormat;
#[doc(inline)]
pub use sys::shd_fill as Fill;
#[doc(inline)]
pub use sys::shd_filter as Filter;
#[doc(inline)]
pub use sys::shd_format as Format;
#[doc(inline)]
pub use sys::shd_frequency as Frequency;
#[doc(inline)]
pub use sys::shd_interpolation as Interpolation;
#[doc(inline)]
pub use sys::shd_irradiance as Irradiance;
#[doc(inline)]
pub use sys::shd_level_rule as LevelRule;
#[doc(inline)]
pub use sys::shd_light_kind as LightKind;
#[doc(inline)]
pub use sys::shd_load_flag as LoadFlag;
#[doc(inline)]
pub use sys::shd_log_level as LogLevel;
#[doc(inline)]
pub use sys::shd_magnification as Magnification;
#[doc(inline)]
pub use sys::shd_material_flag as MaterialFlag;
#[doc(inline)]
pub use sys::shd_mesh_flag as MeshFlag;
#[doc(inline)]
pub use sys::shd_mip_kernel as MipKernel;
#[doc(inline)]
pub use sys::shd_mip_source as MipSource;
#[doc(inline)]
pub use sys::shd_missing_tiles as MissingTiles;
#[doc(inline)]
pub use sys::shd_model as Model;
#[doc(inline)]
pub use sys::shd_normal_encoding as NormalEncoding;
#[doc(inline)]
pub use sys::shd_normal_weight as NormalWeight;
#[doc(inline)]
pub use sys::shd_place_space as PlaceSpace;
#[doc(inline)]
pub use sys::shd_plane as Plane;
#[doc(inline)]
pub use sys::shd_precision as Precision;
#[doc(inline)]
pub use sys::shd_probe_weights as ProbeWeights;
#[doc(inline)]
pub use sys::shd_profile as Profile;
#[doc(inline)]
pub use sys::shd_projection as Projection;
#[doc(inline)]
pub use sys::shd_raw_sample as RawSample;
#[doc(inline)]
pub use sys::shd_render_flag as RenderFlag;
#[doc(inline)]
pub use sys::shd_result as ResultCode;
#[doc(inline)]
pub use sys::shd_rules as Rules;
#[doc(inline)]
pub use sys::shd_scene_flag as SceneFlag;
#[doc(inline)]
pub use sys::shd_scene_part as ScenePart;
#[doc(inline)]
pub use sys::shd_shadow_filter as ShadowFilter;
#[doc(inline)]
pub use sys::shd_shape as Shape;
#[doc(inline)]
pub use sys::shd_simd as Simd;
#[doc(inline)]
pub use sys::shd_slot_source as SlotSource;
#[doc(inline)]
pub use sys::shd_slot_target as SlotTarget;
#[doc(inline)]
pub use sys::shd_solid as Solid;
#[doc(inline)]
pub use sys::shd_solid_distance as SolidDistance;
#[doc(inline)]
pub use sys::shd_solid_fade as SolidFade;
#[doc(inline)]
pub use sys::shd_solid_gradients as SolidGradients;
#[doc(inline)]
pub use sys::shd_solid_sum as SolidSum;
#[doc(inline)]
pub use sys::shd_stochastic as Stochastic;
#[doc(inline)]
pub use sys::shd_supercompression as Supercompression;
#[doc(inline)]
pub use sys::shd_table as Table;
#[doc(inline)]
pub use sys::shd_tessellation_mode as TessellationMode;
#[doc(inline)]
pub use sys::shd_texel_content as TexelContent;
#[doc(inline)]
pub use sys::shd_texel_state as TexelState;
#[doc(inline)]
pub use sys::shd_texture_file_flag as TextureFileFlag;
#[doc(inline)]
pub use sys::shd_texture_file_kind as TextureFileKind;
#[doc(inline)]
pub use sys::shd_texture_flag as TextureFlag;
#[doc(inline)]
pub use sys::shd_topology as Topology;
#[doc(inline)]
pub use sys::shd_vdb_class as VdbClass;
#[doc(inline)]
pub use sys::shd_vdb_flag as VdbFlag;
#[doc(inline)]
pub use sys::shd_visibility as Visibility;
#[doc(inline)]
pub use sys::shd_wrap as Wrap;

/// Options of a context. Zero is the default of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContextDesc {
    /// default 0
    pub flags: ContextFlag,
    /// threads of the built-in executor, 0..1024, at most one per core; 1 = calling thread;
    /// default 0 = one per core
    pub worker_count: u32,
    /// default SHD_SIMD_BEST; SHD_ERROR_UNSUPPORTED if it cannot run here
    pub simd: Simd,
}
impl ContextDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_context_desc {
        let mut raw = sys::shd_context_desc::default();
        raw.flags = self.flags.0;
        raw.worker_count = self.worker_count;
        raw.simd = self.simd;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_context_desc) -> Self {
        Self {
            flags: ContextFlag(raw.flags),
            worker_count: raw.worker_count,
            simd: raw.simd,
        }
    }
}
impl Default for ContextDesc {
    /// The defaults of `shd_context_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_context_desc::default())
    }
}

/// Texels and tables of a texture. Required: format, width, height, texels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureDesc {
    /// any; no default. RGB8 to RGB32F are stored as RGBA. Blocks stay compressed, and lookups
    /// decode them (docs/compressed.md): the caller gives its mip levels; other tables are
    /// kept decoded
    pub format: Format,
    /// texels, 1..65536; width * height * layers at most 2^28; see `tiles` for larger ones
    pub width: u32,
    /// texels, 1..65536
    pub height: u32,
    /// bytes between rows of texels or blocks, at least the bytes of a row; 0 = packed
    pub row_stride: usize,
    /// bytes between layers, at least the rows of a layer times the row stride; 0 = packed
    pub layer_stride: usize,
    /// images of the array, 1..2048; default 1
    pub layers: u32,
    /// sources of r, g, b, a of lookups; default SHD_CHANNEL_DEFAULT
    pub swizzle: [Channel; 4],
    /// values of channels that the format does not have, in lookups inside and outside the
    /// image; finite; default 0, 0, 0, 1
    pub fill: [f32; 4],
    /// default none
    pub tables: Table,
    /// Slices of a 3D texture, 1..65536; default 0 = a 2D texture. width * height * depth is at most 2^28, `layers` is
    /// 1, and SHD_TABLE_MIPMAP is the only table. Texels are \[depth\]\[height\]\[width\], and `layer_stride` is the distance
    /// of slices. Lookups read (u, v, w); w = 0 is the outer face of slice 0. A level halves all three sizes.
    pub depth: u32,
    /// Default SHD_PROJECTION_NONE. With any other one, lookups read (u, v, w) as a direction of any length. `width` and
    /// `height` are equal unless it is LAT_LONG; `layers` of CUBE are the 6 faces +X, -X, +Y, -Y, +Z, -Z; `depth` is 0;
    /// `tables` has SHD_TABLE_MIPMAP at most. Mip levels are averages of texels of one image, unweighted.
    pub projection: Projection,
}
impl TextureDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_texture_desc {
        let mut raw = sys::shd_texture_desc::default();
        raw.format = self.format;
        raw.width = self.width;
        raw.height = self.height;
        raw.row_stride = self.row_stride;
        raw.layer_stride = self.layer_stride;
        raw.layers = self.layers;
        raw.swizzle = self.swizzle;
        raw.fill = self.fill;
        raw.tables = self.tables.0;
        raw.depth = self.depth;
        raw.projection = self.projection;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_texture_desc) -> Self {
        Self {
            format: raw.format,
            width: raw.width,
            height: raw.height,
            row_stride: raw.row_stride,
            layer_stride: raw.layer_stride,
            layers: raw.layers,
            swizzle: raw.swizzle,
            fill: raw.fill,
            tables: Table(raw.tables),
            depth: raw.depth,
            projection: raw.projection,
        }
    }
}
impl Default for TextureDesc {
    /// The defaults of `shd_texture_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_texture_desc::default())
    }
}

/// Size, format and memory of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureInfo {
    /// format of every level; RGBA for RGB8 to RGB32F, with _SRGB
    pub format: Format,
    /// texels of level 0
    pub width: u32,
    /// texels of level 0
    pub height: u32,
    /// images of the array
    pub layers: u32,
    /// 1; with SHD_TABLE_MIPMAP the number of levels down to 1 x 1, or the number of given
    /// levels + 1
    pub level_count: u32,
    /// tables of the texture
    pub tables: Table,
    /// as in its desc
    pub flags: TextureFlag,
    /// bytes of all tables and of the data that shd_texture_update() keeps, without a borrowed
    /// base level
    pub byte_size: usize,
    /// slices of level 0; 0 = not a 3D texture
    pub depth: u32,
    /// as in its desc
    pub projection: Projection,
}
impl TextureInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_texture_info {
        let mut raw = sys::shd_texture_info::default();
        raw.format = self.format;
        raw.width = self.width;
        raw.height = self.height;
        raw.layers = self.layers;
        raw.level_count = self.level_count;
        raw.tables = self.tables.0;
        raw.flags = self.flags.0;
        raw.byte_size = self.byte_size;
        raw.depth = self.depth;
        raw.projection = self.projection;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_texture_info) -> Self {
        Self {
            format: raw.format,
            width: raw.width,
            height: raw.height,
            layers: raw.layers,
            level_count: raw.level_count,
            tables: Table(raw.tables),
            flags: TextureFlag(raw.flags),
            byte_size: raw.byte_size,
            depth: raw.depth,
            projection: raw.projection,
        }
    }
}
impl Default for TextureInfo {
    /// The defaults of `shd_texture_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_texture_info::default())
    }
}

/// Settings of a sampler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SamplerDesc {
    /// default SHD_FILTER_TRILINEAR
    pub filter: Filter,
    /// default SHD_MAGNIFICATION_DEFAULT
    pub magnification: Magnification,
    /// default SHD_WRAP_REPEAT
    pub wrap_u: Wrap,
    /// default SHD_WRAP_REPEAT
    pub wrap_v: Wrap,
    /// colour of texels outside with SHD_WRAP_BORDER: stored r, g, b, a, linear,
    /// before the swizzle of the texture; channels that come from its `fill` are
    /// `fill` outside, too; finite; default 0
    pub border: [f32; 4],
    /// default SHD_PROFILE_LEAST_ERROR. It also determines which
    /// lookups are magnified (shd_magnification)
    pub profile: Profile,
    /// added to the level of detail, -15..15; default 0
    pub lod_bias: f32,
    /// lowest level of detail, 0..32; default 0; it is used where lod_max is lower
    pub lod_min: f32,
    /// highest level of detail, 0..32; default 32
    pub lod_max: f32,
    /// factor of the derivatives in x, 0..64; default 1
    pub width_x: f32,
    /// factor of the derivatives in y, 0..64; default 1
    pub width_y: f32,
    /// blur in u, 0..1, added to the footprint as covariance; default 0
    pub blur_u: f32,
    /// blur in v, 0..1, added to the footprint as covariance; default 0
    pub blur_v: f32,
    /// largest ratio of the footprint's axes, 1..64; default 16
    pub max_anisotropy: f32,
    /// weights of ANISOTROPIC in LEAST_ERROR and EXACT; default SHD_PROBE_WEIGHTS_EQUAL
    pub probe_weights: ProbeWeights,
    /// kernel of bicubic filters; default SHD_CUBIC_CATMULL_ROM
    pub cubic: Cubic,
    /// area of SHD_FILTER_SUMMED_AREA; default SHD_BOX_BOUNDING
    pub r#box: FilterBox,
    /// tolerance of SHD_FILTER_EXACT, 2^-12..1; default 2^-6
    pub tolerance: f32,
    /// Filter that SHD_FILTER_STOCHASTIC estimates: BILINEAR, BICUBIC (B-spline only), TRILINEAR, ANISOTROPIC or EWA;
    /// default SHD_FILTER_TRILINEAR.
    pub stochastic_filter: Filter,
    /// seed of SHD_FILTER_STOCHASTIC; default 0
    pub seed: u32,
    /// default SHD_PRECISION_FULL
    pub precision: Precision,
    /// Largest number of texels that a lookup of ANISOTROPIC or EWA reads; in 3D textures 2 or 4 times as many. 0 = no
    /// limit besides max_anisotropy, or 32 or more; default 0. It limits the ratio of the footprint's axes as
    /// max_anisotropy does: longer footprints use coarser levels.
    pub max_texels: u32,
    /// Length by which a footprint may exceed the probes of ANISOTROPIC in LEAST_ERROR and EXACT before another one is
    /// added, in widths of a probe, 0..1; default 1/8. A footprint r times as long as wide has ceil(r - probe_slack)
    /// probes.
    pub probe_slack: f32,
    /// Part of the way between two mip levels in which TRILINEAR, NEAREST_MIP_LINEAR and ANISOTROPIC in LEAST_ERROR and
    /// EXACT blend them, 0..1; default 1. If f is the fraction of the level of detail, the share of the coarser level is
    /// clamp((f - 1/2) / level_blend + 1/2, 0, 1), and a level without share is not read. With 0, only the nearer level
    /// is read.
    pub level_blend: f32,
    /// random choice of SHD_FILTER_STOCHASTIC; default SHD_STOCHASTIC_TEXEL
    pub stochastic: Stochastic,
    /// across the slices of a 3D texture; no effect for others; default SHD_WRAP_REPEAT
    pub wrap_w: Wrap,
    /// default SHD_MISSING_TILES_WAIT
    pub missing_tiles: MissingTiles,
    /// 1 = comparison lookups, as texture units have them for shadow maps (percentage-closer filtering; Reeves, Salesin
    /// and Cook 1987; Vulkan 1.3 specification, "Depth Compare Operation"); 0 = lookups return texels; default 0. Each
    /// texel that the filter reads becomes 1 if the comparison of the lookup's `reference` with it is true, else 0. The
    /// filter blends these numbers. The result is in r; g and b are 0, and a is 1.
    ///
    /// A texel is its channel of r after the texture's swizzle, which may be a constant of `fill`. Texels outside with
    /// SHD_WRAP_BORDER have the border colour. UNORM and SRGB formats clamp the reference to \[0, 1\]. Numbers are
    /// compared as floats, after sRGB is decoded.
    ///
    /// Works with NEAREST, BILINEAR, NEAREST_MIP, NEAREST_MIP_LINEAR, BILINEAR_MIP, TRILINEAR and ANISOTROPIC on all
    /// textures. Other filters, derivatives, and samplers of materials, lights and tessellations return
    /// SHD_ERROR_UNSUPPORTED. SHD_PRECISION_FAST has no effect.
    pub compares: u32,
    /// comparison of these lookups; default SHD_COMPARE_LESS
    pub compare: Compare,
}
impl SamplerDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_sampler_desc {
        let mut raw = sys::shd_sampler_desc::default();
        raw.filter = self.filter;
        raw.magnification = self.magnification;
        raw.wrap_u = self.wrap_u;
        raw.wrap_v = self.wrap_v;
        raw.border = self.border;
        raw.profile = self.profile;
        raw.lod_bias = self.lod_bias;
        raw.lod_min = self.lod_min;
        raw.lod_max = self.lod_max;
        raw.width_x = self.width_x;
        raw.width_y = self.width_y;
        raw.blur_u = self.blur_u;
        raw.blur_v = self.blur_v;
        raw.max_anisotropy = self.max_anisotropy;
        raw.probe_weights = self.probe_weights;
        raw.cubic = self.cubic;
        raw.r#box = self.r#box;
        raw.tolerance = self.tolerance;
        raw.stochastic_filter = self.stochastic_filter;
        raw.seed = self.seed;
        raw.precision = self.precision;
        raw.max_texels = self.max_texels;
        raw.probe_slack = self.probe_slack;
        raw.level_blend = self.level_blend;
        raw.stochastic = self.stochastic;
        raw.wrap_w = self.wrap_w;
        raw.missing_tiles = self.missing_tiles;
        raw.compares = self.compares;
        raw.compare = self.compare;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_sampler_desc) -> Self {
        Self {
            filter: raw.filter,
            magnification: raw.magnification,
            wrap_u: raw.wrap_u,
            wrap_v: raw.wrap_v,
            border: raw.border,
            profile: raw.profile,
            lod_bias: raw.lod_bias,
            lod_min: raw.lod_min,
            lod_max: raw.lod_max,
            width_x: raw.width_x,
            width_y: raw.width_y,
            blur_u: raw.blur_u,
            blur_v: raw.blur_v,
            max_anisotropy: raw.max_anisotropy,
            probe_weights: raw.probe_weights,
            cubic: raw.cubic,
            r#box: raw.r#box,
            tolerance: raw.tolerance,
            stochastic_filter: raw.stochastic_filter,
            seed: raw.seed,
            precision: raw.precision,
            max_texels: raw.max_texels,
            probe_slack: raw.probe_slack,
            level_blend: raw.level_blend,
            stochastic: raw.stochastic,
            wrap_w: raw.wrap_w,
            missing_tiles: raw.missing_tiles,
            compares: raw.compares,
            compare: raw.compare,
        }
    }
}
impl Default for SamplerDesc {
    /// The defaults of `shd_sampler_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_sampler_desc::default())
    }
}

/// Size and planes of a framebuffer. Required: width, height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramebufferDesc {
    /// pixels, 1..16384
    pub width: u32,
    /// pixels, 1..16384
    pub height: u32,
    /// per pixel: 1, 2, 4, 8 or 16, at shd_sample_position(); default 1
    pub samples: u32,
    /// optional planes; default none
    pub aovs: Aov,
    /// Storage of colour: SHD_FORMAT_RGBA32F, four planes; or interleaved SHD_FORMAT_RGBA16F, _RGBA8_SRGB or _RGBA8.
    /// Default SHD_FORMAT_RGBA32F. Targets are planes in any case. shd_render with SHD_RENDER_LOAD reads colour as it
    /// was rounded.
    pub color_format: Format,
}
impl FramebufferDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_framebuffer_desc {
        let mut raw = sys::shd_framebuffer_desc::default();
        raw.width = self.width;
        raw.height = self.height;
        raw.samples = self.samples;
        raw.aovs = self.aovs.0;
        raw.color_format = self.color_format;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_framebuffer_desc) -> Self {
        Self {
            width: raw.width,
            height: raw.height,
            samples: raw.samples,
            aovs: Aov(raw.aovs),
            color_format: raw.color_format,
        }
    }
}
impl Default for FramebufferDesc {
    /// The defaults of `shd_framebuffer_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_framebuffer_desc::default())
    }
}

/// Size and planes of a framebuffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramebufferInfo {
    /// pixels
    pub width: u32,
    /// pixels
    pub height: u32,
    /// per pixel
    pub samples: u32,
    /// optional planes
    pub aovs: Aov,
    /// storage of colour
    pub color_format: Format,
    /// bytes of all planes and pixels
    pub byte_size: usize,
}
impl FramebufferInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_framebuffer_info {
        let mut raw = sys::shd_framebuffer_info::default();
        raw.width = self.width;
        raw.height = self.height;
        raw.samples = self.samples;
        raw.aovs = self.aovs.0;
        raw.color_format = self.color_format;
        raw.byte_size = self.byte_size;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_framebuffer_info) -> Self {
        Self {
            width: raw.width,
            height: raw.height,
            samples: raw.samples,
            aovs: Aov(raw.aovs),
            color_format: raw.color_format,
            byte_size: raw.byte_size,
        }
    }
}
impl Default for FramebufferInfo {
    /// The defaults of `shd_framebuffer_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_framebuffer_info::default())
    }
}

/// Kind, intensity and placement of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightDesc {
    /// default SHD_LIGHT_KIND_POINT
    pub kind: LightKind,
    /// I, scene-linear RGB, 0..1e12; default 1. Points and spots: E = 1 at distance r takes
    /// I = r^2
    pub intensity: [f32; 3],
    /// position of points, spots and the cookie of directional lights; world space, finite;
    /// default 0
    pub position: [f32; 3],
    /// directional lights and spots: direction of the light rays, world space, any length
    /// except 0; default (0, -1, 0)
    pub direction: [f32; 3],
    /// points and spots: distance from which E is 0 \[world units\]; default 0 = no limit. Lights
    /// with a finite range are culled beyond it
    pub range: f32,
    /// spots: half angle of the full cone \[rad\], 0..outer_angle; default 0
    pub inner_angle: f32,
    /// spots: half angle of the cone \[rad\], 0.001..pi/2, with a cookie up to 1.55; default
    /// pi/4
    pub outer_angle: f32,
    /// up direction of the cookie and of shadow maps, world space. Orthogonalised against
    /// `direction`; replaced by another direction if parallel to it. Default (0, 1, 0)
    pub up: [f32; 3],
    /// directional lights: width and height of the cookie \[world units\], above 0; default 1.
    /// The centre of the cookie lies on the ray from `position`; with wraps that repeat, the
    /// cookie tiles the plane
    pub extent: [f32; 2],
}
impl LightDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_light_desc {
        let mut raw = sys::shd_light_desc::default();
        raw.kind = self.kind;
        raw.intensity = self.intensity;
        raw.position = self.position;
        raw.direction = self.direction;
        raw.range = self.range;
        raw.inner_angle = self.inner_angle;
        raw.outer_angle = self.outer_angle;
        raw.up = self.up;
        raw.extent = self.extent;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_light_desc) -> Self {
        Self {
            kind: raw.kind,
            intensity: raw.intensity,
            position: raw.position,
            direction: raw.direction,
            range: raw.range,
            inner_angle: raw.inner_angle,
            outer_angle: raw.outer_angle,
            up: raw.up,
            extent: raw.extent,
        }
    }
}
impl Default for LightDesc {
    /// The defaults of `shd_light_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_light_desc::default())
    }
}

/// A source for a coefficient. Required: target, and the fields that the source uses.
///
/// Slots that scale light (diffuse, tint, ambient, specular, opacity, emission, metallic, occlusion, matcap) are looked
/// up for every fragment at every frequency. Slots that shape a lobe (exponent, roughness, normal, normal_mixed, height
/// and those of the clear coat) are looked up where lobes are evaluated: at flat and Gouraud frequency at the centroid
/// or vertex, on level 0.
///
/// Values are not clamped, even if negative. NaN and infinity propagate to the colours of their fragments, which
/// shd_render_stats.nonfinite_fragments counts. There are two exceptions. Exponents are clamped to 0..1e6 (NaN becomes
/// 0) and roughness to 0..1 (NaN becomes 1). The surface keeps its normal where a mapped normal is 0 or not finite, or a
/// slope of heights is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlotDesc {
    /// channel of the texture or the solid texture for scalars, 0..3; default 0
    pub channel: u32,
    /// coordinates for the texture: 0 = uv of the mesh, 1 = uv1; default 0
    pub uv_set: u32,
    /// (u', v') = (t\[0\] u + t\[1\] v + t\[2\], t\[3\] u + t\[4\] v + t\[5\]), finite; default identity. glTF's
    /// KHR_texture_transform is T R S, with the rotation r and v downwards
    /// t = {sx cos r, sy sin r, ox, -sx sin r, sy cos r, oy}.
    pub uv_transform: [f32; 6],
    /// Place = place_transform * position, column-major, affine: the last row is 0, 0, 0, 1; default identity. A solid
    /// texture is evaluated at the place. A 3D texture is looked up at (u, v, w) = place, with the derivatives of the
    /// place by pixel steps times `place_width`: it fills the cube from 0 to 1, and its sampler wraps it.
    pub place_transform: [f32; 16],
    /// space of the position; default SHD_PLACE_SPACE_OBJECT
    pub place_space: PlaceSpace,
    /// factor of the width of a pixel, 0..1000; 0 = no band limit, level 0 of
    /// 3D textures; default 1
    pub place_width: f32,
}
impl SlotDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_slot {
        let mut raw = sys::shd_slot::default();
        raw.channel = self.channel;
        raw.uv_set = self.uv_set;
        raw.uv_transform = self.uv_transform;
        raw.place_transform = self.place_transform;
        raw.place_space = self.place_space;
        raw.place_width = self.place_width;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_slot) -> Self {
        Self {
            channel: raw.channel,
            uv_set: raw.uv_set,
            uv_transform: raw.uv_transform,
            place_transform: raw.place_transform,
            place_space: raw.place_space,
            place_width: raw.place_width,
        }
    }
}
impl Default for SlotDesc {
    /// The defaults of `shd_slot`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_slot::default())
    }
}

/// Model and coefficients, scene-linear RGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialDesc {
    /// default SHD_MODEL_LAMBERT
    pub model: Model,
    /// shown instead of the model; default SHD_DEBUG_VIEW_NONE
    pub debug_view: DebugView,
    /// default none
    pub flags: MaterialFlag,
    /// k_a, 0..1e6. Default -1 in all channels: k_a is ambient_share times the diffuse
    /// colour, k_d times its slot. SHD_SLOT_AMBIENT replaces the slot of the diffuse
    /// colour in this product
    pub ambient: [f32; 3],
    /// 0..1; default 1/16; used if ambient is -1. METALLIC_ROUGHNESS multiplies k_a by its
    /// base colour in any case, so k_a is ambient_share there
    pub ambient_share: f32,
    /// k_d or base colour, 0..1e6; default 0.8
    pub diffuse: [f32; 3],
    /// k_s, 0..1e6; default 0.5
    pub specular: [f32; 3],
    /// p, 0..1e6; default 64
    pub exponent: f32,
    /// 0..1; default 0
    pub metallic: f32,
    /// 0..1; default 0.5
    pub roughness: f32,
    /// index of refraction of GLASS, and of METALLIC_ROUGHNESS for the part that is not
    /// metal, 1..10;
    /// default 1.5
    pub ior: f32,
    /// 0..1e12; default 0, so a slot needs a larger value here
    pub emission: [f32; 3],
    /// opacity of models, 0..1; default 1
    pub opacity: f32,
    /// effect of SHD_SLOT_OCCLUSION, 0..1; default 1
    pub occlusion_strength: f32,
    /// default SHD_NORMAL_ENCODING_XYZ
    pub normal_encoding: NormalEncoding,
    /// factor of x and y of mapped normals, -1e3..1e3; default 1
    pub normal_scale: f32,
    /// default SHD_BUMP_NONE
    pub bump: Bump,
    /// factor of heights, -1e6..1e6; default 1
    pub bump_scale: f32,
    /// Depth of height 0 below the surface \[world units\], 0..1e6; height 1 lies on the surface. At Phong frequency, all
    /// textures with the uv set of the height are looked up at the point where the line of sight meets the height field
    /// (parallax occlusion mapping, Tatarchuk 2006). The triangles do not move. Default 0 = off.
    pub parallax_depth: f32,
    /// maximum number of lookups of the height per fragment, 2..256; default 24
    pub parallax_steps: u32,
    /// warm colour of GOOCH, 0..1e6; default (0.4, 0.4, 0)
    pub warm: [f32; 3],
    /// cool colour of GOOCH, 0..1e6; default (0, 0, 0.4)
    pub cool: [f32; 3],
    /// share of k_d added to `warm`, 0..1; default 0.6
    pub warm_mix: f32,
    /// share of k_d added to `cool`, 0..1; default 0.2
    pub cool_mix: f32,
    /// steps of TOON, 1..256; default 3
    pub toon_steps: u32,
    /// default SHD_BLEND_OPAQUE
    pub blend: Blend,
    /// fragments with a smaller alpha are dropped, 0..1; default 0 = none
    pub alpha_cutoff: f32,
    /// Strength c of a clear coat over METALLIC_ROUGHNESS, 0..1; default 0 = none. As KHR_materials_clearcoat of glTF,
    /// with its own roughness and normal n_c and F = 0.04 + 0.96 (1 - |n_c.v|)^5: the model times 1 - c F, plus the sum
    /// of E max(0, n_c.l) c F D V. Without SHD_SLOT_CLEARCOAT_NORMAL, n_c is the normal without normal maps and bumps.
    /// Ambient light and emission are not darkened. No effect on other models.
    pub clearcoat: f32,
    /// 0..1; default 0
    pub clearcoat_roughness: f32,
}
impl MaterialDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_material_desc {
        let mut raw = sys::shd_material_desc::default();
        raw.model = self.model;
        raw.debug_view = self.debug_view;
        raw.flags = self.flags.0;
        raw.ambient = self.ambient;
        raw.ambient_share = self.ambient_share;
        raw.diffuse = self.diffuse;
        raw.specular = self.specular;
        raw.exponent = self.exponent;
        raw.metallic = self.metallic;
        raw.roughness = self.roughness;
        raw.ior = self.ior;
        raw.emission = self.emission;
        raw.opacity = self.opacity;
        raw.occlusion_strength = self.occlusion_strength;
        raw.normal_encoding = self.normal_encoding;
        raw.normal_scale = self.normal_scale;
        raw.bump = self.bump;
        raw.bump_scale = self.bump_scale;
        raw.parallax_depth = self.parallax_depth;
        raw.parallax_steps = self.parallax_steps;
        raw.warm = self.warm;
        raw.cool = self.cool;
        raw.warm_mix = self.warm_mix;
        raw.cool_mix = self.cool_mix;
        raw.toon_steps = self.toon_steps;
        raw.blend = self.blend;
        raw.alpha_cutoff = self.alpha_cutoff;
        raw.clearcoat = self.clearcoat;
        raw.clearcoat_roughness = self.clearcoat_roughness;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_material_desc) -> Self {
        Self {
            model: raw.model,
            debug_view: raw.debug_view,
            flags: MaterialFlag(raw.flags),
            ambient: raw.ambient,
            ambient_share: raw.ambient_share,
            diffuse: raw.diffuse,
            specular: raw.specular,
            exponent: raw.exponent,
            metallic: raw.metallic,
            roughness: raw.roughness,
            ior: raw.ior,
            emission: raw.emission,
            opacity: raw.opacity,
            occlusion_strength: raw.occlusion_strength,
            normal_encoding: raw.normal_encoding,
            normal_scale: raw.normal_scale,
            bump: raw.bump,
            bump_scale: raw.bump_scale,
            parallax_depth: raw.parallax_depth,
            parallax_steps: raw.parallax_steps,
            warm: raw.warm,
            cool: raw.cool,
            warm_mix: raw.warm_mix,
            cool_mix: raw.cool_mix,
            toon_steps: raw.toon_steps,
            blend: raw.blend,
            alpha_cutoff: raw.alpha_cutoff,
            clearcoat: raw.clearcoat,
            clearcoat_roughness: raw.clearcoat_roughness,
        }
    }
}
impl Default for MaterialDesc {
    /// The defaults of `shd_material_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_material_desc::default())
    }
}

/// Counts and bounds of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshInfo {
    /// including the vertices that SHD_MESH_TANGENTS added
    pub vertex_count: u32,
    /// number of separate triangles, also for strips and fans
    pub triangle_count: u32,
    /// bound of the finite positions; 0 if there are none
    pub bounds_min: [f32; 3],
    /// bound of the finite positions; 0 if there are none
    pub bounds_max: [f32; 3],
    /// vertices with a position that is not finite
    pub nonfinite_count: u32,
    /// vertices whose faces have no area or whose normal was 0; they get (0, 0, 1)
    pub normalless_count: u32,
    /// SHD_MESH_TANGENTS: vertices without a tangent from uv; they get a perpendicular
    /// one
    pub tangentless_count: u32,
    /// SHD_MESH_TANGENTS: vertices that were added
    pub split_count: u32,
}
impl MeshInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_mesh_info {
        let mut raw = sys::shd_mesh_info::default();
        raw.vertex_count = self.vertex_count;
        raw.triangle_count = self.triangle_count;
        raw.bounds_min = self.bounds_min;
        raw.bounds_max = self.bounds_max;
        raw.nonfinite_count = self.nonfinite_count;
        raw.normalless_count = self.normalless_count;
        raw.tangentless_count = self.tangentless_count;
        raw.split_count = self.split_count;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_mesh_info) -> Self {
        Self {
            vertex_count: raw.vertex_count,
            triangle_count: raw.triangle_count,
            bounds_min: raw.bounds_min,
            bounds_max: raw.bounds_max,
            nonfinite_count: raw.nonfinite_count,
            normalless_count: raw.normalless_count,
            tangentless_count: raw.tangentless_count,
            split_count: raw.split_count,
        }
    }
}
impl Default for MeshInfo {
    /// The defaults of `shd_mesh_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_mesh_info::default())
    }
}

/// A shape and its subdivision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeDesc {
    /// default sphere
    pub shape: Shape,
    /// spheres and tori: 1e-30..1e30; default 1
    pub radius: f32,
    /// tori: 1e-30..1e30, below `radius`; default 0.25
    pub tube_radius: f32,
    /// boxes and planes: length along x, y, z, 1e-30..1e30; default 2
    pub size: [f32; 3],
    /// Parts; 0 = the number in brackets. Sphere: around, 3..4096 \[32\], and from pole to pole, 2..4096 \[16\]. Box: along
    /// x, y and z, 1..4096 \[1\]. Plane: \[0\] along x and \[2\] along z, as of `size`, 1..4096 \[1\]. Torus: around the axis,
    /// 3..4096 \[48\], and around the tube, 3..4096 \[24\]. Teapot: along each side of a patch, 2..256 \[8\]. Unused numbers
    /// are ignored, as size\[1\] and segments\[1\] of a plane.
    pub segments: [u32; 3],
}
impl ShapeDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_shape_desc {
        let mut raw = sys::shd_shape_desc::default();
        raw.shape = self.shape;
        raw.radius = self.radius;
        raw.tube_radius = self.tube_radius;
        raw.size = self.size;
        raw.segments = self.segments;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_shape_desc) -> Self {
        Self {
            shape: raw.shape,
            radius: raw.radius,
            tube_radius: raw.tube_radius,
            size: raw.size,
            segments: raw.segments,
        }
    }
}
impl Default for ShapeDesc {
    /// The defaults of `shd_shape_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_shape_desc::default())
    }
}

/// A solid texture: a pattern, its octaves and its colours. It has no pointers, so a copy is independent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidDesc {
    /// default SHD_SOLID_STRIPES
    pub kind: Solid,
    /// another seed gives another pattern of the same kind; no effect on STRIPES, CHECKER
    pub seed: u32,
    /// side of a cell or width of a stripe \[units of the positions\], 1e-30..1e30; default 1
    pub size: f32,
    /// Number of octaves of PERLIN, VALUE, SIMPLEX, WORLEY, and of the noise in MARBLE and WOOD, 1..32; default 1. The
    /// sum is N = sum of gain^i n(lacunarity^i p) / sum of gain^i, for i from 0 on. Each octave has a pattern of its
    /// own, except with SHD_SOLID_GRADIENTS_TABLE, as in the classic form.
    pub octaves: u32,
    /// ratio of the frequencies of successive octaves, 1..16; default 2
    pub lacunarity: f32,
    /// ratio of the amplitudes of successive octaves, 0..1; default 1/2
    pub gain: f32,
    /// PERLIN, VALUE and SIMPLEX: default SHD_SOLID_SUM_FBM
    pub sum: SolidSum,
    /// PERLIN: default SHD_SOLID_GRADIENTS_HASHED
    pub gradients: SolidGradients,
    /// PERLIN, VALUE, MARBLE and WOOD: default SHD_SOLID_FADE_QUINTIC
    pub fade: SolidFade,
    /// WORLEY: default SHD_SOLID_DISTANCE_F1
    pub distance: SolidDistance,
    /// MARBLE and WOOD: factor of the noise \[cells\], 0..1000; default 1
    pub distortion: f32,
    /// Values of the first and the last colour, -1e6..1e6; equal = the limits of the kind's range; default 0, 0.
    pub range: [f32; 2],
    /// 2..SHD_MAX_SOLID_COLORS; default 2
    pub color_count: u32,
    /// r, g, b, a at equal distances over `range`, linear, -1e6..1e6; values in between are interpolated, values beyond
    /// `range` have the nearest colour. Default black and white, both opaque.
    pub colors: [[f32; 4]; 8],
}
impl SolidDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_solid_desc {
        let mut raw = sys::shd_solid_desc::default();
        raw.kind = self.kind;
        raw.seed = self.seed;
        raw.size = self.size;
        raw.octaves = self.octaves;
        raw.lacunarity = self.lacunarity;
        raw.gain = self.gain;
        raw.sum = self.sum;
        raw.gradients = self.gradients;
        raw.fade = self.fade;
        raw.distance = self.distance;
        raw.distortion = self.distortion;
        raw.range = self.range;
        raw.color_count = self.color_count;
        raw.colors = self.colors;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_solid_desc) -> Self {
        Self {
            kind: raw.kind,
            seed: raw.seed,
            size: raw.size,
            octaves: raw.octaves,
            lacunarity: raw.lacunarity,
            gain: raw.gain,
            sum: raw.sum,
            gradients: raw.gradients,
            fade: raw.fade,
            distance: raw.distance,
            distortion: raw.distortion,
            range: raw.range,
            color_count: raw.color_count,
            colors: raw.colors,
        }
    }
}
impl Default for SolidDesc {
    /// The defaults of `shd_solid_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_solid_desc::default())
    }
}

/// A perspective camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// world space; default (0, 0, 3)
    pub eye: [f32; 3],
    /// world space, different from the eye; default 0
    pub target: [f32; 3],
    /// world space, any length, not along the line of sight; default (0, 1, 0)
    pub up: [f32; 3],
    /// vertical field of view \[rad\], (0, pi); default 0.8
    pub fov_y: f32,
    /// width / height, > 0; 0 = aspect of the picture, or 1 if there is no picture; default 0
    pub aspect: f32,
    /// distance, > 0; default 0.1
    pub near_plane: f32,
    /// distance, > near_plane; default 100
    pub far_plane: f32,
}
impl Camera {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_camera {
        let mut raw = sys::shd_camera::default();
        raw.eye = self.eye;
        raw.target = self.target;
        raw.up = self.up;
        raw.fov_y = self.fov_y;
        raw.aspect = self.aspect;
        raw.near_plane = self.near_plane;
        raw.far_plane = self.far_plane;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_camera) -> Self {
        Self {
            eye: raw.eye,
            target: raw.target,
            up: raw.up,
            fov_y: raw.fov_y,
            aspect: raw.aspect,
            near_plane: raw.near_plane,
            far_plane: raw.far_plane,
        }
    }
}
impl Default for Camera {
    /// The defaults of `shd_camera`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_camera::default())
    }
}

/// Transforms from world to clip space. Frozen, because it is a member of shd_render_desc. Later options of a picture
/// are appended to shd_render_desc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// rigid, finite
    pub world_to_view: [f32; 16],
    /// projection, finite
    pub view_to_clip: [f32; 16],
    /// world space; viewing directions (wo) point to it
    pub eye: [f32; 3],
}
impl View {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_view {
        let mut raw = sys::shd_view::default();
        raw.world_to_view = self.world_to_view;
        raw.view_to_clip = self.view_to_clip;
        raw.eye = self.eye;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_view) -> Self {
        Self {
            world_to_view: raw.world_to_view,
            view_to_clip: raw.view_to_clip,
            eye: raw.eye,
        }
    }
}

/// Rectangle of pixels of a picture. Frozen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// first column from the left
    pub x: u32,
    /// first row from the top
    pub y: u32,
    /// columns
    pub width: u32,
    /// rows
    pub height: u32,
}
impl Region {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_region {
        let mut raw = sys::shd_region::default();
        raw.x = self.x;
        raw.y = self.y;
        raw.width = self.width;
        raw.height = self.height;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_region) -> Self {
        Self {
            x: raw.x,
            y: raw.y,
            width: raw.width,
            height: raw.height,
        }
    }
}

/// One mesh in the frame. Required: mesh.
///
/// Lines are rectangles around the edge, as long as the edge, with square ends (OpenGL 4.6 core specification,
/// 14.5, antialiased lines). Points are squares around the vertices. Both lie on the grid of 8 subpixel bits and cover
/// samples as triangles do, so a line or point narrower than 1 may fall between samples. Depth varies along a line and
/// is constant across it; a point has the depth of its vertex. depth_bias_slope uses these depths instead of the
/// triangle's. Attributes are interpolated at the pixel, with barycentric coordinates clamped to the triangle, and
/// texture coordinates clamped to those of its vertices; a triangle without area gives the mean of its corners.
///
/// Culling drops all lines and points of a triangle. A triangle without area is dropped if `cull` is not NONE. Clipping
/// at the near and far plane adds no edges. A vertex beyond these planes has no point, and an edge without length has no
/// line. A shared edge or vertex is drawn once by each of its triangles, with the same samples and depths.
/// SHD_COMPARE_LESS therefore shows it once, but with SHD_DRAW_KEEP_DEPTH a blend is applied several times.
///
/// SHD_FILL_LINES draws each edge of the mesh once, for triangles facing either way: `cull` has no effect. The edge
/// belongs to its first triangle: this triangle's vertices shade it, and it is ordered and counted with this triangle.
/// Silhouettes are found for the centre of projection of world_to_view and view_to_clip (view.eye, if a camera made the
/// view), or for the direction of a parallel projection. They depend on object_to_world and the positions of the mesh;
/// vertex programs have no effect on them.
///
/// A drawing without hidden lines takes two draws. The first draws the mesh as usual (without a material, if only lines
/// shall be visible), with depth_bias 1e-5 and depth_bias_slope fill_width / 2 + 1. This bias moves the surface behind
/// the lines that lie on its front. The second draws the lines with SHD_COMPARE_LESS_EQUAL. Lines over everything use
/// SHD_COMPARE_ALWAYS.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawDesc {
    /// affine, finite; default identity
    pub object_to_world: [f32; 16],
    /// default SHD_FREQUENCY_PHONG
    pub frequency: Frequency,
    /// default none
    pub flags: DrawFlag,
    /// default SHD_CULL_NONE
    pub cull: Cull,
    /// default SHD_COMPARE_LESS
    pub compare: Compare,
    /// added to depth, -1..1; the sum is clamped to 0..1; default 0
    pub depth_bias: f32,
    /// factor of another bias: the larger of |dz/dx| and |dz/dy| per pixel; finite;
    /// default 0
    pub depth_bias_slope: f32,
    /// default SHD_FILL_SOLID
    pub fill: Fill,
    /// width of lines and points \[pixels\], 1/16..64; default 0 = 1
    pub fill_width: f32,
    /// edges of SHD_FILL_LINES; default SHD_EDGE_ALL
    pub edges: Edge,
    /// threshold of SHD_EDGE_CREASE, as in shd_edges_desc: -1..1; default 0.5
    pub crease_cosine: f32,
}
impl DrawDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_draw {
        let mut raw = sys::shd_draw::default();
        raw.object_to_world = self.object_to_world;
        raw.frequency = self.frequency;
        raw.flags = self.flags.0;
        raw.cull = self.cull;
        raw.compare = self.compare;
        raw.depth_bias = self.depth_bias;
        raw.depth_bias_slope = self.depth_bias_slope;
        raw.fill = self.fill;
        raw.fill_width = self.fill_width;
        raw.edges = self.edges.0;
        raw.crease_cosine = self.crease_cosine;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_draw) -> Self {
        Self {
            object_to_world: raw.object_to_world,
            frequency: raw.frequency,
            flags: DrawFlag(raw.flags),
            cull: raw.cull,
            compare: raw.compare,
            depth_bias: raw.depth_bias,
            depth_bias_slope: raw.depth_bias_slope,
            fill: raw.fill,
            fill_width: raw.fill_width,
            edges: Edge(raw.edges),
            crease_cosine: raw.crease_cosine,
        }
    }
}
impl Default for DrawDesc {
    /// The defaults of `shd_draw`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_draw::default())
    }
}

/// A whole frame, or a window of it. All pointers are borrowed for the call. Required: framebuffer.
///
/// Draws are projected to the picture. The framebuffer holds the window of the picture that begins at pixel (crop_x,
/// crop_y). Its pixels have the same bits as in the whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderDesc {
    /// linear, premultiplied RGBA; default 0
    pub clear_color: [f32; 4],
    /// 0..1; default 1
    pub clear_depth: f32,
    /// default none
    pub flags: RenderFlag,
    /// default: identity matrices, eye at 0
    pub view: View,
    /// default SHD_VISIBILITY_DEPTH
    pub visibility: Visibility,
    /// pixels, framebuffer size..65536; default 0 = framebuffer size
    pub picture_width: u32,
    /// pixels, framebuffer size..65536; default 0 = framebuffer size
    pub picture_height: u32,
    /// column of the picture at which the framebuffer begins; the framebuffer lies
    /// inside the picture; default 0
    pub crop_x: u32,
    /// row of the picture at which the framebuffer begins; default 0
    pub crop_y: u32,
    /// n, 2..16; 0 and 1 = off. The frame is drawn as a picture n times as large, up to 65536 pixels a side, with the
    /// framebuffer's number of samples in each pixel; crop, viewport and scissor are scaled by n. Colour and targets of
    /// a pixel are the plain average of its n x n pixels; depth and the other planes have the values of the top left
    /// one. Derivatives (and so footprints of textures) and raster positions in programs refer to the large picture;
    /// lines and points are n times as wide in it. With SHD_RENDER_LOAD each of the n x n pixels starts with the pixel's
    /// values. The large picture is drawn in blocks of up to 1024 x 1024 pixels; only one block is in memory. Statistics
    /// are sums over blocks, so a triangle counts in each block.
    pub supersampling: u32,
    /// Largest number of triangles that are processed together, 1024..2^31-1; 0 = 2^21. A larger frame is drawn in
    /// passes. A pass has several whole draws, each of which counts as at least 16 triangles, or a part of one draw. The
    /// framebuffer has the same bits for any number. Draws of SHD_BLEND_WEIGHTED and SHD_BLEND_SORTED form the last pass
    /// together. Only with SHD_VISIBILITY_DEPTH: the other methods order all triangles together.
    ///
    /// Working memory is at most 512 bytes for each of these triangles, 256 for each draw or instance, 24 for each
    /// sample of the framebuffer and 16 more for each of its targets, and 8 MiB for each worker. Additional memory: 4
    /// bytes for each tile of 64 x 64 pixels that a triangle touches beyond dozens, 48 for each piece of a clipped
    /// triangle, 4 for each varying of up to three vertices a triangle, and the triangles of the last pass. A frame in
    /// several passes or with supersampling takes 16 bytes for each pixel of a framebuffer with interleaved colour.
    pub pass_triangles: u32,
    /// factor of its radiance, 0..1e12; default 1
    pub environment_intensity: f32,
    /// rotation or reflection of its directions, column-major, with orthonormal
    /// columns within 1e-3; default identity
    pub environment_to_world: [f32; 9],
    /// default SHD_BACKGROUND_CLEAR
    pub background: Background,
    /// roughness of the GGX lobe that blurs the environment behind the picture, 0..1;
    /// values above 0 need SHD_ENVIRONMENT_TABLE_GGX; default 0 = sharp
    pub background_roughness: f32,
}
impl RenderDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_render_desc {
        let mut raw = sys::shd_render_desc::default();
        raw.clear_color = self.clear_color;
        raw.clear_depth = self.clear_depth;
        raw.flags = self.flags.0;
        raw.view = self.view.to_raw();
        raw.visibility = self.visibility;
        raw.picture_width = self.picture_width;
        raw.picture_height = self.picture_height;
        raw.crop_x = self.crop_x;
        raw.crop_y = self.crop_y;
        raw.supersampling = self.supersampling;
        raw.pass_triangles = self.pass_triangles;
        raw.environment_intensity = self.environment_intensity;
        raw.environment_to_world = self.environment_to_world;
        raw.background = self.background;
        raw.background_roughness = self.background_roughness;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_render_desc) -> Self {
        Self {
            clear_color: raw.clear_color,
            clear_depth: raw.clear_depth,
            flags: RenderFlag(raw.flags),
            view: View::from_raw(&raw.view),
            visibility: raw.visibility,
            picture_width: raw.picture_width,
            picture_height: raw.picture_height,
            crop_x: raw.crop_x,
            crop_y: raw.crop_y,
            supersampling: raw.supersampling,
            pass_triangles: raw.pass_triangles,
            environment_intensity: raw.environment_intensity,
            environment_to_world: raw.environment_to_world,
            background: raw.background,
            background_roughness: raw.background_roughness,
        }
    }
}
impl Default for RenderDesc {
    /// The defaults of `shd_render_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_render_desc::default())
    }
}

/// Statistics of a frame: the counts from nonfinite to rasterised add up to `triangles`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderStats {
    /// in all draws
    pub triangles: u64,
    /// dropped: a vertex is NaN or infinite after transformation
    pub nonfinite: u64,
    /// dropped: outside the view volume
    pub outside: u64,
    /// dropped: facing the culled way, without area on the pixel grid, or
    /// (SHD_FILL_LINES) without a visible edge that belongs to the triangle
    pub culled: u64,
    /// dropped: between pixel centres
    pub empty: u64,
    /// drawn, hidden or not
    pub rasterised: u64,
    /// cut by a clip plane, among outside, culled, empty and rasterised
    pub clipped: u64,
    /// shaded; opaque draws count a pixel once for every triangle that is visible in
    /// it, in each pass (shd_render_desc.pass_triangles)
    pub fragments: u64,
    /// fragments whose r, g, b or a was NaN or infinite (kept as written)
    pub nonfinite_fragments: u64,
    /// covered, but failed the depth test before shading; 0 without
    /// SHD_RENDER_COUNT_HIDDEN. Draws that blend or drop fragments may be tested against
    /// stale depth, so their count is approximate
    pub hidden_samples: u64,
    /// PAINTER and NEWELL: pairs of triangles or pieces that overlap on the screen where the one painted first is nearer
    /// somewhere in the overlap, by more than the tolerance of NEWELL. A lower bound where triangles are dense: pairs
    /// are searched in the cells of a grid, and in a cell of n triangles up to 64 n + 1024 pairs are compared.
    pub order_conflicts: u64,
    /// cuts of NEWELL
    pub splits: u64,
    /// peak of working memory, with what the context keeps from earlier calls; depends on
    /// the number of workers
    pub scratch_bytes: u64,
    /// wall-clock time of transforming vertices
    pub vertex_seconds: f64,
    /// wall-clock time of finding visible triangles and clipping them
    pub assembly_seconds: f64,
    /// wall-clock time of sorting triangles by distance (if at all) and into tiles
    pub binning_seconds: f64,
    /// wall-clock time of coverage, shading and blending
    pub tile_seconds: f64,
}
impl RenderStats {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_render_stats {
        let mut raw = sys::shd_render_stats::default();
        raw.triangles = self.triangles;
        raw.nonfinite = self.nonfinite;
        raw.outside = self.outside;
        raw.culled = self.culled;
        raw.empty = self.empty;
        raw.rasterised = self.rasterised;
        raw.clipped = self.clipped;
        raw.fragments = self.fragments;
        raw.nonfinite_fragments = self.nonfinite_fragments;
        raw.hidden_samples = self.hidden_samples;
        raw.order_conflicts = self.order_conflicts;
        raw.splits = self.splits;
        raw.scratch_bytes = self.scratch_bytes;
        raw.vertex_seconds = self.vertex_seconds;
        raw.assembly_seconds = self.assembly_seconds;
        raw.binning_seconds = self.binning_seconds;
        raw.tile_seconds = self.tile_seconds;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_render_stats) -> Self {
        Self {
            triangles: raw.triangles,
            nonfinite: raw.nonfinite,
            outside: raw.outside,
            culled: raw.culled,
            empty: raw.empty,
            rasterised: raw.rasterised,
            clipped: raw.clipped,
            fragments: raw.fragments,
            nonfinite_fragments: raw.nonfinite_fragments,
            hidden_samples: raw.hidden_samples,
            order_conflicts: raw.order_conflicts,
            splits: raw.splits,
            scratch_bytes: raw.scratch_bytes,
            vertex_seconds: raw.vertex_seconds,
            assembly_seconds: raw.assembly_seconds,
            binning_seconds: raw.binning_seconds,
            tile_seconds: raw.tile_seconds,
        }
    }
}
impl Default for RenderStats {
    /// The defaults of `shd_render_stats`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_render_stats::default())
    }
}

/// Image and tables of an environment. Required: image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvironmentDesc {
    /// any but SHD_PROJECTION_NONE; default SHD_PROJECTION_LAT_LONG
    pub projection: Projection,
    /// default SHD_IRRADIANCE_HARMONICS
    pub irradiance: Irradiance,
    /// default SHD_ENVIRONMENT_TABLE_ALL
    pub tables: EnvironmentTable,
}
impl EnvironmentDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_environment_desc {
        let mut raw = sys::shd_environment_desc::default();
        raw.projection = self.projection;
        raw.irradiance = self.irradiance;
        raw.tables = self.tables.0;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_environment_desc) -> Self {
        Self {
            projection: raw.projection,
            irradiance: raw.irradiance,
            tables: EnvironmentTable(raw.tables),
        }
    }
}
impl Default for EnvironmentDesc {
    /// The defaults of `shd_environment_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_environment_desc::default())
    }
}

/// Properties of an environment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvironmentInfo {
    /// as in its desc
    pub projection: Projection,
    /// as in its desc
    pub irradiance: Irradiance,
    /// as in its desc, with SHD_ENVIRONMENT_TABLE_RADIANCE if there are lobes
    pub tables: EnvironmentTable,
    /// texels a side of the largest map, 0 without SHD_ENVIRONMENT_TABLE_RADIANCE
    pub map_size: u32,
    /// mean radiance of all directions
    pub mean: [f32; 3],
    /// channels of the image that were negative, NaN or above 1e12
    pub replaced_count: u64,
    /// bytes of all tables
    pub byte_size: usize,
}
impl EnvironmentInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_environment_info {
        let mut raw = sys::shd_environment_info::default();
        raw.projection = self.projection;
        raw.irradiance = self.irradiance;
        raw.tables = self.tables.0;
        raw.map_size = self.map_size;
        raw.mean = self.mean;
        raw.replaced_count = self.replaced_count;
        raw.byte_size = self.byte_size;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_environment_info) -> Self {
        Self {
            projection: raw.projection,
            irradiance: raw.irradiance,
            tables: EnvironmentTable(raw.tables),
            map_size: raw.map_size,
            mean: raw.mean,
            replaced_count: raw.replaced_count,
            byte_size: raw.byte_size,
        }
    }
}
impl Default for EnvironmentInfo {
    /// The defaults of `shd_environment_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_environment_info::default())
    }
}

/// Options of a shadow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowDesc {
    /// edge length of each face \[texels\], 16..8192; default 1024
    pub size: u32,
    /// default SHD_SHADOW_FILTER_HARD
    pub filter: ShadowFilter,
    /// n of PCF, VARIANCE and PCSS, 1..15; default 3
    pub taps: u32,
    /// SUMMED_AREA_VARIANCE: edge length of the averaged square, world length at the point, 0..1e9; clamped to one texel
    /// to size / 4 texels. Default 0.
    pub filter_size: f32,
    /// PCSS: edge length of the square light, world length, 0..1e9; default 0. For directional lights: width of the
    /// penumbra per distance of blocker and receiver, which is twice the tangent of half the angular size of the light
    /// (the sun: 0.0093). Search and penumbra are at most size / 4 texels wide.
    pub light_size: f32,
    /// points are moved towards the light by this depth, world length, 0..1e9; default 0
    pub bias: f32,
    /// Factor of another bias: the edge length of a texel at the point times 1/4 + s. s is the sum of the |slopes| of
    /// the surface across and along the map, at most 8. A slope is depth over length. The plane of the surface is exact
    /// at each texel, so this bias covers only the difference of the surface from its plane. Without a normal, 1/4 + s
    /// is replaced by 2, or by n + 1 for PCF. 0..1000; default 1.
    pub bias_slope: f32,
    /// before the lookup, points are moved along their normal by this world length, 0..1e9;
    /// default 0. For coarse meshes with smooth normals: about the edge length of a texel
    pub normal_offset: f32,
    /// faces that cast no shadow: BACK faces are turned away from the light, FRONT faces
    /// towards it. Replaces the culling of the draws. Default SHD_CULL_NONE, for open surfaces.
    /// FRONT avoids acne on closed objects without a bias, but light leaks where they touch
    /// other surfaces
    pub caster_cull: Cull,
    /// VARIANCE, SUMMED_AREA_VARIANCE: visibilities below this value become 0, 0..0.99;
    /// default 0
    pub bleed: f32,
    /// VARIANCE, SUMMED_AREA_VARIANCE: world length squared, 0..1e9; default 0
    pub min_variance: f32,
}
impl ShadowDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_shadow_desc {
        let mut raw = sys::shd_shadow_desc::default();
        raw.size = self.size;
        raw.filter = self.filter;
        raw.taps = self.taps;
        raw.filter_size = self.filter_size;
        raw.light_size = self.light_size;
        raw.bias = self.bias;
        raw.bias_slope = self.bias_slope;
        raw.normal_offset = self.normal_offset;
        raw.caster_cull = self.caster_cull;
        raw.bleed = self.bleed;
        raw.min_variance = self.min_variance;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_shadow_desc) -> Self {
        Self {
            size: raw.size,
            filter: raw.filter,
            taps: raw.taps,
            filter_size: raw.filter_size,
            light_size: raw.light_size,
            bias: raw.bias,
            bias_slope: raw.bias_slope,
            normal_offset: raw.normal_offset,
            caster_cull: raw.caster_cull,
            bleed: raw.bleed,
            min_variance: raw.min_variance,
        }
    }
}
impl Default for ShadowDesc {
    /// The defaults of `shd_shadow_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_shadow_desc::default())
    }
}

/// Light and draws of a map; borrowed for the call. Required: light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowRenderDesc {
    /// Range of depths, near_plane \< far_plane. Surfaces outside cast no shadow. Both 0 = fitted to the draws.
    /// Directional lights: measured from the origin of the world along the direction of the light, any sign. Other
    /// lights: measured from the light along the axis of the face, > 0; a fitted near_plane is at least 1/256 of
    /// far_plane.
    pub near_plane: f32,
    pub far_plane: f32,
    /// Directional lights: the part of the world that needs shadows. Both 0 = the bounds of the draws. Draws between
    /// this part and the light still cast shadows. The size of texels is rounded up in steps of 1/8 to 1/16, and texels
    /// lie at multiples of their size, so shadows do not shimmer while bounds of constant size move.
    pub bounds_min: [f32; 3],
    pub bounds_max: [f32; 3],
}
impl ShadowRenderDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_shadow_render_desc {
        let mut raw = sys::shd_shadow_render_desc::default();
        raw.near_plane = self.near_plane;
        raw.far_plane = self.far_plane;
        raw.bounds_min = self.bounds_min;
        raw.bounds_max = self.bounds_max;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_shadow_render_desc) -> Self {
        Self {
            near_plane: raw.near_plane,
            far_plane: raw.far_plane,
            bounds_min: raw.bounds_min,
            bounds_max: raw.bounds_max,
        }
    }
}
impl Default for ShadowRenderDesc {
    /// The defaults of `shd_shadow_render_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_shadow_render_desc::default())
    }
}

/// Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadDesc {
    /// formats to accept; default 0 = SHD_FILE_FORMAT_DEFAULT
    pub formats: FileFormat,
    /// default none
    pub flags: LoadFlag,
    /// default AUTO; other values override the file's declaration
    pub color_space: ColorEncoding,
    /// tables of textures; default SHD_TABLE_MIPMAP
    pub tables: Table,
    /// part of a multi-part EXR, page of a TIFF, frame of a GIF; default 0
    pub subimage: u32,
    /// size of the file; 0 = 2^30
    pub max_file_bytes: u64,
    /// width * height, of the data and of the display window, and the pixels of all
    /// levels with SHD_LOAD_FILE_LEVELS; 0 = 2^28
    pub max_pixels: u64,
    /// decoded, as RGBA, all levels; 0 = 2^32
    pub max_bytes: u64,
    /// decoded bytes per file byte, for more than 2^24 decoded; 0 = 4000
    pub max_ratio: f64,
    /// \[s\], 0 = 60; kills the child that decodes. With SHD_LOAD_IN_PROCESS it is
    /// checked between bands of rows. A worker that is stopped (SIGSTOP, a debugger)
    /// costs a load all of its time; when it has been silent for two seconds, the
    /// next load starts another one
    pub time_limit: f64,
}
impl LoadDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_load_desc {
        let mut raw = sys::shd_load_desc::default();
        raw.formats = self.formats.0;
        raw.flags = self.flags.0;
        raw.color_space = self.color_space;
        raw.tables = self.tables.0;
        raw.subimage = self.subimage;
        raw.max_file_bytes = self.max_file_bytes;
        raw.max_pixels = self.max_pixels;
        raw.max_bytes = self.max_bytes;
        raw.max_ratio = self.max_ratio;
        raw.time_limit = self.time_limit;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_load_desc) -> Self {
        Self {
            formats: FileFormat(raw.formats),
            flags: LoadFlag(raw.flags),
            color_space: raw.color_space,
            tables: Table(raw.tables),
            subimage: raw.subimage,
            max_file_bytes: raw.max_file_bytes,
            max_pixels: raw.max_pixels,
            max_bytes: raw.max_bytes,
            max_ratio: raw.max_ratio,
            time_limit: raw.time_limit,
        }
    }
}
impl Default for LoadDesc {
    /// The defaults of `shd_load_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_load_desc::default())
    }
}

/// Layout of a file of voxels. Required: width, height, depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RawDesc {
    /// voxels along x, 1..65536; width * height * depth at most 2^28
    pub width: u32,
    /// voxels along y, 1..65536
    pub height: u32,
    /// voxels along z, 1..65536
    pub depth: u32,
    /// default SHD_RAW_SAMPLE_U8
    pub sample: RawSample,
    /// numbers of a voxel, one behind the other, 1..4; default 1
    pub channels: u32,
    /// default SHD_BYTE_ORDER_LITTLE
    pub byte_order: ByteOrder,
    /// bytes before the first voxel, or SHD_RAW_HEADER_REST; default 0
    pub header_bytes: u64,
}
impl RawDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_raw_desc {
        let mut raw = sys::shd_raw_desc::default();
        raw.width = self.width;
        raw.height = self.height;
        raw.depth = self.depth;
        raw.sample = self.sample;
        raw.channels = self.channels;
        raw.byte_order = self.byte_order;
        raw.header_bytes = self.header_bytes;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_raw_desc) -> Self {
        Self {
            width: raw.width,
            height: raw.height,
            depth: raw.depth,
            sample: raw.sample,
            channels: raw.channels,
            byte_order: raw.byte_order,
            header_bytes: raw.header_bytes,
        }
    }
}
impl Default for RawDesc {
    /// The defaults of `shd_raw_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_raw_desc::default())
    }
}

/// Grid and box of an OpenVDB load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VdbDesc {
    /// default none
    pub flags: VdbFlag,
    /// first voxel of the box, in index space, -2^30..2^30; read with SHD_VDB_BOX
    pub box_min: [i32; 3],
    /// last voxel of the box, at least box_min on each axis; read with SHD_VDB_BOX
    pub box_max: [i32; 3],
}
impl VdbDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_vdb_desc {
        let mut raw = sys::shd_vdb_desc::default();
        raw.flags = self.flags.0;
        raw.box_min = self.box_min;
        raw.box_max = self.box_max;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_vdb_desc) -> Self {
        Self {
            flags: VdbFlag(raw.flags),
            box_min: raw.box_min,
            box_max: raw.box_max,
        }
    }
}
impl Default for VdbDesc {
    /// The defaults of `shd_vdb_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_vdb_desc::default())
    }
}

/// Properties of a loaded grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VdbInfo {
    /// as declared by the file
    pub grid_class: VdbClass,
    /// voxel of texel (0, 0, 0), in index space
    pub index_min: [i32; 3],
    /// value of all voxels that the file does not store
    pub background: f32,
    /// in the whole grid
    pub active_voxels: u64,
    /// from texture coordinates (u, v, w) to the world of the file, column-major: for
    /// shd_volume_draw, if the box of the volume is the default box
    pub object_to_world: [f32; 16],
}
impl VdbInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_vdb_info {
        let mut raw = sys::shd_vdb_info::default();
        raw.grid_class = self.grid_class;
        raw.index_min = self.index_min;
        raw.background = self.background;
        raw.active_voxels = self.active_voxels;
        raw.object_to_world = self.object_to_world;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_vdb_info) -> Self {
        Self {
            grid_class: raw.grid_class,
            index_min: raw.index_min,
            background: raw.background,
            active_voxels: raw.active_voxels,
            object_to_world: raw.object_to_world,
        }
    }
}
impl Default for VdbInfo {
    /// The defaults of `shd_vdb_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_vdb_info::default())
    }
}

/// Contents of a texture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureFileInfo {
    /// file format
    pub kind: TextureFileKind,
    /// storage in the file: VkFormat of KTX2; DXGI_FORMAT of DDS, 0 without such a number
    pub file_code: u32,
    /// compression around the levels; NONE for DDS
    pub supercompression: Supercompression,
    /// properties
    pub flags: TextureFileFlag,
    /// storage in the texture
    pub format: Format,
    /// texels of level 0
    pub width: u32,
    /// texels of level 0; 1 for a 1D texture
    pub height: u32,
    /// slices of level 0; 0 = not a 3D texture
    pub depth: u32,
    /// images of the array, or cube maps of an array of cube maps
    pub layers: u32,
    /// 6 for cube maps, otherwise 1
    pub faces: u32,
    /// levels in the file
    pub level_count: u32,
}
impl TextureFileInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_texture_file_info {
        let mut raw = sys::shd_texture_file_info::default();
        raw.kind = self.kind;
        raw.file_code = self.file_code;
        raw.supercompression = self.supercompression;
        raw.flags = self.flags.0;
        raw.format = self.format;
        raw.width = self.width;
        raw.height = self.height;
        raw.depth = self.depth;
        raw.layers = self.layers;
        raw.faces = self.faces;
        raw.level_count = self.level_count;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_texture_file_info) -> Self {
        Self {
            kind: raw.kind,
            file_code: raw.file_code,
            supercompression: raw.supercompression,
            flags: TextureFileFlag(raw.flags),
            format: raw.format,
            width: raw.width,
            height: raw.height,
            depth: raw.depth,
            layers: raw.layers,
            faces: raw.faces,
            level_count: raw.level_count,
        }
    }
}
impl Default for TextureFileInfo {
    /// The defaults of `shd_texture_file_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_texture_file_info::default())
    }
}

/// Options of a KTX2 file that is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ktx2Desc {
    /// NONE, ZSTD or ZLIB; default NONE
    pub supercompression: Supercompression,
    /// 1..19 for ZSTD, 1..9 for ZLIB; default 0 = that of the library
    pub effort: i32,
    /// 3 = write r, g and b of a texture of four channels. Textures that are made of three channels have four, and the
    /// fourth is 0. Default 0 = all channels.
    pub channels: u32,
}
impl Ktx2Desc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_ktx2_desc {
        let mut raw = sys::shd_ktx2_desc::default();
        raw.supercompression = self.supercompression;
        raw.effort = self.effort;
        raw.channels = self.channels;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_ktx2_desc) -> Self {
        Self {
            supercompression: raw.supercompression,
            effort: raw.effort,
            channels: raw.channels,
        }
    }
}
impl Default for Ktx2Desc {
    /// The defaults of `shd_ktx2_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_ktx2_desc::default())
    }
}

/// Options and budgets of a load. A budget that would be exceeded is SHD_ERROR_LIMIT.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneDesc {
    /// default none
    pub flags: SceneFlag,
    /// flags of all meshes; meshes with uv have tangents, unless a normal map reads uv1;
    /// default none
    pub mesh_flags: MeshFlag,
    /// sum of the model and the files that are read with it; 0 = 2^30
    pub max_file_bytes: u64,
    /// sum over all meshes; 0 = 2^26
    pub max_vertices: u64,
    /// sum over all meshes; 0 = 2^26
    pub max_triangles: u64,
    /// 0 = 2^18; always at most 512 deep
    pub max_nodes: u64,
    /// up to 2^20, the maximum of a frame; 0 = 2^18
    pub max_instances: u64,
    /// all textures with their mip levels; 0 = 2^32
    pub max_texture_bytes: u64,
    /// \[s\] 0 = 60. Ends the process that reads; with SHD_SCENE_IN_PROCESS checked
    /// between the steps of a reader
    pub time_limit: f64,
    /// memory of the process that reads, and of what it sends; 0 = 2^32 \[bytes\]
    pub max_reader_bytes: u64,
}
impl SceneDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_scene_desc {
        let mut raw = sys::shd_scene_desc::default();
        raw.flags = self.flags.0;
        raw.mesh_flags = self.mesh_flags.0;
        raw.max_file_bytes = self.max_file_bytes;
        raw.max_vertices = self.max_vertices;
        raw.max_triangles = self.max_triangles;
        raw.max_nodes = self.max_nodes;
        raw.max_instances = self.max_instances;
        raw.max_texture_bytes = self.max_texture_bytes;
        raw.time_limit = self.time_limit;
        raw.max_reader_bytes = self.max_reader_bytes;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_scene_desc) -> Self {
        Self {
            flags: SceneFlag(raw.flags),
            mesh_flags: MeshFlag(raw.mesh_flags),
            max_file_bytes: raw.max_file_bytes,
            max_vertices: raw.max_vertices,
            max_triangles: raw.max_triangles,
            max_nodes: raw.max_nodes,
            max_instances: raw.max_instances,
            max_texture_bytes: raw.max_texture_bytes,
            time_limit: raw.time_limit,
            max_reader_bytes: raw.max_reader_bytes,
        }
    }
}
impl Default for SceneDesc {
    /// The defaults of `shd_scene_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_scene_desc::default())
    }
}

/// Contents of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneInfo {
    /// with triangles
    pub mesh_count: u32,
    /// at least 1
    pub material_count: u32,
    /// that could be read
    pub texture_count: u32,
    /// 0 where the file has none
    pub light_count: u32,
    /// 0 where the file has none
    pub camera_count: u32,
    /// as many as draws
    pub instance_count: u32,
    /// parts of the file that were left out or changed
    pub warning_count: u32,
    /// sum over all meshes, each counted once
    pub vertex_count: u64,
    /// sum over all meshes, each counted once
    pub triangle_count: u64,
    /// lowest x, y, z of all instances, world space
    pub bounds_min: [f32; 3],
    /// highest x, y, z of all instances, world space
    pub bounds_max: [f32; 3],
    /// a place in the world of the file is origin + the place in world space; 0 unless the
    /// model is far away from 0. Equal in all poses
    pub origin: [f64; 3],
    /// 0 where the file has none
    pub animation_count: u32,
    /// meshes with a skin or morph targets, which each pose makes anew
    pub deformed_mesh_count: u32,
}
impl SceneInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_scene_info {
        let mut raw = sys::shd_scene_info::default();
        raw.mesh_count = self.mesh_count;
        raw.material_count = self.material_count;
        raw.texture_count = self.texture_count;
        raw.light_count = self.light_count;
        raw.camera_count = self.camera_count;
        raw.instance_count = self.instance_count;
        raw.warning_count = self.warning_count;
        raw.vertex_count = self.vertex_count;
        raw.triangle_count = self.triangle_count;
        raw.bounds_min = self.bounds_min;
        raw.bounds_max = self.bounds_max;
        raw.origin = self.origin;
        raw.animation_count = self.animation_count;
        raw.deformed_mesh_count = self.deformed_mesh_count;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_scene_info) -> Self {
        Self {
            mesh_count: raw.mesh_count,
            material_count: raw.material_count,
            texture_count: raw.texture_count,
            light_count: raw.light_count,
            camera_count: raw.camera_count,
            instance_count: raw.instance_count,
            warning_count: raw.warning_count,
            vertex_count: raw.vertex_count,
            triangle_count: raw.triangle_count,
            bounds_min: raw.bounds_min,
            bounds_max: raw.bounds_max,
            origin: raw.origin,
            animation_count: raw.animation_count,
            deformed_mesh_count: raw.deformed_mesh_count,
        }
    }
}
impl Default for SceneInfo {
    /// The defaults of `shd_scene_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_scene_info::default())
    }
}

/// A mesh placed in the world with a material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneInstance {
    /// index for shd_scene_mesh()
    pub mesh: u32,
    /// index for shd_scene_material()
    pub material: u32,
    /// affine, finite
    pub object_to_world: [f32; 16],
    /// faces that its draw skips: SHD_CULL_NONE for surfaces that are double-sided
    pub cull: Cull,
}
impl SceneInstance {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_scene_instance {
        let mut raw = sys::shd_scene_instance::default();
        raw.mesh = self.mesh;
        raw.material = self.material;
        raw.object_to_world = self.object_to_world;
        raw.cull = self.cull;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_scene_instance) -> Self {
        Self {
            mesh: raw.mesh,
            material: raw.material,
            object_to_world: raw.object_to_world,
            cull: raw.cull,
        }
    }
}
impl Default for SceneInstance {
    /// The defaults of `shd_scene_instance`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_scene_instance::default())
    }
}

/// Options of a save.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaveDesc {
    /// a framebuffer's colour: PNG 8 or 16, EXR 16 or 32, TIFF 8, 16 or 32;
    /// default 0 = 8 for PNG, 16 for EXR, 32 for TIFF. For images always 0
    pub bit_depth: u32,
    /// framebuffers in 8 and 16 bits: AUTO and SRGB apply the sRGB curve, LINEAR and
    /// DATA do not. Images: the tag of PNG and EXR; AUTO = by pixel format
    pub color_space: ColorEncoding,
    /// a framebuffer's colour in 8 and 16 bits; default none
    pub dither: Dither,
}
impl SaveDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_save_desc {
        let mut raw = sys::shd_save_desc::default();
        raw.bit_depth = self.bit_depth;
        raw.color_space = self.color_space;
        raw.dither = self.dither;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_save_desc) -> Self {
        Self {
            bit_depth: raw.bit_depth,
            color_space: raw.color_space,
            dither: raw.dither,
        }
    }
}
impl Default for SaveDesc {
    /// The defaults of `shd_save_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_save_desc::default())
    }
}

/// Source of the config. Zero is the default of each field. Strings are borrowed for the call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorDesc {
    /// precision of 8-bit images; default SHD_DISPLAY_PRECISION_BAKED
    pub display_precision: DisplayPrecision,
}
impl ColorDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_color_desc {
        let mut raw = sys::shd_color_desc::default();
        raw.display_precision = self.display_precision;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_color_desc) -> Self {
        Self {
            display_precision: raw.display_precision,
        }
    }
}
impl Default for ColorDesc {
    /// The defaults of `shd_color_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_color_desc::default())
    }
}

/// Size of a tile cache.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileCacheDesc {
    /// bytes of a tile, a power of two from 1024 to 2^20; default 65536
    pub tile_bytes: u32,
    /// All memory of the cache: tiles, their table, and places for copies of texels; from 4 tiles plus 64 KiB to 2^31
    /// bytes; default 2^28. It is allocated once. A small budget makes lookups slower, because tiles are loaded again.
    /// Half of the tiles can be pinned.
    pub budget_bytes: u64,
}
impl TileCacheDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_tile_cache_desc {
        let mut raw = sys::shd_tile_cache_desc::default();
        raw.tile_bytes = self.tile_bytes;
        raw.budget_bytes = self.budget_bytes;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_tile_cache_desc) -> Self {
        Self {
            tile_bytes: raw.tile_bytes,
            budget_bytes: raw.budget_bytes,
        }
    }
}
impl Default for TileCacheDesc {
    /// The defaults of `shd_tile_cache_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_tile_cache_desc::default())
    }
}

/// Counters of a tile cache since its creation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileCacheStats {
    /// bytes of a tile
    pub tile_bytes: u32,
    /// as in its desc
    pub budget_bytes: u64,
    /// memory of the cache, at most the budget; it does not change
    pub allocated_bytes: u64,
    /// tiles that fit
    pub tile_count: u32,
    /// tiles in memory now
    pub resident_tiles: u32,
    /// tiles that are pinned now
    pub pinned_tiles: u32,
    /// tiles that shd_tile_cache_load_requested() would load now
    pub requested_tiles: u32,
    /// calls of load callbacks
    pub loads: u64,
    /// tiles that callbacks wrote
    pub loaded_tiles: u64,
    /// tiles of calls that failed
    pub failed_tiles: u64,
    /// tiles that gave their place to others
    pub evicted_tiles: u64,
    /// waits of lookups for tiles that other threads loaded
    pub waits: u64,
}
impl TileCacheStats {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_tile_cache_stats {
        let mut raw = sys::shd_tile_cache_stats::default();
        raw.tile_bytes = self.tile_bytes;
        raw.budget_bytes = self.budget_bytes;
        raw.allocated_bytes = self.allocated_bytes;
        raw.tile_count = self.tile_count;
        raw.resident_tiles = self.resident_tiles;
        raw.pinned_tiles = self.pinned_tiles;
        raw.requested_tiles = self.requested_tiles;
        raw.loads = self.loads;
        raw.loaded_tiles = self.loaded_tiles;
        raw.failed_tiles = self.failed_tiles;
        raw.evicted_tiles = self.evicted_tiles;
        raw.waits = self.waits;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_tile_cache_stats) -> Self {
        Self {
            tile_bytes: raw.tile_bytes,
            budget_bytes: raw.budget_bytes,
            allocated_bytes: raw.allocated_bytes,
            tile_count: raw.tile_count,
            resident_tiles: raw.resident_tiles,
            pinned_tiles: raw.pinned_tiles,
            requested_tiles: raw.requested_tiles,
            loads: raw.loads,
            loaded_tiles: raw.loaded_tiles,
            failed_tiles: raw.failed_tiles,
            evicted_tiles: raw.evicted_tiles,
            waits: raw.waits,
        }
    }
}
impl Default for TileCacheStats {
    /// The defaults of `shd_tile_cache_stats`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_tile_cache_stats::default())
    }
}

/// A rectangle of a level. Required: width, height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileRegion {
    /// layer, face, or slice of the level of a 3D texture; default 0
    pub layer: u32,
    /// 0..level_count - 1; default 0
    pub level: u32,
    /// first column, in texels of the level; default 0
    pub x: u32,
    /// first row; default 0
    pub y: u32,
    /// 1 or more; x + width is at most the width of the level
    pub width: u32,
    /// 1 or more; y + height is at most the height of the level
    pub height: u32,
}
impl TileRegion {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_tile_region {
        let mut raw = sys::shd_tile_region::default();
        raw.layer = self.layer;
        raw.level = self.level;
        raw.x = self.x;
        raw.y = self.y;
        raw.width = self.width;
        raw.height = self.height;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_tile_region) -> Self {
        Self {
            layer: raw.layer,
            level: raw.level,
            x: raw.x,
            y: raw.y,
            width: raw.width,
            height: raw.height,
        }
    }
}
impl Default for TileRegion {
    /// The defaults of `shd_tile_region`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_tile_region::default())
    }
}

/// Options of a texture in a file. Required: cache.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileFileDesc {
    /// meaning of 8-bit numbers; default AUTO = as declared by the file, sRGB if it
    /// declares nothing. Other numbers must be linear, or be declared so here
    pub color_space: ColorEncoding,
    /// open readers to keep, 1..4096; default 0 = 16. Each has a descriptor and some
    /// memory of OpenImageIO; more exist while more threads read. A KTX2 or DDS file
    /// has one descriptor for all threads
    pub max_readers: usize,
    /// colour of absent files of a set, linear; finite; default 0, 0, 0, 1
    pub fill: [f32; 4],
}
impl TileFileDesc {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_tile_file_desc {
        let mut raw = sys::shd_tile_file_desc::default();
        raw.color_space = self.color_space;
        raw.max_readers = self.max_readers;
        raw.fill = self.fill;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_tile_file_desc) -> Self {
        Self {
            color_space: raw.color_space,
            max_readers: raw.max_readers,
            fill: raw.fill,
        }
    }
}
impl Default for TileFileDesc {
    /// The defaults of `shd_tile_file_desc`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_tile_file_desc::default())
    }
}

/// Files of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TileFileInfo {
    /// files of a set side by side; 1 for a file
    pub columns: u32,
    /// files of a set one above the other; 1 for a file
    pub rows: u32,
    /// files that exist
    pub files: u32,
    /// texels of a tile of a file. Caches whose tiles are as large or larger read each tile of
    /// a file once. KTX2 and DDS: 4 for blocks, 1 for pixels
    pub tile_width: u32,
    /// texels of a tile of a file
    pub tile_height: u32,
}
impl TileFileInfo {
    #[allow(dead_code)]
    pub(crate) fn to_raw(self) -> sys::shd_tile_file_info {
        let mut raw = sys::shd_tile_file_info::default();
        raw.columns = self.columns;
        raw.rows = self.rows;
        raw.files = self.files;
        raw.tile_width = self.tile_width;
        raw.tile_height = self.tile_height;
        raw
    }
    #[allow(dead_code)]
    pub(crate) fn from_raw(raw: &sys::shd_tile_file_info) -> Self {
        Self {
            columns: raw.columns,
            rows: raw.rows,
            files: raw.files,
            tile_width: raw.tile_width,
            tile_height: raw.tile_height,
        }
    }
}
impl Default for TileFileInfo {
    /// The defaults of `shd_tile_file_info`.
    fn default() -> Self {
        Self::from_raw(&sys::shd_tile_file_info::default())
    }
}
