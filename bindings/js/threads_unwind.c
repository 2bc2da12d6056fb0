// SPDX-License-Identifier: MIT
// Exceptions of the module with threads, for LLVM before 16. Its code for catch clauses writes the place of a clause to
// one global variable for all threads, but Emscripten's libunwind reads a variable of the thread. These functions
// replace those of libunwind (Unwind-wasm.c) and use the global variable. A lock makes an exception reach its catch
// clause before another thread throws.
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

#include <unwind.h>

enum { CLEANUP_PHASE = 2 };

/** The place of a catch clause, and the number of its type that the personality function finds. */
struct lpad_context {
  uintptr_t index, lsda, selector;
};

struct lpad_context __wasm_lpad_context;

static _Atomic uint32_t s_is_locked;
static _Thread_local uint32_t t_thrown; /* exceptions of this thread that no clause has caught yet */

_Unwind_Reason_Code __gxx_personality_wasm0(int version, _Unwind_Action actions, uint64_t exception_class,
                                            struct _Unwind_Exception* exception, struct _Unwind_Context* context);
void* __real___cxa_begin_catch(void* exception);

/** Called by a throw expression. Destructors that run until the exception is caught may throw and catch others. */
_Unwind_Reason_Code _Unwind_RaiseException(struct _Unwind_Exception* exception) {
  if (t_thrown++ == 0) {
    while (atomic_exchange(&s_is_locked, 1)) {
    }
  }
  __builtin_wasm_throw(0, exception);
}

/** Called by a catch clause once it is chosen. */
void* __wrap___cxa_begin_catch(void* exception) {
  if (t_thrown && --t_thrown == 0) atomic_store(&s_is_locked, 0);
  return __real___cxa_begin_catch(exception);
}

/** Called by code before the catch clauses of a try block, to choose one. */
_Unwind_Reason_Code _Unwind_CallPersonality(void* pointer) {
  struct _Unwind_Exception* exception = pointer;
  __wasm_lpad_context.selector = 0;
  return __gxx_personality_wasm0(1, CLEANUP_PHASE, exception->exception_class, exception,
                                 (struct _Unwind_Context*)&__wasm_lpad_context);
}

void _Unwind_DeleteException(struct _Unwind_Exception* exception) {
  if (exception->exception_cleanup) exception->exception_cleanup(_URC_FOREIGN_EXCEPTION_CAUGHT, exception);
}

/* Called by the personality function. */

void _Unwind_SetGR(struct _Unwind_Context* context, int index, _Unwind_Word value) {
  if (index == 1) ((struct lpad_context*)context)->selector = value;
}

_Unwind_Word _Unwind_GetIP(struct _Unwind_Context* context) {
  return ((struct lpad_context*)context)->index + 2; /* it subtracts 1, and counts from 1 */
}

void _Unwind_SetIP(struct _Unwind_Context* context, _Unwind_Word value) {
  (void)context, (void)value;
}

void* _Unwind_GetLanguageSpecificData(struct _Unwind_Context* context) {
  return (void*)((struct lpad_context*)context)->lsda;
}

uintptr_t _Unwind_GetRegionStart(struct _Unwind_Context* context) {
  (void)context;
  return 0;
}
