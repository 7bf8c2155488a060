// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

namespace reprise::lab {

// The user asked to stop; exit code 130. Thrown between frames, so that no half file is left.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

// From now on SIGINT and SIGTERM set a flag; another one, half a second later or more, ends the
// process at once.
void catchInterrupts();
// Throws Interrupted when one has come.
void throwIfInterrupted();

}  // namespace reprise::lab
