// SPDX-License-Identifier: MIT
// shd-maketx: any image to a tiled file with all mip levels.
#include <OpenImageIO/imageio.h>

#include <csignal>
#include <cstring>

#include "command/program.h"
#include "io/maketx/convert.h"
#include "io/maketx/decoder.h"
#include "io/oiio/silence.h"

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], kDecoderArgument) == 0) return run_decoder();
  return command::run("shd-maketx", [&]() -> int {
    Options options;
    if (!read_options(argc, argv, options)) return kExitOk;
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of write()
    shd::io::silence_libtiff(reinterpret_cast<const void*>(OIIO::openimageio_version));
    OIIO::attribute("threads", options.threads);
    OIIO::attribute("exr_threads", options.threads);
    OIIO::attribute("limits:imagesize_MB", 0);
    return convert_all(options);
  });
}
