// SPDX-License-Identifier: MIT
//
// Trees of ball joints and hinges in compact records, beside the code for all kinds of joints.
#include "physics/src/constraints/direct/joint_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {
using namespace physics;

// No forces of its own. A group with external forces takes no steps of joint trees.
class NoForces final : public ExternalForces {
public:
    void push(std::vector<DirectBody>&, double, double, double) override {}
};

// Links of 0.4 m and 6 kg hang down from the ground and fork at a third of their number. Every one
// moves sideways at its own speed, and the last one has a multiple of the mass.
DirectGroup forked_chain(int links, double damping, double load = 1) {
    DirectGroup group;
    group.bodies.push_back(ground());
    const int fork = 2 * links / 3;
    for (int k = 0; k < links; k++) {
        const int above = k == fork ? links / 3 : k;
        const double depth = 0.4 * (k < fork ? k : k - fork + links / 3);
        DirectBody body =
            body_at({0, 0, -depth - 0.2}, k + 1 == links ? 6 * load : 6, {0.01, 0.01, 0.004});
        body.linear_damping = body.angular_damping = damping;
        body.p = Vec3{std::sin(0.3 * k), 0.2, 0} * body.mass;
        group.bodies.push_back(body);
        join(group, above, k + 1, BallJoint{}, k == 0 ? Vec3{} : Vec3{0, 0, -0.2}, {0, 0, 0.2});
    }
    group.prepare();
    return group;
}

double farthest(const DirectGroup& a, const DirectGroup& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.bodies.size(); k++)
        most = maximum(most, length(a.bodies[k].x - b.bodies[k].x));
    return most;
}

void run(DirectGroup& group, int steps, int substeps) {
    for (int k = 0; k < steps; k++) group.advance(1.0 / 60, substeps);
}

// With 6,000 N at its end, a chain takes energy-momentum steps.
TEST(JointTree, moves_as_the_code_for_all_kinds_of_joints) {
    for (const bool loaded : {false, true}) {
        const int links = 66;
        const double load = loaded ? 100 : 1;
        DirectGroup balls = forked_chain(links, 0.05, load), all = forked_chain(links, 0.05, load),
                    fine = forked_chain(links, 0.05, load);
        NoForces none;
        all.outside = fine.outside = &none;
        run(balls, 30, loaded ? 4 : 8);
        run(all, 30, loaded ? 4 : 8);
        run(fine, 30, 64);
        EXPECT_LT(farthest(balls, fine), 1.05 * farthest(all, fine)) << load;
        EXPECT_LT(widest_gap(balls), 1e-4) << load;
        const DirectGroup::Count of_balls = balls.count(), of_all = all.count();
        EXPECT_EQ(of_balls.energy_steps > 60, loaded);
        EXPECT_EQ(of_balls.energy_steps, of_all.energy_steps) << load;
        EXPECT_LT(of_balls.solves, of_all.solves + 1) << load;
        EXPECT_EQ(of_balls.halvings + of_balls.last_resorts, 0) << load;
    }
}

// 8,000 N of tension pull bodies that turn: only a force at one point of both conserves this.
TEST(JointTree, conserves_the_angular_momentum_of_a_loaded_chain) {
    DirectGroup group = forked_chain(70, 0);
    group.bodies.erase(group.bodies.begin());
    group.joints.erase(group.joints.begin());
    for (DirectJoint& joint : group.joints) joint.a--, joint.b--;
    for (DirectBody& body : group.bodies) body.force = {};
    for (std::size_t k : {0, 69}) {
        group.bodies[k].force = Vec3{0, 0, k == 0 ? 8000.0 : -8000.0};
        group.bodies[k].mass *= 100;
        group.bodies[k].inverse_mass /= 100;
        group.bodies[k].inverse_masses *= 0.01;
    }
    ASSERT_TRUE(group.prepare());
    const auto along_z = [&] {
        double sum = 0;
        for (const DirectBody& body : group.bodies) sum += cross(body.x, body.p).z + body.l.z;
        return sum;
    };
    const double before = along_z();
    run(group, 30, 4);
    EXPECT_GT(group.count().energy_steps, 60);
    EXPECT_NEAR(along_z(), before, 1e-10);
}

TEST(JointTree, reports_the_load_on_its_joints) {
    DirectGroup group = forked_chain(66, 0.05);
    for (DirectBody& body : group.bodies) body.p = {};
    for (DirectJoint& joint : group.joints) joint.force_sum = {};
    run(group, 1, 8);
    EXPECT_NEAR(group.joints[0].force_sum.z * 60, 66 * 6 * g, 40);
}

// Bodies that turn by 0.02 rad per step of a chain of 66 need two sub-steps, those that turn by
// 0.3 rad four.
TEST(JointTree, takes_few_sub_steps_while_bodies_turn_slowly) {
    for (const double spin : {1.0, 20.0}) {
        DirectGroup group = forked_chain(66, 0.05);
        group.may_take_fewer_steps = true;
        for (DirectBody& body : group.bodies) {
            body.p = body.force = {};
            body.l = body.pushed ? Vec3{0, 0, spin * body.moments.z} : Vec3{};
        }
        group.prepare();
        group.advance(1.0 / 60, 8);
        const int least = spin == 1 ? 2 : 4;
        EXPECT_EQ(group.count().rattle_steps + group.count().energy_steps, least) << spin;
    }
}

// Hinges about x and y in turn, with a ball joint at every fifth link. A group of 9 joints is
// exact, one of 66 is not.
DirectGroup mixed_chain(int links, const HingeJoint& hinge, double load = 1) {
    DirectGroup group = forked_chain(links, 0.05, load);
    group.joints.clear();
    const Quat about_x = from_axis_angle({0, 1, 0}, 0.5 * pi);
    const int fork = 2 * links / 3;
    for (int k = 0; k < links; k++) {
        const int above = k == fork ? links / 3 : k;
        const JointKind kind = k % 5 == 4 ? JointKind(BallJoint{}) : JointKind(hinge);
        join(group, above, k + 1, kind, k == 0 ? Vec3{} : Vec3{0, 0, -0.2}, {0, 0, 0.2},
             k % 2 == 0 ? about_y : about_x);
    }
    group.prepare();
    return group;
}

double largest_turn(const DirectGroup& group) {
    double most = 0;
    for (const DirectJoint& j : group.joints)
        for (int k = 0; k < j.turns; k++)
            most = maximum(
                most,
                absolute(dot(group.bodies[static_cast<std::size_t>(j.a)].axes * j.turn_a[k],
                             group.bodies[static_cast<std::size_t>(j.b)].axes * j.turn_b[k])));
    return most;
}

TEST(JointTree, moves_hinges_as_the_code_for_all_kinds_of_joints) {
    struct Case {
        int links;
        double load;
    };
    for (const Case of : {Case{9, 1}, Case{9, 200}, Case{66, 1}, Case{66, 100}}) {
        DirectGroup tree = mixed_chain(of.links, {}, of.load),
                    all = mixed_chain(of.links, {}, of.load),
                    fine = mixed_chain(of.links, {}, of.load);
        NoForces none;
        all.outside = fine.outside = &none;
        run(tree, 30, 8);
        run(all, 30, 8);
        run(fine, 30, 64);
        EXPECT_GT(tree.count().tree_steps, 0);
        EXPECT_EQ(all.count().tree_steps, 0);
        EXPECT_LT(farthest(tree, fine), 1.05 * farthest(all, fine) + 1e-6) << of.links << of.load;
        EXPECT_LT(widest_gap(tree), of.links > 9 ? 1e-4 : 1e-5) << of.links << of.load;
        EXPECT_LT(largest_turn(tree), of.links > 9 ? 3e-4 : 3e-5) << of.links << of.load;
        EXPECT_EQ(tree.count().halvings + tree.count().last_resorts, 0);
    }
}

// Of rods, T = 2 pi sqrt(I / (m g d)) with I = m l^2 / 12 + m d^2 and d = l / 2, to the third order
// of the amplitude.
TEST(JointTree, hinge_pendulums_have_the_analytic_period) {
    DirectGroup group;
    group.bodies.push_back(ground());
    constexpr double amplitude = 0.05;
    for (int k = 0; k < 5; k++) {
        const double half = 0.2 + 0.1 * k, of_rod = 4 * half * half / 12;
        DirectBody body =
            body_at({2.0 * k + half * std::sin(amplitude), 0, -half * std::cos(amplitude)}, 1,
                    {of_rod, of_rod, 1e-3});
        body.q = from_axis_angle({0, 1, 0}, -amplitude);
        refresh(body);
        group.bodies.push_back(body);
        join(group, 0, k + 1, HingeJoint{}, {2.0 * k, 0, 0}, {0, 0, half}, about_y);
    }
    ASSERT_TRUE(group.prepare());
    double crossed[5] = {};
    for (int step = 0; step < 1200; step++) {
        double before[5];
        for (int k = 0; k < 5; k++) before[k] = group.bodies[as_index(k + 1)].x.x - 2.0 * k;
        group.advance(1.0 / 600, 4);
        for (int k = 0; k < 5; k++) {
            const double now = group.bodies[as_index(k + 1)].x.x - 2.0 * k;
            if (crossed[k] == 0 && before[k] > 0 && now <= 0)
                crossed[k] = (step + before[k] / (before[k] - now)) / 600;
        }
    }
    EXPECT_EQ(group.count().tree_steps, group.count().rattle_steps);
    for (int k = 0; k < 5; k++) {
        const double half = 0.2 + 0.1 * k;
        const double period =
            2 * pi * std::sqrt(4.0 / 3 * half / g) * (1 + amplitude * amplitude / 16);
        EXPECT_NEAR(crossed[k], 0.25 * period, 2e-6) << k;
    }
}

// Twelve wheels of 20 kg on a chassis in free flight. Motors of 30 N m turn them against it with
// the acceleration T / I_w + 12 T / I_c, where I_c includes the masses of the wheels, until they
// reach 9 rad/s.
TEST(JointTree, motors_of_a_vehicle_turn_its_wheels_as_their_torque_says) {
    DirectGroup group;
    group.bodies.push_back(body_at({}, 500, {80, 200, 240}));
    const HingeJoint axle{.motor = {.enabled = true, .speed = 9, .max_torque = 30}};
    double of_all = 240;
    for (int k = 0; k < 12; k++) {
        const Vec3 at{0.8 * (k / 2 - 2.5), -0.3, k % 2 == 0 ? 0.9 : -0.9};
        group.bodies.push_back(body_at(at, 20, {0.8, 0.8, 1.2}));
        join(group, 0, k + 1, axle, at, {});
        of_all += 20 * (at.x * at.x + at.y * at.y);
    }
    // About their common centre of mass.
    of_all -= 240 * 0.3 * 0.3 * 240 / 740;
    for (DirectBody& body : group.bodies) body.force = {};
    ASSERT_TRUE(group.prepare());
    const auto speed = [&](std::size_t wheel) {
        return spin(group.bodies[wheel]).z - spin(group.bodies[0]).z;
    };
    const double gain = 30 / 1.2 + 12 * 30 / of_all;
    run(group, 12, 8);
    EXPECT_EQ(group.count().tree_steps, 96);
    for (std::size_t k = 1; k <= 12; k++) EXPECT_NEAR(speed(k), gain * 0.2, 1e-7);
    run(group, 60, 8);
    Vec3 momentum;
    for (const DirectBody& body : group.bodies) momentum += cross(body.x, body.p) + body.l;
    for (std::size_t k = 1; k <= 12; k++) EXPECT_NEAR(speed(k), 9, 1e-9);
    EXPECT_LT(length(momentum), 1e-10);
    EXPECT_EQ(group.count().tree_steps, group.count().rattle_steps);
    EXPECT_LT(widest_gap(group), 1e-5);
}

// Limits are reached while the chain falls from the side.
TEST(JointTree, keeps_limits_as_the_code_for_all_kinds_of_joints) {
    const HingeJoint hinge{.limit = {.enabled = true, .lower = -0.3, .upper = 0.2}};
    const auto thrown = [&] {
        DirectGroup group = mixed_chain(12, hinge);
        for (DirectBody& body : group.bodies) body.p += Vec3{3, -2, 0} * body.mass;
        group.prepare();
        return group;
    };
    DirectGroup tree = thrown(), all = thrown(), fine = thrown();
    NoForces none;
    all.outside = fine.outside = &none;
    int at_limits = 0;
    for (int k = 0; k < 20; k++) {
        run(tree, 1, 8);
        run(all, 1, 8);
        run(fine, 1, 128);
        for (const DirectJoint& joint : tree.joints)
            for (const FreeAxis& axis : joint.free_axes) {
                at_limits += axis.at_limit != 0 ? 1 : 0;
                EXPECT_GT(axis.value, -0.3 - 1e-4);
                EXPECT_LT(axis.value, 0.2 + 1e-4);
            }
    }
    EXPECT_GT(at_limits, 20);
    EXPECT_GT(tree.count().tree_steps, 60);
    EXPECT_LT(farthest(tree, fine), 1.1 * farthest(all, fine) + 1e-4);
    EXPECT_LT(widest_gap(tree), 1e-4);
}

}  // namespace
}  // namespace jostle::test
