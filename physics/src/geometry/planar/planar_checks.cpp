// SPDX-License-Identifier: MIT
#include "physics/src/geometry/planar/planar_checks.h"

#include "jostle/physics/limits.h"
#include "physics/src/foundation/messages.h"

namespace jostle::physics::planar {

Status check_points(const char* name, std::span<const Vec2> points, std::size_t least,
                    std::size_t most) {
    if (points.size() < least || points.size() > most)
        return invalid_argument(std::string(name) + " has " + std::to_string(points.size()) +
                                " points; it must have from " + std::to_string(least) + " to " +
                                std::to_string(most));
    for (std::size_t k = 0; k < points.size(); k++) {
        const Vec2 p = points[k];
        if (absolute(p.x) <= limits::max_coordinate && absolute(p.y) <= limits::max_coordinate)
            continue;
        return invalid_argument(std::string(name) + "[" + std::to_string(k) + "] is (" + text(p.x) +
                                ", " + text(p.y) + "); coordinates must be finite and within +-" +
                                text(limits::max_coordinate) + " m");
    }
    return {};
}

}  // namespace jostle::physics::planar
