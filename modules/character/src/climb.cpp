// SPDX-License-Identifier: MIT
#include "modules/character/src/sweep_parts.h"

#include "modules/character/src/footing.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

constexpr double clearance = 0.0002;  // m between the capsules swept in this file and the skin

// The capsule with most of its skin. A character that steps onto an edge therefore stands on it as
// soon as its skin does.
Capsule with_skin(const CharacterData& record) {
    Capsule capsule = capsule_of(record, current_height(record));
    capsule.radius += record.skin - minimum(clearance, 0.5 * record.skin);
    return capsule;
}

// Returns the fraction of the motion that is free, minus the clearance.
double free_fraction(const EnvironmentQuery& near, const Capsule& capsule, Vec3 from, Vec3 motion) {
    const auto hit = near.sweep(capsule, from, motion);
    if (!hit) return 1;
    return maximum(0, hit->fraction - 1e-5 / length(motion));
}

}  // namespace

std::optional<Vec3> step_down(const EnvironmentQuery& near, const CharacterData& record, Vec3 from,
                              double drop, double floor_height_max) {
    const Capsule capsule = with_skin(record);
    const Vec3 motion = up * -(drop + clearance);
    const auto hit = near.sweep(capsule, from, motion);
    if (!hit || hit->fraction <= 0 || hit->point.y > floor_height_max) return std::nullopt;
    const double lift = clearance / maximum(hit->normal.y, 0.5);  // back to the full skin
    const Vec3 landing =
        from + motion * hit->fraction + up * minimum(lift, -motion.y * hit->fraction);
    const Vec3 feet = landing - up * (0.5 * current_height(record));
    const bool stands = hit->normal.y >= min_walkable_normal_y(record) ||
                        is_step_edge(near, record, feet, hit->point, hit->normal);
    return stands ? std::optional(landing) : std::nullopt;
}

std::optional<Vec3> climb(const EnvironmentQuery& near, const CharacterData& record, Vec3 from,
                          Vec3 displacement, double min_progress) {
    const Capsule capsule = with_skin(record);
    const double step = record.abilities.step_height;
    const double rise = step * free_fraction(near, capsule, from, up * step);
    if (rise < clearance) return std::nullopt;
    const Vec3 above = from + up * rise;
    const double fraction = free_fraction(near, capsule, above, displacement);
    if (fraction * length(displacement) <= min_progress) return std::nullopt;
    const double floor = from.y - 0.5 * current_height(record);
    const auto landing = step_down(near, record, above + displacement * fraction, rise + clearance,
                                   floor + step + 0.002);
    // A step must rise. On a level floor, the remaining displacement is only the clearance to a
    // wall.
    if (!landing || landing->y - from.y < 0.1 * fraction * length(displacement))
        return std::nullopt;
    return landing;
}

}  // namespace jostle::modules::character_detail
