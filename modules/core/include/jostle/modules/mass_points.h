// SPDX-License-Identifier: MIT
//
// Helpers for modules whose deformable objects consist of mass points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "jostle/modules/deformables.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules {

/// Index of the mass point that is nearest to a point (m), of those for which `is_free(index)` if
/// there are any. `count` is at least 1; `position_of(index)` in m.
template <class GetPosition, class IsFree>
std::uint32_t nearest_element(std::size_t count, physics::Vec3 point,
                              const GetPosition& position_of, const IsFree& is_free) {
    const auto rank = [&](std::uint32_t k) {
        return std::pair(!is_free(k), physics::length_squared(position_of(k) - point));
    };
    std::uint32_t best = 0;
    auto best_rank = rank(0);
    for (std::uint32_t k = 1; k < count; k++)
        if (const auto own = rank(k); own < best_rank) {
            best = k;
            best_rank = own;
        }
    return best;
}

/// Velocity changes (m/s) of `count` mass points by an impulse (N s) at a point (m), spread with
/// the weights (1 - (d / push_radius)^2) times mass; none exceeds Deformables::push_speed_max.
/// `position_of` and `mass_of` return those of a mass point, in m and kg. If no mass point is
/// within the radius, `nearest` receives the impulse.
template <class GetPosition, class GetMass>
std::vector<physics::Vec3> spread_impulse(std::size_t count, std::size_t nearest,
                                          physics::Vec3 point, physics::Vec3 impulse,
                                          const GetPosition& position_of, const GetMass& mass_of) {
    std::vector<double> shares(count);
    double sum = 0;
    for (std::size_t k = 0; k < count; k++) {
        const double far = physics::length(position_of(k) - point) / Deformables::push_radius;
        shares[k] = far < 1 ? 1 - far * far : 0;
        sum += shares[k] * mass_of(k);
    }
    if (!(sum > 0)) {
        shares[nearest] = 1;
        sum = mass_of(nearest);
    }
    physics::Vec3 change = impulse * (1 / sum);
    const double speed = physics::length(change);
    if (speed > Deformables::push_speed_max) change *= Deformables::push_speed_max / speed;
    std::vector<physics::Vec3> changes(count);
    for (std::size_t k = 0; k < count; k++) changes[k] = change * shares[k];
    return changes;
}

}  // namespace jostle::modules
