// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "core/fork.h"

namespace shd::core {

struct Context;

/// Type of the object behind a handle of libshd. Extensions use values above 0xffff.
enum class ObjectType : uint32_t {
  kNone = 0,
  kTexture = 1,
  kSampler = 2,
  kMesh = 3,
  kMaterial = 4,
  kLight = 5,
  kFramebuffer = 6,
  kShadow = 7,
  kEnvironment = 8,
  kVolume = 9,
  kTileCache = 10,
  kPolyhedron = 11,
};

/// The memory behind every handle except a context's. It stays mapped, in its context's slabs, until the context is
/// released, so that a released or mistyped handle is recognised instead of followed.
struct Object {
  std::atomic<uint32_t> type;        // ObjectType, or 0 if dead
  std::atomic<uint32_t> references;  // 0 if dead
  Context* context;
  void* body;
  void (*destroy)(Context& context, void* body);  // runs on the thread that releases the last reference
  Object* next;                                   // in the list of dead objects, or of postponed references
  uint64_t birth;                                 // number of the callback that made it (call.h), or 0
  std::atomic<bool> postponed;                    // a reference is dropped later
};

/// Slabs of handles. The handle that has been dead longest is reused first, so that stale handles are detected for as
/// long as possible.
class ObjectPool {
 public:
  /// Makes the pool usable in children. Throws std::bad_alloc.
  void attach() { mutex_.attach(); }
  /// Returns a dead object. Throws std::bad_alloc.
  Object* take(const Allocator& allocator);
  void give_back(Object* object) noexcept;
  void free_all(const Allocator& allocator) noexcept;

 private:
  static constexpr size_t kSlabSize = 64;
  struct Slab {
    Slab* next;
    Object objects[kSlabSize];
  };

  Object* try_take() noexcept;

  ForkMutex mutex_{ForkLevel::kObjects};
  Slab* slabs_ = nullptr;
  Object* oldest_ = nullptr;
  Object* newest_ = nullptr;
  size_t fresh_ = kSlabSize;  // number of objects of the newest slab already in use
};

/// Creates a live handle with one reference, which retains `context`. Throws std::bad_alloc; then `body` is unchanged.
Object* make_object(Context& context, uint32_t type, void* body, void (*destroy)(Context&, void*));

/// Body of a live handle of the given type, otherwise null.
inline void* body_of(const Object* object, uint32_t type) {
  return object && object->type.load(std::memory_order_acquire) == type ? object->body : nullptr;
}

/// Return false and do nothing for a dead or mistyped handle.
bool retain(Object* object, uint32_t type) noexcept;
bool release(Object* object, uint32_t type) noexcept;
/// Drops a reference of a live object.
bool drop_reference(Object* object) noexcept;

}  // namespace shd::core
