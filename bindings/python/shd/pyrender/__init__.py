# SPDX-License-Identifier: MIT
"""The interface of pyrender for offscreen pictures, so that its programs run without OpenGL.

    import shd.pyrender as pyrender

Classes, arguments and attributes have pyrender's names and checks. Lights have its units: a SpotLight or PointLight of
intensity I gives the irradiance I / r^2. Integers of colours are 0..255, and colours of vertices are linear, as in
pyrender; with the flag FLAT they are shown as they are. The README of the package lists the six points in which
pictures differ. There is no Viewer. load() reads model files by libshd_scene.
"""
from .camera import Camera, IntrinsicsCamera, OrthographicCamera, PerspectiveCamera
from .constants import GLTF, RenderFlags, TextAlign
from .light import DirectionalLight, Light, PointLight, SpotLight
from .material import Material, MetallicRoughnessMaterial
from .mesh import Mesh, Primitive
from .model import Model, load
from .node import Node
from .offscreen import OffscreenRenderer
from .scene import Scene
from .texture import Sampler, Texture
from .viewer import Renderer, Viewer

__version__ = "0.1.45"  # of pyrender, whose interface this is

__all__ = ["Camera", "DirectionalLight", "GLTF", "IntrinsicsCamera", "Light", "Material", "Mesh",
           "MetallicRoughnessMaterial", "Model", "Node", "OffscreenRenderer", "OrthographicCamera",
           "PerspectiveCamera", "PointLight", "Primitive", "RenderFlags", "Renderer", "Sampler", "Scene", "SpotLight",
           "TextAlign", "Texture", "Viewer", "__version__", "load"]
