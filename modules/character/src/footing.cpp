// SPDX-License-Identifier: MIT
#include "modules/character/src/footing.h"

#include "modules/character/src/nearest_velocity.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

constexpr double lift_min = 0.02;  // upward component of a normal; a smaller one is a wall

Footing make_footing(const Contact& contact, GroundKind kind, Vec3 normal) {
    return {kind, contact.body, contact.shape, normal, contact.normal, contact.point, contact.gap};
}

// Returns true if steep planes wedge the character so that it cannot fall.
bool is_wedged(std::span<const Contact> touching) {
    VelocityPlanes planes;
    for (const Contact& contact : touching) planes.add(contact.normal, 0);
    return touching.size() > 1 && length(planes.nearest(-up)) < 0.05;
}

}  // namespace

double min_walkable_normal_y(const CharacterData& record) {
    return sin_cos(record.abilities.slope_limit).cos - 1e-9;
}

bool is_step_edge(const EnvironmentQuery& near, const CharacterData& record, Vec3 feet, Vec3 point,
                  Vec3 normal) {
    constexpr double slack = 0.002;  // m
    const double step = record.abilities.step_height;
    if (normal.y < lift_min || point.y - feet.y > step + slack) return false;
    const auto tread = near.floor_behind(point, normal);
    if (!tread || tread->y < min_walkable_normal_y(record)) return false;
    const double waist = record.radius;
    return near.cast_ray(feet + up * waist, -up * (waist + step + 10 * slack)).has_value();
}

Footing find_footing(const EnvironmentQuery& near, const CharacterData& record, Vec3 feet,
                     std::span<const Contact> contacts, double close) {
    std::size_t touching = 0;  // contacts are sorted by gap
    const Contact* best = nullptr;
    for (; touching < contacts.size() && contacts[touching].gap <= close; touching++) {
        const Contact& contact = contacts[touching];
        if (contact.normal.y < lift_min) continue;
        if (best == nullptr || contact.normal.y > best->normal.y) best = &contact;
    }
    if (best == nullptr) return {};
    if (best->normal.y >= min_walkable_normal_y(record))
        return make_footing(*best, GroundKind::on_ground, best->normal);
    for (const Contact& contact : contacts.first(touching))
        if (is_step_edge(near, record, feet, contact.point, contact.normal))
            return make_footing(contact, GroundKind::on_ground, up);
    if (is_wedged(contacts.first(touching))) return make_footing(*best, GroundKind::on_ground, up);
    return make_footing(*best, GroundKind::on_steep_ground, best->normal);
}

}  // namespace jostle::modules::character_detail
