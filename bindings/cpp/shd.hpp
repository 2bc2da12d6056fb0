// SPDX-License-Identifier: MIT
/// @file
/// shd for C++17: owners of handles, exceptions, and columns from containers. Structs are those of the C API; shd::name
/// is a shd_name that starts with its defaults.
///
/// shd_api.hpp, which this header includes, has a function for each function of C that can fail. It throws shd::error.
/// A function that makes an object returns an owner. With an owner as the last argument it returns the shd_result
/// instead and does not throw. Without exceptions (-fno-exceptions) only the second form exists. Programs call all
/// other functions as in C.
///
/// Lifetime and threads are those of the C headers. An owner itself belongs to one thread, as any object of C++.
///
///     shd::context context = shd::context_create(nullptr);
///     shd::texture_desc desc;
///     shd::texture texture = shd::texture_create(context, &desc);
#ifndef SHD_HPP
#define SHD_HPP

#include <shd/shd.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace shd {

#ifdef __cpp_exceptions
/// A call that failed: its result, and the text of shd_last_error() as what().
class error : public std::runtime_error {
 public:
  error(shd_result result, const char* message) : std::runtime_error(message), result_(result) {}
  shd_result result() const noexcept { return result_; }

 private:
  shd_result result_;
};

/// Throws shd::error unless the result is SHD_OK.
inline void check(shd_result result) {
  if (result != SHD_OK) throw error(result, shd_last_error());
}
#endif

/// The owner of one reference to an object. It cannot be copied; share() makes another owner.
template <class Handle, void (*Retain)(Handle*), void (*Release)(Handle*)>
class owner {
 public:
  using handle_type = Handle;

  owner() noexcept = default;
  /// Takes over a reference that the caller owns.
  explicit owner(Handle* handle) noexcept : handle_(handle) {}
  owner(owner&& other) noexcept : handle_(other.detach()) {}
  owner& operator=(owner&& other) noexcept {
    reset(other.detach());
    return *this;
  }
  owner(const owner&) = delete;
  owner& operator=(const owner&) = delete;
  ~owner() { Release(handle_); }

  Handle* get() const noexcept { return handle_; }
  /// Arguments and fields of C take owners as they are. A temporary owner would release the object at once.
  operator Handle*() const& noexcept { return handle_; }
  operator Handle*() && = delete;
  explicit operator bool() const& noexcept { return handle_ != nullptr; }

  /// Another reference to the same object.
  owner share() const noexcept {
    Retain(handle_);
    return owner(handle_);
  }
  /// Gives the reference to the caller.
  Handle* detach() noexcept { return std::exchange(handle_, nullptr); }
  /// Releases the object, and takes over a reference to another one.
  void reset(Handle* handle = nullptr) noexcept { Release(std::exchange(handle_, handle)); }

 private:
  Handle* handle_ = nullptr;
};

/// An owner of another reference to a borrowed handle, such as the result of shd_scene_get_mesh().
template <class Owner>
Owner retain(typename Owner::handle_type* handle) noexcept {
  Owner borrowed(handle);
  Owner owned = borrowed.share();
  borrowed.detach();
  return owned;
}

/// Neighbouring elements of a container or an array, with the part of std::span that columns need. A temporary gives a
/// span if it owns nothing, as another span, or if the elements are constant, for the rest of the expression.
template <class T>
class span {
 public:
  constexpr span() noexcept = default;
  constexpr span(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
  template <std::size_t N>
  constexpr span(T (&array)[N]) noexcept : data_(array), size_(N) {}
  template <class Range, class = std::enable_if_t<
                             (std::is_lvalue_reference_v<Range> || std::is_const_v<T> ||
                              std::is_trivially_destructible_v<Range>)&&!std::is_same_v<std::decay_t<Range>, span> &&
                             std::is_convertible_v<decltype(std::declval<Range&>().data()), T*>>>
  constexpr span(Range&& range) noexcept : data_(range.data()), size_(range.size()) {}

  constexpr T* data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
  constexpr T* begin() const noexcept { return data_; }
  constexpr T* end() const noexcept { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// Packed columns that shd reads.
inline shd_f32_in in(span<const float> values) noexcept {
  return shd_f32_column(values.data(), 0);
}
inline shd_u32_in in(span<const std::uint32_t> values) noexcept {
  return shd_u32_column(values.data(), 0);
}
inline shd_u16_in in(span<const std::uint16_t> values) noexcept {
  return shd_u16_column(values.data(), 0);
}

/// Packed columns that shd writes.
inline shd_f32_out out(span<float> values) noexcept {
  return shd_f32_out_column(values.data(), 0);
}
inline shd_u32_out out(span<std::uint32_t> values) noexcept {
  return shd_u32_out_column(values.data(), 0);
}

/// Columns of one member of records: in(vertices, &vertex::x).
template <class Range, class Record>
shd_f32_in in(const Range& records, float Record::*member) noexcept {
  return shd_f32_column(records.size() ? &(records.data()->*member) : nullptr, sizeof(Record));
}
template <class Range, class Record>
shd_f32_out out(Range& records, float Record::*member) noexcept {
  return shd_f32_out_column(records.size() ? &(records.data()->*member) : nullptr, sizeof(Record));
}

}  // namespace shd

#include "shd_api.hpp"

#ifdef __cpp_exceptions
namespace shd {

/// Make a texture whose tiles `load(span<const shd_tile>)` writes, on any thread, when a lookup first needs them. The
/// function object lives as long as the texture. The lookup fails with SHD_ERROR_CALLBACK and the text of what the
/// function throws. See shd_texture_create() and shd/tile_cache.h.
/// @param desc  its `tiles` are not read
template <class Load>
texture texture_create(shd_context* context_, const shd_texture_desc* desc, shd_tile_cache* cache, Load load) {
  auto kept = std::make_unique<Load>(std::move(load));
  shd_texture_desc tiled = *desc;
  tiled.tiles.cache = cache;
  tiled.tiles.load = [](const shd_tile* tiles, std::size_t count, void* user_data) noexcept -> shd_result {
    try {
      (*static_cast<Load*>(user_data))(span<const shd_tile>(tiles, count));
      return SHD_OK;
    } catch (const std::exception& problem) {
      shd_report_error(SHD_ERROR_CALLBACK, problem.what());
    } catch (...) {
      shd_report_error(SHD_ERROR_CALLBACK, "an exception that is no std::exception");
    }
    return SHD_ERROR_CALLBACK;
  };
  tiled.tiles.release = [](void* user_data) noexcept { delete static_cast<Load*>(user_data); };
  tiled.tiles.user_data = kept.get();
  shd::texture made = texture_create(context_, &tiled);
  kept.release();
  return made;
}

#if __has_include(<shd/scene.h>)
/// A load of a model whose files `find` answers: load(desc), with the callback in its desc. Throws what `find` throws.
template <class Find, class Load>
scene scene_load_found(const shd_scene_desc* desc, Find& find, Load load) {
  struct Call {
    Find& find;
    std::exception_ptr failure;
  } call = {find, nullptr};
  shd_scene_desc found = desc ? *desc : shd_scene_desc_default();
  found.find = [](const char* name, const void** out_bytes, std::size_t* out_size, void* user_data) noexcept {
    Call& running = *static_cast<Call*>(user_data);
    try {
      const span<const unsigned char> bytes = running.find(name);
      *out_bytes = bytes.data(), *out_size = bytes.size();
      return bytes.data() ? SHD_OK : SHD_ERROR_NOT_FOUND;
    } catch (...) {
      running.failure = std::current_exception();
      return SHD_ERROR_CALLBACK;
    }
  };
  found.user_data = &call;
  shd::scene made;
  const shd_result result = load(found, made);
  if (call.failure) std::rethrow_exception(call.failure);
  check(result);
  return made;
}

/// Read a model file. `find(const char *name)` answers the names of its files in place of its folder, with a span of
/// their bytes; a span without data = no such file. The bytes stay until the load returns. See shd_scene_load().
/// @param desc  its `find` is not read; NULL = all defaults
template <class Find>
scene scene_load(shd_context* context_, const char* path, const shd_scene_desc* desc, Find find) {
  return scene_load_found(desc, find, [&](const shd_scene_desc& found, shd::scene& made) {
    return scene_load(context_, path, &found, made);
  });
}

/// Read a model file in memory; `find` as above. See shd_scene_load_memory().
template <class Find>
scene scene_load_memory(shd_context* context_, span<const unsigned char> bytes, const char* name,
                        const shd_scene_desc* desc, Find find) {
  return scene_load_found(desc, find, [&](const shd_scene_desc& found, shd::scene& made) {
    return scene_load_memory(context_, bytes.data(), bytes.size(), name, &found, made);
  });
}
#endif

}  // namespace shd
#endif

#endif  // SHD_HPP
