// SPDX-License-Identifier: MIT
#include "core/object.h"

#include <new>
#include <utility>

#include "core/call.h"
#include "core/context.h"

namespace shd::core {

/// Unused handles are taken first, then dead handles, the longest dead one first. Null if there are none.
Object* ObjectPool::try_take() noexcept {
  if (fresh_ < kSlabSize) return &slabs_->objects[fresh_++];
  Object* object = oldest_;
  if (!object) return nullptr;
  oldest_ = object->next;
  if (!oldest_) newest_ = nullptr;
  return object;
}

Object* ObjectPool::take(const Allocator& allocator) {
  {
    const std::lock_guard<ForkMutex> lock(mutex_);
    if (Object* object = try_take()) return object;
  }
  Slab* slab = new (allocator.allocate(sizeof(Slab))) Slab();  // without the lock: it is the host's code
  Object* object = nullptr;
  {
    const std::lock_guard<ForkMutex> lock(mutex_);
    object = try_take();  // handles of another thread that was faster
    if (!object) {
      slab->next = slabs_;
      slabs_ = std::exchange(slab, nullptr);
      fresh_ = 1;
      object = &slabs_->objects[0];
    }
  }
  if (slab) destroy(allocator, slab);
  return object;
}

void ObjectPool::give_back(Object* object) noexcept {
  const std::lock_guard<ForkMutex> lock(mutex_);
  object->next = nullptr;
  if (newest_) {
    newest_->next = object;
  } else {
    oldest_ = object;
  }
  newest_ = object;
}

void ObjectPool::free_all(const Allocator& allocator) noexcept {
  while (slabs_) {
    Slab* next = slabs_->next;
    destroy(allocator, slabs_);
    slabs_ = next;
  }
}

Object* make_object(Context& context, uint32_t type, void* body, void (*destroy)(Context&, void*)) {
  Object* object = context.objects.take(context.allocator);
  object->context = &context;
  object->body = body;
  object->destroy = destroy;
  object->birth = t_call.callback ? t_call.callback->number : 0;
  object->references.store(1, std::memory_order_relaxed);
  object->type.store(type, std::memory_order_release);
  retain(context);
  return object;
}

bool retain(Object* object, uint32_t type) noexcept {
  if (!object || object->type.load(std::memory_order_acquire) != type) return false;
  uint32_t count = object->references.load(std::memory_order_relaxed);
  do {
    if (count == 0) return false;
  } while (!object->references.compare_exchange_weak(count, count + 1, std::memory_order_relaxed));
  return true;
}

bool release(Object* object, uint32_t type) noexcept {
  if (!object || object->type.load(std::memory_order_acquire) != type) return false;
  return postpone_release(object) || drop_reference(object);
}

bool drop_reference(Object* object) noexcept {
  uint32_t count = object->references.load(std::memory_order_relaxed);
  do {
    if (count == 0) return false;
  } while (!object->references.compare_exchange_weak(count, count - 1, std::memory_order_acq_rel));
  if (count > 1) return true;

  Context& context = *object->context;
  object->type.store(0, std::memory_order_release);
  object->destroy(context, object->body);
  context.objects.give_back(object);
  release(context);
  return true;
}

}  // namespace shd::core
