// SPDX-License-Identifier: MIT
#include "physics/src/geometry/geometry_checks.h"

#include "jostle/physics/limits.h"
#include "physics/src/foundation/messages.h"

namespace jostle::physics {

Status check_mass(double mass) {
    return mass == 0 ? Status{} : check_range("mass", mass, limits::min_mass, limits::max_mass);
}

Status check_pose(const char* name, const Transform& pose) {
    const double norm = norm_squared(pose.rotation);
    const bool turned = is_finite(norm) && norm > 1e-12 && norm < 1e12;
    if (turned && is_within(pose.position, limits::max_coordinate)) return {};
    // Build names for errors only, because this is called very often.
    const std::string prefix = name;
    if (Status s =
            check_vector((prefix + ".position").c_str(), pose.position, limits::max_coordinate);
        !s.ok())
        return s;
    const Quat q = pose.rotation;
    return invalid_argument(prefix + ".rotation is (" + text(q.x) + ", " + text(q.y) + ", " +
                            text(q.z) + ", " + text(q.w) + "); it must be finite and not zero");
}

Status check_material(const Material& m) {
    if (Status s = check_range("friction", m.friction, 0, 100); !s.ok()) return s;
    if (Status s = check_range("restitution", m.restitution, 0, 1); !s.ok()) return s;
    if (Status s = check_range("rolling_friction", m.rolling_friction, 0, 100); !s.ok()) return s;
    if (Status s = check_range("torsional_friction", m.torsional_friction, 0, 100); !s.ok())
        return s;
    if (Status s = check_vector("surface_velocity", m.surface_velocity, limits::max_speed); !s.ok())
        return s;
    if (m.friction_rule > Combine::maximum || m.restitution_rule > Combine::maximum)
        return invalid_argument("friction_rule or restitution_rule has an unknown value");
    return {};
}

}  // namespace jostle::physics
