/* SPDX-License-Identifier: MIT */
/* Bring your own memory: every byte that shd uses is counted, can be refused, and is freed. */
#include <stdio.h>
#include <stdlib.h>

#include <shd/shd.h>

/* The context here has one worker, so that the callbacks run on this thread. With more workers they need a lock. */
struct budget {
    size_t limit, used, peak, blocks;
};

static void *budget_allocate(size_t size, size_t alignment, void *user_data)
{
    struct budget *budget = (struct budget *)user_data;
    void **block;
    uintptr_t start;
    if (size > budget->limit - budget->used) return NULL;
    block = (void **)malloc(size + alignment + sizeof(void *));
    if (!block) return NULL;
    start = ((uintptr_t)(block + 1) + alignment - 1) & ~(uintptr_t)(alignment - 1);
    ((void **)start)[-1] = block; /* stored just before the memory that shd uses */
    budget->used += size;
    budget->blocks += 1;
    if (budget->used > budget->peak) budget->peak = budget->used;
    return (void *)start;
}

static void budget_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    struct budget *budget = (struct budget *)user_data;
    (void)alignment;
    budget->used -= size;
    budget->blocks -= 1;
    free(((void **)memory)[-1]);
}

/* Make a 1024 x 1024 mipmapped texture within `limit` bytes. */
static shd_result try_texture(struct budget *budget, size_t limit)
{
    static uint32_t pixels[1024 * 1024];
    shd_context_desc cd = shd_context_desc_default();
    shd_texture_desc td = shd_texture_desc_default();
    shd_context *context = NULL;
    shd_texture *texture = NULL;
    shd_result result;

    budget->limit = limit;
    budget->peak = 0;
    cd.worker_count = 1;
    cd.allocator.allocate = budget_allocate;
    cd.allocator.free = budget_free;
    cd.allocator.user_data = budget;
    td.width = td.height = 1024;
    td.format = SHD_FORMAT_RGBA8;
    td.texels = pixels;
    td.tables = SHD_TABLE_MIPMAP;

    result = shd_context_create(&cd, &context);
    if (result == SHD_OK) result = shd_texture_create(context, &td, &texture);
    shd_texture_release(texture);
    shd_context_release(context);
    return result;
}

int main(void)
{
    struct budget budget = {0, 0, 0, 0};
    shd_result rich = try_texture(&budget, (size_t)256 << 20);
    size_t peak = budget.peak;
    shd_result poor = try_texture(&budget, (size_t)1 << 20);
    int good = rich == SHD_OK && poor == SHD_ERROR_OUT_OF_MEMORY && peak >= (size_t)4 << 20 && budget.used == 0 &&
               budget.blocks == 0;
    printf("256 MB: %s, peak %zu bytes; 1 MB: %s; left behind: %zu bytes in %zu blocks\n", shd_result_name(rich), peak,
           shd_result_name(poor), budget.used, budget.blocks);
    return good ? 0 : 1;
}
