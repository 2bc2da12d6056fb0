// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <stdexcept>

#include "gpu.h"

namespace shd::bench::gpu {
namespace {

const char* name_of(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "VK_ERROR_OUT_OF_HOST_MEMORY";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "VK_ERROR_OUT_OF_DEVICE_MEMORY";
    case VK_ERROR_INITIALIZATION_FAILED: return "VK_ERROR_INITIALIZATION_FAILED";
    case VK_ERROR_DEVICE_LOST: return "VK_ERROR_DEVICE_LOST";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "VK_ERROR_INCOMPATIBLE_DRIVER";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "VK_ERROR_FEATURE_NOT_PRESENT";
    default: return "VkResult";
  }
}

std::string version_text(uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

/// Whether a device is lavapipe, whose devices are named after llvmpipe.
bool is_lavapipe(const VkPhysicalDeviceProperties& properties) {
  return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU &&
         std::string(properties.deviceName).find("llvmpipe") != std::string::npos;
}

}  // namespace

void check(VkResult result, const char* call) {
  if (result == VK_SUCCESS) return;
  throw std::runtime_error(std::string("lavapipe: ") + call + ": " + name_of(result) + " (" + std::to_string(result) +
                           ")");
}

Device::Device() {
  setenv("LP_NUM_THREADS", "0", 1);  // shaders run on the thread of the queue alone
  try {
    make_instance();
    choose();
    find_derivatives();
    make_device();
  } catch (...) {
    if (device_) vkDestroyDevice(device_, nullptr);
    if (instance_) vkDestroyInstance(instance_, nullptr);
    throw;
  }
}

Device::~Device() {
  pool_ = {};
  vkDestroyDevice(device_, nullptr);
  vkDestroyInstance(instance_, nullptr);
}

void Device::make_instance() {
  auto application = structure<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
  application.pApplicationName = "shd";
  application.apiVersion = VK_API_VERSION_1_2;  // has the properties of drivers
  auto info = structure<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
  info.pApplicationInfo = &application;
  check(vkCreateInstance(&info, nullptr, &instance_), "vkCreateInstance");
}

void Device::choose() {
  uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> all(count);
  check(vkEnumeratePhysicalDevices(instance_, &count, all.data()), "vkEnumeratePhysicalDevices");
  for (VkPhysicalDevice device : all) {
    auto driver = structure<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
    auto group = structure<VkPhysicalDeviceSubgroupProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
    driver.pNext = &group;
    auto properties = structure<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(device, &properties);
    if (!is_lavapipe(properties.properties)) continue;
    physical_ = device;
    vector_size_ = group.subgroupSize;
    description_ = std::string(properties.properties.deviceName) + ", Vulkan " +
                   version_text(properties.properties.apiVersion) + ", " + driver.driverInfo + ", LP_NUM_THREADS=0";
    return;
  }
  throw std::runtime_error("lavapipe: Vulkan has no such device");
}

void Device::find_derivatives() {
  uint32_t count = 0;
  check(vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, nullptr),
        "vkEnumerateDeviceExtensionProperties");
  std::vector<VkExtensionProperties> all(count);
  check(vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, all.data()),
        "vkEnumerateDeviceExtensionProperties");
  for (const VkExtensionProperties& extension : all) {
    const std::string name = extension.extensionName;
    if (name == "VK_KHR_compute_shader_derivatives") derivatives_ = name;
  }
}

void Device::make_device() {
  VkPhysicalDeviceFeatures features = {};
  vkGetPhysicalDeviceFeatures(physical_, &features);
  if (!features.samplerAnisotropy) throw std::runtime_error("lavapipe: the device has no anisotropic filter");
  features = {};
  features.samplerAnisotropy = VK_TRUE;
  const float priority = 1.0f;
  auto queue = structure<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = family_;  // the only one of lavapipe
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = structure<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pEnabledFeatures = &features;
  // The structure of VK_NV_compute_shader_derivatives is that of the extension of Khronos.
  auto implicit = structure<VkPhysicalDeviceComputeShaderDerivativesFeaturesNV>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COMPUTE_SHADER_DERIVATIVES_FEATURES_NV);
  implicit.computeDerivativeGroupLinear = VK_TRUE;
  const char* extensions[] = {derivatives_.c_str()};
  if (has_derivatives()) {
    info.pNext = &implicit;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = extensions;
  }
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, family_, 0, &queue_);
  auto pool = structure<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  pool.queueFamilyIndex = family_;
  pool_ = make(device_, pool, vkCreateCommandPool, vkDestroyCommandPool, "vkCreateCommandPool");
}

VkCommandBuffer Device::begin() const {
  auto info = structure<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  info.commandPool = pool_.get();
  info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device_, &info, &commands), "vkAllocateCommandBuffers");
  const auto start = structure<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  check(vkBeginCommandBuffer(commands, &start), "vkBeginCommandBuffer");
  return commands;
}

void Device::end(VkCommandBuffer commands) const {
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
}

void Device::run(VkCommandBuffer commands) const {
  auto submit = structure<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
  check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
}

void Device::free(VkCommandBuffer commands) const {
  vkFreeCommandBuffers(device_, pool_.get(), 1, &commands);
}

Handle<VkDeviceMemory> Device::allocate(const VkMemoryRequirements& needs) const {
  constexpr VkMemoryPropertyFlags kShared = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  VkPhysicalDeviceMemoryProperties memory = {};
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    const bool allowed = needs.memoryTypeBits >> i & 1u;
    if (!allowed || (memory.memoryTypes[i].propertyFlags & kShared) != kShared) continue;
    auto info = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = needs.size;
    info.memoryTypeIndex = i;
    return make(device_, info, vkAllocateMemory, vkFreeMemory, "vkAllocateMemory");
  }
  throw std::runtime_error("lavapipe: no memory that the host sees");
}

}  // namespace shd::bench::gpu
