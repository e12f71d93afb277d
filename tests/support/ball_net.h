// SPDX-License-Identifier: MIT
//
// A net of balls. A joint connects each ball, at half of the distance, to the previous balls of its
// row and column. The first row is static.
#pragma once

#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {

struct BallNet {
    std::vector<physics::BodyId> balls;    // row by row
    std::vector<physics::JointId> across;  // joints along the rows
};

// Adds an n by n net. `down`, `right`: offset between rows and columns, m. `end_density`: density
// of the last row, kg/m^3.
inline BallNet add_ball_net(physics::World& world, int n, physics::Vec3 first, physics::Vec3 down,
                            physics::Vec3 right, double end_density = 1000) {
    BallNet net;
    const auto connect = [&](std::size_t a, std::size_t b, physics::Vec3 offset) {
        return must(world.create_joint({.body_a = net.balls[a],
                                        .body_b = net.balls[b],
                                        .frame_a = {.position = offset * 0.5},
                                        .frame_b = {.position = offset * -0.5}}));
    };
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            net.balls.push_back(add(world, {.geometry = physics::Sphere{0.1},
                                            .position = first + right * column + down * row,
                                            .density = row + 1 == n ? end_density : 1000,
                                            .type = row == 0 ? physics::BodyType::static_body
                                                             : physics::BodyType::dynamic}));
            const std::size_t here = net.balls.size() - 1;
            if (row > 0) connect(here - static_cast<std::size_t>(n), here, down);
            if (row > 0 && column > 0) net.across.push_back(connect(here - 1, here, right));
        }
    return net;
}

}  // namespace jostle::test
