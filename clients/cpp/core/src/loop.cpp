// SPDX-License-Identifier: MIT
#include "jostle/client/loop.h"

#include "clients/cpp/core/src/loop_thread.h"

namespace jostle::client {

Loop::Loop() : thread_(std::make_unique<LoopThread>()) {}
Loop::~Loop() = default;

}  // namespace jostle::client
