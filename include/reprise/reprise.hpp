// SPDX-License-Identifier: MIT
//
// C++ wrapper of reprise.h: ownership and exceptions, nothing else. Conventions, layouts and units
// are those of reprise.h.
#ifndef REPRISE_REPRISE_HPP
#define REPRISE_REPRISE_HPP

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reprise/reprise.h"

namespace reprise {

class ApiError : public std::runtime_error {
 public:
  ApiError(RepriseResult code, const std::string& text) : std::runtime_error(text), result(code) {}
  RepriseResult result;
};

// A context that is destroyed with its owner. Every call throws ApiError, with the library's
// message, where the C call returns an error.
class OwnedContext {
 public:
  using MessageHandler = std::function<void(RepriseMessageSeverity, const std::string&)>;

  // The message callback of `info` is replaced; `handler` receives messages that are no errors.
  explicit OwnedContext(RepriseContextInfo info, MessageHandler handler = {})
      : messages_(std::make_unique<Messages>()) {
    messages_->handler = std::move(handler);
    info.size = sizeof(info);
    info.message_callback = &OwnedContext::receive;
    info.message_user = messages_.get();
    check(repriseCreateContext(&info, &context_));
  }
  ~OwnedContext() { repriseDestroyContext(context_); }
  OwnedContext(OwnedContext&& other) noexcept
      : messages_(std::move(other.messages_)), context_(std::exchange(other.context_, nullptr)) {}
  OwnedContext& operator=(OwnedContext&& other) noexcept {
    std::swap(messages_, other.messages_);
    std::swap(context_, other.context_);
    return *this;
  }

  RepriseContext handle() const { return context_; }

  void prepare() { check(reprisePrepare(context_)); }
  void reset() { check(repriseReset(context_)); }
  void resize(VkExtent2D max_input, VkExtent2D max_output = {}) {
    check(repriseResize(context_, max_input, max_output));
  }
  void set(const char* name, double value) {
    const RepriseSettingValue setting{name, value, nullptr};
    check(repriseSetSettings(context_, &setting, 1));
  }
  void set(const char* name, const char* text) {
    const RepriseSettingValue setting{name, 0.0, text};
    check(repriseSetSettings(context_, &setting, 1));
  }
  double get(const char* name) const {
    double value = 0.0;
    check(repriseGetSetting(context_, name, &value));
    return value;
  }
  // Extents {0, 0}: the maximum.
  RepriseSamplePlan plan(uint64_t frame_index, VkExtent2D input_extent = {},
                         VkExtent2D output_extent = {}) const {
    RepriseSamplePlan plan{};
    plan.size = sizeof(plan);
    check(repriseGetSamplePlanAt(context_, frame_index, input_extent, output_extent, &plan));
    return plan;
  }
  void recordRequest(VkCommandBuffer commands, RepriseFrame frame) {
    frame.size = sizeof(frame);
    check(repriseRecordRequest(context_, commands, &frame));
  }
  // A null buffer where the technique, as it is set, requests nothing.
  RepriseSampleRequests sampleRequests() const {
    RepriseSampleRequests requests{};
    requests.size = sizeof(requests);
    const RepriseResult result = repriseGetSampleRequests(context_, &requests);
    if (result == REPRISE_ERROR_UNSUPPORTED) {
      messages_->last_error.clear();
    } else {
      check(result);
    }
    return requests;
  }
  void record(VkCommandBuffer commands, RepriseFrame frame) {
    frame.size = sizeof(frame);
    check(repriseRecord(context_, commands, &frame));
  }
  std::vector<RepriseMemoryItem> memory() const {
    uint32_t count = 0;
    check(repriseGetMemory(context_, nullptr, 0, &count));
    std::vector<RepriseMemoryItem> items(count);
    check(repriseGetMemory(context_, items.data(), count, &count));
    return items;
  }
  std::vector<std::string> passNames() const {
    std::vector<std::string> names;
    for (uint32_t i = 0; i < repriseGetPassCount(context_); ++i) {
      names.emplace_back(repriseGetPassName(context_, i));
    }
    return names;
  }

 private:
  struct Messages {
    MessageHandler handler;
    std::string last_error;
  };
  static void receive(RepriseMessageSeverity severity, const char* text, void* user) {
    auto* messages = static_cast<Messages*>(user);
    if (severity == REPRISE_MESSAGE_ERROR) {
      messages->last_error = text;
    } else if (messages->handler) {
      messages->handler(severity, text);
    }
  }
  void check(RepriseResult result) const {
    if (result == REPRISE_SUCCESS) return;
    std::string text = std::exchange(messages_->last_error, std::string());
    throw ApiError(result, text.empty() ? repriseResultText(result) : text);
  }

  std::unique_ptr<Messages> messages_;  // its address is the callback's user pointer
  RepriseContext context_ = nullptr;
};

}  // namespace reprise

#endif
