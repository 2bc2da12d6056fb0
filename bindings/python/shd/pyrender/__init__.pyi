# SPDX-License-Identifier: MIT
# Types of shd.pyrender.
from types import TracebackType
from typing import Any, Dict, Iterable, List, Literal, Mapping, Optional, Set, Tuple, Type, Union

import numpy as np
import numpy.typing as npt

from .. import _Attribute, _Bytes, _Image, _Numbers, _Path
from .constants import GLTF as GLTF, RenderFlags as RenderFlags, TextAlign as TextAlign
from ..renderer import _Trimesh, _TrimeshScene

__version__: str

_Doubles = npt.NDArray[np.float64]
_Singles = npt.NDArray[np.float32]
_AnyTrimesh = Union[_Trimesh, Model]
_Textured = Union[Texture, _Image, None]

class _Boxed:
    @property
    def bounds(self) -> _Doubles: ...
    @property
    def centroid(self) -> _Doubles: ...
    @property
    def extents(self) -> _Doubles: ...
    @property
    def scale(self) -> float: ...

class Camera:
    name: Optional[str]
    znear: float
    zfar: Optional[float]
    def __init__(self, znear: float = ..., zfar: Optional[float] = ..., name: Optional[str] = ...) -> None: ...
    def get_projection_matrix(self, width: Optional[float] = ..., height: Optional[float] = ...) -> _Doubles: ...

class PerspectiveCamera(Camera):
    yfov: float
    aspectRatio: Optional[float]
    def __init__(self, yfov: float, znear: float = ..., zfar: Optional[float] = ...,
                 aspectRatio: Optional[float] = ..., name: Optional[str] = ...) -> None: ...

class OrthographicCamera(Camera):
    xmag: float
    ymag: float
    def __init__(self, xmag: float, ymag: float, znear: float = ..., zfar: float = ...,
                 name: Optional[str] = ...) -> None: ...

class IntrinsicsCamera(Camera):
    fx: float
    fy: float
    cx: float
    cy: float
    def __init__(self, fx: float, fy: float, cx: float, cy: float, znear: float = ..., zfar: Optional[float] = ...,
                 name: Optional[str] = ...) -> None: ...
    def get_projection_matrix(self, width: float, height: float) -> _Doubles: ...  # type: ignore[override]

class Light:
    name: Optional[str]
    intensity: float
    shadow_texture: Optional[Texture]
    def __init__(self, color: Optional[_Numbers] = ..., intensity: Optional[float] = ...,
                 name: Optional[str] = ...) -> None: ...
    color: _Attribute[_Singles, _Numbers]

class DirectionalLight(Light): ...

class PointLight(Light):
    range: Optional[float]
    def __init__(self, color: Optional[_Numbers] = ..., intensity: Optional[float] = ...,
                 range: Optional[float] = ..., name: Optional[str] = ...) -> None: ...

class SpotLight(Light):
    range: Optional[float]
    innerConeAngle: float
    outerConeAngle: float
    def __init__(self, color: Optional[_Numbers] = ..., intensity: Optional[float] = ...,
                 range: Optional[float] = ..., innerConeAngle: float = ..., outerConeAngle: float = ...,
                 name: Optional[str] = ...) -> None: ...

class Sampler:
    name: Optional[str]
    magFilter: Optional[int]
    minFilter: Optional[int]
    wrapS: int
    wrapT: int
    def __init__(self, name: Optional[str] = ..., magFilter: Optional[int] = ..., minFilter: Optional[int] = ...,
                 wrapS: int = ..., wrapT: int = ...) -> None: ...

_Channels = Literal["D", "R", "RG", "GB", "RGB", "RGBA"]

class Texture:
    name: Optional[str]
    sampler: Sampler
    source_channels: Optional[_Channels]
    width: Optional[int]
    height: Optional[int]
    tex_type: Optional[int]
    data_format: Optional[int]
    def __init__(self, name: Optional[str] = ..., sampler: Optional[Sampler] = ..., source: Optional[_Image] = ...,
                 source_channels: Optional[_Channels] = ..., width: Optional[int] = ..., height: Optional[int] = ...,
                 tex_type: Optional[int] = ..., data_format: Optional[int] = ...) -> None: ...
    source: _Attribute[Optional[npt.NDArray[np.uint8]], Optional[_Image]]
    def is_transparent(self, cutoff: float = ...) -> bool: ...
    def delete(self) -> None: ...

_AlphaMode = Literal["OPAQUE", "MASK", "BLEND"]

class Material:
    name: Optional[str]
    normalTexture: _Attribute[Optional[Texture], _Textured]
    occlusionTexture: _Attribute[Optional[Texture], _Textured]
    emissiveTexture: _Attribute[Optional[Texture], _Textured]
    alphaMode: _AlphaMode
    alphaCutoff: float
    doubleSided: bool
    smooth: bool
    wireframe: bool
    def __init__(self, name: Optional[str] = ..., normalTexture: _Textured = ..., occlusionTexture: _Textured = ...,
                 emissiveTexture: _Textured = ..., emissiveFactor: Optional[_Numbers] = ...,
                 alphaMode: Optional[_AlphaMode] = ..., alphaCutoff: Optional[float] = ..., doubleSided: bool = ...,
                 smooth: bool = ..., wireframe: bool = ...) -> None: ...
    emissiveFactor: _Attribute[_Singles, Optional[_Numbers]]

class MetallicRoughnessMaterial(Material):
    metallicFactor: float
    roughnessFactor: float
    def __init__(self, name: Optional[str] = ..., normalTexture: _Textured = ..., occlusionTexture: _Textured = ...,
                 emissiveTexture: _Textured = ..., emissiveFactor: Optional[_Numbers] = ...,
                 alphaMode: Optional[_AlphaMode] = ..., alphaCutoff: Optional[float] = ..., doubleSided: bool = ...,
                 smooth: bool = ..., wireframe: bool = ..., baseColorFactor: Optional[_Numbers] = ...,
                 baseColorTexture: _Textured = ..., metallicFactor: Optional[float] = ...,
                 roughnessFactor: Optional[float] = ..., metallicRoughnessTexture: _Textured = ...) -> None: ...
    baseColorFactor: _Attribute[_Singles, Optional[_Numbers]]
    baseColorTexture: _Attribute[Optional[Texture], _Textured]
    metallicRoughnessTexture: _Attribute[Optional[Texture], _Textured]
    @property
    def is_transparent(self) -> bool: ...

class Primitive(_Boxed):
    material: Material
    mode: int
    targets: Any
    joints_0: Any
    weights_0: Any
    def __init__(self, positions: _Numbers, normals: Optional[_Numbers] = ..., tangents: Optional[_Numbers] = ...,
                 texcoord_0: Optional[_Numbers] = ..., texcoord_1: Optional[_Numbers] = ...,
                 color_0: Optional[_Numbers] = ..., joints_0: Any = ..., weights_0: Any = ...,
                 indices: Optional[_Numbers] = ..., material: Optional[Material] = ..., mode: Optional[int] = ...,
                 targets: Any = ..., poses: Optional[_Numbers] = ...) -> None: ...
    positions: _Attribute[_Singles, _Numbers]
    normals: _Attribute[Optional[_Singles], Optional[_Numbers]]
    tangents: _Attribute[Optional[_Singles], Optional[_Numbers]]
    texcoord_0: _Attribute[Optional[_Singles], Optional[_Numbers]]
    texcoord_1: _Attribute[Optional[_Singles], Optional[_Numbers]]
    color_0: _Attribute[Optional[_Singles], Optional[_Numbers]]
    indices: _Attribute[Optional[npt.NDArray[np.int64]], Optional[_Numbers]]
    poses: _Attribute[Optional[_Doubles], Optional[_Numbers]]
    @property
    def is_transparent(self) -> bool: ...

class Mesh(_Boxed):
    name: Optional[str]
    primitives: List[Primitive]
    weights: Any
    is_visible: bool
    def __init__(self, primitives: Iterable[Primitive], name: Optional[str] = ..., weights: Any = ...,
                 is_visible: bool = ...) -> None: ...
    @property
    def is_transparent(self) -> bool: ...
    @staticmethod
    def from_points(points: _Numbers, colors: Optional[_Numbers] = ..., normals: Optional[_Numbers] = ...,
                    is_visible: bool = ..., poses: Optional[_Numbers] = ...) -> Mesh: ...
    @staticmethod
    def from_trimesh(mesh: Union[_AnyTrimesh, Iterable[_AnyTrimesh]], material: Optional[Material] = ...,
                     is_visible: bool = ..., poses: Optional[_Numbers] = ..., wireframe: bool = ...,
                     smooth: bool = ...) -> Mesh: ...

class Model(_Boxed):
    warnings: List[str]
    @property
    def vertices(self) -> _Doubles: ...
    @property
    def vertex_normals(self) -> _Doubles: ...
    @property
    def faces(self) -> npt.NDArray[np.int64]: ...
    @property
    def face_normals(self) -> _Doubles: ...
    @property
    def is_empty(self) -> bool: ...
    @property
    def geometry(self) -> Dict[str, Model]: ...
    @property
    def graph(self) -> Any: ...
    def dump(self, concatenate: bool = ...) -> Any: ...
    def copy(self) -> Model: ...
    def apply_transform(self, transform: _Numbers) -> Model: ...
    def apply_translation(self, translation: _Numbers) -> Model: ...
    def apply_scale(self, scaling: _Numbers) -> Model: ...
    def primitives(self, material: Optional[Material] = ..., poses: Optional[_Numbers] = ..., wireframe: bool = ...,
                   smooth: bool = ...) -> List[Primitive]: ...

def load(source: Union[_Path, _Bytes], **values: Any) -> Model: ...

class Node:
    name: Optional[str]
    camera: Optional[Camera]
    mesh: Optional[Mesh]
    light: Optional[Light]
    children: List[Node]
    skin: Any
    weights: Any
    def __init__(self, name: Optional[str] = ..., camera: Optional[Camera] = ..., children: Optional[List[Node]] = ...,
                 skin: Any = ..., matrix: Optional[_Numbers] = ..., mesh: Optional[Mesh] = ...,
                 rotation: Optional[_Numbers] = ..., scale: Optional[_Numbers] = ...,
                 translation: Optional[_Numbers] = ..., weights: Any = ..., light: Optional[Light] = ...) -> None: ...
    matrix: _Attribute[_Doubles, _Numbers]
    rotation: _Attribute[_Doubles, _Numbers]
    scale: _Attribute[_Doubles, _Numbers]
    translation: _Attribute[_Doubles, _Numbers]

_Object = Union[Mesh, Light, Camera]

class Scene(_Boxed):
    name: Optional[str]
    def __init__(self, nodes: Optional[Iterable[Node]] = ..., bg_color: Optional[_Numbers] = ...,
                 ambient_light: Optional[_Numbers] = ..., name: Optional[str] = ...) -> None: ...
    bg_color: _Attribute[_Singles, Optional[_Numbers]]
    ambient_light: _Attribute[_Singles, Optional[_Numbers]]
    main_camera_node: _Attribute[Optional[Node], Node]
    nodes: Set[Node]
    mesh_nodes: Set[Node]
    light_nodes: Set[Node]
    point_light_nodes: Set[Node]
    spot_light_nodes: Set[Node]
    directional_light_nodes: Set[Node]
    camera_nodes: Set[Node]
    meshes: Set[Mesh]
    lights: Set[Light]
    point_lights: Set[Light]
    spot_lights: Set[Light]
    directional_lights: Set[Light]
    cameras: Set[Camera]
    def clear(self) -> None: ...
    def add(self, obj: _Object, name: Optional[str] = ..., pose: Optional[_Numbers] = ...,
            parent_node: Optional[Node] = ..., parent_name: Optional[str] = ...) -> Node: ...
    def add_node(self, node: Node, parent_node: Optional[Node] = ...) -> None: ...
    def remove_node(self, node: Node) -> None: ...
    def has_node(self, node: Node) -> bool: ...
    def get_nodes(self, node: Optional[Node] = ..., name: Optional[str] = ..., obj: Optional[_Object] = ...,
                  obj_name: Optional[str] = ...) -> Set[Node]: ...
    def get_pose(self, node: Node) -> _Doubles: ...
    def set_pose(self, node: Node, pose: _Numbers) -> None: ...
    @staticmethod
    def from_trimesh_scene(trimesh_scene: Union[_TrimeshScene, Model], bg_color: Optional[_Numbers] = ...,
                           ambient_light: Optional[_Numbers] = ...) -> Scene: ...

_Color = npt.NDArray[np.uint8]

class OffscreenRenderer:
    viewport_width: int
    viewport_height: int
    point_size: float
    def __init__(self, viewport_width: int, viewport_height: int, point_size: float = ...) -> None: ...
    def render(self, scene: Scene, flags: int = ..., seg_node_map: Optional[Mapping[Node, Any]] = ...,
               ) -> Tuple[_Color, _Singles]: ...  # with DEPTH_ONLY the depth alone
    def delete(self) -> None: ...
    def __enter__(self) -> OffscreenRenderer: ...
    def __exit__(self, kind: Optional[Type[BaseException]], problem: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None: ...

class Viewer:
    def __init__(self, *arguments: Any, **values: Any) -> None: ...

class Renderer(Viewer): ...
