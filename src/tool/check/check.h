// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: check, the program shd-check, which judges texture lookups of any implementation.
///
/// Input:      the command line; a texture; a table of lookups with their results.
/// Output:     the refused rows and their bounds, the diagnosis, a report; the exit code has the verdict.
/// Invariants: uses shd only through its public headers, with image/srgb.h and image/half.h. An error is a Failure with
///             a sentence for the user and an exit code. A hypothesis changes a copy of the Case and nothing else.
///
/// | file            | contents                                                              |
/// |-----------------|-----------------------------------------------------------------------|
/// | main.cpp        | from options to the verdict                                           |
/// | options.h       | the command line                                                      |
/// | npy.h           | .npy arrays                                                           |
/// | picture.h       | texels from files, and their formats                                  |
/// | table.h         | tables of lookups                                                     |
/// | case.h          | lookups, results, and all that decides which results are legal        |
/// | columns.h       | changes of the columns of a case                                      |
/// | textures.h      | the texture with each decoding                                        |
/// | bounds.h        | legal values of each row                                              |
/// | levels.h        | bounds of lookups that are shifted on each level                      |
/// | hypotheses.h    | other implementations, and other meanings of columns                  |
/// | diagnose.h      | the hypotheses that explain most refused rows                         |
/// | report.h        | texts of a verdict; report_file.cpp: CSV and JSON                     |
/// | module.mjs      | the program in WebAssembly, for pages and Node                        |
#pragma once
