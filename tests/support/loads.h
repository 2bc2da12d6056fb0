/* SPDX-License-Identifier: MIT */
/* Loads of textures by one desc each: the arguments become fields of the load desc. `load` and outputs may be NULL. */
#ifndef SHD_TESTS_SUPPORT_LOADS_H
#define SHD_TESTS_SUPPORT_LOADS_H

#include <shd/io.h>

static inline shd_load_desc loads_desc(const shd_load_desc *load) { return load ? *load : shd_load_desc_default(); }

static inline shd_result load_file(shd_context *context, const char *path, const shd_load_desc *load,
                                   shd_texture_file_info *info, shd_texture **out)
{
    shd_load_desc desc = loads_desc(load);
    desc.info = info;
    return shd_texture_load(context, path, &desc, out);
}

static inline shd_result load_file_memory(shd_context *context, const void *bytes, size_t size,
                                          const shd_load_desc *load, shd_texture_file_info *info, shd_texture **out)
{
    shd_load_desc desc = loads_desc(load);
    desc.info = info;
    return shd_texture_load_memory(context, bytes, size, &desc, out);
}

static inline shd_result load_raw(shd_context *context, const char *path, const shd_raw_desc *raw,
                                  const shd_load_desc *load, shd_texture **out)
{
    shd_load_desc desc = loads_desc(load);
    desc.raw = raw;
    return shd_texture_load(context, path, &desc, out);
}

static inline shd_result load_stack(shd_context *context, const shd_stack_desc *stack, const shd_load_desc *load,
                                    shd_texture **out)
{
    shd_load_desc desc = loads_desc(load);
    desc.stack = stack;
    return shd_texture_load(context, NULL, &desc, out);
}

static inline shd_result load_vdb(shd_context *context, const char *path, const shd_vdb_desc *vdb,
                                  const shd_load_desc *load, shd_vdb_info *info, shd_texture **out)
{
    shd_load_desc desc = loads_desc(load);
    desc.vdb = vdb;
    desc.vdb_info = info;
    return shd_texture_load(context, path, &desc, out);
}

#endif /* SHD_TESTS_SUPPORT_LOADS_H */
