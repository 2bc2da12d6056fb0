// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: embree, (draws -> answers of rays), the only user of Embree.
///
/// Input:      checked meshes and matrices; batches of rays.
/// Output:     whether each ray is blocked.
/// Units:      world space and world lengths.
/// Invariants: uses only the public functions of libshd. Throws Failure if Embree fails.
///
/// | file     | contents                                            |
/// |----------|-----------------------------------------------------|
/// | tree.h   | Tree: triangles in an Embree scene, and its queries |
#pragma once
