// SPDX-License-Identifier: MIT
#include "lab/run/interrupt.h"

#include <csignal>
#include <ctime>

namespace reprise::lab {
namespace {

// One request to stop may come as several signals: `timeout` sends one to the process and one to
// its group, a shell and a terminal likewise. What comes within this time is the same request.
constexpr double kSameRequestSeconds = 0.5;

volatile std::sig_atomic_t interrupted = 0;
timespec first_request;

double secondsSince(const timespec& then) {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - then.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - then.tv_nsec);
}

void receive(int signal) {
  if (interrupted == 0) {
    clock_gettime(CLOCK_MONOTONIC, &first_request);
    interrupted = 1;
  } else if (secondsSince(first_request) > kSameRequestSeconds) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void catchInterrupts() {
  struct sigaction action = {};
  action.sa_handler = receive;
  action.sa_flags = SA_RESTART;
  // One handler at a time: the other signal waits until this one has been noted.
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void throwIfInterrupted() {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace reprise::lab
