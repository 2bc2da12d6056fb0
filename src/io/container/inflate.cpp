// SPDX-License-Identifier: MIT
#include "io/container/inflate.h"

#ifdef SHD_WITH_ZLIB
#include <zlib.h>
#endif
#ifdef SHD_WITH_ZSTD
#include <zstd.h>
#include <zstd_errors.h>
#endif

#include <algorithm>
#include <new>

#include "core/failure.h"

namespace shd::io {

namespace {

using Bytes = std::vector<unsigned char>;

[[noreturn, maybe_unused]] void refuse_absent(const char* library, const char* package) {
  core::refuse(SHD_ERROR_UNSUPPORTED, "KTX2: this libshd_io was built without %s (Debian: %s)", library, package);
}

#ifdef SHD_WITH_ZSTD

/// Throws for an error of the library.
size_t require_zstd(size_t result) {
  if (!ZSTD_isError(result)) return result;
  if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  core::refuse(SHD_ERROR_CORRUPT, "KTX2: Zstandard: %s", ZSTD_getErrorName(result));
}

void inflate_zstd(const unsigned char* in, size_t in_size, unsigned char* out, size_t out_size) {
  const size_t got = require_zstd(ZSTD_decompress(out, out_size, in, in_size));
  if (got != out_size) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: a level has %zu bytes after Zstandard, not %zu", got, out_size);
  }
}

Bytes deflate_zstd(int32_t effort, const Bytes& in) {
  Bytes out(ZSTD_compressBound(in.size()));
  const int level = effort == 0 ? ZSTD_defaultCLevel() : effort;
  out.resize(require_zstd(ZSTD_compress(out.data(), out.size(), in.data(), in.size(), level)));
  return out;
}

#else

void inflate_zstd(const unsigned char*, size_t, unsigned char*, size_t) {
  refuse_absent("Zstandard", "libzstd-dev");
}

Bytes deflate_zstd(int32_t, const Bytes&) {
  refuse_absent("Zstandard", "libzstd-dev");
}

#endif

#ifdef SHD_WITH_ZLIB

constexpr size_t kPiece = size_t{1} << 30;  // zlib counts in 32 bits

/// Moves a stream through one of zlib's functions. Returns its last result; *in_size and *out_size become what is left.
template <class Step>
int run_zlib(z_stream* stream, Step&& step, const unsigned char* in, size_t* in_size, unsigned char* out,
             size_t* out_size) {
  stream->next_in = const_cast<unsigned char*>(in);
  stream->next_out = out;
  int result = Z_OK;
  while (result == Z_OK) {
    const size_t in_piece = std::min(*in_size, kPiece), out_piece = std::min(*out_size, kPiece);
    stream->avail_in = static_cast<uInt>(in_piece);
    stream->avail_out = static_cast<uInt>(out_piece);
    result = step(in_piece == *in_size ? Z_FINISH : Z_NO_FLUSH);
    const size_t taken = in_piece - stream->avail_in, made = out_piece - stream->avail_out;
    *in_size -= taken;
    *out_size -= made;
    // Z_BUF_ERROR: Z_FINISH with more to come, or no progress.
    if (result == Z_BUF_ERROR && taken + made != 0) result = Z_OK;
  }
  return result;
}

void inflate_zlib(const unsigned char* in, size_t in_size, unsigned char* out, size_t out_size) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  size_t out_left = out_size;
  const int result = run_zlib(
      &stream, [&](int flush) { return inflate(&stream, flush); }, in, &in_size, out, &out_left);
  inflateEnd(&stream);
  if (result == Z_MEM_ERROR) throw std::bad_alloc();
  if (result == Z_STREAM_END && out_left == 0) return;
  if (result == Z_STREAM_END || out_left == 0) {
    core::refuse(SHD_ERROR_CORRUPT, "KTX2: a level does not have %zu bytes after zlib", out_size);
  }
  core::refuse(SHD_ERROR_CORRUPT, "KTX2: zlib: %s", result == Z_BUF_ERROR ? "the stream is cut off" : "damaged data");
}

Bytes deflate_zlib(int32_t effort, const Bytes& in) {
  Bytes out(compressBound(static_cast<uLong>(in.size())));
  z_stream stream = {};
  if (deflateInit(&stream, effort == 0 ? Z_DEFAULT_COMPRESSION : effort) != Z_OK) throw std::bad_alloc();
  size_t in_left = in.size(), left = out.size();
  const int result = run_zlib(
      &stream, [&](int flush) { return deflate(&stream, flush); }, in.data(), &in_left, out.data(), &left);
  deflateEnd(&stream);
  if (result != Z_STREAM_END) core::refuse(SHD_ERROR_INTERNAL, "zlib: deflate returned %d", result);
  out.resize(out.size() - left);
  return out;
}

#else

void inflate_zlib(const unsigned char*, size_t, unsigned char*, size_t) {
  refuse_absent("zlib", "zlib1g-dev");
}

Bytes deflate_zlib(int32_t, const Bytes&) {
  refuse_absent("zlib", "zlib1g-dev");
}

#endif

}  // namespace

void inflate_level(shd_supercompression scheme, const unsigned char* in, size_t in_size, unsigned char* out,
                   size_t out_size) {
  if (scheme == SHD_SUPERCOMPRESSION_ZSTD) {
    inflate_zstd(in, in_size, out, out_size);
  } else {
    inflate_zlib(in, in_size, out, out_size);
  }
}

int32_t most_effort(shd_supercompression scheme) {
#ifdef SHD_WITH_ZSTD
  if (scheme == SHD_SUPERCOMPRESSION_ZSTD) return 19;
#endif
#ifdef SHD_WITH_ZLIB
  if (scheme == SHD_SUPERCOMPRESSION_ZLIB) return 9;
#endif
  (void)scheme;
  return 0;
}

Bytes deflate_level(shd_supercompression scheme, int32_t effort, const Bytes& in) {
  return scheme == SHD_SUPERCOMPRESSION_ZSTD ? deflate_zstd(effort, in) : deflate_zlib(effort, in);
}

}  // namespace shd::io
