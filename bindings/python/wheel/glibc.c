// SPDX-License-Identifier: MIT
// Lets a library that is linked on a new system run with glibc 2.28 (PEP 600: manylinux_2_28).
//
// glibc 2.34 moved the functions of libpthread and libdl to libc, under a new version. Static libraries of this system
// refer to that version. The functions below have their names, are hidden in the library, and jump to the functions of
// the first version, which every glibc has. Newer functions are defined with older ones.
#define _GNU_SOURCE
#include <link.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/random.h>
#include <unistd.h>

#if defined(__x86_64__)
#define FIRST "GLIBC_2.2.5"
#define JUMP "jmp first_"
#define PLT "@PLT"
#elif defined(__aarch64__)
#define FIRST "GLIBC_2.17"
#define JUMP "b first_"
#define PLT ""
#else
#error "first version of glibc: not known for this processor"
#endif

#define USE_FIRST(name)                                                                                         \
  __asm__(".text\n.globl " #name "\n.hidden " #name "\n.type " #name ", %function\n" #name ":\n" JUMP #name PLT \
          "\n.size " #name ", . - " #name                                                                       \
          "\n"                                                                                                  \
          ".symver first_" #name ", " #name "@" FIRST)

USE_FIRST(dlclose);
USE_FIRST(dlerror);
USE_FIRST(dlopen);
USE_FIRST(dlsym);
USE_FIRST(pthread_attr_getstack);
USE_FIRST(pthread_attr_setstacksize);
USE_FIRST(pthread_create);
USE_FIRST(pthread_detach);
USE_FIRST(pthread_getattr_np);
USE_FIRST(pthread_getspecific);
USE_FIRST(pthread_join);
USE_FIRST(pthread_key_create);
USE_FIRST(__pthread_key_create);
USE_FIRST(pthread_key_delete);
USE_FIRST(pthread_mutexattr_destroy);
USE_FIRST(pthread_mutexattr_init);
USE_FIRST(pthread_mutexattr_settype);
USE_FIRST(pthread_once);
USE_FIRST(pthread_setspecific);

#define HIDDEN __attribute__((visibility("hidden")))

// glibc 2.32. libstdc++ counts references without atomic operations while it is set; zero is always correct.
HIDDEN char __libc_single_threaded = 0;

// glibc 2.36, for std::random_device.
HIDDEN uint32_t arc4random(void) {
  uint32_t value;
  if (getentropy(&value, sizeof value) != 0) abort();
  return value;
}

struct search {
  uintptr_t pc;
  struct dl_find_object* found;
};

static int find(struct dl_phdr_info* info, size_t size, void* data) {
  (void)size;
  const struct search* search = data;
  const ElfW(Phdr)* eh_frame = NULL, *text = NULL;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)* segment = &info->dlpi_phdr[i];
    if (segment->p_type == PT_GNU_EH_FRAME) eh_frame = segment;
    if (segment->p_type == PT_LOAD && search->pc - (info->dlpi_addr + segment->p_vaddr) < segment->p_memsz)
      text = segment;
  }
  if (!text || !eh_frame) return 0;
  search->found->dlfo_map_start = (void*)(info->dlpi_addr + text->p_vaddr);
  search->found->dlfo_map_end = (void*)(info->dlpi_addr + text->p_vaddr + text->p_memsz);
  search->found->dlfo_eh_frame = (void*)(info->dlpi_addr + eh_frame->p_vaddr);
  return 1;
}

// glibc 2.35, for the unwinder of libgcc: the unwind table of the object that has an instruction.
HIDDEN int _dl_find_object(void* pc, struct dl_find_object* found) {
  struct search search = {(uintptr_t)pc, found};
  return dl_iterate_phdr(find, &search) ? 0 : -1;
}
