// SPDX-License-Identifier: MIT
//
// Joints: a door on a hinge. A motor opens the door until the hinge reaches its limit. Then the
// motor is switched off, and a spring closes the door.
//
// Shows: create_joint, HingeJoint with motor, limit and spring, joint state, set_joint.
// Run:   build/dev/bin/jostle-joints
#include <cstdio>

#include "jostle/physics/physics.h"

using namespace jostle::physics;

namespace {

constexpr JointLimit limit{.enabled = true, .lower = 0, .upper = 1.2};  // rad

// Steps the world for two seconds and prints the angle of the door every half second.
void run(World& world, JointId hinge) {
    for (int step = 1; step <= 120; step++) {
        world.step(1.0 / 60).expect();
        if (step % 30 == 0)
            std::printf("  %.1f s: %.2f rad\n", world.time(), world.joint(hinge)->angle);
    }
}

}  // namespace

int main() {
    World world;
    // A door of 1 m by 2 m by 0.1 m. Its hinge is at x = 0, its centre at x = 0.5 m.
    const BodyId door = world
                            .create_body({.pose = {.position = {0.5, 1.05, 0}}},
                                         {.geometry = Box{{0.5, 1, 0.05}}, .density = 600})
                            .value();

    // A hinge rotates about the z axis of its frames. This rotation turns z into the world's y.
    const Quat upright = from_axis_angle({1, 0, 0}, -pi / 2);
    const JointMotor motor{.enabled = true, .speed = 1, .max_torque = 400};  // rad/s, N m
    const JointId hinge =
        world
            .create_joint({.body_b = door,  // no body_a: the door hangs on the world
                           .frame_a = {.position = {0, 1.05, 0}, .rotation = upright},
                           .frame_b = {.position = {-0.5, 0, 0}, .rotation = upright},
                           .kind = HingeJoint{.limit = limit, .motor = motor}})
            .value();
    std::printf("the motor opens the door:\n");
    run(world, hinge);
    const double opened = world.joint(hinge)->angle;

    // The same hinge, with a spring of 0.5 Hz instead of the motor.
    world.set_joint(hinge, HingeJoint{.limit = limit, .spring = {.hertz = 0.5}}).expect();
    std::printf("the spring closes the door:\n");
    run(world, hinge);

    const JointState end = world.joint(hinge).value();
    std::printf("the anchors are %.1f mm apart\n", 1000 * end.separation);
    return opened > 1.19 && end.angle < 0.05 && end.separation < 0.001 ? 0 : 1;
}
