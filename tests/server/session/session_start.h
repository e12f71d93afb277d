// SPDX-License-Identifier: MIT
//
// The time at which sessions of these tests begin: not zero, which stands for "never".
#pragma once

#include "server/util/clock.h"

namespace jostle::server {

inline constexpr Clock::time_point start = Clock::time_point() + std::chrono::seconds(1000);

}  // namespace jostle::server
