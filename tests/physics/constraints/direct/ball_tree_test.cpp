// SPDX-License-Identifier: MIT
//
// Trees of ball joints in compact records, beside the code for all kinds of joints.
#include "physics/src/constraints/direct/ball_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/constraints/direct/small_groups.h"

namespace jostle::test {
namespace {
using namespace physics;

// No forces of its own. A group with external forces takes no steps of ball trees.
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
TEST(BallTree, moves_as_the_code_for_all_kinds_of_joints) {
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
TEST(BallTree, conserves_the_angular_momentum_of_a_loaded_chain) {
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

TEST(BallTree, reports_the_load_on_its_joints) {
    DirectGroup group = forked_chain(66, 0.05);
    for (DirectBody& body : group.bodies) body.p = {};
    for (DirectJoint& joint : group.joints) joint.force_sum = {};
    run(group, 1, 8);
    EXPECT_NEAR(group.joints[0].force_sum.z * 60, 66 * 6 * g, 40);
}

// Bodies that turn by 0.02 rad per step of a chain of 66 need two sub-steps, those that turn by
// 0.3 rad four.
TEST(BallTree, takes_few_sub_steps_while_bodies_turn_slowly) {
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

}  // namespace
}  // namespace jostle::test
