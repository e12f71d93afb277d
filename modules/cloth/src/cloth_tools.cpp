// SPDX-License-Identifier: MIT
//
// The tools of players on cloth: rays, grabs, pushes, cuts and pulses of pressure.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "jostle/modules/cloth.h"
#include "jostle/modules/mass_points.h"
#include "jostle/modules/ray_tests.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/cloth_data.h"
#include "modules/cloth/src/cloth_step.h"

namespace jostle::modules {

using namespace physics;
using cloth_detail::Cloth;
using cloth_detail::Sheet;

namespace {

Error unknown(std::uint32_t object) {
    return Error{ErrorCode::not_found, "no cloth has the key " + std::to_string(object)};
}
Error no_vertex(std::uint32_t vertex) {
    return Error{ErrorCode::not_found, "the cloth has no vertex " + std::to_string(vertex)};
}

double mass_of(const Sheet& sheet) {
    double sum = 0;
    for (const double mass : sheet.topology().masses) sum += mass;
    return sum;
}

bool may_meet(const Ray& ray, const Sheet& sheet) {
    Vec3 low = sheet.position(0), high = low;
    for (std::size_t k = 1; k < sheet.size(); k++) {
        low = min(low, sheet.position(k));
        high = max(high, sheet.position(k));
    }
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; axis++) {
        if (ray.motion[axis] == 0) {
            if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return false;
            continue;
        }
        const double a = (low[axis] - ray.origin[axis]) / ray.motion[axis];
        const double b = (high[axis] - ray.origin[axis]) / ray.motion[axis];
        first = maximum(first, minimum(a, b));
        last = minimum(last, maximum(a, b));
    }
    return first <= last + 1e-9;
}

bool is_attached(const Cloth& cloth, std::uint32_t vertex) {
    return std::ranges::binary_search(cloth.attachments, vertex, {}, &ClothAttachment::vertex);
}

// Of all vertices, or of the free ones if there are any.
std::uint32_t nearest_vertex(const Cloth& cloth, Vec3 point, bool free) {
    return nearest_element(
        cloth.sheet.size(), point, [&](std::size_t k) { return cloth.sheet.position(k); },
        [&](std::uint32_t vertex) { return !free || !is_attached(cloth, vertex); });
}

// A third of the area of the triangles at each vertex, as a vector normal to them, m^2.
std::vector<Vec3> areas_of(const Sheet& sheet) {
    std::vector<Vec3> areas(sheet.size());
    for (const auto& corners : sheet.topology().triangles) {
        const Vec3 a = sheet.position(corners[0]);
        const Vec3 third =
            cross(sheet.position(corners[1]) - a, sheet.position(corners[2]) - a) * (1.0 / 6);
        for (const std::uint32_t corner : corners) areas[corner] += third;
    }
    return areas;
}

}  // namespace

std::optional<DeformableHit> Cloths::cast_ray(const Ray& ray) const {
    std::optional<DeformableHit> first;
    for (const auto& cloth : cloths_) {
        const Sheet& sheet = cloth->sheet;
        if (!may_meet(ray, sheet)) continue;
        for (const auto& corners : sheet.topology().triangles) {
            const auto hit =
                meet_triangle(ray, {sheet.position(corners[0]), sheet.position(corners[1]),
                                    sheet.position(corners[2])});
            if (!hit || (first && hit->fraction >= first->fraction)) continue;
            first = DeformableHit{{cloth->key.number, corners[hit->corner]},
                                  hit->fraction,
                                  ray.origin + ray.motion * hit->fraction};
        }
    }
    return first;
}

std::optional<DeformablePoint> Cloths::nearest(std::uint32_t object, Vec3 point) const {
    const Cloth* cloth = find({object});
    if (cloth == nullptr || !is_finite(point)) return std::nullopt;
    return DeformablePoint{object, nearest_vertex(*cloth, point, true)};
}

Status Cloths::push(World&, DeformablePoint at, Vec3 impulse) {
    Cloth* cloth = find({at.object});
    if (cloth == nullptr) return unknown(at.object);
    Sheet& sheet = cloth->sheet;
    if (at.element >= sheet.size()) return no_vertex(at.element);
    if (!is_finite(impulse))
        return Error{ErrorCode::invalid_argument, "impulse: is not finite; must be in N s"};
    const std::vector<Vec3> changes = spread_impulse(
        sheet.size(), at.element, sheet.position(at.element), impulse,
        [&](std::size_t k) { return sheet.position(k); },
        [&](std::size_t k) { return sheet.topology().masses[k]; });
    for (std::size_t k = 0; k < changes.size(); k++)
        if (changes[k] != Vec3{}) sheet.set_velocity(k, sheet.velocity(k) + changes[k]);
    cloth_detail::wake(*cloth);
    return {};
}

Status Cloths::grab(World& world, std::uint32_t holder, DeformablePoint at) {
    if (holder == 0) return Error{ErrorCode::invalid_argument, "holder: is 0; must be at least 1"};
    Cloth* cloth = find({at.object});
    if (cloth == nullptr) return unknown(at.object);
    if (at.element >= cloth->sheet.size()) return no_vertex(at.element);
    if (is_attached(*cloth, at.element))
        return Error{ErrorCode::failed_precondition,
                     "vertex " + std::to_string(at.element) + " is attached or held already"};
    if (Status s = attach(world, cloth->key, {.vertex = at.element}); !s.ok()) return s;
    release(holder);
    std::ranges::find(cloth->attachments, at.element, &ClothAttachment::vertex)->holder = holder;
    cloth->bodies.add_grab(
        make_point_grab(holder, cloth->sheet.position(at.element), mass_of(cloth->sheet)));
    return {};
}

bool Cloths::drag(std::uint32_t holder, Vec3 target) {
    for (const auto& cloth : cloths_)
        if (PointGrab* grab = cloth->bodies.grab(holder)) return grab->aim_at(target);
    return false;
}

void Cloths::release(std::uint32_t holder) {
    for (const auto& cloth : cloths_) {
        if (holder == 0 || cloth->bodies.grab(holder) == nullptr) continue;
        cloth->bodies.remove_grab(holder);
        std::erase_if(cloth->attachments,
                      [&](const ClothAttachment& each) { return each.holder == holder; });
        cloth_detail::wake(*cloth);
    }
}

Status Cloths::cut_at(World& world, std::uint32_t object, Vec3 point) {
    const Cloth* cloth = find({object});
    if (cloth == nullptr) return unknown(object);
    if (!is_finite(point))
        return Error{ErrorCode::invalid_argument, "point: is not finite; must be a point in m"};
    const Vec3 at = cloth->sheet.position(nearest_vertex(*cloth, point, false));
    const Result<std::uint32_t> torn = tear(world, {object}, at, 0);
    if (!torn.ok()) return torn.error();
    if (*torn > 0) return {};
    return Error{ErrorCode::failed_precondition, "the cloth is torn at this vertex already"};
}

// Both sides of a cloth face the pulse.
void Cloths::apply_pulse(World&, const PressurePulse& pulse) {
    for (const auto& cloth : cloths_) {
        Sheet& sheet = cloth->sheet;
        std::vector<Vec3> areas;
        for (std::size_t k = 0; k < sheet.size(); k++) {
            const Vec3 at = sheet.position(k), away = at - pulse.center;
            if (length_squared(away) >= pulse.radius * pulse.radius) continue;
            if (areas.empty()) areas = areas_of(sheet);
            const double distance = length(away);
            const double area =
                distance > 0 ? absolute(dot(areas[k], away)) / distance : length(areas[k]);
            sheet.set_velocity(
                k, sheet.velocity(k) + pulse.change_of(at, area, sheet.topology().masses[k]));
        }
        if (!areas.empty()) cloth_detail::wake(*cloth);
    }
}

}  // namespace jostle::modules
