// SPDX-License-Identifier: MIT
//
// Rows of every kind of joint against two things that know nothing of them: how their errors change
// when bodies move, and what a step of the solver does to velocities.
#include "physics/src/constraints/joints/joint_rows.h"

#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

SixDofJoint universal() {
    SixDofJoint six;
    six.axes->rotation_x = {.free = true, .motor = {true, 0.4, 50}};
    six.axes->rotation_z = {.free = true, .spring = {1, 0.5}, .spring_target = 0.2};
    return six;
}
SixDofJoint all_free() {
    SixDofJoint six;
    six.axes->x = {.free = true, .limit = {true, 0.3, 1}};
    six.axes->y = {.free = true, .spring = {0.8, 0.1}, .spring_target = 0.1};
    six.axes->rotation_x = {.free = true, .limit = {true, 0.3, 1}};
    six.axes->rotation_y = {.free = true, .friction = 0.5};
    return six;
}

struct Case {
    const char* name;
    JointKind kind;
    std::size_t rows;
};

std::vector<Case> cases() {
    std::vector<Case> all = {
        {"ball", BallJoint{}, 3},
        {"driven ball", BallJoint{.drive = {.spring = {1, 0.3}, .max_torque = 1e9}}, 6},
        {"rubbing ball", BallJoint{.friction_torque = 1e-3}, 6},
        {"hinge", HingeJoint{}, 5},
        {"hinge beyond its limit", HingeJoint{.limit = {true, 0.4, 1}}, 6},
        {"driven hinge", HingeJoint{.motor = {true, 0.3, 300}}, 6},
        {"sprung hinge", HingeJoint{.spring = {0.7, 0.2}, .spring_angle = 0.3}, 6},
        {"cone-twist", ConeTwistJoint{.swing = 3, .twist = {true, -0.1, 0.1}}, 3},
        {"cone-twist beyond", ConeTwistJoint{.swing = 0.5, .twist = {true, 0.3, 0.8}}, 4},
        {"fixed", FixedJoint{}, 6},
        {"sprung fixed", FixedJoint{.linear = {1, 1}}, 6},
        {"rod", DistanceJoint{.min_length = std::sqrt(0.42), .max_length = std::sqrt(0.42)}, 1},
        {"spring", DistanceJoint{0, 9, {1, 0.2}, 0.5}, 1},
        {"velocity row",
         VelocityRow{
             .linear_a = {0, -1, 0}, .linear_b = {0, 1, 0.5}, .speed = 0.3, .softness = 0.1},
         1},
        {"slider", SliderJoint{.motor = {true, 0.4, 100}}, 6},
        {"universal joint", universal(), 6},
        {"free axes beyond", all_free(), 6},
        {"wheel",
         WheelJoint{.suspension = {2, 0.5}, .suspension_target = 0.1, .motor = {true, 3, 20}}, 6},
        {"grab", GrabJoint{.target = {0.1, 0.2, 0}, .spring = {1, 0.5}, .angular_damping = 2}, 6},
        {"path",
         PathJoint{.points = {{-2, 0, 0}, {-1, 0.3, 0}, {0, 0, 0}, {1, 0, 0.2}},
                   .motor = {true, 0.01, 1e4}},
         3},
        {"gear", GearJoint{.ratio = 2}, 1},
        {"rack", RackJoint{.radius = 0.4}, 1},
        {"pulley",
         PulleyJoint{
             .point_a = {-1, 4, 0}, .point_b = {1, 4, 0}, .length = 11.076570383037215, .ratio = 2},
         1},
    };
    return all;
}

// Two bodies with one joint of the kind.
struct Pair {
    World world;
    BodyId a, b;
    JointId joint;

    explicit Pair(const JointKind& kind, bool ends_meet, Vec3 gravity = {}, bool aligned = true)
        : world(make_world({.gravity = gravity, .substeps = 16, .sleeping = false})) {
        const Quat turn = from_rotation_vector({0.3, -0.4, 0.2});
        a = add(world,
                {.geometry = Box{{0.3, 0.2, 0.4}}, .position = {-0.6, 0, 0}, .rotation = turn});
        b = add(world,
                {.geometry = Box{{0.2, 0.3, 0.3}},
                 .position = {0.7, 0.1, -0.2},
                 .rotation = aligned ? turn : from_rotation_vector({0.5, 0.2, -0.1}) * turn});
        const Vec3 at{0.1, 0.05, 0.02};
        const Vec3 off = ends_meet ? Vec3{} : Vec3{0.4, 0.5, 0.1};
        const auto in = [&](BodyId body, Vec3 p) {
            return apply_inverse(state_of(world, body).pose, p);
        };
        joint = must(world.create_joint({.body_a = a,
                                         .body_b = b,
                                         .frame_a = {.position = in(a, at)},
                                         .frame_b = {.position = in(b, at + off)},
                                         .kind = kind}));
    }
    ConstraintSystem system(const ConstraintSystemOptions& question = {}) const {
        return must(world.constraint_system(joint, question));
    }
    void move(double dt) {
        for (const BodyId body : {a, b}) {
            const BodyState s = state_of(world, body);
            must(world.set_pose(body,
                                {s.pose.position + s.linear_velocity * dt,
                                 from_rotation_vector(s.angular_velocity * dt) * s.pose.rotation}));
        }
    }
};

bool needs_ends_apart(const JointKind& kind) {
    return std::holds_alternative<DistanceJoint>(kind) || std::holds_alternative<GrabJoint>(kind) ||
           std::holds_alternative<PulleyJoint>(kind);
}

// The rate of a row is what its error changes by, to second order in the time.
TEST(JointRows, rates_match_finite_differences_of_errors) {
    constexpr double dt = 1e-5;
    for (const Case& kind : cases()) {
        SCOPED_TRACE(kind.name);
        // Turns are held about the axes of aligned frames; the others may be anywhere.
        const bool aligned = !std::holds_alternative<SixDofJoint>(kind.kind) &&
                             !std::holds_alternative<ConeTwistJoint>(kind.kind) &&
                             !std::holds_alternative<DistanceJoint>(kind.kind);
        JointKind moved = kind.kind;
        if (auto* pulley = std::get_if<PulleyJoint>(&moved))
            pulley->length = 5;  // taut all the way
        Pair pair(moved, false, {}, aligned);
        // Gears and racks count from where they were first seen.
        const bool counts =
            std::holds_alternative<GearJoint>(moved) || std::holds_alternative<RackJoint>(moved);
        if (counts) must(pair.world.step(dt));
        must(pair.world.set_velocity(pair.a, {0.3, -0.2, 0.5}, {0.4, 0.1, -0.3}));
        must(pair.world.set_velocity(pair.b, {-0.1, 0.4, 0.2}, {-0.2, 0.5, 0.3}));
        if (counts) {  // what carries them keeps their axes
            const Vec3 z = rotate(state_of(pair.world, pair.a).pose.rotation, {0, 0, 1});
            must(pair.world.set_angular_velocity(pair.a, z * 0.7));
            must(pair.world.set_angular_velocity(pair.b, z * -0.4));
            if (std::holds_alternative<RackJoint>(moved))
                must(pair.world.set_angular_velocity(pair.b, {}));
        }
        const ConstraintSystem now = pair.system();
        pair.move(dt);
        const ConstraintSystem after = pair.system();
        pair.move(-2 * dt);
        const ConstraintSystem before = pair.system();
        ASSERT_EQ(now.rows.size(), after.rows.size());
        ASSERT_EQ(now.rows.size(), before.rows.size());
        for (std::size_t k = 0; k < now.rows.size(); k++) {
            const RowRole role = now.rows[k].role;
            if (role == RowRole::motor || role == RowRole::friction || role == RowRole::velocity)
                continue;
            EXPECT_NEAR(now.rows[k].rate, (after.rows[k].error - before.rows[k].error) / (2 * dt),
                        2e-5)
                << name_of(now.rows[k]);
        }
    }
}

// Impulses by many sweeps, each within its bounds.
std::vector<double> swept(const ConstraintSystem& s) {
    std::vector<double> x(s.rows.size());
    for (int sweep = 0; sweep < 20000; sweep++)
        for (std::size_t i = 0; i < x.size(); i++) {
            double left = s.rhs[i];
            for (std::size_t j = 0; j < x.size(); j++) left -= s.at(i, j) * x[j];
            x[i] = clamp(x[i] + left / s.at(i, i), s.rows[i].lower, s.rows[i].upper);
        }
    return x;
}

// In a short step: there what a spring does in many sub-steps is what it does in one.
TEST(JointRows, impulses_match_a_step) {
    for (const Case& kind : cases()) {
        SCOPED_TRACE(kind.name);
        constexpr double dt = 1e-3;
        const bool apart = needs_ends_apart(kind.kind);
        Pair pair(kind.kind, !apart, {1, -9.81, 2});
        if (std::string_view(kind.name).ends_with("limit") ||
            std::string_view(kind.name).ends_with("beyond"))
            continue;  // errors of position, which the solver mends at a rate of its own
        // Sweeps go on from what they found before.
        for (int step = 0; step < 8; step++) must(pair.world.step(dt));
        const ConstraintSystem s = pair.system({.h = dt, .position_correction = 0});
        EXPECT_GE(s.rows.size(), kind.rows);
        const std::vector<double> x = swept(s);
        must(pair.world.step(dt));
        for (std::size_t k = 0; k < s.bodies.size(); k++) {
            Vec3 v = s.bodies[k].free_linear_velocity, w = s.bodies[k].free_angular_velocity;
            for (std::size_t i = 0; i < x.size(); i++)
                for (int p = 0; p < s.rows[i].jacobian_count; p++) {
                    const RowJacobian& part = s.rows[i].jacobians[p];
                    if (part.body != static_cast<int>(k)) continue;
                    v += scaled(part.linear, s.bodies[k].inverse_mass) * x[i];
                    w += s.bodies[k].inverse_inertia * part.angular * x[i];
                }
            const BodyState after = state_of(pair.world, s.bodies[k].id);
            // Of what gravity adds.
            EXPECT_LT(length(after.linear_velocity - v), 2e-3 * 9.81 * dt) << k;
            EXPECT_LT(length(after.angular_velocity - w), 1e-2 * 9.81 * dt) << k;
        }
    }
}

TEST(JointRows, gear_rotates_relative_to_its_carriers) {
    World world = make_world({.gravity = {}});
    const BodyId arm = add(world, {.geometry = Box{{1, 0.1, 0.1}}});
    BodyId wheels[2];
    for (int k = 0; k < 2; k++) {
        const Vec3 at{k == 0 ? -0.8 : 0.8, 0, 0.3};
        wheels[k] = add(world, {.geometry = Sphere{0.2}, .position = at});
        must(world.create_joint({.body_a = arm,
                                 .body_b = wheels[k],
                                 .frame_a = {.position = at},
                                 .kind = HingeJoint{}}));
    }
    const JointId gear = must(world.create_joint(
        {.body_a = wheels[0], .body_b = wheels[1], .kind = GearJoint{.ratio = 3}}));
    must(world.set_angular_velocity(arm, {0, 0, 0.5}));
    must(world.set_angular_velocity(wheels[0], {0, 0, 2}));
    must(world.set_angular_velocity(wheels[1], {0, 0, -1}));
    const ConstraintSystem s = must(world.constraint_system(gear));
    ASSERT_EQ(s.rows.size(), 11u);
    const ConstraintRow& row = s.rows.back();
    EXPECT_EQ(row.role, RowRole::gear);
    EXPECT_EQ(row.jacobian_count, 3);
    EXPECT_NEAR(row.rate, (2 - 0.5) + 3 * (-1 - 0.5), 1e-12);
}

TEST(JointRows, limits_of_equal_bounds_hold_in_both_directions) {
    const Pair pair(HingeJoint{.limit = {true, 0.2, 0.2}}, true);
    const ConstraintSystem s = pair.system();
    ASSERT_EQ(s.rows.size(), 6u);
    EXPECT_EQ(s.rows[0].role, RowRole::limit);
    EXPECT_LT(s.rows[0].lower, -1e200);
    EXPECT_GT(s.rows[0].upper, 1e200);
}

}  // namespace
}  // namespace jostle::test
