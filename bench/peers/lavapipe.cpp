// SPDX-License-Identifier: MIT
// Lookups as a compute shader of Mesa's lavapipe: columns of floats in, RGBA floats out.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gpu.h"
#include "lavapipe_implicit.h"
#include "lavapipe_shader.h"
#include "peers.h"

namespace shd::bench {
namespace {

constexpr uint32_t kGroup = 256;         // invocations of a work group, as in lavapipe.comp
constexpr uint32_t kMostGroups = 65535;  // every implementation of Vulkan has as many
constexpr uint32_t kColumns = 6;

/// A device for all passes that live at one time.
std::shared_ptr<const gpu::Device> shared_device() {
  static std::weak_ptr<const gpu::Device> last;
  std::shared_ptr<const gpu::Device> device = last.lock();
  if (!device) last = device = std::make_shared<const gpu::Device>();
  return device;
}

/// sum / area, rounded to the nearest integer, ties to even. `area` is even.
uint8_t rounded_mean(uint64_t sum, uint64_t area) {
  const uint64_t down = sum / area, rest = sum % area;
  return static_cast<uint8_t>(down + (rest > area / 2 || (rest == area / 2 && down % 2 == 1)));
}

/// All levels of a texture, whose texels are means of base texels, rounded as those of shd.
std::vector<std::vector<uint8_t>> make_levels(uint32_t edge, const std::vector<uint8_t>& texels) {
  std::vector<std::vector<uint8_t>> levels = {texels};
  std::vector<uint64_t> sums(texels.begin(), texels.end());
  for (uint64_t area = 4; edge > 1; area *= 4) {
    const size_t row = size_t{edge} * 4;
    edge /= 2;
    std::vector<uint64_t> half;
    std::vector<uint8_t> level;
    half.reserve(sums.size() / 4);
    for (size_t i = 0; i < size_t{edge} * edge * 4; ++i) {
      const uint64_t* corner = &sums[i / (row / 2) * 2 * row + i % (row / 2) / 4 * 8 + i % 4];
      half.push_back(corner[0] + corner[4] + corner[row] + corner[row + 4]);
      level.push_back(rounded_mean(half.back(), area));
    }
    sums = std::move(half);
    levels.push_back(std::move(level));
  }
  return levels;
}

VkSamplerCreateInfo sampler_info(PeerFilter filter) {
  const bool nearest = filter == PeerFilter::kNearest || filter == PeerFilter::kNearestMip;
  const bool blended = filter == PeerFilter::kTrilinear || filter == PeerFilter::kAnisotropic16;
  auto info = gpu::structure<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
  info.minFilter = info.magFilter = nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
  info.mipmapMode = blended ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
  info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_REPEAT;
  info.anisotropyEnable = filter == PeerFilter::kAnisotropic16;
  info.maxAnisotropy = 16.0f;
  info.maxLod = VK_LOD_CLAMP_NONE;
  return info;
}

/// The given levels, or levels of the base texels.
std::vector<std::vector<uint8_t>> levels_of(uint32_t edge, const std::vector<uint8_t>& texels) {
  if (!has_levels(edge, texels)) return make_levels(edge, texels);
  std::vector<std::vector<uint8_t>> levels;
  auto from = texels.begin();
  for (uint32_t size = edge; from != texels.end(); size = std::max(size / 2, 1u)) {
    const auto end = from + static_cast<ptrdiff_t>(size_t{size} * size * 4);
    levels.emplace_back(from, end);
    from = end;
  }
  return levels;
}

/// The shader for one filter, with the layout of its arguments.
class Program {
 public:
  /// The lookups have `invocations` each, and implicit derivatives or their own.
  Program(VkDevice device, PeerFilter filter, uint32_t invocations, bool implicit) {
    const VkSamplerCreateInfo sampler = sampler_info(filter);
    sampler_ = gpu::make(device, sampler, vkCreateSampler, vkDestroySampler, "vkCreateSampler");
    make_layout(device);
    make_pipeline(device, invocations, filter != PeerFilter::kNearest && filter != PeerFilter::kBilinear, implicit);
  }
  VkSampler sampler() const { return sampler_.get(); }
  VkDescriptorSetLayout set_layout() const { return set_layout_.get(); }
  VkPipelineLayout layout() const { return layout_.get(); }
  VkPipeline pipeline() const { return pipeline_.get(); }

 private:
  void make_layout(VkDevice device);
  void make_pipeline(VkDevice device, uint32_t invocations, bool levels, bool implicit);

  gpu::Handle<VkSampler> sampler_;
  gpu::Handle<VkDescriptorSetLayout> set_layout_;
  gpu::Handle<VkPipelineLayout> layout_;
  gpu::Handle<VkPipeline> pipeline_;
};

void Program::make_layout(VkDevice device) {
  VkDescriptorSetLayoutBinding bindings[3] = {};
  for (uint32_t i = 0; i < 3; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = i ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  auto set = gpu::structure<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  set.bindingCount = 3;
  set.pBindings = bindings;
  set_layout_ =
      gpu::make(device, set, vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout, "vkCreateDescriptorSetLayout");
  const VkPushConstantRange count = {VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(uint32_t)};
  const VkDescriptorSetLayout sets[] = {set_layout_.get()};
  auto info = gpu::structure<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  info.setLayoutCount = 1;
  info.pSetLayouts = sets;
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &count;
  layout_ = gpu::make(device, info, vkCreatePipelineLayout, vkDestroyPipelineLayout, "vkCreatePipelineLayout");
}

void Program::make_pipeline(VkDevice device, uint32_t invocations, bool levels, bool implicit) {
  auto code = gpu::structure<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  code.codeSize = implicit ? sizeof kLavapipeImplicit : sizeof kLavapipeShader;
  code.pCode = implicit ? kLavapipeImplicit : kLavapipeShader;
  const auto shader = gpu::make(device, code, vkCreateShaderModule, vkDestroyShaderModule, "vkCreateShaderModule");
  const uint32_t constants[2] = {invocations, levels ? VK_TRUE : VK_FALSE};
  const VkSpecializationMapEntry entries[2] = {{0, 0, sizeof(uint32_t)}, {1, sizeof(uint32_t), sizeof(uint32_t)}};
  const VkSpecializationInfo special = {2, entries, sizeof constants, constants};
  auto info = gpu::structure<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader.get();
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &special;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  gpu::check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
             "vkCreateComputePipelines");
  pipeline_ = gpu::Handle<VkPipeline>(device, pipeline, vkDestroyPipeline);
}

/// The anisotropic filter of Mesa 22 takes its axes from differences between 2 x 2 neighbouring invocations, although
/// the shader gives it derivatives, and one size of the level for all invocations of a vector. So each of its lookups
/// has a vector of invocations, at its point and at its differences. Mesa 25 filters lookups with explicit derivatives
/// trilinearly, but its compute shaders have implicit ones.
uint32_t invocations_of(PeerFilter filter, const gpu::Device& device) {
  return filter == PeerFilter::kAnisotropic16 ? device.vector_size() : 1;
}

uint32_t work_groups(size_t lookups, uint32_t invocations) {
  const uint64_t groups = (uint64_t{lookups} * invocations + kGroup - 1) / kGroup;
  if (groups >= 1 && groups <= kMostGroups) return static_cast<uint32_t>(groups);
  throw std::runtime_error("lavapipe: lookups.count: " + std::to_string(lookups) + " is not in 1.." +
                           std::to_string(uint64_t{kMostGroups} * kGroup / invocations));
}

class LavapipePass final : public Peer {
 public:
  LavapipePass(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels, PeerFilter filter)
      : lookups_(lookups),
        device_(shared_device()),
        invocations_(invocations_of(filter, *device_)),
        groups_(work_groups(lookups.count(), invocations_)),
        program_(device_->get(), filter, invocations_, invocations_ > 1 && device_->has_derivatives()),
        texture_(*device_, levels_of(edge, texels)),
        columns_(*device_, lookups.count() * kColumns * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT),
        results_(*device_, lookups.count() * 4 * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT),
        count_(static_cast<uint32_t>(lookups.count())) {
    refresh();
    make_set();
    record();
  }
  ~LavapipePass() override { device_->free(commands_); }
  LavapipePass(const LavapipePass&) = delete;
  LavapipePass& operator=(const LavapipePass&) = delete;

  void refresh() override {
    auto* to = columns_.data<float>();
    const Lookups& q = lookups_;
    for (const std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) {
      to = std::copy(column->begin(), column->end(), to);
    }
  }
  void run() override { device_->run(commands_); }
  uint32_t copies() const override { return invocations_; }
  std::vector<float> image() override {
    return std::vector<float>(results_.data<float>(), results_.data<float>() + size_t{count_} * 4);
  }

 private:
  void make_set();
  void record();

  const Lookups& lookups_;
  std::shared_ptr<const gpu::Device> device_;
  uint32_t invocations_, groups_;
  Program program_;
  gpu::Texture texture_;
  gpu::Buffer columns_, results_;
  uint32_t count_;
  gpu::Handle<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

void LavapipePass::make_set() {
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2}};
  auto pool = gpu::structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
  pool.maxSets = 1;
  pool.poolSizeCount = 2;
  pool.pPoolSizes = sizes;
  pool_ = gpu::make(device_->get(), pool, vkCreateDescriptorPool, vkDestroyDescriptorPool, "vkCreateDescriptorPool");
  const VkDescriptorSetLayout layouts[] = {program_.set_layout()};
  auto info = gpu::structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  info.descriptorPool = pool_.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = layouts;
  gpu::check(vkAllocateDescriptorSets(device_->get(), &info, &set_), "vkAllocateDescriptorSets");
  const VkDescriptorImageInfo image = {program_.sampler(), texture_.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorBufferInfo buffers[] = {{columns_.get(), 0, VK_WHOLE_SIZE}, {results_.get(), 0, VK_WHOLE_SIZE}};
  auto texture = gpu::structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
  texture.dstSet = set_;
  texture.descriptorCount = 1;
  texture.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  texture.pImageInfo = &image;
  auto arrays = gpu::structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
  arrays.dstSet = set_;
  arrays.dstBinding = 1;
  arrays.descriptorCount = 2;  // they fill bindings 1 and 2
  arrays.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  arrays.pBufferInfo = buffers;
  const VkWriteDescriptorSet writes[] = {texture, arrays};
  vkUpdateDescriptorSets(device_->get(), 2, writes, 0, nullptr);
}

void LavapipePass::record() {
  commands_ = device_->begin();
  vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, program_.pipeline());
  vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, program_.layout(), 0, 1, &set_, 0, nullptr);
  vkCmdPushConstants(commands_, program_.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof count_, &count_);
  vkCmdDispatch(commands_, groups_, 1, 1);
  auto barrier = gpu::structure<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
  vkCmdPipelineBarrier(commands_, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0,
                       nullptr, 0, nullptr);
  device_->end(commands_);
}

/// Filters one texel; throws where the device or its compiler does not work.
void try_lookup() {
  Lookups q;
  for (std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) column->assign(1, 0.25f);
  LavapipePass pass(q, 1, {255, 0, 51, 255}, PeerFilter::kTrilinear);
  pass.run();
  const float want[] = {1.0f, 0.0f, 0.2f, 1.0f};
  for (size_t c = 0; c < 4; ++c) {
    if (std::fabs(pass.image()[c] - want[c]) < 1e-3f) continue;
    throw std::runtime_error("lavapipe: a texture of one texel is filtered wrongly");
  }
}

}  // namespace

std::string lavapipe_problem() {
  static const std::string problem = [] {
    try {
      try_lookup();
      return std::string();
    } catch (const std::exception& e) {
      return std::string(e.what());
    }
  }();
  return problem;
}

std::string lavapipe_description() {
  return shared_device()->description();
}

std::unique_ptr<Peer> make_lavapipe(const Lookups& lookups, uint32_t edge, const std::vector<uint8_t>& texels,
                                    PeerFilter filter) {
  return std::make_unique<LavapipePass>(lookups, edge, texels, filter);
}

}  // namespace shd::bench
