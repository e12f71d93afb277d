// SPDX-License-Identifier: MIT
#include "server/world/rewind_view.h"

#include <algorithm>
#include <chrono>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

namespace {

constexpr double speed_max = 100;  // m/s; same value as the clients' interpolation

const EntityPose* find(const PoseList& poses, EntityId entity) {
    std::size_t low = 0, high = poses.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (poses[middle].id < entity)
            low = middle + 1;
        else
            high = middle;
    }
    return low < poses.size() && poses[low].id == entity ? &poses[low] : nullptr;
}

double seconds_between(const RewindFrames& frames) {
    return std::chrono::duration<double>(frames.after->due - frames.before->due).count();
}

// Finds entities whose ids are requested in ascending order, in one pass over the list.
class AscendingSearch {
public:
    explicit AscendingSearch(const PoseList& poses) : at_(poses.begin()), end_(poses.end()) {}
    const EntityPose* find(EntityId entity) {
        while (!(at_ == end_) && at_->id < entity) ++at_;
        return !(at_ == end_) && at_->id == entity ? &*at_ : nullptr;
    }

private:
    PoseList::Iterator at_, end_;
};

}  // namespace

Transform interpolate(const Transform& a, const Transform& b, double fraction,
                      double seconds_apart) {
    if (a == b) return a;
    ASSERT(fraction >= 0 && fraction <= 1);
    if (length(b.position - a.position) > speed_max * seconds_apart) return a;
    const Quat &p = a.rotation, &q = b.rotation;
    const double along = p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w;
    const double sign = along < 0 ? -1 : 1, rest = 1 - fraction;
    const Quat turned{rest * p.x + sign * fraction * q.x, rest * p.y + sign * fraction * q.y,
                      rest * p.z + sign * fraction * q.z, rest * p.w + sign * fraction * q.w};
    return {a.position + (b.position - a.position) * fraction, normalized(turned)};
}

std::optional<Transform> RewindView::pose_of(EntityId entity) const {
    const EntityPose* after = find(frames_.after->entities, entity);
    if (!after) return std::nullopt;
    const EntityPose* before = find(frames_.before->entities, entity);
    if (!before || frames_.before == frames_.after) return after->pose;
    return interpolate(before->pose, after->pose, frames_.fraction, seconds_between(frames_));
}

// A body that appeared in the later frame has that frame's pose.
std::vector<ShapePlacement> RewindView::shapes(const EntityList& now,
                                               const CandidateFilter& candidate_filter) const {
    std::vector<ShapePlacement> placements;
    const bool same = frames_.before == frames_.after;
    const double seconds = seconds_between(frames_);
    AscendingSearch before(frames_.before->entities), after(frames_.after->entities);
    for (const auto& entity : now) {
        const EntityPose* to = after.find(entity->id);
        if (!to) continue;
        const EntityPose* from = same ? nullptr : before.find(entity->id);
        const Transform pose =
            from ? interpolate(from->pose, to->pose, frames_.fraction, seconds) : to->pose;
        if (!candidate_filter(pose.position, entity->bounding_radius)) continue;
        for (const ShapeState& shape : entity->shapes)
            placements.push_back({shape.id, compose(pose, shape.pose)});
    }
    return placements;
}

// An interpolated pose is at most one step away from the later one; after a teleport it is the
// earlier one.
std::vector<ShapePlacement> RewindView::shapes_along_segment(const EntityList& now, Vec3 origin,
                                                             Vec3 motion) const {
    std::vector<std::uint32_t> indices;
    std::vector<EntityId> candidates;
    const auto add = [&](const Frame& frame, double margin) {
        indices.clear();
        frame.pose_grid().append_near_segment(origin, motion, margin, indices);
        for (const std::uint32_t index : indices)
            candidates.push_back((*frame.entity_list)[index]->id);
    };
    const bool same = frames_.before == frames_.after;
    add(*frames_.after, same ? 0 : speed_max * seconds_between(frames_));
    if (!same) add(*frames_.before, 0);
    std::ranges::sort(candidates);
    const auto repeated = std::ranges::unique(candidates);
    candidates.erase(repeated.begin(), repeated.end());
    const CandidateFilter filter = along_segment(origin, motion);
    std::vector<ShapePlacement> placements;
    for (const EntityId id : candidates) {
        const auto entity =
            std::ranges::lower_bound(now, id, {}, [](const auto& e) { return e->id; });
        if (entity == now.end() || (*entity)->id != id) continue;
        const std::optional<Transform> pose = pose_of(id);
        if (!pose || !filter(pose->position, (*entity)->bounding_radius)) continue;
        for (const ShapeState& shape : (*entity)->shapes)
            placements.push_back({shape.id, compose(*pose, shape.pose)});
    }
    return placements;
}

std::vector<PlacedPoints> RewindView::points(const SphereFilter& filter) const {
    const auto placed = [&](const Frame& frame) {
        const auto pose = [&](EntityId entity) -> std::optional<Transform> {
            const EntityPose* at = find(frame.entities, entity);
            return at ? std::optional(at->pose) : std::nullopt;
        };
        return frame.points ? place_points(*frame.points, pose, filter)
                            : std::vector<PlacedPoints>();
    };
    std::vector<PlacedPoints> points = placed(*frames_.before);
    if (frames_.before != frames_.after)
        interpolate_points(points, placed(*frames_.after), frames_.fraction);
    return points;
}

RewindView::CandidateFilter along_segment(Vec3 origin, Vec3 motion) {
    const double size = std::max(length_squared(motion), 1e-300);
    return [=](Vec3 center, double radius) {
        const Vec3 to = center - origin;
        const double nearest = std::clamp(dot(to, motion) / size, 0.0, 1.0);
        const double bounding_radius = radius * 1.000001 + 1e-6;  // margin for rounding
        return length_squared(to - motion * nearest) <= bounding_radius * bounding_radius;
    };
}

RewindView::CandidateFilter within_box(const Aabb& box) {
    return [=](Vec3 center, double radius) {
        const double bounding_radius = radius * 1.000001 + 1e-6;
        return overlap(box, grow({center, center}, bounding_radius));
    };
}

}  // namespace jostle::server
