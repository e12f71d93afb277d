// SPDX-License-Identifier: MIT
#include "server/world/resolve_target.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "jostle/modules/deformables.h"
#include "server/world/point_shapes.h"
#include "server/world/rewind_view.h"

namespace jostle::server {

using namespace physics;

namespace {

struct AimHit {
    EntityId entity = 0;
    Vec3 point;           // world; at the current pose of the entity
    double fraction = 0;  // of the ray
};

QueryFilter filter_of(const HostedState& state, const Aim& aim) {
    const Entity* ignored = state.entities.find(aim.ignore);
    return {.ignore = ignored ? ignored->body : BodyId{}};
}

Result<AimHit> aim_hit_of(const HostedState& state, const Result<std::optional<RayHit>>& hit) {
    if (!hit.ok()) return hit.error();
    if (!*hit) return Error{ErrorCode::not_found, "the ray of the aim hits no shape"};
    return AimHit{state.entities.entity_of((*hit)->body), (*hit)->point, (*hit)->fraction};
}

Result<AimHit> cast_now(const HostedState& state, const Aim& aim) {
    return aim_hit_of(
        state, state.world.queries().cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
}

// The hit point is transformed to the current pose of its body.
Result<AimHit> cast_rewound(const HostedState& state, const RewindView& past, const EntityList& now,
                            const Aim& aim) {
    const Result<Queries> then = state.world.queries().with_shapes_at(
        past.shapes_along_segment(now, aim.origin, aim.motion));
    if (!then.ok()) return then.error();
    Result<AimHit> hit =
        aim_hit_of(state, then->cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
    if (!hit.ok()) return hit;
    ASSERT(past.pose_of(hit->entity) && state.entities.find(hit->entity));
    const Transform past_pose = *past.pose_of(hit->entity);
    const Transform pose = state.world.body(state.entities.find(hit->entity)->body)->pose;
    hit->point = apply(pose, apply_inverse(past_pose, hit->point));
    return hit;
}

// The parts of an action that resolve_target() reads and sets.
struct Targeting {
    const std::optional<Aim>* aim = nullptr;
    std::uint32_t point_object = 0;
    Vec3 point;  // near the object
};

Targeting targeting_of(const Action& action) {
    if (const auto* impulse = std::get_if<ImpulseCommand>(&action))
        return {&impulse->aim, impulse->point_object, impulse->point.value_or(Vec3{})};
    if (const auto* grab = std::get_if<GrabCommand>(&action))
        return {&grab->aim, grab->point_object, grab->point};
    if (const auto* explode = std::get_if<ExplodeCommand>(&action)) return {&explode->aim};
    if (const auto* cut = std::get_if<CutCommand>(&action))
        return {&cut->aim, cut->point_object, cut->point};
    return {};
}

Status set_entity(Action& action, const AimHit& hit) {
    if (auto* impulse = std::get_if<ImpulseCommand>(&action)) {
        impulse->entity = hit.entity;
        impulse->point = hit.point;
    } else if (auto* grab = std::get_if<GrabCommand>(&action)) {
        grab->entity = hit.entity;
        grab->point = hit.point;
    } else if (auto* explode = std::get_if<ExplodeCommand>(&action)) {
        explode->center = hit.point;
    } else if (std::holds_alternative<CutCommand>(action)) {
        return Error{ErrorCode::permission_denied, "the ray of the aim hits entity " +
                                                       std::to_string(hit.entity) +
                                                       "; only ropes and cloths can be cut"};
    }
    return {};
}

void set_deformable(Action& action, const DeformableTarget& target, Vec3 point) {
    if (auto* impulse = std::get_if<ImpulseCommand>(&action))
        impulse->deformable = target;
    else if (auto* grab = std::get_if<GrabCommand>(&action))
        grab->deformable = target;
    else if (auto* explode = std::get_if<ExplodeCommand>(&action))
        explode->center = point;
    else if (auto* cut = std::get_if<CutCommand>(&action)) {
        cut->deformable = target;
        cut->point = point;
    }
}

// What a ray hits of ropes and cloths.
struct DeformableAimHit {
    DeformableTarget target;
    Vec3 point;  // m, world; at the current position of what was hit
    double fraction = 0;
};

std::optional<DeformableAimHit> cast_at_deformables_now(const HostedState& state, const Ray& ray) {
    const auto hit = modules::cast_ray_at_deformables(state.world, ray);
    if (!hit) return std::nullopt;
    // The nearest point may be attached, so that it cannot be grabbed.
    const auto at =
        modules::deformables_of(state.world, hit->module)->nearest(hit->at.object, hit->position);
    ASSERT(at);
    return DeformableAimHit{{hit->module, at->object, at->element}, hit->position, hit->fraction};
}

// The current position of a point of a point object; nothing: it does not exist any more.
std::optional<Vec3> position_now(const HostedState& state, const ModuleChannels& channels,
                                 std::uint32_t object, std::size_t element) {
    const auto pose_of = [&](EntityId id) -> std::optional<Transform> {
        const Entity* const entity = state.entities.find(id);
        const auto body = state.world.body(entity ? entity->body : BodyId{});
        return body.ok() ? std::optional(body->pose) : std::nullopt;
    };
    const auto& objects = *channels.points();
    const auto found =
        std::ranges::find(objects, object, [](const auto& s) { return s->object->id; });
    if (found == objects.end()) return std::nullopt;
    const auto placed = place_points({*found}, pose_of, [](Vec3, double) { return true; });
    if (placed.empty() || element >= placed.front().positions.size()) return std::nullopt;
    return placed.front().positions[element];
}

// The hit moved with the point next to it. Nothing also if the object has ended since.
std::optional<DeformableAimHit> cast_at_deformables_rewound(const HostedState& state,
                                                            const ModuleChannels& channels,
                                                            const RewindView& past,
                                                            const Ray& ray) {
    const auto hit = cast_ray(past.points(along_segment(ray.origin, ray.motion)), ray);
    if (!hit) return std::nullopt;
    const auto object = channels.point_object(hit->object->id);
    const auto now = position_now(state, channels, hit->object->id, hit->element);
    const modules::Deformables* const deformables =
        object ? modules::deformables_of(state.world, object->module) : nullptr;
    if (!now || deformables == nullptr) return std::nullopt;
    const auto at = deformables->nearest(object->key, *now);
    if (!at) return std::nullopt;
    const Vec3 then = ray.origin + ray.motion * hit->fraction;
    return DeformableAimHit{
        {object->module, at->object, at->element}, then + (*now - hit->element_at), hit->fraction};
}

Status resolve_aim(const HostedState& state, const ModuleChannels& channels, const FrameRing& past,
                   const EntityList& now, const Aim& aim, Action& action, InputResult& result) {
    const Ray ray{aim.origin, aim.motion};
    std::optional<DeformableAimHit> deformable;
    Result<AimHit> hit = AimHit{};
    const auto frames = aim.view_time ? past.at(*aim.view_time) : std::nullopt;
    if (frames) {
        const RewindView view(*frames);
        result.view_time_clamped = view.clamped();
        hit = cast_rewound(state, view, now, aim);
        // Points are stored while a client subscribes to them.
        deformable = view.has_points() ? cast_at_deformables_rewound(state, channels, view, ray)
                                       : cast_at_deformables_now(state, ray);
    } else {
        hit = cast_now(state, aim);
        deformable = cast_at_deformables_now(state, ray);
    }
    if (deformable && (!hit.ok() || deformable->fraction < hit->fraction)) {
        set_deformable(action, deformable->target, deformable->point);
        return {};
    }
    if (!hit.ok()) return hit.error();
    result.entity = hit->entity;
    return set_entity(action, *hit);
}

Status resolve_point_object(const HostedState& state, const ModuleChannels& channels,
                            const Targeting& from, Action& action) {
    const std::string id = std::to_string(from.point_object);
    const auto object = channels.point_object(from.point_object);
    const modules::Deformables* deformables =
        object ? modules::deformables_of(state.world, object->module) : nullptr;
    const auto at = deformables ? deformables->nearest(object->key, from.point) : std::nullopt;
    if (!at)
        return Error{ErrorCode::not_found,
                     "point object " + id + " does not exist or is no rope or cloth"};
    set_deformable(action, {object->module, at->object, at->element}, from.point);
    return {};
}

}  // namespace

bool has_target(const Action& action) {
    const Targeting targeting = targeting_of(action);
    return (targeting.aim && *targeting.aim) || targeting.point_object != 0;
}

Status resolve_target(const HostedState& state, const ModuleChannels& channels,
                      const FrameRing& past, const EntityList& now, Action& action,
                      InputResult& result) {
    const Targeting targeting = targeting_of(action);
    if (targeting.aim && *targeting.aim) {
        const Aim aim = **targeting.aim;  // the action changes
        return resolve_aim(state, channels, past, now, aim, action, result);
    }
    if (targeting.point_object != 0)
        return resolve_point_object(state, channels, targeting, action);
    return {};
}

}  // namespace jostle::server
