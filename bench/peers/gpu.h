// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The part of Vulkan that lavapipe.cpp uses: a device, its memory, and commands that are waited for. Everything throws
/// std::runtime_error, whose text names the call and its result.
namespace shd::bench::gpu {

void check(VkResult result, const char* call);

/// A structure of Vulkan with its type; all other members are zero.
template <class T>
T structure(VkStructureType type) {
  T value = {};
  value.sType = type;
  return value;
}

/// An object of a device, destroyed with its owner.
template <class T>
class Handle {
 public:
  using Destroy = void(VKAPI_PTR*)(VkDevice, T, const VkAllocationCallbacks*);

  Handle() = default;
  Handle(VkDevice device, T value, Destroy destroy) : device_(device), value_(value), destroy_(destroy) {}
  Handle(Handle&& other) noexcept { swap(other); }
  Handle& operator=(Handle&& other) noexcept {
    swap(other);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (value_ != VK_NULL_HANDLE) destroy_(device_, value_, nullptr);
  }
  T get() const { return value_; }

 private:
  void swap(Handle& other) {
    std::swap(device_, other.device_);
    std::swap(value_, other.value_);
    std::swap(destroy_, other.destroy_);
  }

  VkDevice device_ = VK_NULL_HANDLE;
  T value_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

/// Makes an object, for example with vkCreateSampler and vkDestroySampler.
template <class T, class Info>
Handle<T> make(VkDevice device, const Info& info,
               VkResult(VKAPI_PTR* create)(VkDevice, const Info*, const VkAllocationCallbacks*, T*),
               typename Handle<T>::Destroy destroy, const char* call) {
  T value = VK_NULL_HANDLE;
  check(create(device, &info, nullptr, &value), call);
  return Handle<T>(device, value, destroy);
}

/// The lavapipe of this machine, with one queue. Devices of other drivers are not used.
class Device {
 public:
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice get() const { return device_; }
  /// Names and versions of the device, its driver and Vulkan.
  const std::string& description() const { return description_; }
  /// Number of invocations that the device runs in one vector, a multiple of 4.
  uint32_t vector_size() const { return vector_size_; }
  /// Whether compute shaders have implicit derivatives.
  bool has_derivatives() const { return !derivatives_.empty(); }
  /// Memory for `needs`, in which the host can write. Every memory of lavapipe is such.
  Handle<VkDeviceMemory> allocate(const VkMemoryRequirements& needs) const;
  /// Commands to be recorded, until end().
  VkCommandBuffer begin() const;
  void end(VkCommandBuffer commands) const;
  /// Runs commands, and waits until they are finished.
  void run(VkCommandBuffer commands) const;
  void free(VkCommandBuffer commands) const;

 private:
  void make_instance();
  void choose();
  void find_derivatives();
  void make_device();

  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t family_ = 0, vector_size_ = 4;
  Handle<VkCommandPool> pool_;
  std::string description_, derivatives_;  // the latter is the name of an extension
};

/// A buffer that the host sees.
class Buffer {
 public:
  Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage);
  VkBuffer get() const { return buffer_.get(); }
  template <class T>
  T* data() const {
    return static_cast<T*>(mapped_);
  }

 private:
  Handle<VkDeviceMemory> memory_;
  Handle<VkBuffer> buffer_;
  void* mapped_ = nullptr;
};

/// A square RGBA8 texture with every level, ready for shaders.
class Texture {
 public:
  Texture(const Device& device, const std::vector<std::vector<uint8_t>>& levels);
  VkImageView view() const { return view_.get(); }

 private:
  void make_image(const Device& device, uint32_t edge, uint32_t levels);
  void upload(const Device& device, const Buffer& staging, uint32_t edge, uint32_t levels) const;

  Handle<VkDeviceMemory> memory_;
  Handle<VkImage> image_;
  Handle<VkImageView> view_;
};

}  // namespace shd::bench::gpu
