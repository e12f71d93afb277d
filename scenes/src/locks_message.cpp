// SPDX-License-Identifier: MIT
#include "jostle/scenes/locks_message.h"

#include "jostle/v1/scene.pb.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr struct {
    AxisLocks bit;
    bool (v1::Locks::*get)() const;
    void (v1::Locks::*set)(bool);
} lock_fields[] = {{lock_x, &v1::Locks::x, &v1::Locks::set_x},
                   {lock_y, &v1::Locks::y, &v1::Locks::set_y},
                   {lock_z, &v1::Locks::z, &v1::Locks::set_z},
                   {lock_rotation_x, &v1::Locks::turn_x, &v1::Locks::set_turn_x},
                   {lock_rotation_y, &v1::Locks::turn_y, &v1::Locks::set_turn_y},
                   {lock_rotation_z, &v1::Locks::turn_z, &v1::Locks::set_turn_z}};

}  // namespace

v1::Locks locks_message(AxisLocks locks) {
    v1::Locks message;
    for (const auto& field : lock_fields)
        if ((locks & field.bit) != 0) (message.*field.set)(true);
    return message;
}

AxisLocks locks_of(const v1::Locks& message) {
    AxisLocks locks = 0;
    for (const auto& field : lock_fields)
        if ((message.*field.get)()) locks = static_cast<AxisLocks>(locks | field.bit);
    return locks;
}

}  // namespace jostle::scenes
