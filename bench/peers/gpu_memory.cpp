// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "gpu.h"

namespace shd::bench::gpu {
namespace {

/// Moves all levels from one layout to another one.
void move(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to, VkAccessFlags access) {
  auto barrier = structure<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
  barrier.dstAccessMask = access;
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr,
                       0, nullptr, 1, &barrier);
}

}  // namespace

Buffer::Buffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage) {
  auto info = structure<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = size;
  info.usage = usage;
  buffer_ = make(device.get(), info, vkCreateBuffer, vkDestroyBuffer, "vkCreateBuffer");
  VkMemoryRequirements needs = {};
  vkGetBufferMemoryRequirements(device.get(), buffer_.get(), &needs);
  memory_ = device.allocate(needs);
  check(vkBindBufferMemory(device.get(), buffer_.get(), memory_.get(), 0), "vkBindBufferMemory");
  check(vkMapMemory(device.get(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
}

Texture::Texture(const Device& device, const std::vector<std::vector<uint8_t>>& levels) {
  const auto count = static_cast<uint32_t>(levels.size());
  const auto edge = static_cast<uint32_t>(std::lround(std::sqrt(static_cast<double>(levels[0].size() / 4))));
  VkDeviceSize size = 0;
  for (const std::vector<uint8_t>& level : levels) size += level.size();
  const Buffer staging(device, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  auto* to = staging.data<uint8_t>();
  for (const std::vector<uint8_t>& level : levels) to = std::copy(level.begin(), level.end(), to);
  make_image(device, edge, count);
  upload(device, staging, edge, count);
}

void Texture::make_image(const Device& device, uint32_t edge, uint32_t levels) {
  auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.extent = {edge, edge, 1};
  info.mipLevels = levels;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  image_ = make(device.get(), info, vkCreateImage, vkDestroyImage, "vkCreateImage");
  VkMemoryRequirements needs = {};
  vkGetImageMemoryRequirements(device.get(), image_.get(), &needs);
  memory_ = device.allocate(needs);
  check(vkBindImageMemory(device.get(), image_.get(), memory_.get(), 0), "vkBindImageMemory");
  auto view = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
  view.image = image_.get();
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = info.format;
  view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, levels, 0, 1};
  view_ = make(device.get(), view, vkCreateImageView, vkDestroyImageView, "vkCreateImageView");
}

void Texture::upload(const Device& device, const Buffer& staging, uint32_t edge, uint32_t levels) const {
  std::vector<VkBufferImageCopy> copies;
  VkDeviceSize offset = 0;
  for (uint32_t level = 0; level < levels; ++level) {
    const uint32_t size = edge >> level;
    VkBufferImageCopy copy = {};
    copy.bufferOffset = offset;
    copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
    copy.imageExtent = {size, size, 1};
    copies.push_back(copy);
    offset += VkDeviceSize{size} * size * 4;
  }
  VkCommandBuffer commands = device.begin();
  constexpr VkImageLayout kWritten = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  constexpr VkImageLayout kRead = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  move(commands, image_.get(), VK_IMAGE_LAYOUT_UNDEFINED, kWritten, VK_ACCESS_TRANSFER_WRITE_BIT);
  vkCmdCopyBufferToImage(commands, staging.get(), image_.get(), kWritten, levels, copies.data());
  move(commands, image_.get(), kWritten, kRead, VK_ACCESS_SHADER_READ_BIT);
  device.end(commands);
  device.run(commands);
  device.free(commands);
}

}  // namespace shd::bench::gpu
