// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: io/maketx, the program shd-maketx. Its manual page is made of its options.
///
/// Input:      the command line; an image file, of any size, that OpenImageIO reads. The file is untrusted.
/// Output:     a tiled TIFF or OpenEXR file with all mip levels.
/// Invariants: an error is a Failure with a sentence for the user and an exit code; an output appears whole or not at
///             all; an interrupted run continues from the folder OUTPUT.part, with the same bits in the end; rows in
///             memory are bounded by --memory, and wide filters refuse larger images; only the decoder, a confined
///             process, reads the bytes of the input.
///             Levels are those of libshd, because texture/table/mip_stream.h adds in the order of its builders.
///
/// | file        | contents                                             |
/// |-------------|------------------------------------------------------|
/// | main.cpp    | from options to the file                             |
/// | options.h   | the command line, checked                            |
/// | source.h    | the input: its description, and its rows in bands    |
/// | decoder.h   | the process that decodes the input                   |
/// | color.h     | conversion between colour spaces                     |
/// | probe.h     | an angular probe as latitude and longitude           |
/// | whole.h     | context, format and memory of a whole image          |
/// | stats.h     | hash and mean of level 0                             |
/// | jobs.h      | inputs and outputs of several files                  |
/// | pyramid.h   | levels of rows, for every format                     |
/// | part.h      | the folder of an unfinished run                      |
/// | target.h    | the tiled file                                       |
/// | convert.h   | bands through the pyramid and into the file          |
/// | bar.h       | progress and the time left                           |
#pragma once
