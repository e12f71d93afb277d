// SPDX-License-Identifier: MIT
//
// Sliders, six-dofs and wheels against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/joint_fixture.h"
#include "tests/support/near.h"

namespace jostle::test {
namespace {
using namespace physics;

// What stands still and touches nothing.
BodyId bare_anchor(World& world) {
    return must(world.create_body({.type = BodyType::static_body},
                                  {.geometry = Sphere{0.05}, .filter = {.mask = 0}}));
}

// Turns z to the direction of the world's x.
const Quat along_x = from_axis_angle({0, 1, 0}, pi / 2);

// Seconds between zero crossings upward of `value`, over `seconds`.
template <class Value>
double period_of(World& world, double seconds, Value value, double hz = 60) {
    double last = value(), first = -1, latest = -1;
    int times = 0;
    for (int i = 1; i <= seconds * hz; i++) {
        must(world.step(1 / hz));
        const double now = value();
        if (last < 0 && now >= 0) {
            latest = (i - now / (now - last)) / hz;
            if (first < 0)
                first = latest;
            else
                times++;
        }
        last = now;
    }
    return times > 0 ? (latest - first) / times : 0;
}

TEST(Slider, spring_oscillates_at_its_frequency) {
    World world = make_world({.gravity = {}});
    const BodyId cart = block(world, {.position = {0.4, 0, 0}});
    join(world, bare_anchor(world), cart, SliderJoint{.spring = {1.5, 0}, .spring_travel = 0.1},
         {{}, along_x}, {{}, along_x});
    const double period = period_of(world, 10, [&] { return position_of(world, cart).x - 0.1; });
    EXPECT_NEAR(period, 1 / 1.5, 0.01 / 1.5);
    EXPECT_NEAR(position_of(world, cart).y, 0, 1e-6);
}

// On a slope of 30 degrees: g / 2.
TEST(Slider, falls_along_its_axis_and_stops_at_its_limit) {
    World world = make_world();
    const Quat slope = from_axis_angle({0, 0, 1}, -pi / 6) * along_x;
    const BodyId cart = block(world, {});
    const JointId slider = join(world, bare_anchor(world), cart,
                                SliderJoint{.limit = {true, -1, 1.5}}, {{}, slope}, {{}, slope});
    run(world, 0.5);
    JointState j = must(world.joint(slider));
    EXPECT_NEAR(j.travel, 9.81 / 2 * 0.125, 0.02);
    EXPECT_NEAR(length(j.force), 9.81 * std::cos(pi / 6) * state_of(world, cart).mass,
                0.01 * state_of(world, cart).mass);
    run(world, 3);
    j = must(world.joint(slider));
    EXPECT_NEAR(j.travel, 1.5, 1e-3);
    EXPECT_NEAR(length(j.offset - Vec3{0, 0, 1.5}), 0, 1e-3);
    EXPECT_NEAR(length(j.force), 9.81 * state_of(world, cart).mass, 1);
}

// 2 kg, 10 N: 5 m/s^2 to 3 m/s. Then friction alone: 4 N take 2 m/s each second.
TEST(Slider, motor_and_friction_apply_their_forces) {
    World world = make_world({.gravity = {}});
    const BodyId cart = block(world, {});
    must(world.set_mass(cart, 2));
    const JointId slider = join(world, bare_anchor(world), cart,
                                SliderJoint{.motor = {true, 3, 10}}, {{}, along_x}, {{}, along_x});
    run(world, 0.3);
    EXPECT_NEAR(velocity_of(world, cart).x, 1.5, 1e-3);
    EXPECT_NEAR(must(world.joint(slider)).force.x, 10, 1e-3);
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, cart).x, 3, 1e-3);
    must(world.set_joint(slider, SliderJoint{.friction_force = 4}));
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, cart).x, 1, 1e-3);
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, cart).x, 0, 1e-4);
}

// A weight on the far end of a drawer: the rails bear its moment, and it does not tilt.
TEST(Slider, does_not_rotate_under_an_off_axis_load) {
    World world = make_world();
    const BodyId drawer = block(world, {.geometry = Box{{1, 0.1, 0.3}}, .position = {1, 0, 0}});
    const JointId slider =
        join(world, bare_anchor(world), drawer, SliderJoint{.limit = {true, 0, 0}}, {{}, along_x},
             {{-1, 0, 0}, along_x});
    run(world, 5);
    const Vec3 x = rotate(state_of(world, drawer).pose.rotation, {1, 0, 0});
    EXPECT_GT(x.x, std::cos(1e-3));
    EXPECT_NEAR(must(world.joint(slider)).torque.z, 9.81 * state_of(world, drawer).mass, 2);
}

TEST(Slider, breaks_at_its_force_and_reports_it) {
    World world = make_world();
    const BodyId cart = block(world, {});
    const double weight = 9.81 * state_of(world, cart).mass;
    must(world.create_joint({.body_a = bare_anchor(world),
                             .body_b = cart,
                             .frame_a = {{}, along_x},
                             .frame_b = {{}, along_x},
                             .kind = SliderJoint{},
                             .break_force = 0.9 * weight}));
    run(world, 1.0 / 60);
    ASSERT_EQ(world.events().joints_broke.size(), 1u);
    EXPECT_NEAR(world.events().joints_broke[0].force, weight, 0.01 * weight);
}

// Two bodies that tumble together: the pair must not drift apart or gain energy.
double energy_after(const JointKind& kind, double& error) {
    World world = make_world({.gravity = {}});
    const BodyId a = block(world, {.geometry = Box{{0.2, 0.3, 0.1}}, .spin = {1, 2, 3}});
    const BodyId b = block(world, {.geometry = Box{{0.3, 0.1, 0.2}}, .position = {1, 0, 0}});
    join(world, a, b, kind, {{0.5, 0, 0}, {}}, {{-0.5, 0, 0}, {}});
    run(world, 0.5);
    const double before = world.summary().kinetic_energy;
    run(world, 10);
    error = world.summary().max_joint_error;
    return world.summary().kinetic_energy / before;
}

TEST(SixDof, fully_locked_equals_a_fixed_joint) {
    double fixed_error = 0, locked_error = 0;
    const double fixed = energy_after(FixedJoint{}, fixed_error);
    const double locked = energy_after(SixDofJoint{}, locked_error);
    EXPECT_NEAR(locked, fixed, 1e-3);
    EXPECT_NEAR(locked_error, fixed_error, 1e-4);
    // The same fall of the same boards, step by step.
    World worlds[2] = {make_world(), make_world()};
    BodyId boards[2];
    const JointKind kinds[2] = {FixedJoint{}, SixDofJoint{}};
    for (int k = 0; k < 2; k++) {
        boards[k] = block(worlds[k], {.geometry = Box{{0.5, 0.05, 0.2}}, .position = {0.5, 0, 0}});
        join(worlds[k], bare_anchor(worlds[k]), boards[k], kinds[k], {}, {{-0.5, 0, 0}, {}});
        run(worlds[k], 2);
    }
    EXPECT_TRUE(near(position_of(worlds[0], boards[0]), position_of(worlds[1], boards[1]), 1e-5));
}

TEST(SixDof, three_free_rotations_equal_a_ball_joint) {
    double ball_error = 0, free_error = 0;
    const double ball = energy_after(BallJoint{}, ball_error);
    const JointAxis free{.free = true};
    const double six = energy_after(
        SixDofJoint{SixDofAxes{.rotation_x = free, .rotation_y = free, .rotation_z = free}},
        free_error);
    EXPECT_NEAR(six, ball, 1e-3);
    EXPECT_NEAR(free_error, ball_error, 1e-4);
}

// A lone free turn goes all the way round, whichever it is.
TEST(SixDof, one_free_rotation_equals_a_hinge) {
    for (int axis = 0; axis < 3; axis++) {
        SCOPED_TRACE(axis);
        World world = make_world({.gravity = {}});
        const BodyId rotor = block(world, {});
        SixDofAxes axes;
        JointAxis& turn =
            axis == 0 ? axes.rotation_x : (axis == 1 ? axes.rotation_y : axes.rotation_z);
        turn = {.free = true, .motor = {true, 2, 1e6}};
        const JointId joint = join(world, bare_anchor(world), rotor, SixDofJoint{axes});
        run(world, 1);
        const JointState j = must(world.joint(joint));
        const double angles[] = {j.angles.x, j.angles.y, j.angles.z};
        EXPECT_NEAR(angles[axis], 2, 0.01);
        EXPECT_NEAR(angles[(axis + 1) % 3], 0, 1e-4);
        EXPECT_NEAR(angles[(axis + 2) % 3], 0, 1e-4);
        run(world, 9);
        const Vec3 w = state_of(world, rotor).angular_velocity;
        const double spin[] = {w.x, w.y, w.z};
        EXPECT_NEAR(spin[axis], 2, 1e-4);
        EXPECT_NEAR(length(w), 2, 1e-4);
    }
}

// A universal joint bent by 30 degrees: the driven shaft turns as Cardan's formula says,
// tan(out) = tan(in) * cos(bend), with w_out between cos(bend) and 1 / cos(bend) of w_in.
TEST(SixDof, two_free_rotations_equal_a_universal_joint) {
    World world = make_world({.gravity = {}});
    const double bend = pi / 6;
    const Quat lean = from_axis_angle({0, 0, 1}, bend);
    // Shafts along x, then along the bent x. The cross' arms are a's z and b's y.
    const BodyId in = block(world, {.geometry = Box{{0.5, 0.1, 0.1}}, .position = {-0.5, 0, 0}});
    const BodyId out = block(world, {.geometry = Box{{0.5, 0.1, 0.1}},
                                     .position = rotate(lean, {0.5, 0, 0}),
                                     .rotation = lean});
    join(world, bare_anchor(world), in, HingeJoint{.motor = {true, 2, 1e6}},
         {{-0.5, 0, 0}, along_x}, {{}, along_x});
    join(world, bare_anchor(world), out, HingeJoint{}, {rotate(lean, {0.5, 0, 0}), lean * along_x},
         {{}, along_x});
    const JointAxis free{.free = true};
    join(world, in, out, SixDofJoint{SixDofAxes{.rotation_y = free, .rotation_z = free}},
         {{0.5, 0, 0}, {}}, {{-0.5, 0, 0}, {}});
    double slow = 9, fast = 0;
    run(world, 1);
    for (int i = 0; i < 300; i++) {
        must(world.step(1.0 / 60));
        const double w = length(state_of(world, out).angular_velocity);
        slow = std::min(slow, w);
        fast = std::max(fast, w);
    }
    EXPECT_NEAR(slow, 2 * std::cos(bend), 0.02);
    EXPECT_NEAR(fast, 2 / std::cos(bend), 0.02);
}

// Each translation has its own spring and its own limit.
TEST(SixDof, axes_are_independent) {
    World world = make_world({.gravity = {}});
    const BodyId bob = block(world, {.position = {0.2, -0.3, 0}});
    SixDofAxes axes;
    axes.x = {.free = true, .spring = {1, 0}};
    axes.y = {.free = true, .spring = {2, 0}};
    axes.z = {.free = true, .limit = {true, -0.1, 0.1}, .motor = {true, 1, 1e6}};
    join(world, bare_anchor(world), bob, SixDofJoint{axes});
    World copy = make_world({.gravity = {}});
    const BodyId twin = block(copy, {.position = {0.2, -0.3, 0}});
    join(copy, bare_anchor(copy), twin, SixDofJoint{axes});
    EXPECT_NEAR(period_of(world, 10, [&] { return position_of(world, bob).x; }), 1, 0.01);
    EXPECT_NEAR(period_of(copy, 10, [&] { return position_of(copy, twin).y; }), 0.5, 0.005);
    EXPECT_NEAR(position_of(world, bob).z, 0.1, 2e-3);
}

// The wheel's spring acts between the wheel and what carries it: here what stands still.
TEST(Wheel, suspension_oscillates_at_its_frequency) {
    World world = make_world({.gravity = {}});
    const BodyId wheel =
        block(world, {.geometry = Cylinder{0.3, 0.1}, .position = {0, 0.1, 0}, .spin = {0, 0, 30}});
    join(world, bare_anchor(world), wheel,
         WheelJoint{.suspension = {2, 0}, .suspension_target = -0.05});
    EXPECT_NEAR(period_of(world, 8, [&] { return position_of(world, wheel).y + 0.05; }), 0.5,
                0.005);
    EXPECT_NEAR(state_of(world, wheel).angular_velocity.z, 30, 0.01);
    EXPECT_NEAR(position_of(world, wheel).x, 0, 1e-4);
}

TEST(Wheel, reaches_its_steering_angle_and_spins_by_its_torque) {
    World world = make_world({.gravity = {}});
    const BodyId wheel = block(world, {.geometry = Sphere{0.3}});
    const double inertia = state_of(world, wheel).inertia.z.z;
    const JointId joint =
        join(world, bare_anchor(world), wheel,
             WheelJoint{.travel = {true, 0, 0}, .motor = {true, 10, 4 * inertia}});
    run(world, 1);
    EXPECT_NEAR(state_of(world, wheel).angular_velocity.z, 4, 0.01);
    must(world.set_joint(joint, WheelJoint{.travel = {true, 0, 0}, .steering = 0.5}));
    run(world, 2);
    const JointState j = must(world.joint(joint));
    EXPECT_NEAR(j.angles.y, 0.5, 1e-3);
    const Vec3 w = state_of(world, wheel).angular_velocity;
    EXPECT_TRUE(near(w, Vec3{std::sin(0.5), 0, std::cos(0.5)} * length(w), 0.01));
}

// A car of four wheels with 20 N m on each of the rear ones: F = torque / radius in all.
TEST(Wheel, drives_a_car) {
    World world = make_world();
    add_floor(world, 1);
    const BodyId chassis =
        block(world, {.geometry = Box{{1, 0.2, 0.5}}, .position = {0, 0.7, 0}, .density = 300});
    double mass = state_of(world, chassis).mass, rolling = 0;
    std::vector<JointId> joints;
    for (int k = 0; k < 4; k++) {
        const Vec3 at{k < 2 ? -0.8 : 0.8, 0.3, k % 2 == 0 ? -0.6 : 0.6};
        const BodyId wheel =
            block(world, {.geometry = Sphere{0.3}, .position = at, .density = 200});
        mass += state_of(world, wheel).mass;
        rolling += state_of(world, wheel).inertia.z.z / 0.09;
        WheelJoint kind{.suspension = {3, 0.7}, .travel = {true, -0.2, 0.2}};
        if (k < 2) kind.motor = {true, -100, 20};
        joints.push_back(join(world, chassis, wheel, kind, {at - Vec3{0, 0.7, 0}, {}}));
    }
    run(world, 2);
    const double from = velocity_of(world, chassis).x;
    run(world, 1);
    EXPECT_NEAR(velocity_of(world, chassis).x - from, 2 * 20 / 0.3 / (mass + rolling), 0.05);
    EXPECT_NEAR(velocity_of(world, chassis).z, 0, 0.02);
    EXPECT_LT(world.summary().max_joint_error, 1e-3);
    for (const JointId joint : joints) EXPECT_LT(std::abs(must(world.joint(joint)).travel), 0.15);
}

// A castor turns behind the way it is pulled. The wheel's centre trails its steering axis.
TEST(Wheel, castor_stays_within_its_limits) {
    World world = make_world({.gravity = {}});
    const BodyId wheel = block(world, {.geometry = Sphere{0.3}, .spin = {0, 3, 0}});
    const JointId joint = join(
        world, bare_anchor(world), wheel,
        WheelJoint{
            .travel = {true, 0, 0}, .free_steering = true, .steering_limit = {true, -1, 0.75}});
    double most = 0;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        most = std::max(most, must(world.joint(joint)).angles.y);
    }
    EXPECT_NEAR(most, 0.75, 0.01);
}

// Mirrored arms, moving bases, any thread count: a saved and loaded world goes on in the same way.
TEST(AxisJoints, continue_identically_after_load) {
    World world = make_world();
    const BodyId a = block(world, {.geometry = Box{{0.2, 0.3, 0.1}}, .spin = {1, 2, 3}});
    const BodyId b = block(world, {.position = {2, 0, 0}});
    const BodyId c = block(world, {.position = {4, 0, 0}});
    const BodyId d = block(world, {.position = {6, 0, 0}});
    join(world, a, b,
         SliderJoint{.limit = {true, -1, 1},
                     .motor = {true, 1, 50},
                     .spring = {2, 0.1},
                     .friction_force = 3},
         {{1, 0, 0}, along_x}, {{-1, 0, 0}, along_x});
    SixDofAxes axes;
    axes.z = {.free = true, .limit = {true, -0.2, 0.2}};
    axes.rotation_x = {.free = true, .spring = {3, 0.2}, .spring_target = 0.4};
    axes.rotation_z = {.free = true, .motor = {true, 2, 10}, .friction = 1};
    join(world, b, c, SixDofJoint{axes}, {{1, 0, 0}, {}}, {{-1, 0, 0}, {}});
    join(world, c, d, WheelJoint{.suspension = {4, 0.3}, .steering = 0.2, .motor = {true, 5, 30}},
         {{1, 0, 0}, {}}, {{-1, 0, 0}, {}});
    run(world, 1);
    World loaded = must(load(save(world)));
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    EXPECT_EQ(first_difference(world, loaded), std::nullopt);
    run(world, 1);
    run(loaded, 1);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
}

}  // namespace
}  // namespace jostle::test
