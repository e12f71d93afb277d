// SPDX-License-Identifier: MIT
//
// The step of tests that say nothing else of it.
#pragma once

namespace jostle::test {

inline constexpr double dt = 1.0 / 60;  // s

}  // namespace jostle::test
