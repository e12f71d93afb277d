// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/modules/vehicle_def.h"

namespace jostle::modules::vehicle_detail {

// Impulse of drag and downforce at velocity v over the time h, N s; implicit in the drag.
inline physics::Vec3 aerodynamic_impulse(const Aerodynamics& air, physics::Vec3 v, physics::Vec3 up,
                                         double mass, double h) {
    const double speed = length(v), flow = 0.5 * air.density * speed * h;
    const double drag = flow * air.drag_area;
    const double press = physics::minimum(flow * speed * air.downforce_area, 100 * mass * h);
    return v * (-drag / (1 + drag / mass)) - up * press;
}

}  // namespace jostle::modules::vehicle_detail
