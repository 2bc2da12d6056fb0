// SPDX-License-Identifier: MIT
// Lets a library or a program that is linked on a new system run with glibc 2.28 (PEP 600: manylinux_2_28).
//
// glibc 2.34 moved the functions of libpthread and libdl to libc, under a new version. Static libraries of this system
// refer to that version. The functions below have their names, are hidden in the library, and jump to the functions of
// the first version, which every glibc has. Newer functions are defined with older ones.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <link.h>
#include <pthread.h>
#include <spawn.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#if defined(__x86_64__)
#define FIRST "GLIBC_2.2.5"
#define SECOND "GLIBC_2.3.3"
#define STAT_VERSION 1
#define JUMP "jmp first_"
#define PLT "@PLT"
#elif defined(__aarch64__)
#define FIRST "GLIBC_2.17"
#define SECOND FIRST
#define STAT_VERSION 0
#define JUMP "b first_"
#define PLT ""
#else
#error "first version of glibc: not known for this processor"
#endif

#define USE(name, version)                                                                                      \
  __asm__(".text\n.globl " #name "\n.hidden " #name "\n.type " #name ", %function\n" #name ":\n" JUMP #name PLT \
          "\n.size " #name ", . - " #name                                                                       \
          "\n"                                                                                                  \
          ".symver first_" #name ", " #name "@" version)
#define USE_FIRST(name) USE(name, FIRST)

USE(dladdr1, SECOND);
USE(dlinfo, SECOND);
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
USE_FIRST(pthread_mutex_timedlock);
USE_FIRST(pthread_mutex_trylock);
USE_FIRST(pthread_once);
USE_FIRST(pthread_rwlock_rdlock);
USE_FIRST(pthread_rwlock_unlock);
USE_FIRST(pthread_rwlock_wrlock);
USE_FIRST(pthread_setspecific);

// glibc 2.29. The older functions set errno, too, and have the same results.
USE_FIRST(exp);
USE_FIRST(exp2);
USE_FIRST(log);
USE_FIRST(log2);
USE_FIRST(pow);

#define HIDDEN __attribute__((visibility("hidden")))

// glibc 2.32. libstdc++ counts references without atomic operations while it is set; zero is always correct.
HIDDEN char __libc_single_threaded = 0;

// glibc 2.36, for std::random_device.
HIDDEN uint32_t arc4random(void) {
  uint32_t value;
  if (getentropy(&value, sizeof value) != 0) abort();
  return value;
}

// glibc 2.33. Before, these were functions of the headers.
int first_fxstat(int version, int file, struct stat* out);
int first_lxstat(int version, const char* path, struct stat* out);
int first_xstat(int version, const char* path, struct stat* out);
__asm__(".symver first_fxstat, __fxstat@" FIRST);
__asm__(".symver first_lxstat, __lxstat@" FIRST);
__asm__(".symver first_xstat, __xstat@" FIRST);
HIDDEN int fstat(int file, struct stat* out) {
  return first_fxstat(STAT_VERSION, file, out);
}
HIDDEN int fstat64(int file, struct stat64* out) {
  return first_fxstat(STAT_VERSION, file, (struct stat*)out);
}
HIDDEN int lstat(const char* path, struct stat* out) {
  return first_lxstat(STAT_VERSION, path, out);
}
HIDDEN int stat(const char* path, struct stat* out) {
  return first_xstat(STAT_VERSION, path, out);
}

// A time of another clock as one of CLOCK_REALTIME. A clock that is set during a wait changes its length.
static int real_time(clockid_t clock, const struct timespec* end, struct timespec* real) {
  struct timespec now;
  if (clock_gettime(clock, &now) != 0 || clock_gettime(CLOCK_REALTIME, real) != 0) return EINVAL;
  real->tv_sec += end->tv_sec - now.tv_sec;
  real->tv_nsec += end->tv_nsec - now.tv_nsec;
  if (real->tv_nsec < 0) real->tv_nsec += 1000000000, --real->tv_sec;
  if (real->tv_nsec >= 1000000000) real->tv_nsec -= 1000000000, ++real->tv_sec;
  return 0;
}

// glibc 2.30, for std::timed_mutex and std::condition_variable.
HIDDEN int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock, const struct timespec* end) {
  struct timespec real;
  const int error = real_time(clock, end, &real);
  return error ? error : pthread_mutex_timedlock(mutex, &real);
}
HIDDEN int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                                  const struct timespec* end) {
  struct timespec real;
  const int error = real_time(clock, end, &real);
  return error ? error : pthread_cond_timedwait(condition, mutex, &real);
}

// glibc 2.29 and 2.34, where the system has them. Otherwise shd-io-worker does the same when it starts.
HIDDEN int posix_spawn_file_actions_addchdir_np(posix_spawn_file_actions_t* restrict actions,
                                                const char* restrict path) {
  int (*add)(posix_spawn_file_actions_t*, const char*);
  *(void**)&add = dlsym(RTLD_DEFAULT, "posix_spawn_file_actions_addchdir_np");
  return add ? add(actions, path) : 0;
}
HIDDEN int posix_spawn_file_actions_addclosefrom_np(posix_spawn_file_actions_t* actions, int first) {
  int (*add)(posix_spawn_file_actions_t*, int);
  *(void**)&add = dlsym(RTLD_DEFAULT, "posix_spawn_file_actions_addclosefrom_np");
  return add ? add(actions, first) : 0;
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
