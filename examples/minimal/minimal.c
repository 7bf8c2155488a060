// SPDX-License-Identifier: MIT
//
// The smallest host: a device, frames of a tilted edge sampled once a pixel, and Reprise's
// `reprise` that turns them into an antialiased image. Prints one row of it; exits 0 if the edge
// came out smooth.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

#include "reprise/reprise.h"

enum { kWidth = 64, kHeight = 32, kFrames = 64, kTexels = kWidth * kHeight };

#define CHECK(call)                                         \
  do {                                                      \
    int check_result = (int)(call);                         \
    if (check_result != 0) {                                \
      fprintf(stderr, "%s gave %d\n", #call, check_result); \
      exit(1);                                              \
    }                                                       \
  } while (0)

static VkPhysicalDevice gpu;
static VkDevice device;

static VkDeviceMemory allocate(VkMemoryRequirements needs, VkMemoryPropertyFlags flags) {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(gpu, &memory);
  uint32_t type = 0;
  while (!(needs.memoryTypeBits & (1u << type)) ||
         (memory.memoryTypes[type].propertyFlags & flags) != flags) {
    ++type;
  }
  VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, NULL, needs.size, type};
  VkDeviceMemory result;
  CHECK(vkAllocateMemory(device, &info, NULL, &result));
  return result;
}

typedef struct Image {
  VkImage handle;
  VkDeviceMemory memory;
  VkImageView view;
} Image;

static Image createImage(VkFormat format, VkImageUsageFlags usage) {
  Image image;
  VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = (VkExtent3D){kWidth, kHeight, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = usage;
  CHECK(vkCreateImage(device, &info, NULL, &image.handle));
  VkMemoryRequirements needs;
  vkGetImageMemoryRequirements(device, image.handle, &needs);
  image.memory = allocate(needs, 0);
  CHECK(vkBindImageMemory(device, image.handle, image.memory, 0));
  VkImageViewCreateInfo view = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image.handle;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = (VkImageSubresourceRange){VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  CHECK(vkCreateImageView(device, &view, NULL, &image.view));
  return image;
}

static void barrier(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
  VkImageMemoryBarrier info = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  info.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  info.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  info.oldLayout = from;
  info.newLayout = to;
  info.srcQueueFamilyIndex = info.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  info.image = image;
  info.subresourceRange = (VkImageSubresourceRange){VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, NULL, 0, NULL, 1, &info);
}

static void printMessage(RepriseMessageSeverity severity, const char* text, void* user) {
  (void)user;
  fprintf(stderr, "reprise %d: %s\n", (int)severity, text);
}

int main(void) {
  // A device that meets the library's requirements.
  VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo instance_info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  instance_info.pApplicationInfo = &application;
  VkInstance instance;
  CHECK(vkCreateInstance(&instance_info, NULL, &instance));
  uint32_t one = 1;
  vkEnumeratePhysicalDevices(instance, &one, &gpu);
  RepriseRequirements requirements = {sizeof(requirements)};
  CHECK(repriseGetRequirements("reprise", instance, gpu, vkGetInstanceProcAddr, &requirements));
  float priority = 1.0f;
  VkDeviceQueueCreateInfo queue_info = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue_info.queueCount = 1;  // of family 0
  queue_info.pQueuePriorities = &priority;
  VkDeviceCreateInfo device_info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  device_info.queueCreateInfoCount = 1;
  device_info.pQueueCreateInfos = &queue_info;
  device_info.pEnabledFeatures = &requirements.features;
  CHECK(vkCreateDevice(gpu, &device_info, NULL, &device));
  VkQueue queue;
  vkGetDeviceQueue(device, 0, 0, &queue);

  // What a renderer has: colour, depth, motion, and an image for the result.
  const VkImageUsageFlags in = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  const VkImageUsageFlags out = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  Image images[4] = {
      createImage(VK_FORMAT_R32G32B32A32_SFLOAT, in), createImage(VK_FORMAT_R32_SFLOAT, in),
      createImage(VK_FORMAT_R32G32_SFLOAT, in), createImage(VK_FORMAT_R32G32B32A32_SFLOAT, out)};
  VkBufferCreateInfo buffer_info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  buffer_info.size = kTexels * 48;  // in: colour 16, depth 4, motion 8 bytes a texel; out at 32
  buffer_info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  VkBuffer buffer;
  CHECK(vkCreateBuffer(device, &buffer_info, NULL, &buffer));
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device, buffer, &needs);
  VkDeviceMemory buffer_memory =
      allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  CHECK(vkBindBufferMemory(device, buffer, buffer_memory, 0));
  float* texels;
  CHECK(vkMapMemory(device, buffer_memory, 0, VK_WHOLE_SIZE, 0, (void**)&texels));
  memset(texels, 0, kTexels * 48);

  VkCommandPoolCreateInfo pool_info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, NULL,
                                       VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, 0};
  VkCommandPool pool;
  CHECK(vkCreateCommandPool(device, &pool_info, NULL, &pool));
  VkCommandBufferAllocateInfo commands_info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, NULL,
                                               pool, VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
  VkCommandBuffer commands;
  CHECK(vkAllocateCommandBuffers(device, &commands_info, &commands));

  // [embed] Once a view:
  RepriseContextInfo info = {sizeof(info)};
  info.instance = instance;
  info.physical_device = gpu;
  info.device = device;
  info.get_instance_proc_addr = vkGetInstanceProcAddr;
  info.technique = "reprise";
  info.max_input_extent = (VkExtent2D){kWidth, kHeight};
  info.frames_in_flight = 1;
  info.depth_kind = REPRISE_DEPTH_PLANAR;
  info.message_callback = printMessage;
  RepriseContext context;
  CHECK(repriseCreateContext(&info, &context));
  CHECK(reprisePrepare(context));

  for (uint64_t frame_index = 0; frame_index < kFrames; ++frame_index) {
    // [embed] Every frame: ask how to sample it, render it so ...
    RepriseSamplePlan plan = {sizeof(plan)};
    CHECK(repriseGetSamplePlan(context, frame_index, &plan));
    for (int i = 0; i < kTexels; ++i) {
      const float x = (float)(i % kWidth) + 0.5f - plan.jitter_px[0];
      const float y = (float)(i / kWidth) + 0.5f - plan.jitter_px[1];
      const float light = x + 0.3f * y > 35.3f ? 1.0f : 0.0f;  // the scene: a tilted edge
      for (int c = 0; c < 3; ++c) texels[4 * i + c] = light;
      texels[4 * kTexels + i] = 10.0f;  // view depth; motion after it stays 0
    }

    VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    CHECK(vkBeginCommandBuffer(commands, &begin));
    const VkDeviceSize offsets[4] = {0, kTexels * 16, kTexels * 20, kTexels * 32};
    VkBufferImageCopy copy = {0};
    copy.imageSubresource = (VkImageSubresourceLayers){VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.imageExtent = (VkExtent3D){kWidth, kHeight, 1};
    for (int i = 0; i < 4; ++i) {
      barrier(commands, images[i].handle, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
      copy.bufferOffset = offsets[i];  // the last one stays for the copy back
      if (i == 3) continue;
      vkCmdCopyBufferToImage(commands, buffer, images[i].handle, VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
      barrier(commands, images[i].handle, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
    }

    // [embed] ... and record the resolve into your command buffer.
    RepriseFrame frame = {sizeof(frame)};
    frame.frame_index = frame_index;
    frame.color = (RepriseImage){images[0].view, {kWidth, kHeight}, VK_IMAGE_LAYOUT_GENERAL};
    frame.depth = (RepriseImage){images[1].view, {kWidth, kHeight}, VK_IMAGE_LAYOUT_GENERAL};
    frame.motion = (RepriseImage){images[2].view, {kWidth, kHeight}, VK_IMAGE_LAYOUT_GENERAL};
    frame.output = (RepriseImage){images[3].view, {kWidth, kHeight}, VK_IMAGE_LAYOUT_GENERAL};
    frame.jitter_px[0] = plan.jitter_px[0];
    frame.jitter_px[1] = plan.jitter_px[1];
    frame.motion_scale[0] = frame.motion_scale[1] = 1.0f;
    frame.pre_exposure = 1.0f;
    frame.frame_time_s = 1.0f / 60.0f;
    frame.reset = frame_index == 0;
    CHECK(repriseRecord(context, commands, &frame));
    // [embed] end

    barrier(commands, images[3].handle, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
    vkCmdCopyImageToBuffer(commands, images[3].handle, VK_IMAGE_LAYOUT_GENERAL, buffer, 1, &copy);
    CHECK(vkEndCommandBuffer(commands));
    VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &commands;
    CHECK(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE));
    CHECK(vkQueueWaitIdle(queue));
  }

  // The edge crosses row 16 between x = 29 and 32; its pixels must have become shades.
  const float* row = texels + 8 * kTexels + 4 * 16 * kWidth;
  int shades = 0;
  for (int x = 27; x < 35; ++x) {
    printf("%.3f ", (double)row[4 * x]);
    shades += row[4 * x] > 0.05f && row[4 * x] < 0.95f;
  }
  printf("\n%d pixels of row 16 lie between dark and light\n", shades);

  repriseDestroyContext(context);
  for (int i = 0; i < 4; ++i) {
    vkDestroyImageView(device, images[i].view, NULL);
    vkDestroyImage(device, images[i].handle, NULL);
    vkFreeMemory(device, images[i].memory, NULL);
  }
  vkDestroyBuffer(device, buffer, NULL);
  vkFreeMemory(device, buffer_memory, NULL);
  vkDestroyCommandPool(device, pool, NULL);
  vkDestroyDevice(device, NULL);
  vkDestroyInstance(instance, NULL);
  return shades >= 1 && shades <= 3 ? 0 : 1;
}
