// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: scene, model files (libshd_scene).
///
/// Input:      a path and checked limits. Model files are untrusted.
/// Output:     an import gives a Model, plain data; make_objects() turns it into handles of libshd.
/// Invariants: only the files named assimp_* include headers of assimp. libshd and libshd_io are used only through
///             their public functions. A problem with the whole file is a Failure. A problem with a part of it, such as
///             a missing texture, is a warning, and the part is left out. Nothing is printed.
///
/// | file                | contents                                                |
/// |---------------------|---------------------------------------------------------|
/// | model.h             | contents of a file, as plain data                       |
/// | limits.h            | budgets, and the deadline of an import                  |
/// | import.h            | a file to a Model; assimp_import.cpp: meshes and nodes  |
/// | assimp_sanitize.cpp | faces and nodes that assimp's own steps can work on     |
/// | assimp_surface.cpp  | materials and the textures that they name               |
/// | assimp_light.cpp    | lights and cameras                                      |
/// | assimp_files.cpp    | the files that assimp may open, counted                 |
/// | assimp_parts.h      | declarations that the assimp_*.cpp files share          |
/// | find_file.h         | finds files by names that come from other machines      |
/// | bounds.h            | the box around all instances                            |
/// | textures.h          | textures of a Model as handles                          |
/// | objects.h           | a Model as handles, descs and draws                     |
/// | owned.h             | handles that release themselves                         |
#pragma once
