// SPDX-License-Identifier: MIT
#include "server/world/point_shapes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/modules/ray_tests.h"
#include "jostle/physics/mesh.h"
#include "jostle/physics/world.h"

namespace jostle::server {

using namespace physics;

namespace {

// Calls visit(a, b) with the indices of the points of each link.
template <class Visit>
void for_each_link(const PointObjectDescription& object, const Visit& visit) {
    std::size_t first = 0;
    for (const std::uint32_t size : object.strands) {
        for (std::size_t k = first; k + 1 < first + size; k++) visit(k, k + 1);
        first += size;
    }
}

// Calls visit(a, b, c) with the indices of the corners of each triangle. A cell of a grid is two
// triangles, as clients draw it.
template <class Visit>
void for_each_triangle(const PlacedPoints& points, const Visit& visit) {
    const PointObjectDescription& object = *points.object;
    if (object.form == PointForm::triangles) {
        for (std::size_t k = 0; k + 2 < object.triangles.size(); k += 3)
            visit(object.triangles[k], object.triangles[k + 1], object.triangles[k + 2]);
        return;
    }
    if (object.form != PointForm::grid || object.columns == 0) return;
    const std::size_t columns = object.columns, rows = points.positions.size() / columns;
    for (std::size_t row = 0; row + 1 < rows; row++)
        for (std::size_t column = 0; column + 1 < columns; column++) {
            const std::size_t a = row * columns + column, b = a + columns;
            visit(a, b, a + 1);
            visit(a + 1, b, b + 1);
        }
}

// The rotation that turns the y axis into a direction.
Quat rotation_to(Vec3 direction) {
    const Vec3 y{0, 1, 0};
    const double along = dot(y, direction);
    if (along < -1 + 1e-12) return {1, 0, 0, 0};
    const Vec3 axis = cross(y, direction);
    return normalized({axis.x, axis.y, axis.z, 1 + along});
}

BodyAndShapes links_of(const PlacedPoints& points) {
    BodyAndShapes made{.body = {.type = BodyType::static_body}};
    for_each_link(*points.object, [&](std::size_t from, std::size_t to) {
        const Vec3 a = points.positions[from], along = points.positions[to] - a;
        const double size = length(along), radius = std::max(points.object->radius, 1e-4);
        const Transform pose{a + along * 0.5, size > 0 ? rotation_to(along / size) : Quat{}};
        if (size > 1e-6)
            made.shapes.push_back({.geometry = Capsule{radius, 0.5 * size}, .pose = pose});
        else
            made.shapes.push_back({.geometry = Sphere{radius}, .pose = pose});
    });
    return made;
}

BodyAndShapes surface_of(const PlacedPoints& points) {
    BodyAndShapes made{.body = {.type = BodyType::static_body}};
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for_each_triangle(points, [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
                             static_cast<std::uint32_t>(c)});
    });
    // Coordinates of meshes are limited, those of the world much less.
    made.body.pose.position = points.positions.front();
    std::vector<Vec3> vertices = points.positions;
    for (Vec3& vertex : vertices) vertex -= made.body.pose.position;
    if (const auto mesh = build_mesh(vertices, triangles); mesh.ok())
        made.shapes.push_back({.geometry = Mesh{*mesh}});
    return made;
}

}  // namespace

bool has_shape(const PointObjectDescription& object) {
    return object.form == PointForm::strands || object.form == PointForm::grid ||
           object.form == PointForm::triangles;
}

std::vector<PlacedPoints> place_points(const PointObjects& objects, const PoseOfEntity& pose_of,
                                       const SphereFilter& filter) {
    std::vector<PlacedPoints> placed;
    for (const auto& state : objects) {
        if (!has_shape(*state->object) || !filter(state->center, state->reach)) continue;
        std::optional<Transform> pose;
        if (state->object->entity != 0 && !(pose = pose_of(state->object->entity))) continue;
        PlacedPoints& points = placed.emplace_back(state->object);
        const double step = 1e-6 * state->object->step_um;
        points.positions.reserve(state->values.size() / 3);
        for (std::size_t k = 0; k + 2 < state->values.size(); k += 3) {
            const Vec3 at{step * state->values[k], step * state->values[k + 1],
                          step * state->values[k + 2]};
            points.positions.push_back(pose ? apply(*pose, at) : at);
        }
    }
    return placed;
}

void interpolate_points(std::vector<PlacedPoints>& points, const std::vector<PlacedPoints>& later,
                        double fraction) {
    ASSERT(fraction >= 0 && fraction <= 1);
    for (PlacedPoints& from : points) {
        const auto to = std::ranges::find(later, from.object, &PlacedPoints::object);
        if (to == later.end() || to->positions.size() != from.positions.size()) continue;
        for (std::size_t k = 0; k < from.positions.size(); k++)
            from.positions[k] += (to->positions[k] - from.positions[k]) * fraction;
    }
}

std::optional<PointHit> cast_ray(const std::vector<PlacedPoints>& points, const Ray& ray) {
    std::optional<PointHit> first;
    for (const PlacedPoints& each : points) {
        const auto take = [&](double fraction, std::size_t element) {
            if (!first || fraction < first->fraction)
                first = PointHit{each.object, element, each.positions[element], fraction};
        };
        if (each.object->form == PointForm::strands)
            for_each_link(*each.object, [&](std::size_t a, std::size_t b) {
                if (const auto hit = modules::enter_link(ray, each.positions[a], each.positions[b],
                                                         each.object->radius))
                    take(hit->fraction, hit->share < 0.5 ? a : b);
            });
        for_each_triangle(each, [&](std::size_t a, std::size_t b, std::size_t c) {
            const std::size_t corners[] = {a, b, c};
            if (const auto hit = modules::meet_triangle(
                    ray, {each.positions[a], each.positions[b], each.positions[c]}))
                take(hit->fraction, corners[hit->corner]);
        });
    }
    return first;
}

PointShapes::PointShapes(const std::vector<PlacedPoints>& points) {
    World world = std::move(*World::create());
    for (const PlacedPoints& each : points) {
        ASSERT(has_shape(*each.object));
        if (each.positions.empty()) continue;
        const BodyAndShapes made =
            each.object->form == PointForm::strands ? links_of(each) : surface_of(each);
        // Points that are too far away for shapes are not found.
        const Result<BodyId> body = world.create_body(made.body, made.shapes);
        if (!body.ok()) continue;
        for (const ShapeId shape : world.shapes_of(*body)) {
            if (object_of_.size() <= shape.index) object_of_.resize(shape.index + 1);
            object_of_[shape.index] = each.object->id;
        }
    }
    queries_ = world.query_frame();
}

std::uint32_t PointShapes::object_of(ShapeId shape) const {
    ASSERT(shape.index < object_of_.size() && object_of_[shape.index] != 0);
    return object_of_[shape.index];
}

}  // namespace jostle::server
