// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: scene, model files (libshd_scene).
///
/// Input:      a path and checked limits. Model files are untrusted.
/// Output:     read/ gives a Model, plain data; make_objects() turns it into handles of libshd.
/// Invariants: what follows a reader does not know the format. Only the files named assimp_* include headers of assimp.
///             libshd and libshd_io are used only through their public functions. A problem with the whole file is a
///             Failure. A problem with a part of it, such as a missing texture, is a warning, and the part is left out.
///             Nothing is printed.
///
/// | file         | contents                                              |
/// |--------------|-------------------------------------------------------|
/// | model.h      | contents of a file, as plain data                     |
/// | limits.h     | budgets, and the deadline of a load                   |
/// | read/read.h  | a file to a Model                                     |
/// | reading.h    | a file to a Model, by the worker or in this process   |
/// | host_files.h | the files around a model, by the rules of the host    |
/// | disk_files.h | files on disk, found by names of any system           |
/// | callback_files.h | files that a callback of the host answers         |
/// | columns.h    | rows of all columns of a geometry                     |
/// | sample.h     | values of an animation at given seconds               |
/// | pose.h       | the tree of a Model as matrices of a pose             |
/// | normals.h    | flat and missing normals                              |
/// | project.h    | coordinates from positions                            |
/// | deform.h     | vertices moved by morph targets and skins             |
/// | bounds.h     | the box around all instances, and the scene's origin  |
/// | textures.h   | textures of a Model as handles                        |
/// | specular_glossiness.h | surfaces and maps of that kind, converted    |
/// | materials.h  | surfaces of a Model as materials                      |
/// | stage.h      | lights and cameras of a pose                          |
/// | objects.h    | a Model as handles, descs and draws of a pose         |
/// | owned.h      | handles that release themselves                       |
/// | text.h       | texts of files, made safe for messages                |
#pragma once
