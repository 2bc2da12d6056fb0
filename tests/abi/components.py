# SPDX-License-Identifier: MIT
"""The libraries of shd and their public headers."""

# Every header that is in no row belongs to libshd.
OWN_HEADERS = {"shd_color": ["color"], "shd_embree": ["embree"],
               "shd_io": ["io", "texture_file", "tile_file", "volume_file", "worker"], "shd_scene": ["scene"]}
LIBRARIES = ["shd", *OWN_HEADERS]


def headers_of(include, library):
    """Names of the headers of a library in include/shd, without their suffix."""
    if library in OWN_HEADERS:
        return OWN_HEADERS[library]
    others = {h for headers in OWN_HEADERS.values() for h in headers}
    return sorted({p.stem for p in (include / "shd").glob("*.h")} - others)
