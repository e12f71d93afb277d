// SPDX-License-Identifier: MIT
#include "server/world/resolve_aim.h"

#include <utility>
#include <variant>

#include "server/world/rewind_view.h"

namespace jostle::server {

using namespace physics;

namespace {

struct AimHit {
    EntityId entity = 0;
    Vec3 point;  // as it is now
};

QueryFilter filter_of(const HostedState& state, const Aim& aim) {
    const Entity* ignored = state.entities.find(aim.ignore);
    return {.ignore = ignored ? ignored->body : BodyId{}};
}

Result<AimHit> met(const HostedState& state, const Result<std::optional<RayHit>>& hit) {
    if (!hit.ok()) return hit.error();
    if (!*hit) return Error{ErrorCode::not_found, "the ray of the aim meets nothing"};
    return AimHit{state.entities.entity_of((*hit)->body), (*hit)->point};
}

Result<AimHit> cast_now(const HostedState& state, const Aim& aim) {
    return met(state,
               state.world.queries().cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
}

// The point moved with its body since.
Result<AimHit> cast_rewound(const HostedState& state, const RewindView& past, const EntityList& now,
                            const Aim& aim) {
    const Result<Queries> then = state.world.queries().with_shapes_at(
        past.shapes(now, along_segment(aim.origin, aim.motion)));
    if (!then.ok()) return then.error();
    Result<AimHit> found =
        met(state, then->cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
    if (!found.ok()) return found;
    const Transform was = *past.pose_of(found->entity);
    const Transform is = state.world.body(state.entities.find(found->entity)->body)->pose;
    found->point = apply(is, apply_inverse(was, found->point));
    return found;
}

const std::optional<Aim>* aim_of(const Action& action) {
    if (const auto* impulse = std::get_if<ImpulseCommand>(&action)) return &impulse->aim;
    if (const auto* grab = std::get_if<GrabCommand>(&action)) return &grab->aim;
    if (const auto* explode = std::get_if<ExplodeCommand>(&action)) return &explode->aim;
    return nullptr;
}

void point_at(Action& action, const AimHit& met) {
    if (auto* impulse = std::get_if<ImpulseCommand>(&action)) {
        impulse->entity = met.entity;
        impulse->point = met.point;
    } else if (auto* grab = std::get_if<GrabCommand>(&action)) {
        grab->entity = met.entity;
        grab->point = met.point;
    } else if (auto* explode = std::get_if<ExplodeCommand>(&action)) {
        explode->center = met.point;
    }
}

}  // namespace

bool has_aim(const Action& action) {
    const std::optional<Aim>* aim = aim_of(action);
    return aim && *aim;
}

Status resolve_aim(const HostedState& state, const FrameRing& past, const EntityList& now,
                   Action& action, InputResult& result) {
    const std::optional<Aim>* aim = aim_of(action);
    if (!aim || !*aim) return {};
    Result<AimHit> found = AimHit{};
    const auto then = (*aim)->view_time ? past.at(*(*aim)->view_time) : std::nullopt;
    if (then) {
        const RewindView view(*then);
        result.view_time_clamped = view.clamped();
        found = cast_rewound(state, view, now, **aim);
    } else {
        found = cast_now(state, **aim);
    }
    if (!found.ok()) return found.error();
    result.entity = found->entity;
    point_at(action, *found);
    return {};
}

}  // namespace jostle::server
