// SPDX-License-Identifier: MIT
// shd-maketx: any image to a tiled file with all mip levels.
#include <OpenImageIO/imageio.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include <shd/base.h>

#include "command/failure.h"
#include "io/maketx/convert.h"
#include "io/maketx/decoder.h"
#include "io/oiio/silence.h"

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], kDecoderArgument) == 0) return run_decoder();
  try {
    const Options options = read_options(argc, argv);
    if (options.help) {
      std::fputs(kHelp, stdout);
      return kExitOk;
    }
    if (options.version) {
      std::printf("shd-maketx %d.%d.%d\n", SHD_VERSION_MAJOR, SHD_VERSION_MINOR, SHD_VERSION_PATCH);
      return kExitOk;
    }
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of write()
    shd::io::silence_libtiff(reinterpret_cast<const void*>(OIIO::openimageio_version));
    OIIO::attribute("threads", options.threads);
    OIIO::attribute("exr_threads", options.threads);
    OIIO::attribute("limits:imagesize_MB", 0);
    convert(options);
    return kExitOk;
  } catch (const Failure& failure) {
    std::fprintf(stderr, "shd-maketx: %s\n", failure.what());
    return failure.code;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "shd-maketx: out of memory\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shd-maketx: %s\n", error.what());
  }
  return kExitFailed;
}
