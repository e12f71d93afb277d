// SPDX-License-Identifier: MIT
#include "jostle/snapshot/quantize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/snapshot/frame_codec.h"
#include "tests/proto/snapshot/motion.h"

namespace jostle::snapshot {

TEST(Quantize, position_error_is_at_most_half_a_unit_and_rotation_error_a_quarter_degree) {
    Random random(7);
    const QuantSpec spec;
    double worst_m = 0, worst_deg = 0;
    for (int i = 0; i < 20000; i++) {
        Pose pose;
        for (double& p : pose.position) p = random.in(-1000, 1000);
        double norm = 0;
        for (double& q : pose.rotation) {
            q = random.in(-1, 1);
            norm += q * q;
        }
        for (double& q : pose.rotation) q /= std::sqrt(norm);
        const Pose back = dequantize(quantize(1, pose, false, spec), spec);
        double dot = 0;
        for (std::size_t k = 0; k < 4; k++) dot += pose.rotation[k] * back.rotation[k];
        worst_deg = std::max(worst_deg, 2 * std::acos(std::min(1.0, std::fabs(dot))) * 57.29578);
        for (std::size_t k = 0; k < 3; k++)
            worst_m = std::max(worst_m, std::fabs(pose.position[k] - back.position[k]));
    }
    EXPECT_LE(worst_m, 0.5 / 512 + 1e-12);
    EXPECT_LE(worst_deg, 0.25);
    EXPECT_GT(worst_deg, 0.1);  // the bound is not trivial
}

TEST(Quantize, non_finite_numbers_stay_in_range) {
    Pose pose;
    pose.position = {std::numeric_limits<double>::quiet_NaN(), 1e300, -1e300};
    const EntityState state = quantize(1, pose, false, {});
    EXPECT_EQ(state.position[0], 0);
    EXPECT_EQ(state.position[1], 2147483647);
    EXPECT_EQ(state.position[2], -2147483647 - 1);
}

TEST(Quantize, invalid_rotations_become_valid) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::array<double, 4> rotation :
         {std::array{nan, nan, nan, nan}, {2.0, 2.0, 2.0, 2.0}, {0.0, 0.0, 0.0, 0.0}}) {
        const QuantizedFrame frame{.frame = 1,
                                   .entities = {quantize(1, {{0, 0, 0}, rotation}, false, {})}};
        const auto back = decode_frame(1, encode_frame(frame, {}, {}), {}, {});
        ASSERT_TRUE(back.ok()) << back.error().message;
        EXPECT_EQ(*back, frame);
    }
}

}  // namespace jostle::snapshot
