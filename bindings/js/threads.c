// SPDX-License-Identifier: MIT
// The executor of the module with threads. Its threads are Web Workers over the same memory (lib/threads.js), and take
// the tasks of parallel_for() together with the calling thread. A thread cannot run functions of JavaScript that belong
// to the calling thread: it leaves the call in its mailbox, and the calling thread answers it.
#define _GNU_SOURCE /* pthread_getattr_np() */
#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>

#include <shd/shd.h>

enum { MOST_THREADS = 64, STACK_SIZE = 2 << 20 };

/** A call of a function of JavaScript. lib/threads.js has the layout. */
struct mailbox {
  _Atomic uint32_t state; /* 1: waits for an answer, 2: is answered */
  uint32_t function;      /* index in the list of functions */
  double words[8];        /* arguments; the result replaces the first one */
};

static struct {
  _Atomic uint32_t signal;   /* changes when the calling thread has something to do */
  _Atomic uint32_t requests; /* grows with each call in a mailbox */
  _Atomic uint32_t job;      /* changes when a job begins */
  _Atomic uint32_t busy;     /* threads that have not finished the job */
  _Atomic uint32_t stopped;  /* index of a thread that a trap or an exception has ended, or 0; lib/threads.js sets it */
  struct mailbox mailboxes[MOST_THREADS];

  uint32_t thread_count; /* beside the calling thread */
  uint32_t answered;     /* requests that were answered */
  bool has_job, may_wait;

  shd_task_fn task; /* the job */
  void* task_data;
  size_t count;
  uint32_t first_worker, worker_count;
  _Atomic size_t next;
} s_pool;

/* lib/threads.js has these: one answers the mailboxes, one returns 1 if the instance has functions of JavaScript. */
__attribute__((import_module("shd"), import_name("answer"))) extern void answer(void);
__attribute__((import_module("shd"), import_name("has_functions"))) extern int has_functions(void);

static void wait_for_change(_Atomic uint32_t* word, uint32_t value) {
  __builtin_wasm_memory_atomic_wait32((int*)word, (int)value, -1);
}

static void change(_Atomic uint32_t* word) {
  atomic_fetch_add(word, 1);
  __builtin_wasm_memory_atomic_notify((int*)word, MOST_THREADS);
}

static void take_tasks(uint32_t worker) {
  for (size_t i; (i = atomic_fetch_add(&s_pool.next, 1)) < s_pool.count;) {
    s_pool.task(i, worker, s_pool.task_data);
  }
}

/** A thread with an index from 1. It ends with the instance. */
static void* run_thread(void* index) {
  uint32_t seen = 0;
  for (;;) {
    while (atomic_load(&s_pool.job) == seen) wait_for_change(&s_pool.job, seen);
    seen = atomic_load(&s_pool.job);
    const uint32_t worker = (uint32_t)(uintptr_t)index - s_pool.first_worker;
    if (worker < s_pool.worker_count) take_tasks(worker);
    if (atomic_fetch_sub(&s_pool.busy, 1) == 1) change(&s_pool.signal);
  }
  return NULL;
}

/**
 * Waits for the threads, and answers their calls. If a thread has stopped, the calling thread stops, too: no destructor
 * runs, which could wait for a lock of that thread. lib/call.js throws what has stopped it.
 */
static void wait_for_threads(void) {
  for (;;) {
    const uint32_t seen = atomic_load(&s_pool.signal);
    if (atomic_load(&s_pool.stopped)) __builtin_trap();
    const uint32_t requests = atomic_load(&s_pool.requests);
    if (requests != s_pool.answered) {
      s_pool.answered = requests;
      answer();
    } else if (!atomic_load(&s_pool.busy)) {
      return;
    } else if (s_pool.may_wait) {
      wait_for_change(&s_pool.signal, seen);
    }
  }
}

/**
 * An executor. `user_data` is its number of workers. If the instance has functions of JavaScript, the calling thread
 * takes no tasks: it could wait for a lock of a thread that waits for an answer.
 */
static shd_result run_tasks(size_t count, shd_task_fn task, void* task_data, void* user_data) {
  if (s_pool.has_job || count < 2) { /* a function of JavaScript called shd */
    for (size_t i = 0; i < count; ++i) task(i, 0, task_data);
    return SHD_OK;
  }
  const bool helps = !has_functions();
  s_pool.has_job = true;
  s_pool.task = task, s_pool.task_data = task_data, s_pool.count = count;
  s_pool.worker_count = (uint32_t)(uintptr_t)user_data;
  s_pool.first_worker = helps ? 0 : 1;
  atomic_store(&s_pool.next, 0);
  atomic_store(&s_pool.busy, s_pool.thread_count);
  change(&s_pool.job);
  if (helps) take_tasks(0);
  wait_for_threads();
  s_pool.has_job = false;
  return SHD_OK;
}

/* Exports for lib/threads.js. */

void* shd_js_executor(void);
void* shd_js_mailboxes(void);
int shd_js_start_thread(uint32_t index, int may_wait);
void* shd_js_stack_top(pthread_t thread);

void* shd_js_executor(void) {
  return (void*)run_tasks;
}

void* shd_js_mailboxes(void) {
  return &s_pool;
}

/** Makes thread `index` of 1..MOST_THREADS - 1; pthread_create() calls JavaScript for the Web Worker. 0 = success. */
int shd_js_start_thread(uint32_t index, int may_wait) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, STACK_SIZE);
  pthread_t thread;
  s_pool.may_wait = may_wait != 0;
  if (index >= MOST_THREADS) return 1;
  const int result = pthread_create(&thread, &attributes, run_thread, (void*)(uintptr_t)index);
  if (!result) s_pool.thread_count = index;
  return result;
}

/** The end of a thread's stack, where it begins to grow down. */
void* shd_js_stack_top(pthread_t thread) {
  pthread_attr_t attributes;
  void* address = NULL;
  size_t size = 0;
  if (pthread_getattr_np(thread, &attributes) || pthread_attr_getstack(&attributes, &address, &size)) return NULL;
  return (char*)address + size;
}
