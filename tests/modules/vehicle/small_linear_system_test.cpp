// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/small_linear_system.h"

#include <gtest/gtest.h>

namespace jostle::modules::vehicle_detail {
namespace {

TEST(SmallLinearSystem, solves_a_hilbert_matrix) {
    SmallLinearSystem<8> system;
    system.clear(5);
    // b = A (1, 2, 3, 4, 5)
    for (std::size_t i = 0; i < 5; i++)
        for (std::size_t j = 0; j < 5; j++) {
            const double entry = 1.0 / static_cast<double>(i + j + 1);
            system.a[i][j] = entry;
            system.b[i] += entry * static_cast<double>(j + 1);
        }
    system.solve();
    for (std::size_t i = 0; i < 5; i++) EXPECT_NEAR(system.b[i], static_cast<double>(i + 1), 1e-9);
}

TEST(SmallLinearSystem, empty_system_is_a_no_op) {
    SmallLinearSystem<8> system;
    system.clear(0);
    system.solve();
    EXPECT_EQ(system.size, 0u);
}

}  // namespace
}  // namespace jostle::modules::vehicle_detail
