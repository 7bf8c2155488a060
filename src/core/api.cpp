// SPDX-License-Identifier: MIT
//
// The C boundary: arguments are checked, exceptions end here.
#include <cstring>
#include <new>
#include <string>

#include "core/context.h"
#include "core/error.h"
#include "core/requirements.h"
#include "reprise/reprise.h"

struct RepriseContext_T : reprise::Context {
  using reprise::Context::Context;
};

namespace {

using reprise::Error;
using reprise::fail;

// Runs `work`; every failure becomes a code and one message to `report`.
template <typename Report, typename Work>
RepriseResult guarded(const char* call, const Report& report, const Work& work) {
  try {
    work();
    return REPRISE_SUCCESS;
  } catch (const Error& error) {
    report(std::string(call) + ": " + error.text);
    return error.result;
  } catch (const std::bad_alloc&) {
    report(std::string(call) + ": out of host memory");
    return REPRISE_ERROR_OUT_OF_MEMORY;
  } catch (...) {
    report(std::string(call) + ": internal error");
    return REPRISE_ERROR_DEVICE;
  }
}

template <typename Work>
RepriseResult guarded(const char* call, RepriseContext context, const Work& work) {
  if (context == nullptr) return REPRISE_ERROR_INVALID_ARGUMENT;
  return guarded(
      call, [&](const std::string& text) { context->report(REPRISE_MESSAGE_ERROR, text); }, work);
}

void require(bool holds, const char* message) {
  if (!holds) fail(REPRISE_ERROR_INVALID_ARGUMENT, message);
}

// A C host may have put any number there, which an enumeration may not hold.
bool isDepthKind(const RepriseDepthKind& kind) {
  static_assert(sizeof(RepriseDepthKind) == sizeof(int));
  int value;
  std::memcpy(&value, &kind, sizeof(value));
  return value >= REPRISE_DEPTH_DEVICE && value <= REPRISE_DEPTH_ORTHOGRAPHIC;
}

void checkContextInfo(const RepriseContextInfo& info) {
  require(info.size == sizeof(RepriseContextInfo), "info.size must be sizeof(RepriseContextInfo)");
  require(info.instance != VK_NULL_HANDLE, "info.instance is null");
  require(info.physical_device != VK_NULL_HANDLE, "info.physical_device is null");
  require(info.device != VK_NULL_HANDLE, "info.device is null");
  require(info.get_instance_proc_addr != nullptr, "info.get_instance_proc_addr is null");
  require(info.technique != nullptr, "info.technique is null");
  require(info.setting_count == 0 || info.settings != nullptr, "info.settings is null");
  require(info.frames_in_flight >= 1 && info.frames_in_flight <= 8,
          "info.frames_in_flight must be in [1, 8]");
  require(isDepthKind(info.depth_kind), "info.depth_kind is not a RepriseDepthKind");
  require((info.flags & ~uint32_t{REPRISE_CONTEXT_MOTION_INCLUDES_JITTER}) == 0,
          "info.flags has an unknown bit");
}

}  // namespace

extern "C" {

uint32_t repriseGetTechniqueCount(void) {
  return static_cast<uint32_t>(reprise::techniqueList().size());
}

const RepriseTechniqueInfo* repriseGetTechnique(uint32_t index) {
  const auto list = reprise::techniqueList();
  return index < list.size() ? list[index].info : nullptr;
}

const RepriseTechniqueInfo* repriseFindTechnique(const char* name) {
  const reprise::TechniqueEntry* entry = name != nullptr ? reprise::findTechnique(name) : nullptr;
  return entry != nullptr ? entry->info : nullptr;
}

#define REPRISE_TEXT_(x) #x
#define REPRISE_TEXT(x) REPRISE_TEXT_(x)
const char* repriseGetVersion(void) {
  return REPRISE_TEXT(REPRISE_VERSION_MAJOR) "." REPRISE_TEXT(
      REPRISE_VERSION_MINOR) "." REPRISE_TEXT(REPRISE_VERSION_PATCH);
}

const char* repriseResultText(RepriseResult result) {
  switch (result) {
    case REPRISE_SUCCESS:
      return "success";
    case REPRISE_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case REPRISE_ERROR_UNSUPPORTED:
      return "unsupported";
    case REPRISE_ERROR_NOT_PREPARED:
      return "not prepared";
    case REPRISE_ERROR_OUT_OF_MEMORY:
      return "out of memory";
    case REPRISE_ERROR_DEVICE:
      return "device error";
  }
  return "unknown result";
}

RepriseResult repriseGetRequirements(const char* technique, VkInstance instance,
                                     VkPhysicalDevice physical_device,
                                     PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                                     RepriseRequirements* requirements) {
  if (requirements == nullptr || requirements->size != sizeof(RepriseRequirements) ||
      repriseFindTechnique(technique) == nullptr) {
    return REPRISE_ERROR_INVALID_ARGUMENT;
  }
  return guarded(
      "repriseGetRequirements", [](const std::string&) {},
      [&] {
        reprise::describeRequirements(*requirements);
        if (physical_device == VK_NULL_HANDLE) return;
        require(instance != VK_NULL_HANDLE && get_instance_proc_addr != nullptr,
                "instance and get_instance_proc_addr are needed to check a device");
        reprise::checkDevice(instance, physical_device, get_instance_proc_addr, *requirements);
      });
}

RepriseResult repriseCreateContext(const RepriseContextInfo* info, RepriseContext* context) {
  if (info == nullptr || context == nullptr) return REPRISE_ERROR_INVALID_ARGUMENT;
  *context = nullptr;
  if (info->size != sizeof(RepriseContextInfo)) return REPRISE_ERROR_INVALID_ARGUMENT;
  return guarded(
      "repriseCreateContext",
      [&](const std::string& text) {
        if (info->message_callback != nullptr) {
          info->message_callback(REPRISE_MESSAGE_ERROR, text.c_str(), info->message_user);
        }
      },
      [&] {
        checkContextInfo(*info);
        *context = new RepriseContext_T(*info);
      });
}

void repriseDestroyContext(RepriseContext context) {
  delete context;
}

RepriseResult repriseSetSettings(RepriseContext context, const RepriseSettingValue* values,
                                 uint32_t count) {
  return guarded("repriseSetSettings", context, [&] {
    require(count == 0 || values != nullptr, "values is null");
    context->setSettings(values, count);
  });
}

RepriseResult repriseGetSetting(RepriseContext context, const char* name, double* value) {
  return guarded("repriseGetSetting", context, [&] {
    require(value != nullptr, "value is null");
    *value = context->getSetting(name);
  });
}

RepriseResult repriseHoldFrameTime(RepriseContext context, double measured_s, double target_s) {
  return guarded("repriseHoldFrameTime", context, [&] {
    // Written so that a NaN fails too.
    const auto sensible = [](double time_s) { return time_s > 0.0 && time_s < 10.0; };
    require(sensible(measured_s), "measured_s must be in (0, 10) seconds");
    require(sensible(target_s), "target_s must be in (0, 10) seconds");
    context->holdFrameTime(measured_s, target_s);
  });
}

RepriseResult repriseResize(RepriseContext context, VkExtent2D max_input_extent,
                            VkExtent2D max_output_extent) {
  return guarded("repriseResize", context,
                 [&] { context->resize(max_input_extent, max_output_extent); });
}

RepriseResult reprisePrepare(RepriseContext context) {
  return guarded("reprisePrepare", context, [&] { context->prepare(); });
}

RepriseResult repriseReset(RepriseContext context) {
  return guarded("repriseReset", context, [&] { context->reset(); });
}

RepriseResult repriseGetSamplePlan(RepriseContext context, uint64_t frame_index,
                                   RepriseSamplePlan* plan) {
  return guarded("repriseGetSamplePlan", context, [&] {
    require(plan != nullptr, "plan is null");
    require(plan->size == sizeof(RepriseSamplePlan), "plan.size must be sizeof(RepriseSamplePlan)");
    context->plan(frame_index, {}, {}, *plan);
  });
}

RepriseResult repriseGetSamplePlanAt(RepriseContext context, uint64_t frame_index,
                                     VkExtent2D input_extent, VkExtent2D output_extent,
                                     RepriseSamplePlan* plan) {
  return guarded("repriseGetSamplePlanAt", context, [&] {
    require(plan != nullptr, "plan is null");
    require(plan->size == sizeof(RepriseSamplePlan), "plan.size must be sizeof(RepriseSamplePlan)");
    context->plan(frame_index, input_extent, output_extent, *plan);
  });
}

RepriseResult repriseGetSampleRequests(RepriseContext context, RepriseSampleRequests* requests) {
  return guarded("repriseGetSampleRequests", context, [&] {
    require(requests != nullptr, "requests is null");
    require(requests->size == sizeof(RepriseSampleRequests),
            "requests.size must be sizeof(RepriseSampleRequests)");
    context->sampleRequests(*requests);
  });
}

RepriseResult repriseRecordRequest(RepriseContext context, VkCommandBuffer commands,
                                   const RepriseFrame* frame) {
  return guarded("repriseRecordRequest", context, [&] {
    require(commands != VK_NULL_HANDLE, "commands is null");
    require(frame != nullptr, "frame is null");
    context->recordRequest(commands, *frame);
  });
}

RepriseResult repriseRecord(RepriseContext context, VkCommandBuffer commands,
                            const RepriseFrame* frame) {
  return guarded("repriseRecord", context, [&] {
    require(commands != VK_NULL_HANDLE, "commands is null");
    require(frame != nullptr, "frame is null");
    context->record(commands, *frame);
  });
}

uint32_t repriseGetPassCount(RepriseContext context) {
  return context != nullptr ? context->passCount() : 0;
}

const char* repriseGetPassName(RepriseContext context, uint32_t index) {
  return context != nullptr ? context->passName(index) : nullptr;
}

RepriseResult repriseGetMemory(RepriseContext context, RepriseMemoryItem* items, uint32_t capacity,
                               uint32_t* count) {
  return guarded("repriseGetMemory", context, [&] {
    require(count != nullptr, "count is null");
    require(capacity == 0 || items != nullptr, "items is null");
    *count = context->memory(items, capacity);
  });
}

}  // extern "C"
