/* SPDX-License-Identifier: MIT */
/* Loads every file below the given folders twice in the default setting, in this one process, and counts the results.
 * Usage: load_folder [--time SECONDS] FOLDER... Two loads of a file must have equal results and equal pixels. The exit
 * code is 1 if they differ or if no file was found; a crash of this process is a failure, too. For corpora that are not
 * part of the tree, for example the regression files of OpenImageIO and libtiff. */
#define _XOPEN_SOURCE 700
#include <ftw.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <shd/io.h>

struct counts {
  long tried, loaded, refused, different, died, late;
};

static struct counts g_counts;
static shd_context* g_context;
static shd_load_desc g_desc;

/* FNV-1a (Fowler, Noll, Vo, "The FNV Non-Cryptographic Hash Algorithm"). */
static uint64_t hash_bytes(uint64_t hash, const void* bytes, size_t size) {
  const unsigned char* at = (const unsigned char*)bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ at[i]) * UINT64_C(1099511628211);
  return hash;
}

static shd_result load(const char* path, uint64_t* hash) {
  shd_image image = shd_image_default();
  shd_bitmap* bitmap = NULL;
  shd_result result = shd_bitmap_load(g_context, path, &g_desc, &bitmap);
  *hash = 0;
  if (result != SHD_OK) return result;
  result = shd_bitmap_get_image(bitmap, &image);
  if (result == SHD_OK) {
    const char* space = shd_bitmap_get_color_space(bitmap);
    *hash = hash_bytes(UINT64_C(14695981039346656037), space, strlen(space));
    *hash = hash_bytes(*hash, &image.width, sizeof image.width);
    *hash = hash_bytes(*hash, &image.height, sizeof image.height);
    *hash = hash_bytes(*hash, image.pixels, image.row_stride * image.height);
  }
  shd_bitmap_release(bitmap);
  return result;
}

static int visit(const char* path, const struct stat* status, int kind, struct FTW* place) {
  shd_result results[2];
  uint64_t hashes[2];
  int i;
  (void)place;
  if (kind != FTW_F || !S_ISREG(status->st_mode)) return 0;
  for (i = 0; i < 2; ++i) results[i] = load(path, &hashes[i]);
  ++g_counts.tried;
  g_counts.loaded += results[1] == SHD_OK;
  g_counts.refused += results[1] != SHD_OK;
  if (results[1] != SHD_OK && strstr(shd_last_error(), "the decoder died")) {
    ++g_counts.died;
    printf("%s\n", shd_last_error());
  }
  if (results[1] != SHD_OK && strstr(shd_last_error(), "time_limit")) {
    ++g_counts.late;
    printf("%s\n", shd_last_error());
  }
  if (results[0] != results[1] || hashes[0] != hashes[1]) {
    ++g_counts.different;
    printf("%s: results %d and %d, hashes %016" PRIx64 " and %016" PRIx64 "\n", path, (int)results[0], (int)results[1],
           hashes[0], hashes[1]);
  }
  return 0;
}

int main(int count, char** arguments) {
  int i = 1;
  g_desc = shd_load_desc_default();
  g_desc.time_limit = 20;
  if (count > 2 && strcmp(arguments[1], "--time") == 0) {
    g_desc.time_limit = strtod(arguments[2], NULL);
    i = 3;
  }
  if (i >= count) {
    fprintf(stderr, "usage: load_folder [--time SECONDS] FOLDER...\n");
    return 2;
  }
  if (shd_context_create(NULL, &g_context) != SHD_OK) return 2;
  for (; i < count; ++i) {
    if (nftw(arguments[i], visit, 32, FTW_PHYS) != 0) perror(arguments[i]);
  }
  printf("%ld files: %ld loaded, %ld refused (%ld decoders died, %ld were late), %ld different\n", g_counts.tried,
         g_counts.loaded, g_counts.refused, g_counts.died, g_counts.late, g_counts.different);
  shd_context_release(g_context);
  return g_counts.tried == 0 || g_counts.different > 0;
}
