// SPDX-License-Identifier: MIT
//
// The default time step of tests.
#pragma once

namespace jostle::test {

inline constexpr double dt = 1.0 / 60;  // s

}  // namespace jostle::test
