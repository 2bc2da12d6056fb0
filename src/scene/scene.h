// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: scene, model files (libshd_scene).
///
/// Input:      a path and checked limits. Model files are untrusted.
/// Output:     an import gives a Model, plain data; make_objects() turns it into handles of libshd.
/// Invariants: only the files named assimp_* know assimp. libshd and libshd_io are reached through their public
///             functions only. What is wrong with a whole file is a Failure; what is wrong with a part of it, such as a
///             texture that is missing, is a warning and the part is left out.
///
/// | file                | what                                                    |
/// |---------------------|---------------------------------------------------------|
/// | model.h             | what a file holds, as plain data                        |
/// | limits.h            | budgets, and the moment by which an import must be done |
/// | import.h            | a file to a Model; assimp_import.cpp: meshes and nodes  |
/// | assimp_sanitize.cpp | faces and nodes that assimp's own steps can work on     |
/// | assimp_surface.cpp  | materials and the textures that they name               |
/// | assimp_light.cpp    | lights and cameras                                      |
/// | assimp_files.cpp    | the files that assimp may open, counted                 |
/// | assimp_parts.h      | what the assimp_*.cpp files share                       |
/// | find_file.h         | the file that a model written on another machine means  |
/// | bounds.h            | the box around all instances                            |
/// | textures.h          | textures of a Model as handles                          |
/// | objects.h           | a Model as handles, descs and draws                     |
/// | owned.h             | handles that release themselves                         |
#pragma once
