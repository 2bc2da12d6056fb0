/* SPDX-License-Identifier: MIT */
/* An allocator that counts, fails on request, and checks what is freed. For one thread only: the context must have
   worker_count 1. */
#ifndef SHD_TESTS_SUPPORT_FAULT_ALLOCATOR_H
#define SHD_TESTS_SUPPORT_FAULT_ALLOCATOR_H

#include <stdlib.h>

#include "support/check.h"

#include <shd/context.h>

/** Counts since it was zeroed, and the point of failure. */
typedef struct shd_fault_allocator {
    size_t calls;   /* allocations requested since the last shd_fault_arm */
    size_t fail_at; /* 1 = the next one fails; 0 = none fails */
    int persistent; /* all later ones fail too */
    size_t live_bytes;
    size_t live_blocks;
    size_t peak_bytes;
    size_t mistakes; /* frees of foreign memory, or with another size or alignment */
} shd_fault_allocator;

/** Header in front of every block. */
typedef struct shd_fault_header {
    void *raw;
    size_t size, alignment;
    uint64_t magic;
} shd_fault_header;

#define SHD_FAULT_MAGIC 0x73686446617573ull

static inline void *shd_fault_allocate(size_t size, size_t alignment, void *user_data)
{
    shd_fault_allocator *self = (shd_fault_allocator *)user_data;
    shd_fault_header header;
    unsigned char *raw, *block;
    ++self->calls;
    if (self->fail_at && (self->persistent ? self->calls >= self->fail_at : self->calls == self->fail_at)) return NULL;
    if (size == 0 || alignment < 8 || (alignment & (alignment - 1))) {
        ++self->mistakes;
        return NULL;
    }
    raw = (unsigned char *)malloc(size + alignment + sizeof header);
    if (!raw) return NULL;
    block = raw + sizeof header;
    block += (alignment - (uintptr_t)block % alignment) % alignment;
    header.raw = raw;
    header.size = size;
    header.alignment = alignment;
    header.magic = SHD_FAULT_MAGIC;
    memcpy(block - sizeof header, &header, sizeof header);
    memset(block, 0xcd, size); /* makes reads before the first write visible */
    self->live_bytes += size;
    ++self->live_blocks;
    if (self->live_bytes > self->peak_bytes) self->peak_bytes = self->live_bytes;
    return block;
}

static inline void shd_fault_free(void *memory, size_t size, size_t alignment, void *user_data)
{
    shd_fault_allocator *self = (shd_fault_allocator *)user_data;
    shd_fault_header header;
    memcpy(&header, (unsigned char *)memory - sizeof header, sizeof header);
    if (header.magic != SHD_FAULT_MAGIC || header.size != size || header.alignment != alignment) {
        ++self->mistakes;
        return;
    }
    memset((unsigned char *)memory - sizeof header, 0xdd, size + sizeof header);
    self->live_bytes -= size;
    --self->live_blocks;
    free(header.raw);
}

/** Makes the n-th allocation from now on fail, 1 = the next; 0 = none. */
static inline void shd_fault_arm(shd_fault_allocator *self, size_t n, int persistent)
{
    self->calls = 0;
    self->fail_at = n;
    self->persistent = persistent;
}

/** Options of a single-threaded context that allocates its memory from `self`. */
static inline shd_context_desc shd_fault_context_desc(shd_fault_allocator *self)
{
    shd_context_desc desc = shd_context_desc_default();
    desc.flags = SHD_CONTEXT_RETURN_MEMORY; /* so that every allocation can fail, and is freed by its call */
    desc.worker_count = 1;
    desc.allocator.allocate = shd_fault_allocate;
    desc.allocator.free = shd_fault_free;
    desc.allocator.user_data = self;
    return desc;
}

/** Fails unless all memory was freed correctly. */
static inline void shd_assert_all_freed(const char *what, const shd_fault_allocator *self)
{
    if (self->live_bytes || self->live_blocks || self->mistakes) {
        fail_msg("%s: %zu bytes in %zu blocks left, %zu wrong frees", what, self->live_bytes, self->live_blocks,
                 self->mistakes);
    }
}

#endif /* SHD_TESTS_SUPPORT_FAULT_ALLOCATOR_H */
