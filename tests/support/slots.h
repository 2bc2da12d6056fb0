/* SPDX-License-Identifier: MIT */
/* Slots of a material desc that a test fills step by step. */
#ifndef SHD_TESTS_SUPPORT_SLOTS_H
#define SHD_TESTS_SUPPORT_SLOTS_H

#include <shd/material.h>

enum { SHD_TEST_SLOTS = 17 };

/** Slots of one material. Zero is none. */
typedef struct shd_slot_list {
    shd_slot slot[SHD_TEST_SLOTS];
    uint32_t count;
} shd_slot_list;

/** Appends a slot, lists it in the desc, and returns it for further changes. */
static inline shd_slot *shd_slot_list_add(shd_slot_list *list, shd_material_desc *desc, shd_slot slot)
{
    list->slot[list->count] = slot;
    desc->slots = list->slot;
    desc->slot_count = list->count + 1;
    return &list->slot[list->count++];
}

#endif /* SHD_TESTS_SUPPORT_SLOTS_H */
