// SPDX-License-Identifier: MIT
#include "lab/run/interrupt.h"

#include <csignal>

namespace reprise::lab {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void receive(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, receive);
  std::signal(SIGTERM, receive);
}

void throwIfInterrupted() {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace reprise::lab
