// SPDX-License-Identifier: MIT
#pragma once

#include "core/context.h"
#include "core/object.h"
#include "core/status.h"

namespace shd::abi {

/// Checks a context handle. The tag catches null and most damage; a released context cannot be detected.
inline shd_result check_context(const shd_context* handle) {
  const auto* context = reinterpret_cast<const core::Context*>(handle);
  if (context && context->tag == core::kContextTag) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, handle ? "context: not a live handle" : "context: NULL");
}

inline core::Context& context_of(shd_context* handle) {
  return *reinterpret_cast<core::Context*>(handle);
}
inline const core::Context& context_of(const shd_context* handle) {
  return *reinterpret_cast<const core::Context*>(handle);
}

/// Object behind a handle such as shd_texture; handles are pointers to core::Object.
template <class Handle>
core::Object* object_of(Handle* handle) {
  return reinterpret_cast<core::Object*>(handle);
}
template <class Handle>
const core::Object* object_of(const Handle* handle) {
  return reinterpret_cast<const core::Object*>(handle);
}

/// Stores the body of a live handle of `type` in `*out`; an error names `name`.
template <class Body, class Handle>
shd_result read_handle(const char* name, const Handle* handle, core::ObjectType type, Body** out) {
  if (!handle) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  *out = static_cast<Body*>(core::body_of(object_of(handle), static_cast<uint32_t>(type)));
  if (*out) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: not a live handle of its type", name);
}

template <class Handle>
void retain_handle(Handle* handle, core::ObjectType type) {
  core::retain(object_of(handle), static_cast<uint32_t>(type));
}
template <class Handle>
void release_handle(Handle* handle, core::ObjectType type) {
  core::release(object_of(handle), static_cast<uint32_t>(type));
}

/// Retains the object of an optional handle, of any context. Without a handle, `body` and `object` stay as they are.
template <class Body, class Handle>
shd_result retain_part(const char* field, Handle* handle, core::ObjectType type, const Body** body,
                       core::Object** object) {
  if (!handle) return SHD_OK;
  Body* found = nullptr;
  if (const shd_result result = read_handle(field, handle, type, &found)) return result;
  if (!core::retain(object_of(handle), static_cast<uint32_t>(type))) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: not a live handle of its type", field);
  }
  *body = found;
  *object = object_of(handle);
  return SHD_OK;
}

/// Makes a handle for a body that core::create made. Destroys the body on failure.
template <class Body, class Handle>
void make_handle(core::Context& context, core::ObjectType type, Body* body, Handle** out) {
  const auto destroy = [](core::Context& owner, void* memory) {
    core::destroy(owner.allocator, static_cast<Body*>(memory));
  };
  try {
    *out = reinterpret_cast<Handle*>(core::make_object(context, static_cast<uint32_t>(type), body, destroy));
  } catch (...) {
    core::destroy(context.allocator, body);
    throw;
  }
}

/// Makes a body, which fill(body) fills, and its handle. Destroys the body if fill() returns an error or throws.
template <class Body, class Handle, class Fill>
shd_result create_handle(core::Context& context, core::ObjectType type, const Fill& fill, Handle** out) {
  auto* body = core::create<Body>(context.allocator);
  shd_result result;
  try {
    result = fill(body);
  } catch (...) {
    core::destroy(context.allocator, body);
    throw;
  }
  if (result != SHD_OK) {
    core::destroy(context.allocator, body);
    return result;
  }
  make_handle(context, type, body, out);
  return SHD_OK;
}

}  // namespace shd::abi
