// SPDX-License-Identifier: MIT
//
// The tools of players on ropes: rays, grabs, pushes, cuts and pulses of pressure.
#include <algorithm>
#include <string>
#include <utility>

#include "jostle/modules/mass_points.h"
#include "jostle/modules/ray_tests.h"
#include "jostle/modules/rope.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_data.h"
#include "modules/rope/src/rope_step.h"

namespace jostle::modules {

using namespace physics;
using rope_detail::Rope;
using rope_detail::Strand;

namespace {

Error unknown(std::uint32_t object) {
    return Error{ErrorCode::not_found, "no rope has the key " + std::to_string(object)};
}

double mass_of(const Strand& strand, std::size_t node) {
    const double before = node > 0 ? strand.rest_lengths[node - 1] : 0;
    const double after = node < strand.links() ? strand.rest_lengths[node] : 0;
    return 0.5 * strand.mass_per_length * (before + after);
}

double mass_of(const Strand& strand) {
    double length = 0;
    for (const double link : strand.rest_lengths) length += link;
    return strand.mass_per_length * length;
}

bool is_attached(const Rope& rope, std::uint32_t node) {
    return std::ranges::binary_search(rope.attachments, node, {}, &RopeAttachment::node);
}

}  // namespace

std::optional<DeformableHit> Ropes::cast_ray(const Ray& ray) const {
    std::optional<DeformableHit> first;
    for (const auto& rope : ropes_) {
        const Strand& strand = rope->strand;
        for (std::size_t k = 0; k < strand.links(); k++) {
            const auto hit =
                enter_link(ray, strand.positions[k], strand.positions[k + 1], rope->def.radius);
            if (!hit || (first && hit->fraction >= first->fraction)) continue;
            first = DeformableHit{
                {rope->key.number, static_cast<std::uint32_t>(hit->share < 0.5 ? k : k + 1)},
                hit->fraction,
                ray.origin + ray.motion * hit->fraction};
        }
    }
    return first;
}

std::optional<DeformablePoint> Ropes::nearest(std::uint32_t object, Vec3 point) const {
    const Rope* rope = find({object});
    if (rope == nullptr || !is_finite(point)) return std::nullopt;
    return DeformablePoint{object,
                           nearest_element(
                               rope->strand.positions.size(), point,
                               [&](std::size_t k) { return rope->strand.positions[k]; },
                               [&](std::uint32_t node) { return !is_attached(*rope, node); })};
}

Status Ropes::push(World&, DeformablePoint at, Vec3 impulse) {
    Rope* rope = find({at.object});
    if (rope == nullptr) return unknown(at.object);
    Strand& strand = rope->strand;
    if (at.element > strand.links())
        return Error{ErrorCode::not_found, "the rope has no node " + std::to_string(at.element)};
    if (!is_finite(impulse))
        return Error{ErrorCode::invalid_argument, "impulse: is not finite; must be in N s"};
    const std::vector<Vec3> changes = spread_impulse(
        strand.positions.size(), at.element, strand.positions[at.element], impulse,
        [&](std::size_t k) { return strand.positions[k]; },
        [&](std::size_t k) { return mass_of(strand, k); });
    for (std::size_t k = 0; k < changes.size(); k++) strand.velocities[k] += changes[k];
    rope_detail::wake(*rope);
    return {};
}

Status Ropes::grab(World& world, std::uint32_t holder, DeformablePoint at) {
    if (holder == 0) return Error{ErrorCode::invalid_argument, "holder: is 0; must be at least 1"};
    Rope* rope = find({at.object});
    if (rope == nullptr) return unknown(at.object);
    if (at.element > rope->strand.links())
        return Error{ErrorCode::not_found, "the rope has no node " + std::to_string(at.element)};
    if (is_attached(*rope, at.element))
        return Error{ErrorCode::failed_precondition,
                     "node " + std::to_string(at.element) + " is attached or held already"};
    if (Status s = attach(world, rope->key, {.node = at.element}); !s.ok()) return s;
    release(holder);
    std::ranges::find(rope->attachments, at.element, &RopeAttachment::node)->holder = holder;
    rope->bodies.add_grab(
        make_point_grab(holder, rope->strand.positions[at.element], mass_of(rope->strand)));
    return {};
}

bool Ropes::drag(std::uint32_t holder, Vec3 target) {
    for (const auto& rope : ropes_)
        if (PointGrab* grab = rope->bodies.grab(holder)) return grab->aim_at(target);
    return false;
}

void Ropes::release(std::uint32_t holder) {
    for (const auto& rope : ropes_) {
        if (holder == 0 || rope->bodies.grab(holder) == nullptr) continue;
        rope->bodies.remove_grab(holder);
        std::erase_if(rope->attachments,
                      [&](const RopeAttachment& each) { return each.holder == holder; });
        rope_detail::wake(*rope);
    }
}

Status Ropes::cut_at(World& world, std::uint32_t object, Vec3 point) {
    const Result<RopeKey> rest = cut(world, {object}, point);
    return rest.ok() ? Status() : rest.error();
}

// A rope presents its diameter to the pulse.
void Ropes::apply_pulse(World&, const PressurePulse& pulse) {
    for (const auto& rope : ropes_) {
        Strand& strand = rope->strand;
        bool any = false;
        for (std::size_t k = 0; k < strand.positions.size(); k++) {
            const Vec3 at = strand.positions[k];
            if (length_squared(at - pulse.center) >= pulse.radius * pulse.radius) continue;
            const double area = 2 * rope->def.radius * mass_of(strand, k) / strand.mass_per_length;
            strand.velocities[k] += pulse.change_of(at, area, mass_of(strand, k));
            any = true;
        }
        if (any) rope_detail::wake(*rope);
    }
}

}  // namespace jostle::modules
