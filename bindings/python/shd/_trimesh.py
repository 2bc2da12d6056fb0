# SPDX-License-Identifier: MIT
"""What meshes of trimesh and their materials have, by the names of their attributes, for shd.Renderer and shd.pyrender."""
import numpy as np

ARGUMENTS = ("normalTexture", "occlusionTexture", "emissiveTexture", "emissiveFactor", "baseColorFactor",
             "baseColorTexture", "metallicFactor", "roughnessFactor", "metallicRoughnessTexture", "doubleSided",
             "alphaMode", "alphaCutoff")


def is_simple(material):
    """Whether a material is a SimpleMaterial, of an OBJ file, and not a PBRMaterial."""
    return not hasattr(material, "baseColorTexture")


def material_values(material):
    """A material as arguments of glTF's metallic-roughness. Those that it lacks are None."""
    if not is_simple(material):
        return {name: getattr(material, name, None) for name in ARGUMENTS}
    diffuse = getattr(material, "diffuse", None)
    return {**dict.fromkeys(ARGUMENTS), "baseColorTexture": getattr(material, "image", None),
            "baseColorFactor": getattr(material, "main_color", None) if diffuse is None else diffuse,
            "roughnessFactor": roughness_of(material)}


def roughness_of(material):
    """The roughness of a SimpleMaterial, whose exponent is 1 by default."""
    exponent = (getattr(material, "kwargs", None) or {}).get("Ns", getattr(material, "glossiness", None))
    exponent = 1.0 if exponent is None else max(float(np.ravel(exponent)[0]), 0.0)
    # GGX of alpha^2 = 2 / (p + 2) is as wide as Blinn's lobe (Walter et al., "Microfacet Models for Refraction", 2007).
    return (2 / (exponent + 2)) ** 0.25


def surface_of(item):
    """The kind of a mesh's visual, "texture", "vertex", "face" or None, its columns uv or color, and its material."""
    visual = getattr(item, "visual", None)
    if visual is None or getattr(visual, "defined", True) is False:
        return None, {}, None
    kind = getattr(visual, "kind", None)
    if kind is None:
        kind = "texture" if getattr(visual, "material", None) is not None else "vertex"
    if kind == "texture":
        uv = getattr(visual, "uv", None)
        return kind, {} if uv is None or not len(uv) else {"uv": np.asarray(uv)[:, :2]}, visual.material
    colors = getattr(visual, f"{kind}_colors", None)
    return (None, {}, None) if colors is None else (kind, {"color": np.asarray(colors)}, None)


def unshared(columns, faces, kind):
    """Columns of triangles that share no vertices, so that each has its own normal or colour. Colours of faces have a
    row for each triangle, other columns one for each vertex. A column may be None."""
    return {name: np.repeat(column, 3, axis=0) if name == "color" and kind == "face" else
            np.asarray(column)[faces.reshape(-1)] for name, column in columns.items() if column is not None}
