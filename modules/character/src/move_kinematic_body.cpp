// SPDX-License-Identifier: MIT
#include "modules/character/src/sweep_parts.h"

#include "modules/character/src/steering.h"

namespace jostle::modules::character_detail {

using namespace physics;

void move_kinematic_body(World& world, const CharacterData& record, double rise, double speed,
                         double dt) {
    const Transform pose{record.feet + up * record.foot_height, orientation(record)};
    const Result<BodyState> body = world.body(record.body);
    if (!body.ok()) return;
    const bool rests = body->linear_velocity == Vec3{} && body->angular_velocity == Vec3{};
    if (rests && body->pose == pose) return;
    constexpr double least_rise = 0.01;  // m
    Vec3 teleport = absolute(rise) > least_rise ? up * rise : Vec3{};
    const Vec3 displacement = pose.position - body->pose.position - teleport;
    const double size = length(displacement), most = speed * dt;
    if (size > most) teleport += displacement * (1 - most / size);
    if (teleport != Vec3{})
        static_cast<void>(
            world.set_pose(record.body, {body->pose.position + teleport, body->pose.rotation}));
    static_cast<void>(world.move_to(record.body, pose, dt));
}

}  // namespace jostle::modules::character_detail
