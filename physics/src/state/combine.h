// SPDX-License-Identifier: MIT
//
// One coefficient from two materials.
#pragma once

#include "jostle/physics/defs.h"

namespace jostle::physics {

inline double combine(double a, Combine rule_a, double b, Combine rule_b) {
    switch (rule_a < rule_b ? rule_b : rule_a) {
        case Combine::average:
            return 0.5 * (a + b);
        case Combine::geometric_mean:
            return square_root(a * b);
        case Combine::minimum:
            return minimum(a, b);
        case Combine::multiply:
            return a * b;
        case Combine::maximum:
            break;
    }
    return maximum(a, b);
}

inline double pair_friction(const Material& a, const Material& b) {
    return combine(a.friction, a.friction_rule, b.friction, b.friction_rule);
}
inline double pair_restitution(const Material& a, const Material& b) {
    return combine(a.restitution, a.restitution_rule, b.restitution, b.restitution_rule);
}

}  // namespace jostle::physics
