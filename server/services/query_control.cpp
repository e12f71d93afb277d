// SPDX-License-Identifier: MIT
#include "server/services/query_control.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>
#include <type_traits>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/limits.h"
#include "jostle/scenes/shape_message.h"
#include "jostle/v1/query.pb.h"
#include "server/messages/message_parts.h"
#include "server/services/query_target.h"

namespace jostle::server {

namespace {

constexpr int rays_max = 1000, shapes_max = 100, points_max = 1000;  // per request
// Bounds the cost of quickhull; more points do not make a better query shape.
constexpr int hull_points_max = 1000;
// Per response: keeps it below the default client limit of 4 MiB.
constexpr std::size_t hits_max = 50000;
constexpr double coordinate_max = physics::limits::max_coordinate;  // m

Error cancelled() {
    return {ErrorCode::deadline_exceeded, "the deadline passed while the response was computed"};
}

// Errors of the solver: invalid_argument is a fault of the request, all others are internal.
Error from_solver(const Error& error) {
    return error.code == ErrorCode::invalid_argument ? error
                                                     : Error{ErrorCode::internal, error.message};
}

// --- decoding requests ---

Status check_count(const char* field, int count, int max) {
    if (count <= max) return {};
    return invalid_argument(
        fmt::format("{} has {} entries; at most {} are allowed", field, count, max));
}

Status check_number(const std::string& field, double x, double low, double high) {
    if (low <= x && x <= high) return {};
    return invalid_argument(
        fmt::format("{} is {:g}; it must be from {:g} to {:g}", field, x, low, high));
}

Status check_vector(const std::string& field, const v1::Vec3& v) {
    if (Status s = check_number(field + ".x", v.x(), -coordinate_max, coordinate_max); !s.ok())
        return s;
    if (Status s = check_number(field + ".y", v.y(), -coordinate_max, coordinate_max); !s.ok())
        return s;
    return check_number(field + ".z", v.z(), -coordinate_max, coordinate_max);
}

// Decodes a convex shape; other shapes are rejected before the cost of building them.
Result<physics::ShapeDef> read_shape(const v1::Shape& message, const std::string& field) {
    const auto* kind = v1::Shape::descriptor()->FindFieldByNumber(message.kind_case());
    switch (message.kind_case()) {
        case v1::Shape::kHull:
            if (const int points = message.hull().points_size(); points > hull_points_max)
                return invalid_argument(
                    fmt::format("{}.hull.points has {} entries; at most {} are allowed", field,
                                points, hull_points_max));
            break;
        case v1::Shape::kPlane:
        case v1::Shape::kMesh:
        case v1::Shape::kSolid:
        case v1::Shape::kHeightField:
        case v1::Shape::kCompound:
        case v1::Shape::kGeometry:
        case v1::Shape::KIND_NOT_SET:
            return invalid_argument(
                fmt::format("{} is {}; it must be a sphere, capsule, box, cylinder, cone or hull",
                            field, kind != nullptr ? "a " + kind->name() : "empty"));
        default:
            break;
    }
    Result<physics::ShapeDef> read = scenes::shape_from_message(message, field);
    if (!read.ok()) return from_solver(read.error());
    return read;
}

// An entity to ignore that no longer exists has no effect.
physics::QueryFilter read_filter(const v1::QueryFilter& message, const QueryFrame& frame) {
    physics::QueryFilter filter;
    if (message.has_categories()) filter.categories = message.categories();
    filter.triggers = message.include_triggers();
    if (message.ignore() != 0) filter.ignore = frame.body_of(message.ignore());
    return filter;
}

// --- encoding responses ---

// A hit and whether it is of the shapes of point objects.
template <class PhysicsHit>
struct Found {
    PhysicsHit hit;
    bool is_point_object = false;
};

template <class PhysicsHit>
void write_hit(v1::Hit& to, const Found<PhysicsHit>& from, const QueryTarget& target) {
    if (from.is_point_object) {
        to.set_object(target.points->object_of(from.hit.shape));
    } else {
        const ShapeOwner owner = target.frame->owner_of(from.hit.shape);
        ASSERT(owner.entity != 0);
        to.set_entity(owner.entity);
        to.set_shape(owner.number);
    }
    to.set_fraction(from.hit.fraction);
    write_vector(*to.mutable_point(), from.hit.point);
    write_vector(*to.mutable_normal(), from.hit.normal);
}

// Runs `query` on the shapes of entities, and on those of point objects if they are searched.
// `query` takes Queries and returns a Result of a list of hits that are sorted by fraction.
template <class Query>
Status write_all_hits(v1::Hits& to, const QueryTarget& target, std::size_t& total,
                      const Query& query) {
    const auto hits = query(target.queries);
    if (!hits.ok()) return from_solver(hits.error());
    using PhysicsHit = typename std::decay_t<decltype(*hits)>::value_type;
    std::vector<Found<PhysicsHit>> found;
    for (const PhysicsHit& hit : *hits) found.push_back({hit});
    if (target.points) {
        const auto more = query(target.points->queries());
        if (!more.ok()) return from_solver(more.error());
        for (const PhysicsHit& hit : *more) found.push_back({hit, true});
        std::ranges::stable_sort(found, {}, [](const auto& each) { return each.hit.fraction; });
    }
    total += found.size();
    if (total > hits_max)
        return Error{
            ErrorCode::resource_exhausted,
            fmt::format("the response would have more than {} hits; split the request", hits_max)};
    for (const Found<PhysicsHit>& each : found) write_hit(*to.add_hits(), each, target);
    return {};
}

// The same for a `query` that returns the closest hit, if there is one.
template <class Query>
Status write_closest_hit(v1::Hits& to, const QueryTarget& target, const Query& query) {
    auto hit = query(target.queries);
    if (!hit.ok()) return from_solver(hit.error());
    bool is_point_object = false;
    if (target.points) {
        auto other = query(target.points->queries());
        if (!other.ok()) return from_solver(other.error());
        is_point_object = *other && (!*hit || (*other)->fraction < (*hit)->fraction);
        if (is_point_object) hit = std::move(other);
    }
    if (*hit) write_hit(*to.add_hits(), Found{**hit, is_point_object}, target);
    return {};
}

void write_box(v1::DebugBox& to, const physics::Aabb& from) {
    write_vector(*to.mutable_low(), from.low);
    write_vector(*to.mutable_high(), from.high);
}

// --- queries ---

template <class Request>
Result<QueryTarget> target_of(const WorldDirectory& worlds, const Request& request,
                              const RewindView::CandidateFilter& candidate_filter = any_candidate) {
    return query_target(worlds, request.world(),
                        request.has_view_time() ? &request.view_time() : nullptr,
                        request.filter().include_deformables(), candidate_filter);
}

template <class Response>
void write_view_time(Response& to, const QueryTarget& target) {
    to.set_tick(target.tick);
    to.set_view_time_clamped(target.clamped);
}

// Restricts the rewound shapes to those that the rays can hit.
RewindView::CandidateFilter along_rays(const v1::CastRaysRequest& request) {
    if (request.rays_size() == 1)
        return along_segment(to_vector(request.rays(0).origin()),
                             to_vector(request.rays(0).motion()));
    std::optional<physics::Aabb> box;
    for (const v1::Ray& ray : request.rays()) {
        const physics::Vec3 from = to_vector(ray.origin()), to = from + to_vector(ray.motion());
        const physics::Aabb of_ray{min(from, to), max(from, to)};
        box = box ? unite(*box, of_ray) : of_ray;
    }
    return within_box(box.value_or(physics::Aabb{}));
}

Status check_ray(const v1::Ray& ray, int number) {
    const std::string field = fmt::format("rays[{}]", number);
    if (Status s = check_vector(field + ".origin", ray.origin()); !s.ok()) return s;
    if (Status s = check_vector(field + ".motion", ray.motion()); !s.ok()) return s;
    if (to_vector(ray.motion()) == physics::Vec3{})
        return invalid_argument(field + ".motion is zero; it must have a length");
    return {};
}

Status cast_one(const physics::Ray& ray, v1::HitMode mode, const physics::QueryFilter& filter,
                const QueryTarget& target, v1::Hits& hits, std::size_t& total) {
    if (mode == v1::HIT_MODE_ALL)
        return write_all_hits(hits, target, total, [&](const physics::Queries& queries) {
            return queries.cast_ray_all(ray, filter);
        });
    const auto closest = [&](const physics::Queries& queries) {
        return queries.cast_ray(ray, filter);
    };
    if (Status s = write_closest_hit(hits, target, closest); !s.ok()) return s;
    if (mode == v1::HIT_MODE_ANY && hits.hits_size() > 0) {
        // HIT_MODE_ANY returns only what was hit. The solver's any-hit test returns no shape, so
        // the closest hit is used; the mode only reduces the size of the response.
        v1::Hit& hit = *hits.mutable_hits(0);
        const std::uint32_t entity = hit.entity(), object = hit.object();
        hit.Clear();
        hit.set_entity(entity);
        hit.set_object(object);
    }
    return {};
}

CopyLayers layers_of(const v1::DebugRequest& request) {
    return (request.contacts() ? copy_contacts : 0) | (request.islands() ? copy_islands : 0) |
           (request.bounds() ? copy_bounds : 0) | (request.joints() ? copy_joints : 0) |
           (request.broad_phase() ? copy_broad_phase : 0);
}

}  // namespace

Status QueryControl::cast_rays(const v1::CastRaysRequest& request, v1::CastRaysResponse& response,
                               const CancellationCheck& still_needed) const {
    if (Status s = check_count("rays", request.rays_size(), rays_max); !s.ok()) return s;
    if (!v1::HitMode_IsValid(request.mode()))
        return invalid_argument(fmt::format("mode is {}; it must be a HitMode from 0 to {}",
                                            static_cast<int>(request.mode()),
                                            static_cast<int>(v1::HitMode_MAX)));
    for (int i = 0; i < request.rays_size(); i++)
        if (Status s = check_ray(request.rays(i), i); !s.ok()) return s;
    const Result<QueryTarget> target = target_of(context_.worlds, request, along_rays(request));
    if (!target.ok()) return target.error();
    const QueryFramePtr& frame = target->frame;
    write_view_time(response, *target);
    const physics::QueryFilter filter = read_filter(request.filter(), *frame);
    std::size_t total = 0;
    for (const v1::Ray& ray : request.rays()) {
        if (!still_needed()) return cancelled();
        const physics::Ray cast{to_vector(ray.origin()), to_vector(ray.motion())};
        if (Status s = cast_one(cast, request.mode(), filter, *target, *response.add_rays(), total);
            !s.ok())
            return s;
    }
    return {};
}

Status QueryControl::cast_shapes(const v1::CastShapesRequest& request,
                                 v1::CastShapesResponse& response,
                                 const CancellationCheck& still_needed) const {
    if (Status s = check_count("shapes", request.shapes_size(), shapes_max); !s.ok()) return s;
    if (!v1::HitMode_IsValid(request.mode()) || request.mode() == v1::HIT_MODE_ANY)
        return invalid_argument(fmt::format(
            "mode is {}; for shapes it must be HIT_MODE_CLOSEST (1) or HIT_MODE_ALL (3)",
            static_cast<int>(request.mode())));
    std::vector<physics::ShapeCast> casts;
    for (int i = 0; i < request.shapes_size(); i++) {
        if (!still_needed()) return cancelled();
        const std::string field = fmt::format("shapes[{}]", i);
        const v1::MovingShape& moving = request.shapes(i);
        const Result<physics::ShapeDef> shape = read_shape(moving.shape(), field + ".shape");
        if (!shape.ok()) return shape.error();
        if (Status s = check_vector(field + ".motion", moving.motion()); !s.ok()) return s;
        casts.push_back({shape->geometry, shape->pose, to_vector(moving.motion())});
    }
    const Result<QueryTarget> target = target_of(context_.worlds, request);
    if (!target.ok()) return target.error();
    const QueryFramePtr& frame = target->frame;
    write_view_time(response, *target);
    const physics::QueryFilter filter = read_filter(request.filter(), *frame);
    std::size_t total = 0;
    for (const physics::ShapeCast& cast : casts) {
        if (!still_needed()) return cancelled();
        v1::Hits& hits = *response.add_shapes();
        const auto all = [&](const physics::Queries& queries) {
            return queries.cast_shape_all(cast, filter);
        };
        const auto closest = [&](const physics::Queries& queries) {
            return queries.cast_shape(cast, filter);
        };
        if (Status s = request.mode() == v1::HIT_MODE_ALL
                           ? write_all_hits(hits, *target, total, all)
                           : write_closest_hit(hits, *target, closest);
            !s.ok())
            return s;
    }
    return {};
}

Status QueryControl::overlap(const v1::OverlapRequest& request, v1::OverlapResponse& response,
                             const CancellationCheck&) const {
    physics::ShapeDef shape;
    switch (request.what_case()) {
        case v1::OverlapRequest::kShape: {
            Result<physics::ShapeDef> read = read_shape(request.shape(), "shape");
            if (!read.ok()) return read.error();
            shape = std::move(*read);
            break;
        }
        case v1::OverlapRequest::kPoint:
            if (Status s = check_vector("point", request.point()); !s.ok()) return s;
            break;
        case v1::OverlapRequest::WHAT_NOT_SET:
            return invalid_argument("give shape or point");
    }
    const Result<QueryTarget> target = target_of(context_.worlds, request);
    if (!target.ok()) return target.error();
    const QueryFramePtr& frame = target->frame;
    write_view_time(response, *target);
    const physics::QueryFilter filter = read_filter(request.filter(), *frame);
    const auto shapes_in = [&](const physics::Queries& queries) {
        return request.has_shape() ? queries.overlap_shape(shape.geometry, shape.pose, filter)
                                   : queries.shapes_at(to_vector(request.point()), filter);
    };
    const auto found = shapes_in(target->queries);
    if (!found.ok()) return from_solver(found.error());
    std::set<std::uint32_t> entities, objects;
    for (const physics::ShapeId id : *found) entities.insert(frame->owner_of(id).entity);
    response.mutable_entities()->Add(entities.begin(), entities.end());
    if (!target->points) return {};
    const auto found_points = shapes_in(target->points->queries());
    if (!found_points.ok()) return from_solver(found_points.error());
    for (const physics::ShapeId id : *found_points) objects.insert(target->points->object_of(id));
    response.mutable_objects()->Add(objects.begin(), objects.end());
    return {};
}

Status QueryControl::closest_points(const v1::ClosestPointsRequest& request,
                                    v1::ClosestPointsResponse& response,
                                    const CancellationCheck&) const {
    if (Status s = check_count("points", request.points_size(), points_max); !s.ok()) return s;
    if (Status s = check_number("max_distance", request.max_distance(), 0, coordinate_max); !s.ok())
        return s;
    std::vector<physics::Vec3> points;
    for (int i = 0; i < request.points_size(); i++) {
        if (Status s = check_vector(fmt::format("points[{}]", i), request.points(i)); !s.ok())
            return s;
        points.push_back(to_vector(request.points(i)));
    }
    const Result<QueryTarget> target = target_of(context_.worlds, request);
    if (!target.ok()) return target.error();
    const QueryFramePtr& frame = target->frame;
    write_view_time(response, *target);
    const physics::QueryFilter filter = read_filter(request.filter(), *frame);
    const auto found = target->queries.closest_points(points, request.max_distance(), filter);
    if (!found.ok()) return from_solver(found.error());
    using ClosestPoints = std::vector<std::optional<physics::ClosestPoint>>;
    physics::Result<ClosestPoints> others = ClosestPoints(points.size());
    if (target->points)
        others = target->points->queries().closest_points(points, request.max_distance(), filter);
    if (!others.ok()) return from_solver(others.error());
    for (std::size_t k = 0; k < points.size(); k++) {
        const std::optional<physics::ClosestPoint>&of_entity = (*found)[k], &other = (*others)[k];
        const bool is_other = other && (!of_entity || other->distance < of_entity->distance);
        const std::optional<physics::ClosestPoint>& closest = is_other ? other : of_entity;
        v1::ClosestPoint& to = *response.add_points();
        if (!closest) continue;
        if (is_other)
            to.set_object(target->points->object_of(closest->shape));
        else
            to.set_entity(frame->owner_of(closest->shape).entity);
        to.set_distance(closest->distance);
        write_vector(*to.mutable_point(), closest->point);
        write_vector(*to.mutable_normal(), closest->normal);
    }
    return {};
}

Status QueryControl::debug(const v1::DebugRequest& request, v1::DebugResponse& response,
                           const CancellationCheck&) const {
    const Result<QueryFramePtr> frame = debug_frame(request);
    if (!frame.ok()) return frame.error();
    write_debug(request, **frame, response);
    return {};
}

Result<QueryFramePtr> QueryControl::debug_frame(const v1::DebugRequest& request) const {
    const CopyLayers layers = layers_of(request);
    if (layers == 0)
        return invalid_argument(
            "request at least one of contacts, islands, bounds, joints, broad_phase");
    return query_frame_of(context_.worlds, request.world(), layers);
}

void QueryControl::write_debug(const v1::DebugRequest& request, const QueryFrame& frame,
                               v1::DebugResponse& response) {
    response.set_tick(frame.tick);
    response.set_truncated((frame.truncated & layers_of(request)) != 0);
    // The copy may contain more than this request needs, for other clients.
    if (request.contacts())
        for (const DebugContact& from : frame.contacts) {
            v1::DebugContact& to = *response.add_contacts();
            write_vector(*to.mutable_point(), from.point);
            write_vector(*to.mutable_normal(), from.normal);
            to.set_separation(from.gap);
            to.set_impulse(from.impulse);
            to.set_touching(from.touching);
        }
    if (request.islands())
        for (const DebugIsland& from : frame.islands) {
            v1::DebugIsland& to = *response.add_islands();
            to.mutable_entities()->Add(from.entities.begin(), from.entities.end());
            to.set_asleep(from.asleep);
        }
    if (request.bounds())
        for (const physics::Aabb& box : frame.bounds) write_box(*response.add_bounds(), box);
    if (request.joints())
        for (const DebugJoint& from : frame.joints) {
            v1::DebugJoint& to = *response.add_joints();
            to.set_entity_a(from.entity_a);
            to.set_entity_b(from.entity_b);
            write_vector(*to.mutable_anchor_a(), from.anchor_a);
            write_vector(*to.mutable_anchor_b(), from.anchor_b);
            to.set_kind(from.kind);
        }
    if (request.broad_phase())
        for (const physics::Aabb& cell : frame.cells) write_box(*response.add_broad_phase(), cell);
}

}  // namespace jostle::server
