// SPDX-License-Identifier: MIT
//
// What a character gives to a dynamic body that is in its way: a plastic impact, so that momentum
// is kept. What it had before it made an effort is an impact of any size; the effort is bounded.
#pragma once

#include "surroundings.h"

namespace jostle::modules::character_detail {

struct Push {
    physics::Vec3 before;  // m/s of the character before it made an effort, as the body's
    physics::Vec3 now;     // m/s with the effort
    double effort = 0;     // N s that are left of it
};

// 1/kg: how easily a point of the body gives way along a unit direction; 0 where nothing moves it.
double compliance(const physics::BodyState& body, physics::Vec3 point, physics::Vec3 direction);

// The impulse along -normal that the character gives, N s; it was applied to the body, and taken
// off the effort. 0: they do not close.
double push_body(physics::World& world, const Contact& contact, double mass, Push& push);

}  // namespace jostle::modules::character_detail
