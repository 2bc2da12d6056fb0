// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: io, files in and out.
///
/// Input:      untrusted bytes; rows of pixels to store.
/// Output:     Bitmap, rows from the top in one of libshd's formats: RGBA, or one channel of volumes; whole files.
/// Invariants: only abi/ calls libshd, so that the worker process does not need it; failures are thrown by
///             core::refuse(); sizes are checked against the Limits before memory is allocated; a build has one of the
///             rooms oiio/ and small/, and one for WebAssembly has neither worker/ nor server/; decoders are given
///             memory, and open files only by oiio/tiles.cpp, whose files are trusted; files are opened by
///             core/regular_file.h and file/write_file.cpp alone; only the worker sets the process-wide attributes of
///             OpenImageIO; what a child of the worker sends is untrusted.
///
/// Rooms, each of which includes its own files and those of the rooms before it:
/// file bitmap check container codec oiio small vdb worker load server maketx abi
///
/// | file                        | contents                                                             |
/// |-----------------------------|----------------------------------------------------------------------|
/// | file/printable.h            | texts of files and of the system, made safe for messages             |
/// | file/memory.h               | Buffer, memory of the host's allocator                               |
/// | file/byte_reader.h          | numbers at checked places of untrusted bytes                         |
/// | file/limits.h               | budgets: checked sizes, deadline                                     |
/// | file/file_descriptor.h      | descriptors with an owner; failures of the system                    |
/// | file/memory_file.h          | an anonymous file for decoders that need a path                      |
/// | file/read_file.h            | a regular file as bytes                                              |
/// | file/write_file.h           | atomic writing of a file                                             |
/// | file/numbered_path.h        | paths of a numbered series of files                                  |
/// | file/udim.h                 | the files of a UDIM set                                              |
/// | file/module.h               | opening of modules                                                   |
/// | file/worker_path.h          | where the program shd-io-worker is                                   |
/// | bitmap/bitmap.h             | a decoded file, the options of a load, and the receiver of pixels   |
/// | bitmap/levels.h             | sizes of mip levels                                                  |
/// | bitmap/channels.h           | selection of the channels r, g, b, a, and expansion to RGBA          |
/// | bitmap/transfer.h           | colour-space names and transfer curves                               |
/// | bitmap/raw_voxels.h         | numbers of a file of voxels in this machine's byte order             |
/// | check/sniff.h               | format and declared size from the first bytes                        |
/// | check/<format>_header.h     | checks of the headers of OpenEXR, BMP, HDR, JPEG and TGA             |
/// | check/tiff_pages.h          | the chain of pages of a TIFF                                         |
/// | check/scrub.h               | removal of metadata that decoders would parse                        |
/// | container/texture_file.h    | KTX2 and DDS files as textures: formats, parsing, unpacking          |
/// | container/texture_load.h    | such a file as a bitmap, and the checks of one that a worker sends   |
/// | container/texture_tiles.h   | such a file that stays open, and the texels of its tiles             |
/// | container/ktx2.h            | parts of a KTX2 file (ktx2*.cpp); dds_file.cpp parses DDS            |
/// | container/ktx2_write.h      | a KTX2 file from texels                                              |
/// | container/inflate.h         | Zstandard and zlib                                                   |
/// | container/astc.h            | ASTC blocks, the only user of libastcenc                             |
/// | codec/codec.h               | decode and encode: by OpenImageIO in oiio/, otherwise in small/      |
/// | codec/tiles.h               | tiles of files that stay open, by OpenImageIO                        |
/// | oiio/handle.h               | an input or output that prints nothing                               |
/// | oiio/silence.h              | no messages of libtiff on stderr                                     |
/// | oiio/module.h               | all of it in a module that a shared libshd_io opens at the first use |
/// | small/rows.h                | rows of PNG, JPEG (libpng, libjpeg) and Radiance HDR, files of them  |
/// | vdb/vdb.h                   | decode_grid; vdb.cpp is the only user of OpenVDB                     |
/// | vdb/header.h                | the grids of an OpenVDB file                                         |
/// | vdb/module.h                | decode_grid in a module                                              |
/// | worker/protocol.h           | messages between this process and its worker                         |
/// | worker/packet.h             | sending and receiving with deadlines                                 |
/// | worker/child_process.h      | starting and ending a program                                        |
/// | worker/link.h               | the worker of this process: started, connected, replaced             |
/// | worker/call.h               | one job of the worker; run.h: one job of a module                    |
/// | load/load.h                 | the pipeline: sniff, scrub, check, decode                            |
/// | load/isolate.h              | the pipeline in a child of the worker, or in this process            |
/// | server/job.h                | the worker: the server (serve.cpp) and its children                  |
/// | server/module.h             | a child that runs a module                                           |
/// | server/memory.h             | memory of these children                                             |
/// | server/confine.h            | limits of these children by the system                               |
/// | maketx/                     | the program shd-maketx, which has parts of libshd and of these rooms |
/// | abi/                        | the bodies of the public functions                                   |
#pragma once
