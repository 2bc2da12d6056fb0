# SPDX-License-Identifier: MIT
"""A tracer of rays for occlusion. Needs the component libshd_embree."""
import ctypes

from . import _api
from ._convert import elements
from ._objects import Object


class Tracer:
    """The tracer of a tree: the `tracer` of an OcclusionDesc."""

    _struct = "shd_tracer"

    def __init__(self, tree):
        self._tree = tree

    def build(self, keep):
        made = _api.struct_type("shd_tracer")()
        _api.check(_api.lib.shd_embree_get_tracer(self._tree.handle("shd_embree", keep, "tracer"),
                                                  ctypes.addressof(made)))
        keep.append(made)
        return made


class Tree(Object):
    """Tree(context, draws): the triangles of draws in a tree of Embree.

        occlusion = shd.occlusion(context, position, normal, tracer=shd.embree.Tree(context, draws).tracer)
    """

    _kind = "shd_embree"

    def __init__(self, context, draws):
        keep = []
        draws = list(draws)
        array = elements("shd_draw", draws, keep, "draws")
        self._adopt(keep, _api.lib.shd_embree_create, context.handle("shd_context", keep),
                    ctypes.addressof(array) if draws else None, len(draws))

    @property
    def tracer(self):
        return Tracer(self)
