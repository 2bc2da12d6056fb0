/* SPDX-License-Identifier: MIT */
/* Paths of everything that is no readable regular file, in the folder of io_files.h. A load of each must be an error,
 * and must not wait for a writer or read an endless device. */
#ifndef SHD_TESTS_SUPPORT_ODD_PATHS_H
#define SHD_TESTS_SUPPORT_ODD_PATHS_H

#include "support/io_files.h"

/** A path, and the answer to a load of it. */
typedef struct odd_path {
    const char *name; /**< in the folder */
    const char *kind; /**< "link": to `target`; else the kind of file */
    const char *target;
    shd_result expected;
    const char *message;
} odd_path;

/* All end with 0, so that a numbered path can name them. */
static const odd_path k_odd_paths[] = {
    {"fifo0", "fifo", NULL, SHD_ERROR_IO, "is not a regular file"},
    {"socket0", "socket", NULL, SHD_ERROR_IO, "is not a regular file"},
    {"folder0", "folder", NULL, SHD_ERROR_IO, "is not a regular file"},
    {"to_fifo0", "link", "fifo0", SHD_ERROR_IO, "is not a regular file"},
    {"to_socket0", "link", "socket0", SHD_ERROR_IO, "is not a regular file"},
    {"to_folder0", "link", "folder0", SHD_ERROR_IO, "is not a regular file"},
    {"to_zero0", "link", "/dev/zero", SHD_ERROR_IO, "is not a regular file"},
    {"to_null0", "link", "/dev/null", SHD_ERROR_IO, "is not a regular file"},
    {"to_nothing0", "link", "nothing", SHD_ERROR_NOT_FOUND, ""},
    {"to_itself0", "link", "to_itself0", SHD_ERROR_IO, ""},
    {"missing0", "nothing", NULL, SHD_ERROR_NOT_FOUND, ""},
    {"forbidden0", "forbidden", NULL, SHD_ERROR_IO, "Permission denied"},
};
enum { ODD_PATHS = sizeof k_odd_paths / sizeof k_odd_paths[0] };

/** Makes what the paths name. */
static inline void make_odd_paths(void)
{
    size_t i;
    for (i = 0; i < ODD_PATHS; ++i) {
        const odd_path *p = &k_odd_paths[i];
        const char *path = io_path(p->name);
        if (strcmp(p->kind, "fifo") == 0) assert_int_equal(mkfifo(path, 0600), 0);
        if (strcmp(p->kind, "socket") == 0) assert_int_equal(mknod(path, S_IFSOCK | 0600, 0), 0);
        if (strcmp(p->kind, "folder") == 0) assert_int_equal(mkdir(path, 0700), 0);
        if (strcmp(p->kind, "link") == 0) assert_int_equal(symlink(p->target, path), 0);
        if (strcmp(p->kind, "forbidden") == 0) {
            io_write(path, "x", 1);
            assert_int_equal(chmod(path, 0), 0);
        }
    }
}

/** Whether the system has this case: root may read everything. */
static inline int has_odd_path(const odd_path *p) { return strcmp(p->kind, "forbidden") != 0 || geteuid() != 0; }

#endif /* SHD_TESTS_SUPPORT_ODD_PATHS_H */
