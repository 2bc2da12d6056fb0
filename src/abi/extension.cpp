// SPDX-License-Identifier: MIT
#include <shd/extension.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "core/executor.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// Body of an extension's handle: the object behind the handle and its destructor.
struct ExtensionBody {
  void* body;
  void (*destroy)(void* body);
};

void destroy_extension(core::Context& context, void* memory) {
  auto* extension = static_cast<ExtensionBody*>(memory);
  extension->destroy(extension->body);
  core::destroy(context.allocator, extension);
}

bool is_extension_type(uint32_t type) {
  return type > 0xffff;
}

}  // namespace

extern "C" {

shd_result shd_report_error(shd_result result, const char* message) {
  return core::fail(result, "%s", message ? message : "");
}

void* shd_context_allocate(shd_context* context, size_t size, size_t alignment) {
  const core::ErrnoScope host_errno;
  if (check_context(context) != SHD_OK || size == 0 || size > PTRDIFF_MAX) return nullptr;
  if (alignment & (alignment - 1)) return nullptr;  // the host was promised a power of two
  const shd_allocator& callbacks = context_of(context).allocator.callbacks;
  return callbacks.allocate(size, alignment < 8 ? 8 : alignment, callbacks.user_data);
}

void shd_context_free(shd_context* context, void* memory, size_t size, size_t alignment) {
  if (!memory || check_context(context) != SHD_OK) return;
  const shd_allocator& callbacks = context_of(context).allocator.callbacks;
  callbacks.free(memory, size, alignment < 8 ? 8 : alignment, callbacks.user_data);
}

void shd_context_log(shd_context* context, shd_log_level level, const char* message) {
  if (check_context(context) == SHD_OK && message) core::log(context_of(context), level, "%s", message);
}

shd_result shd_context_parallel_for(shd_context* context, size_t count, shd_task_fn task, void* task_data) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_context(context));
    SHD_TRY(check_not_null("parallel_for.task", reinterpret_cast<const void*>(task)));
    SHD_TRY(check_count("parallel_for.count", count, 0, UINT32_MAX));
    core::parallel_for(context_of(context), static_cast<uint32_t>(count),
                       [&](uint32_t index, uint32_t worker) { task(index, worker, task_data); });
    return SHD_OK;
  });
}

shd_result shd_object_create(shd_context* context, uint32_t type, void* body, void (*destroy)(void* body),
                             shd_object** out_object) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_object", out_object));
    *out_object = nullptr;
    SHD_TRY(check_context(context));
    SHD_TRY(check_not_null("object.body", body));
    SHD_TRY(check_not_null("object.destroy", reinterpret_cast<const void*>(destroy)));
    if (!is_extension_type(type)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "object.type: 0x%x is not above 0xffff", type);
    }
    core::Context& owner = context_of(context);
    auto* extension = core::create<ExtensionBody>(owner.allocator, ExtensionBody{body, destroy});
    try {
      *out_object = reinterpret_cast<shd_object*>(core::make_object(owner, type, extension, destroy_extension));
    } catch (...) {
      core::destroy(owner.allocator, extension);
      throw;
    }
    return SHD_OK;
  });
}

void* shd_object_get_body(const shd_object* object, uint32_t type) {
  void* extension = is_extension_type(type) ? core::body_of(object_of(object), type) : nullptr;
  if (extension) return static_cast<ExtensionBody*>(extension)->body;
  core::fail(SHD_ERROR_INVALID_ARGUMENT, object ? "object: not a live handle of its type" : "object: NULL");
  return nullptr;
}

shd_context* shd_object_get_context(const shd_object* object) {
  if (!object || object_of(object)->type.load() == 0) return nullptr;
  return reinterpret_cast<shd_context*>(object_of(object)->context);
}

shd_context* shd_framebuffer_get_context(const shd_framebuffer* framebuffer) {
  const auto type = static_cast<uint32_t>(core::ObjectType::kFramebuffer);
  if (!core::body_of(object_of(framebuffer), type)) return nullptr;
  return reinterpret_cast<shd_context*>(object_of(framebuffer)->context);
}

void shd_object_retain(shd_object* object, uint32_t type) {
  if (is_extension_type(type)) core::retain(object_of(object), type);
}

void shd_object_release(shd_object* object, uint32_t type) {
  if (is_extension_type(type)) core::release(object_of(object), type);
}

}  // extern "C"
