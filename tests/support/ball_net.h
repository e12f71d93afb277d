// SPDX-License-Identifier: MIT
//
// A net of balls of which each is tied, half-way, to those before it in its row and its column. The
// first row stands still.
#pragma once

#include <vector>

#include "tests/support/world_builder.h"

namespace jostle::test {

struct BallNet {
    std::vector<physics::BodyId> balls;    // row by row
    std::vector<physics::JointId> across;  // joints along the rows
};

// n by n. `down`, `right`: m, from one row or column to the next. `end_density`: kg/m^3, of the
// last row.
inline BallNet add_ball_net(physics::World& world, int n, physics::Vec3 first, physics::Vec3 down,
                            physics::Vec3 right, double end_density = 1000) {
    BallNet net;
    const auto tie = [&](std::size_t a, std::size_t b, physics::Vec3 way) {
        return must(world.create_joint({.body_a = net.balls[a],
                                        .body_b = net.balls[b],
                                        .frame_a = {.position = way * 0.5},
                                        .frame_b = {.position = way * -0.5}}));
    };
    for (int row = 0; row < n; row++)
        for (int column = 0; column < n; column++) {
            net.balls.push_back(add(world, {.geometry = physics::Sphere{0.1},
                                            .position = first + right * column + down * row,
                                            .density = row + 1 == n ? end_density : 1000,
                                            .type = row == 0 ? physics::BodyType::static_body
                                                             : physics::BodyType::dynamic}));
            const std::size_t here = net.balls.size() - 1;
            if (row > 0) tie(here - static_cast<std::size_t>(n), here, down);
            if (row > 0 && column > 0) net.across.push_back(tie(here - 1, here, right));
        }
    return net;
}

}  // namespace jostle::test
