// SPDX-License-Identifier: MIT
#include "modules/crowd/src/outline.h"

#include <variant>

#include "jostle/physics/hull.h"
#include "jostle/physics/planar.h"

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr int circle_corners = 16;

// Corners of a shape whose hull is its outline in any projection; round shapes are approximated.
class OutlineCorners {
public:
    std::vector<Vec3> operator()(const Box& box) const {
        std::vector<Vec3> corners;
        for (int k = 0; k < 8; k++)
            corners.push_back({(k & 1) ? box.half_extents.x : -box.half_extents.x,
                               (k & 2) ? box.half_extents.y : -box.half_extents.y,
                               (k & 4) ? box.half_extents.z : -box.half_extents.z});
        return corners;
    }
    std::vector<Vec3> operator()(const Hull& hull) const { return hull.data->vertices; }
    std::vector<Vec3> operator()(const Sphere& sphere) const { return ball({}, sphere.radius); }
    std::vector<Vec3> operator()(const Capsule& capsule) const {
        std::vector<Vec3> corners = ball({0, capsule.half_length, 0}, capsule.radius);
        for (const Vec3 p : ball({0, -capsule.half_length, 0}, capsule.radius))
            corners.push_back(p);
        return corners;
    }
    std::vector<Vec3> operator()(const Cylinder& cylinder) const {
        std::vector<Vec3> corners = ring({0, cylinder.half_length, 0}, cylinder.radius);
        for (const Vec3 p : ring({0, -cylinder.half_length, 0}, cylinder.radius))
            corners.push_back(p);
        return corners;
    }
    std::vector<Vec3> operator()(const Cone& cone) const {
        std::vector<Vec3> corners = ring({0, -cone.half_length, 0}, cone.radius);
        corners.push_back({0, cone.half_length, 0});
        return corners;
    }
    template <class Other>
    std::vector<Vec3> operator()(const Other&) const {
        return {};
    }

private:
    // A horizontal ring. Its corners lie outside of the circle, so that their sides touch it.
    static std::vector<Vec3> ring(Vec3 center, double radius) {
        std::vector<Vec3> points;
        const double outer = radius / sin_cos(pi / circle_corners).cos;
        for (int k = 0; k < circle_corners; k++) {
            const SinCos turn = sin_cos(2 * pi * k / circle_corners);
            points.push_back(center + Vec3{outer * turn.cos, 0, outer * turn.sin});
        }
        return points;
    }
    // Rings in all three planes.
    static std::vector<Vec3> ball(Vec3 center, double radius) {
        std::vector<Vec3> points;
        for (const Vec3 p : ring({}, radius)) {
            points.push_back(center + p);
            points.push_back(center + Vec3{p.x, p.z, 0});
            points.push_back(center + Vec3{0, p.x, p.z});
        }
        return points;
    }
};

}  // namespace

Result<std::vector<Wall>> outline_of(const World& world, BodyId id, bool vertical) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return body.error();
    std::vector<Wall> walls;
    for (const ShapeId shape_id : world.shapes_of(id)) {
        const Result<ShapeState> shape = world.shape(shape_id);
        if (!shape.ok() || shape->trigger) continue;
        std::vector<Vec2> points;
        for (const Vec3 corner : std::visit(OutlineCorners(), shape->geometry)) {
            const Vec3 p = apply(body->pose, apply(shape->pose, corner));
            points.push_back(vertical ? Vec2{p.x, p.y} : Vec2{p.x, p.z});
        }
        if (points.empty()) continue;
        const Result<std::vector<Vec2>> hull = planar::convex_hull(points);
        if (!hull.ok()) return hull.error();
        for (std::size_t k = 0; k < hull->size(); k++)
            walls.push_back({(*hull)[k], (*hull)[(k + 1) % hull->size()]});
    }
    if (walls.empty())
        return Error{ErrorCode::invalid_argument,
                     "the body has no outline; it must have a box, a hull or a round shape"};
    return walls;
}

}  // namespace jostle::modules::crowd_detail
