// SPDX-License-Identifier: MIT
//
// Groups of joints without a world, against closed forms and what must be kept.
#include "physics/src/constraints/direct/direct_group.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {
using namespace physics;

// Links of 0.2 m along x from the ground, the last one so many times as heavy.
DirectGroup chain(int links, double ratio) {
    DirectGroup group;
    group.bodies.push_back(ground());
    for (int k = 0; k < links; k++) {
        const double mass = k + 1 == links ? 0.1 * ratio : 0.1;
        group.bodies.push_back(
            body_at({0.1 + 0.2 * k, 0, 0}, mass, Vec3{0.0001, 0.0004, 0.0004} * (mass / 0.1)));
        join(group, k, k + 1, BallJoint{}, k == 0 ? Vec3{} : Vec3{0.1, 0, 0}, {-0.1, 0, 0});
    }
    group.prepare();
    return group;
}

// A rod that is let go from the horizontal comes back after 4 K(sin 45) / w0 = 1.935750 s.
TEST(DirectGroup, pendulum_has_the_analytic_period) {
    DirectGroup group;
    group.bodies = {ground(), body_at({0.5, 0, 0}, 1, {0.0016667, 0.0841667, 0.0841667})};
    join(group, 0, 1, HingeJoint{}, {}, {-0.5, 0, 0}, about_y);
    group.prepare();
    const double period = 1.935750, dt = period / 120;
    for (int k = 0; k < 120; k++) group.advance(dt, 8);
    EXPECT_LT(length(group.bodies[1].x - Vec3{0.5, 0, 0}), 1e-5);
    EXPECT_LT(widest_gap(group), 1e-6);
    EXPECT_EQ(group.count().rattle_steps, 600) << "five stages of a step of fourth order";
}

// A chain with a thousand times the mass at its end cracks like a whip: it stays together, gains no
// energy, and never needs the last resort.
TEST(DirectGroup, keeps_the_joints_of_a_whip_closed) {
    for (const double ratio : {1.0, 100.0, 1000.0}) {
        DirectGroup group = chain(10, ratio);
        const double before = energy(group), scale = 0.1 * (9 + ratio) * g * 2;
        double gap = 0, most = before;
        for (int k = 0; k < 2 * 60; k++) {
            group.advance(1.0 / 60, 8);
            gap = maximum(gap, widest_gap(group));
            most = maximum(most, energy(group));
        }
        EXPECT_LT(gap, 1e-5) << ratio;
        EXPECT_LT(most - before, 1e-4 * scale) << ratio;
        EXPECT_EQ(group.count().last_resorts, 0) << ratio;
    }
}

// Nothing pulls from outside: both momenta stay what they are, to rounding.
TEST(DirectGroup, conserves_momenta_of_a_tumbling_group) {
    DirectGroup group;
    for (int k = 0; k < 5; k++) {
        group.bodies.push_back(body_at({0.2 * k, 0, 0}, 1 + k, {0.01, 0.02, 0.025}));
        group.bodies.back().force = {};
        group.bodies.back().p = {0, 1.0 * k, -2.0 * (k % 2)};
        group.bodies.back().l = {0.01 * k, 0.1, 0.02};
        if (k > 0) join(group, k - 1, k, BallJoint{}, {0.1, 0, 0}, {-0.1, 0, 0});
    }
    group.prepare();
    const auto momenta = [&] {
        Vec3 p, l;
        for (const DirectBody& body : group.bodies) {
            p += body.p;
            l += body.l + cross(body.x, body.p);
        }
        return std::pair(p, l);
    };
    const auto before = momenta();
    for (int k = 0; k < 600; k++) group.advance(1.0 / 60, 8);
    EXPECT_LT(length(momenta().first - before.first), 1e-11);
    EXPECT_LT(length(momenta().second - before.second), 1e-11);
}

// Four hinges of a parallelogram: three of their twenty rows follow from the others.
TEST(DirectGroup, keeps_the_energy_of_a_loop_with_redundant_rows) {
    DirectGroup group;
    const Vec3 rod{0.0841667, 0.0841667, 0.0016667};
    group.bodies = {ground(), body_at({0, 0, -0.5}, 1, rod), body_at({1.5, 0, -0.5}, 1, rod),
                    body_at({0.75, 0, -1}, 2, {0.0033, 0.38, 0.38})};
    join(group, 0, 1, HingeJoint{}, {}, {0, 0, 0.5}, about_y);
    join(group, 0, 2, HingeJoint{}, {1.5, 0, 0}, {0, 0, 0.5}, about_y);
    join(group, 1, 3, HingeJoint{}, {0, 0, -0.5}, {-0.75, 0, 0}, about_y);
    join(group, 2, 3, HingeJoint{}, {0, 0, -0.5}, {0.75, 0, 0}, about_y);
    group.bodies[3].p = {2, 0, 0};
    group.prepare();
    const double before = energy(group);
    group.advance(1.0 / 60, 8);  // velocities are made to fit
    const double fit = energy(group);
    EXPECT_LT(fit, before);
    for (int k = 0; k < 600; k++) group.advance(1.0 / 60, 8);
    EXPECT_NEAR(energy(group), fit, 1e-5);
    EXPECT_LT(widest_gap(group), 1e-6);
}

// A rod between two points, with its y axis along it.
int add_rod(DirectGroup& group, Vec3 from, Vec3 to, double radius, double mass, Vec3 gravity) {
    const Vec3 along = to - from;
    const double half = 0.5 * length(along);
    const double across = mass / 3 * (half * half + radius * radius);
    DirectBody rod =
        body_at((from + to) * 0.5, mass, {across, mass / 1.5 * radius * radius, across});
    const Vec3 y = normalized(along), axis = cross(Vec3{0, 1, 0}, y);
    rod.q = normalized(Quat{axis.x, axis.y, axis.z, 1 + y.y});
    rod.force = gravity * mass;
    refresh(rod);
    group.bodies.push_back(rod);
    return static_cast<int>(group.bodies.size()) - 1;
}

void hinge_at(DirectGroup& group, int a, int b, Vec3 point, Vec3 axis) {
    const Vec3 turn = cross(Vec3{0, 0, 1}, axis);
    const Quat frame = normalized(Quat{turn.x, turn.y, turn.z, 1 + axis.z});
    const auto end = [&](int k) -> DirectEnd {
        const DirectBody& body = group.bodies[static_cast<std::size_t>(k)];
        return {inverse_rotate(body.q, point - body.x), conjugate(body.q) * frame};
    };
    DirectJoint joint;
    joint.a = a;
    joint.b = b;
    set_up(joint, HingeJoint{}, end(a), end(b));
    write_vectors(joint, group.bodies[static_cast<std::size_t>(a)],
                  group.bodies[static_cast<std::size_t>(b)]);
    group.joints.push_back(joint);
}

// Four bars whose skew hinges leave one motion, although 20 rows hold 18 degrees of freedom (G. T.
// Bennett, 1903). The energy stays within 0.03 % of the largest kinetic energy, 9.8 J.
TEST(DirectGroup, bennett_linkage_keeps_moving) {
    const Vec3 corners[] = {{0.4, 0, 0.25}, {0, 0.3, -0.25}, {-0.4, 0, 0.25}, {0, -0.3, -0.25}};
    for (const int substeps : {1, 2, 4, 8}) {
        DirectGroup group;
        group.bodies.push_back(ground());
        for (int k = 0; k < 4; k++) {
            const Vec3 here = corners[k], next = corners[(k + 1) % 4], last = corners[(k + 3) % 4];
            if (k < 3) add_rod(group, here, next, 0.02, 1 + 0.3 * k, {2, 3, -9});
            hinge_at(group, k == 3 ? 0 : k, k == 3 ? 3 : k + 1, here,
                     normalized(cross(here - last, next - here)));
        }
        group.prepare();
        const double before = energy(group);
        double worst = 0, gap = 0;
        for (int k = 0; k < 600; k++) {
            group.advance(1.0 / 60, substeps);
            worst = maximum(worst, std::abs(energy(group) - before));
            gap = maximum(gap, widest_gap(group));
        }
        EXPECT_LT(worst, 3e-3) << substeps;
        EXPECT_LT(gap, 1e-7) << substeps;
        EXPECT_EQ(group.count().last_resorts, 0) << substeps;
    }
}

// A load of a thousand times the mass of a link swings down from the horizontal.
TEST(DirectGroup, heavy_loads_on_chains_keep_their_energy) {
    struct Case {
        int links;
        double hz;
        int substeps;
    };
    for (const Case& each : {Case{20, 30, 1}, Case{20, 60, 1}, Case{20, 60, 8}, Case{100, 60, 4}}) {
        DirectGroup group = chain(each.links, 1000);
        const double before = energy(group), fall = 100 * g * 0.2 * each.links;
        double worst = 0, gap = 0;
        for (int k = 0; k < 2 * each.hz; k++) {
            group.advance(1 / each.hz, each.substeps);
            worst = maximum(worst, std::abs(energy(group) - before));
            gap = maximum(gap, widest_gap(group));
        }
        EXPECT_LT(worst, 1e-4 * fall) << each.links << " links, " << each.hz << " Hz";
        EXPECT_LT(gap, 1e-4) << each.links << " links, " << each.hz << " Hz";
        EXPECT_EQ(group.count().last_resorts, 0);
    }
}

// A rod swings from 163 degrees. Finer steps keep its energy better, to rounding.
TEST(DirectGroup, pendulum_improves_with_finer_steps) {
    double last = 1;
    for (const double hz : {60.0, 120.0, 240.0, 480.0}) {
        DirectGroup group;
        const double start = 163 * pi / 180;
        group.bodies = {ground(), body_at(Vec3{std::sin(start), 0, -std::cos(start)} * 0.5, 1,
                                          {0.0841667, 0.0841667, 0.0016667})};
        group.bodies[1].q = from_axis_angle({0, 1, 0}, -start);
        refresh(group.bodies[1]);
        hinge_at(group, 0, 1, {}, {0, 1, 0});
        group.prepare();
        const double before = energy(group);
        double worst = 0;
        for (int k = 0; k < 10 * hz; k++) {
            group.advance(1 / hz, 8);
            worst = maximum(worst, std::abs(energy(group) - before));
        }
        EXPECT_LT(worst, 0.3 * last) << hz;
        last = maximum(worst, 3e-12);
    }
}

// A straight bridge between two walls cannot bend, so its weight asks for any tension: it stays
// where it is and gains nothing.
TEST(DirectGroup, straight_bridge_gains_no_energy) {
    for (const double hz : {30.0, 60.0})
        for (const int substeps : {1, 8}) {
            DirectGroup group;
            group.bodies.push_back(ground());
            constexpr int planks = 20;
            for (int k = 0; k <= planks; k++) {
                const Vec3 here{0.5 * k, 0, 0};
                if (k < planks) add_rod(group, here, here + Vec3{0.5, 0, 0}, 0.05, 100, {0, 0, -g});
                hinge_at(group, k, k < planks ? k + 1 : 0, here, {0, 1, 0});
            }
            group.prepare();
            const double before = energy(group);
            double most = before, gap = 0;
            for (int k = 0; k < 2 * hz; k++) {
                group.advance(1 / hz, substeps);
                most = maximum(most, energy(group));
                gap = maximum(gap, widest_gap(group));
            }
            EXPECT_LT(most - before, 1e-6) << hz << " Hz, " << substeps;
            EXPECT_LT(gap, 2e-3) << hz << " Hz, " << substeps;
        }
}

// Forty wheels on hinges of one tumbling chassis: work in proportion to the wheels.
TEST(DirectGroup, solves_a_hub_in_linear_time) {
    DirectGroup group;
    constexpr int wheels = 40;
    group.bodies.push_back(body_at({}, 100, {20, 30, 40}));
    group.bodies[0].l = {8, 30, 12};
    for (int k = 0; k < wheels; k++) {
        const Vec3 at{0.1 * k - 2, -0.2, k % 2 == 0 ? 0.5 : -0.5};
        const Vec3 turn{0.4, 1, 0.3};
        group.bodies.push_back(body_at(at, 2, {0.02, 0.02, 0.04}));
        group.bodies.back().p = cross(turn, at) * 2;
        group.bodies.back().l = {0.02 * turn.x, 0.02 * turn.y, 0.04 * (turn.z + k % 3)};
        join(group, 0, k + 1, HingeJoint{}, at, {});
    }
    for (DirectBody& body : group.bodies) body.force = {};
    // Five rows a joint; all pairs of joints would take 40 times as much.
    ASSERT_TRUE(group.prepare(wheels * 64 * 125));
    const auto spin_sum = [&] {
        Vec3 sum;
        for (const DirectBody& body : group.bodies) sum += body.l + cross(body.x, body.p);
        return sum;
    };
    const Vec3 turning = spin_sum();
    group.advance(1.0 / 60, 8);
    const double before = energy(group);  // velocities are made to fit
    for (int k = 0; k < 120; k++) group.advance(1.0 / 60, 8);
    EXPECT_NEAR(energy(group), before, 1e-5 * before);
    EXPECT_LT(length(spin_sum() - turning), 1e-9);
    EXPECT_LT(widest_gap(group), 1e-8);
    EXPECT_EQ(group.count().last_resorts, 0);
    EXPECT_EQ(group.count().energy_steps, 0);
}

// A motor gives its most until it reaches its speed, then what it takes; a limit stops it.
TEST(DirectGroup, motors_and_limits_respect_their_bounds) {
    DirectGroup group;
    group.bodies = {ground(), body_at({0.5, 0, 0}, 1, {0.01, 0.0841667, 0.0841667})};
    group.bodies[1].force = {};
    const int motor = join(group, 0, 1,
                           HingeJoint{.limit = {true, -1, 1.6},
                                      .motor = {.enabled = true, .speed = 2, .max_torque = 0.5}},
                           {}, {-0.5, 0, 0}, about_y);
    group.prepare();
    const double inertia = 0.0841667 + 0.25;
    // 1.496 rad/s^2 for 1.337 s, then 2 rad/s until 1.6 rad are reached at 1.468 s.
    for (int k = 1; k <= 90; k++) {
        group.advance(1.0 / 60, 8);
        const double t = k / 60.0, w = length(spin(group.bodies[1]));
        if (t < 1.335) {
            EXPECT_NEAR(w, 0.5 * t / inertia, 1e-5) << t;
        } else if (t > 1.354 && t < 1.465) {
            EXPECT_NEAR(w, 2, 1e-6) << t;
        } else if (t > 1.485) {
            EXPECT_LT(w, 1e-6) << t;
        }
    }
    for (int k = 0; k < 60; k++) group.advance(1.0 / 60, 8);
    const DirectJoint& joint = group.joints[static_cast<std::size_t>(motor)];
    EXPECT_EQ(joint.free_axes[0].at_limit, -1);
    EXPECT_LT(length(spin(group.bodies[1])), 1e-9);
    const Vec3 x = group.bodies[1].axes * Vec3{1, 0, 0};
    EXPECT_NEAR(arc_tangent(-x.z, x.x), 1.6, 1e-5);
}

// Ends that start a metre apart come together at ten metres a second, and keep none of it.
TEST(DirectGroup, closes_joint_errors_without_adding_energy) {
    DirectGroup group;
    group.bodies = {ground(), body_at({1, 0, 0}, 1, {0.004, 0.004, 0.004})};
    group.bodies[1].force = {};
    join(group, 0, 1, BallJoint{}, {}, {});
    group.prepare();
    group.advance(0.05, 8);
    EXPECT_NEAR(group.bodies[1].x.x, 0.5, 1e-6);
    EXPECT_LT(length(velocity(group.bodies[1])), 1e-9);
    group.advance(0.1, 8);
    EXPECT_LT(length(group.bodies[1].x), 1e-5);
    EXPECT_LT(energy(group), 1e-12);
}

}  // namespace
}  // namespace jostle::test
