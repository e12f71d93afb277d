// SPDX-License-Identifier: MIT
//
// What acts along the ways that joints leave free, against closed forms.
#include "physics/src/constraints/direct/free_axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/physics/constraints/direct/small_groups.h"
#include "tests/support/step_time.h"

namespace jostle::test {
namespace {

const Vec3 small{0.004, 0.005, 0.006};

// One body, 1 kg at the origin, that a joint with axes along `frame` ties to the ground.
DirectGroup tied(const JointKind& kind, Quat frame = {}, Vec3 arm = {}) {
    DirectGroup group;
    group.bodies = {ground(), body_at({}, 1, small)};
    join(group, 0, 1, kind, arm, arm, frame);
    group.prepare();
    return group;
}
DirectGroup floating(const JointKind& kind, Quat frame = {}, Vec3 arm = {}) {
    DirectGroup group = tied(kind, frame, arm);
    group.bodies[1].force = {};
    return group;
}
void advance_for(DirectGroup& group, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / dt));
    for (int k = 0; k < steps; k++) group.advance(dt, 8);
}

const Quat z_along_x = from_axis_angle({0, 1, 0}, 0.5 * pi);

TEST(FreeAxis, slider_accelerates_along_its_axis) {
    const double slope = 0.4;
    const Quat frame = from_axis_angle({0, 1, 0}, 0.5 * pi + slope);  // z along x and down
    DirectGroup group = tied(SliderJoint{}, frame, {0.3, 0.2, -0.1});
    advance_for(group, 1);
    const double travel = 0.5 * g * std::sin(slope);
    const Vec3 line = rotate(frame, {0, 0, 1});
    EXPECT_LT(length(group.bodies[1].x - line * travel), 1e-9);
    EXPECT_LT(length(spin(group.bodies[1])), 1e-9);
}

// Two bodies of which one slides along the other as both tumble.
TEST(FreeAxis, slider_conserves_momenta_and_energy) {
    DirectGroup group;
    group.bodies = {body_at({}, 2, {0.02, 0.03, 0.04}), body_at({0.3, 0, 0}, 1, small)};
    for (DirectBody& body : group.bodies) body.force = {};
    const Vec3 turn{0.5, 2, 1};
    group.bodies[0].l = Vec3{0.02 * turn.x, 0.03 * turn.y, 0.04 * turn.z};
    group.bodies[1].l = Vec3{small.x * turn.x, small.y * turn.y, small.z * turn.z};
    group.bodies[1].p = cross(turn, {0.3, 0, 0});
    join(group, 0, 1, SliderJoint{.spring = {0.8, 0}, .spring_travel = 0.1}, {0.1, 0.05, 0},
         {-0.2, 0.05, 0}, z_along_x);
    group.prepare();
    const auto momentum = [&] {
        Vec3 sum;
        for (const DirectBody& body : group.bodies) sum += body.l + cross(body.x, body.p);
        return sum;
    };
    const auto total = [&] {
        const DirectJoint& joint = group.joints[0];
        const double stretch = dot(rotate(group.bodies[0].q, {1, 0, 0}),
                                   group.bodies[1].x + group.bodies[1].axes * joint.arm_b -
                                       group.bodies[0].x - group.bodies[0].axes * joint.arm_a) -
                               0.1;
        return energy(group) + 0.5 * joint.free_axes[0].stiffness * stretch * stretch;
    };
    group.advance(dt, 8);
    const Vec3 before = momentum();
    const double start = energy(group);
    double most = 0, least = 1e300;
    for (int k = 0; k < 600; k++) {
        group.advance(dt, 8);
        most = maximum(most, total());
        least = minimum(least, total());
    }
    EXPECT_LT(length(momentum() - before), 1e-11);
    EXPECT_GT(start, 0.01);
    // The rate is against the bodies' masses as they are felt along the line, which change by the
    // travel: the energy is kept as far as the stiffness is.
    EXPECT_LT(most - least, 0.1 * start);
}

TEST(FreeAxis, slider_stops_at_its_limit_and_carries_the_weight) {
    DirectGroup group = tied(SliderJoint{.limit = {true, -0.5, 1}});
    advance_for(group, 0.3);
    EXPECT_NEAR(group.bodies[1].x.z, -0.5 * g * 0.09, 1e-9);
    advance_for(group, 0.1);
    EXPECT_NEAR(group.bodies[1].x.z, -0.5, 1e-9);
    EXPECT_LT(length(velocity(group.bodies[1])), 1e-9);
    group.joints[0].force_sum = {};
    group.advance(dt, 8);
    EXPECT_NEAR(group.joints[0].force_sum.z / dt, g, 1e-6);
}

TEST(FreeAxis, slider_motor_applies_its_maximum_force_until_it_reaches_its_speed) {
    DirectGroup group = floating(SliderJoint{.motor = {true, 2, 4}}, z_along_x);
    advance_for(group, 0.25);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 1, 1e-9);
    advance_for(group, 0.5);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 2, 1e-9);
}

TEST(FreeAxis, friction_stops_the_motion_and_holds) {
    DirectGroup group = floating(SliderJoint{.friction_force = 2}, z_along_x);
    group.bodies[1].p = {1, 0, 0};
    advance_for(group, 0.4);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 0.2, 1e-9);
    EXPECT_NEAR(group.bodies[1].x.x, 0.4 - 0.16, 1e-9);
    advance_for(group, 0.2);
    EXPECT_NEAR(group.bodies[1].x.x, 0.25, 1e-5);
    EXPECT_LT(length(velocity(group.bodies[1])), 1e-12);
    group.bodies[1].force = {1.9, 0, 0};
    advance_for(group, 1);
    EXPECT_NEAR(group.bodies[1].x.x, 0.25, 1e-5);
    group.bodies[1].force = {2.5, 0, 0};
    advance_for(group, 1);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 0.5, 1e-3);
}

// A motor of 3 N against friction of 1 N: 2 N until it has its speed, 1 N to keep it.
TEST(FreeAxis, motor_overcomes_friction) {
    DirectGroup group =
        floating(SliderJoint{.motor = {true, 1, 3}, .friction_force = 1}, z_along_x);
    advance_for(group, 0.25);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 0.5, 1e-3);
    advance_for(group, 0.5);
    EXPECT_NEAR(velocity(group.bodies[1]).x, 1, 1e-9);
    // A load that both together do not carry: they push back with all they have.
    group.bodies[1].force = {-5, 0, 0};
    advance_for(group, 0.5);
    const double before = velocity(group.bodies[1]).x;
    EXPECT_LT(before, 0);
    advance_for(group, 0.5);
    EXPECT_NEAR(velocity(group.bodies[1]).x - before, -0.5, 1e-9);
}

TEST(FreeAxis, undamped_spring_oscillates_for_a_minute) {
    DirectGroup group = floating(SliderJoint{.spring = {1, 0}}, z_along_x);
    group.bodies[1].x = {1, 0, 0};
    double worst = 0;
    for (int k = 1; k <= 3600; k++) {
        group.advance(dt, 8);
        const Vec3 x = group.bodies[1].x, v = velocity(group.bodies[1]);
        worst = maximum(worst, absolute(x.x * x.x + v.x * v.x / (4 * pi * pi) - 1));
        if (k % 60 == 0) {
            EXPECT_NEAR(x.x, 1, 1e-6) << k;
        }
    }
    EXPECT_LT(worst, 1e-5);
}

TEST(FreeAxis, damped_spring_decays_at_the_analytic_rate) {
    const double ratio = 0.2, w = 2 * pi * 2, slower = w * std::sqrt(1 - ratio * ratio);
    DirectGroup group = floating(SliderJoint{.spring = {2, ratio}}, z_along_x);
    group.bodies[1].x = {1, 0, 0};
    for (int k = 1; k <= 60; k++) {
        group.advance(dt, 8);
        const double t = k * dt;
        const double truth = std::exp(-ratio * w * t) *
                             (std::cos(slower * t) + ratio * w / slower * std::sin(slower * t));
        EXPECT_NEAR(group.bodies[1].x.x, truth, 2e-4) << t;
    }
}

// The spring of a hinge feels the rod's own inertia, the pivot makes it four times as slow to turn.
// Halving the step divides the error by four.
double error_of_damped_rod(int substeps) {
    const double inertia = 1.0 / 12, about_end = inertia + 0.25, ratio = 0.5, w = 2 * pi * 2;
    DirectGroup group;
    group.bodies = {ground(), body_at({0.5, 0, 0}, 1, {0.01, inertia, inertia})};
    group.bodies[1].force = {};
    group.bodies[1].p = {0, 0, -1};
    group.bodies[1].l = {0, 2 * inertia, 0};
    join(group, 0, 1, HingeJoint{.spring = {2, ratio}}, {}, {-0.5, 0, 0}, about_y);
    group.prepare();
    for (int k = 0; k < 60; k++) group.advance(dt, substeps);
    const double k = w * w * inertia / about_end, c = 2 * ratio * w * inertia / about_end;
    const double slower = std::sqrt(k - 0.25 * c * c);
    const double truth = 2 / slower * std::exp(-0.5 * c) * std::sin(slower);
    const Vec3 x = group.bodies[1].axes * Vec3{1, 0, 0};
    return std::abs(std::atan2(-x.z, x.x) - truth);
}
TEST(FreeAxis, damped_spring_is_second_order_with_rigid_joints) {
    const double coarse = error_of_damped_rod(2), fine = error_of_damped_rod(4);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_GT(coarse / fine, 3.5);
    EXPECT_LT(coarse / fine, 4.5);
}

// Of a thousand turns a second no step sees anything. Without damping energy is kept, with damping
// the spring goes to rest.
TEST(FreeAxis, springs_too_stiff_for_the_step_remain_bounded) {
    for (const double ratio : {0.0, 0.3, 1.0, 10.0}) {
        DirectGroup group = floating(SliderJoint{.spring = {1000, ratio}}, z_along_x);
        group.bodies[1].p = {1, 0, 0};
        double most = 0;
        for (int k = 0; k < 600; k++) {
            group.advance(dt, 8);
            most = maximum(most, energy(group));
        }
        EXPECT_LT(most, 0.5 + 1e-9) << ratio;
        if (ratio > 0) {
            // To the tolerance of a step, 3e-7 m in 1/480 s.
            EXPECT_LT(length(group.bodies[1].x), 3e-7) << ratio;
            EXPECT_LT(length(velocity(group.bodies[1])), 1.5e-4) << ratio;
        }
        EXPECT_GT(group.count().energy_steps, 0) << ratio;
    }
}

// A cardan joint: two shafts at an angle b; tan(out) = tan(in) cos(b) from where the input's pin
// lies across the bend.
TEST(FreeAxis, universal_joint_matches_the_cardan_equation) {
    const double bend = 0.5;
    const Vec3 out{std::cos(bend), 0, std::sin(bend)};
    DirectGroup group;
    group.bodies = {ground(), body_at({-0.5, 0, 0}, 1, small), body_at(out * 0.5, 1, small)};
    for (DirectBody& body : group.bodies) body.force = {};
    // The second body's axes are along its shaft.
    group.bodies[2].q = from_axis_angle({0, 1, 0}, -bend);
    refresh(group.bodies[2]);
    join(group, 0, 1, HingeJoint{}, {-0.5, 0, 0}, {}, z_along_x);
    DirectJoint end;
    end.a = 0;
    end.b = 2;
    set_up(end, HingeJoint{}, {out * 0.5, group.bodies[2].q * z_along_x}, {{}, z_along_x});
    write_vectors(end, group.bodies[0], group.bodies[2]);
    group.joints.push_back(end);
    // Pins across the shafts: a's along y, b's in the plane of the bend.
    SixDofAxes axes;
    axes.rotation_x.free = axes.rotation_z.free = true;
    DirectJoint cross_joint;
    cross_joint.a = 1;
    cross_joint.b = 2;
    const Quat pins = from_axis_angle({0, 0, 1}, 0.5 * pi);  // x along y
    SixDofJoint six;
    *six.axes = axes;
    set_up(cross_joint, six, {{0.5, 0, 0}, pins}, {{-0.5, 0, 0}, pins});
    EXPECT_EQ(cross_joint.rows(), 4);
    write_vectors(cross_joint, group.bodies[1], group.bodies[2]);
    group.joints.push_back(cross_joint);
    group.bodies[1].l = {small.x * 5, 0, 0};
    group.prepare();
    advance_for(group, 1);
    const double before = energy(group);
    for (int k = 0; k < 120; k++) {
        group.advance(dt, 8);
        const Vec3 y_in = group.bodies[1].axes * Vec3{0, 1, 0};
        const Vec3 y_out =
            inverse_rotate(from_axis_angle({0, 1, 0}, -bend), group.bodies[2].axes * Vec3{0, 1, 0});
        const double in = std::atan2(y_in.z, y_in.y), turned = std::atan2(y_out.z, y_out.y);
        EXPECT_NEAR(std::sin(turned) * std::cos(in),
                    std::cos(turned) * std::sin(in) * std::cos(bend), 1e-5);
    }
    EXPECT_NEAR(energy(group), before, 1e-6 * before);
}

// Falls freely until the rope is taut; then it hangs and swings, and gains nothing.
TEST(FreeAxis, rope_is_slack_and_then_catches) {
    DirectGroup group;
    group.bodies = {ground(), body_at({0.6, 0, 0}, 1, small)};
    join(group, 0, 1, DistanceJoint{.min_length = 0, .max_length = 1}, {}, {});
    group.prepare();
    advance_for(group, 0.4);  // taut at a depth of 0.8, after 0.404 s
    EXPECT_NEAR(group.bodies[1].x.z, -0.5 * g * 0.16, 1e-9);
    EXPECT_NEAR(group.bodies[1].x.x, 0.6, 1e-9);
    advance_for(group, 0.1);
    const double caught = energy(group);  // what pulled at the rope is gone
    EXPECT_NEAR(caught, -g * 0.8 + 0.5 * 2 * g * 0.8 * 0.36, 0.02);
    double most = 0;
    for (int k = 0; k < 300; k++) {
        group.advance(dt, 8);
        most = maximum(most, length(group.bodies[1].x));
        EXPECT_NEAR(energy(group), caught, 1e-4);
    }
    EXPECT_LT(most, 1 + 1e-5);
    EXPECT_GT(most, 1 - 1e-5);
}

// A rod on a shoulder falls over until its cone holds it, and turns about itself as far as it may.
TEST(FreeAxis, cone_twist_stays_within_its_cone) {
    DirectGroup group;
    group.bodies = {ground(), body_at({0, 0, 0.5}, 1, {0.0841667, 0.0841667, 0.002})};
    group.bodies[1].p = {0.05, 0.02, 0};
    group.bodies[1].l = {-0.0841667 * 0.04, 0.0841667 * 0.1, 0.002};
    const Quat x_up = from_axis_angle({0, 1, 0}, -0.5 * pi);
    join(group, 0, 1, ConeTwistJoint{.swing = 0.7, .twist = {true, -0.3, 0.4}}, {}, {0, 0, -0.5},
         x_up);
    group.prepare();
    double swing = 0, twist = 0;
    const double before = energy(group);
    for (int k = 0; k < 300; k++) {
        group.advance(dt, 8);
        const DirectJoint& joint = group.joints[0];
        write_vectors(group.joints[0], group.bodies[0], group.bodies[1]);
        twist = maximum(twist, joint.free_axes[0].value);
        swing = maximum(swing, joint.free_axes[1].value);
        EXPECT_LT(energy(group), before + 1e-4);
    }
    EXPECT_NEAR(swing, 0.7, 1e-4);
    EXPECT_NEAR(twist, 0.4, 1e-4);
    EXPECT_LT(widest_gap(group), 1e-5);
}

// Far beyond its limit a joint comes back at a bounded speed, and keeps none of it.
TEST(FreeAxis, violated_limits_recover_at_a_bounded_speed) {
    DirectGroup hinge = floating(HingeJoint{.limit = {true, 1, 2}}, about_y);
    hinge.advance(0.05, 8);
    write_vectors(hinge.joints[0], hinge.bodies[0], hinge.bodies[1]);
    EXPECT_NEAR(hinge.joints[0].free_axes[0].value, 8 * 0.05, 1e-5);
    EXPECT_LT(length(spin(hinge.bodies[1])), 1e-9);
    DirectGroup slider = floating(SliderJoint{.limit = {true, -3, -2}}, z_along_x);
    slider.advance(0.05, 8);
    EXPECT_NEAR(slider.bodies[1].x.x, -0.5, 1e-6);
    EXPECT_LT(length(velocity(slider.bodies[1])), 1e-9);
    slider.advance(1, 60);
    EXPECT_NEAR(slider.bodies[1].x.x, -2, 1e-6);
}

// A motor at its most on a chain that is too stiff for other steps than energy-momentum ones.
TEST(FreeAxis, motor_and_friction_forces_are_reported_at_any_step_size) {
    DirectGroup group;
    group.bodies.push_back(ground());
    for (int k = 0; k < 6; k++) {
        const double mass = k == 5 ? 1000 : 0.1;
        group.bodies.push_back(
            body_at({0.1 + 0.2 * k, 0, 0}, mass, Vec3{0.0001, 0.0004, 0.0004} * (mass / 0.1)));
        join(group, k, k + 1, HingeJoint{.motor = {k == 0, 100, 0.3}},
             k == 0 ? Vec3{} : Vec3{0.1, 0, 0}, {-0.1, 0, 0}, about_y);
    }
    group.prepare();
    advance_for(group, 0.5);
    group.joints[0].torque_sum = {};
    const int before = group.count().energy_steps;
    group.advance(dt, 8);
    EXPECT_GT(group.count().energy_steps, before);
    EXPECT_NEAR(absolute(group.joints[0].torque_sum.y) / dt, 0.3, 1e-6);
}

}  // namespace
}  // namespace jostle::test
