// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: tool, the program shd-render. Its manual page is made of its options.
///
/// Input:      the command line; a model file or the name of a shape.
/// Output:     pictures.
/// Invariants: uses shd only through its public headers and core/regular_file.h. An error is a Failure with a sentence
///             for the user and an exit code.
///
/// | file        | contents                                                |
/// |-------------|---------------------------------------------------------|
/// | main.cpp    | from options to pictures                                |
/// | options.h   | the command line, checked                               |
/// | option_groups.h | the options, group by group                         |
/// | model.h     | the scene of a file, or a shape, and the floor          |
/// | volumes.h   | the volume of a file                                    |
/// | shapes.h    | meshes of shd/shapes.h                                  |
/// | materials.h | materials, changed by the options                       |
/// | solids.h    | built-in solid textures                                 |
/// | uv.h        | coordinates of textures from positions                  |
/// | draws.h     | all materials, and the draws of a picture               |
/// | textures.h  | built-in textures and files; normal_maps.cpp            |
/// | camera.h    | the camera of a file, or one that shows the whole model |
/// | lights.h    | presets, options and the lights of a file               |
/// | environment.h | light and background from an image                    |
/// | shadows.h   | shadow maps                                             |
/// | tables.h    | tables of textures and shadow maps as pictures          |
/// | occlusion.h | ambient occlusion at vertices                           |
/// | samples.h   | the draws that the samples of pixels show               |
/// | cryptomatte.h | mattes of objects and materials                       |
/// | output.h    | file names and saving                                   |
/// | stage.h     | objects that the pictures of a setting share, and frames |
/// | reports.h   | messages about parts of a model that are not used       |
/// | show.h      | pictures of `--show`: show_planes.cpp and others        |
/// | zoom.h      | pixels enlarged, with their samples                     |
/// | compare.h   | differences of pictures                                 |
/// | settings.h  | the settings of `--compare`, cut into options           |
/// | picture.h   | pictures in memory                                      |
/// | check/      | another program, shd-check: check.h                     |
/// | progress.h  | progress and the time left                              |
/// | handles.h   | handles that release themselves                         |
#pragma once
