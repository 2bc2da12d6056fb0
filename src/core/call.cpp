// SPDX-License-Identifier: MIT
#include "core/call.h"

#include <cstring>

#include "core/object.h"
#include "core/status.h"

namespace shd::core {
namespace {

std::atomic<uint64_t> g_callbacks{0};

/// Puts the objects of a list before those of another one.
Object* join(Object* first, Object* rest) {
  if (!first) return rest;
  Object* last = first;
  while (last->next) last = last->next;
  last->next = rest;
  return first;
}

}  // namespace

Call& this_call() noexcept {
  return t_call;
}

CallbackScope::CallbackScope(Callback* callback) : callback_(*callback) {
  callback->outer = t_call.callback;
  callback->number = g_callbacks.fetch_add(1, std::memory_order_relaxed) + 1;
  t_call.callback = callback;
}

SharedCall::~SharedCall() {
  if (Object* const postponed = postponed_.load(std::memory_order_acquire)) {
    t_call.postponed = join(postponed, t_call.postponed);
  }
}

TaskScope::~TaskScope() {
  Object* const postponed = t_call.postponed;
  t_call = before_;
  if (!postponed) return;
  Object* last = postponed;
  while (last->next) last = last->next;
  Object* first = shared_.postponed_.load(std::memory_order_relaxed);
  do {
    last->next = first;
  } while (!shared_.postponed_.compare_exchange_weak(first, postponed, std::memory_order_acq_rel));
}

bool postpone_release(Object* object) noexcept {
  const Callback* const callback = t_call.callback;
  if (!callback || object->birth >= callback->number) return false;
  for (int tries = 0; tries < 4; ++tries) {
    if (!object->postponed.exchange(true, std::memory_order_acq_rel)) {
      object->next = t_call.postponed;
      t_call.postponed = object;
      return true;
    }
    // Another reference is postponed and keeps the object, so this one can be dropped.
    uint32_t count = object->references.load(std::memory_order_relaxed);
    if (count > 1 && object->references.compare_exchange_strong(count, count - 1, std::memory_order_acq_rel))
      return true;
  }
  return true;  // the host has no reference any more
}

void drop_postponed() noexcept {
  char text[kErrorTextSize];
  std::memcpy(text, last_error(), std::strlen(last_error()) + 1);
  while (Object* const object = t_call.postponed) {
    t_call.postponed = object->next;
    object->postponed.store(false, std::memory_order_release);
    drop_reference(object);
  }
  fail(SHD_OK, "%s", text);
}

}  // namespace shd::core
