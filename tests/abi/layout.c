/* SPDX-License-Identifier: MIT */
/* Size of every public struct and place of every member on LP64. Padding is listed, so that none comes unseen. No sized
 * struct ends with padding: there a field could be appended that older callers leave undefined. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <shd/shd.h>
#include <shd/texture_file.h>
#include <shd/tile_file.h>
#include <shd/volume_file.h>
#include <shd/worker.h>
#ifdef SHD_TEST_COLOR
#include <shd/color.h>
#endif
#ifdef SHD_TEST_IO
#include <shd/io.h>
#endif
#ifdef SHD_TEST_SCENE
#include <shd/scene.h>
#endif

#if defined(__LP64__) || defined(_LP64)

#define SHD_STRUCT(type, size) _Static_assert(sizeof(type) == (size), #type " has another size");
#define SHD_FIELD(type, field, offset, size)                                      \
    _Static_assert(offsetof(type, field) == (offset), #type "." #field " moved"); \
    _Static_assert(sizeof(((type *)0)->field) == (size), #type "." #field " has another size");
#define SHD_PADDING(type, offset, size)
#include "layouts.inc"
#undef SHD_STRUCT
#undef SHD_FIELD
#undef SHD_PADDING

/** A struct (field is ""), one of its members, or padding (field is "padding"). */
struct row {
    const char *type;
    const char *field;
    size_t offset, size;
};

#define SHD_STRUCT(type, size) {#type, "", 0, size},
#define SHD_FIELD(type, field, offset, size) {#type, #field, offset, size},
#define SHD_PADDING(type, offset, size) {#type, "padding", offset, size},
static const struct row k_rows[] = {
#include "layouts.inc"
};

int main(void)
{
    const size_t count = sizeof k_rows / sizeof k_rows[0];
    size_t structs = 0, holes = 0, i = 0;
    while (i < count) {
        const struct row *owner = &k_rows[i++];
        const int is_sized = strcmp(k_rows[i].field, "struct_size") == 0;
        size_t end = 0;
        for (; i < count && k_rows[i].field[0]; ++i) {
            if (k_rows[i].offset != end || strcmp(k_rows[i].type, owner->type)) {
                printf("%s: hole or stray member before %s at %zu\n", owner->type, k_rows[i].field, end);
                ++holes;
            }
            end = k_rows[i].offset + k_rows[i].size;
        }
        if (end != owner->size) {
            printf("%s: members end at %zu, size is %zu\n", owner->type, end, owner->size);
            ++holes;
        }
        if (is_sized && strcmp(k_rows[i - 1].field, "padding") == 0) {
            printf("%s: ends with padding\n", owner->type);
            ++holes;
        }
        ++structs;
    }
    printf("%zu structs, %zu members, %zu holes\n", structs, count - structs, holes);
    return holes != 0;
}

#else

int main(void)
{
    puts("layouts are stated for LP64 only");
    return 77;
}

#endif
