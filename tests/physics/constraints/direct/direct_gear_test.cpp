// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/direct_gear.h"

#include <gtest/gtest.h>

#include <vector>

#include "physics/src/constraints/direct/free_turn.h"
#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {

// Two bodies and a carrier that move at random velocities.
std::vector<DirectBody> moving_bodies() {
    std::vector<DirectBody> bodies{body_at({0, 0, 0}, 1, {0.1, 0.2, 0.3}),
                                   body_at({1, 2, 0}, 2, {0.3, 0.2, 0.1}),
                                   body_at({3, 1, 1}, 5, {1, 2, 3})};
    const Vec3 speeds[] = {{1, 2, 3}, {-1, 0.5, 2}, {0.3, -2, 1}};
    for (std::size_t k = 0; k < bodies.size(); k++) {
        bodies[k].p = speeds[k] * bodies[k].mass;
        bodies[k].l = in_axes(bodies[k].axes, bodies[k].moments) * speeds[2 - k];
    }
    return bodies;
}

DirectGear gear_of(DirectGear::Motion first, DirectGear::Motion second) {
    DirectGear gear;
    gear.ends[0] = {.motion = first, .scale = -0.4, .body = 0, .carrier = 2, .arm = {0.1, 0, 0.2}};
    gear.ends[1] = {.motion = second, .scale = 2, .body = 1, .carrier = 2, .arm = {0, 0.3, 0}};
    for (DirectGear::End& end : gear.ends) {
        end.point = {1, 9, 2};
        if (end.motion == DirectGear::Motion::hang) end.carrier = -1;
    }
    list_parts(gear);
    return gear;
}

void move(std::vector<DirectBody>& bodies, double h) {
    for (DirectBody& body : bodies) {
        body.x1 = body.x + velocity(body) * h;
        const Vec3 t = spin(body) * (0.5 * h);
        const double s = 1 / square_root(1 + dot(t, t));
        body.q1 = Quat{s * t.x, s * t.y, s * t.z, s} * body.q;
        body.axes1 = to_matrix(body.q1);
    }
}

TEST(DirectGear, lists_each_body_once) {
    EXPECT_EQ(gear_of(DirectGear::Motion::turn, DirectGear::Motion::slide).part_count, 3);
    EXPECT_EQ(gear_of(DirectGear::Motion::hang, DirectGear::Motion::hang).part_count, 2);
}

TEST(DirectGear, rope_changes_by_its_mean_row_exactly) {
    std::vector<DirectBody> bodies = moving_bodies();
    DirectGear gear = gear_of(DirectGear::Motion::hang, DirectGear::Motion::hang);
    write_gear(gear, bodies);
    const double before = gear.value, h = 0.1;
    move(bodies, h);
    write_mean_gear(gear, bodies);
    EXPECT_NEAR(trial_sum(gear, bodies) - before, h * rate_of(gear, bodies), 1e-12);
}

// b slides along z in a carrier that turns, a turns in the world.
TEST(DirectGear, rack_changes_by_its_mean_row_exactly) {
    std::vector<DirectBody> bodies = moving_bodies();
    const auto spin_with = [](DirectBody& body, Vec3 w) {
        body.l = in_axes(body.axes, body.moments) * w;
    };
    const Vec3 turning{1, 0, 2};
    for (DirectBody& body : bodies) {
        body.p = cross(turning, body.x - bodies[2].x) * body.mass;
        spin_with(body, turning);
    }
    bodies[1].p += Vec3{0, 0, 3} * bodies[1].mass;
    spin_with(bodies[0], {0, 0, 5});
    DirectGear gear = gear_of(DirectGear::Motion::turn, DirectGear::Motion::slide);
    gear.ends[0].carrier = -1;
    list_parts(gear);
    write_gear(gear, bodies);
    EXPECT_NEAR(rate_of(gear, bodies), -0.4 * 5 + 2 * 3, 1e-12);
    const double before = gear.value, h = 0.1;
    move(bodies, h);
    // The carrier holds b, whose centre would otherwise leave on a straight line.
    const Vec3 arm = inverse_rotate(bodies[2].q, bodies[1].x - bodies[2].x);
    bodies[1].x1 = bodies[2].x1 + rotate(bodies[2].q1, arm + Vec3{0, 0, 0.3});
    bodies[1].p = (bodies[1].x1 - bodies[1].x) * (bodies[1].mass / h);
    write_mean_gear(gear, bodies);
    EXPECT_NEAR(trial_sum(gear, bodies) - before, h * rate_of(gear, bodies), 1e-7);
}

}  // namespace
}  // namespace jostle::test
