// SPDX-License-Identifier: MIT
#include "modules/fields/src/body_field_cache.h"

#include <utility>

#include "jostle/modules/waves.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

ProjectedShape faces_of(const Geometry& geometry, const Transform& pose) {
    ProjectedShape shape{.kind = ProjectedShape::Kind::faces};
    for (const PanelSurface& surface : panel_surfaces(geometry, pose))
        for (const auto& triangle : surface.triangles) {
            const Vec3 area = area_of(surface, triangle);
            // The triangles of a flat face are consecutive.
            const bool same =
                !shape.areas.empty() && dot(shape.areas.back(), area) >=
                                            (1 - 1e-12) * length(shape.areas.back()) * length(area);
            if (same)
                shape.areas.back() += area;
            else
                shape.areas.push_back(area);
        }
    return shape;
}

ProjectedShape projected_shape_of(const Geometry& geometry, const Transform& pose) {
    using Kind = ProjectedShape::Kind;
    const Vec3 axis = rotate(pose.rotation, {0, 1, 0});
    if (const auto* sphere = std::get_if<Sphere>(&geometry))
        return {.kind = Kind::ball, .round = pi * sphere->radius * sphere->radius};
    if (const auto* c = std::get_if<Capsule>(&geometry))
        return {.kind = Kind::capsule,
                .axis = axis,
                .round = pi * c->radius * c->radius,
                .side = 4 * c->radius * c->half_length};
    if (const auto* c = std::get_if<Cylinder>(&geometry))
        return {.kind = Kind::cylinder,
                .axis = axis,
                .round = pi * c->radius * c->radius,
                .side = 4 * c->radius * c->half_length};
    if (const auto* c = std::get_if<Cone>(&geometry))
        return {.kind = Kind::cone,
                .axis = axis,
                .round = pi * c->radius * c->radius,
                .radius = c->radius,
                .height = 2 * c->half_length};
    return faces_of(geometry, pose);
}

void add_projected_shape(std::vector<ProjectedShape>& projected_shapes, const Geometry& geometry,
                         const Transform& pose) {
    if (const auto* compound = std::get_if<Compound>(&geometry)) {
        for (const CompoundChild& child : compound->data->children)
            projected_shapes.push_back(
                projected_shape_of(child.geometry, compose(pose, child.pose)));
    } else if (is_convex(kind_of(geometry))) {
        projected_shapes.push_back(projected_shape_of(geometry, pose));
    }
}

// The base projects to an ellipse and the tip to a point on its minor axis. Stretched to a circle,
// the projection is the area enclosed by the two tangents from the tip and the arc beyond the
// tangent points.
double area_of_cone(const ProjectedShape& cone, double along, double across) {
    const double r = cone.radius, tip = cone.height * across;
    if (along * r >= tip) return cone.round * along;
    if (along < 1e-9) return r * tip;
    const double far = tip / along, tangent = square_root(far * far - r * r);
    return along * (r * r * (pi - arc_tangent(tangent, r)) + r * tangent);
}

double area_of(const ProjectedShape& shape, Vec3 direction) {
    if (shape.kind == ProjectedShape::Kind::ball) return shape.round;
    if (shape.kind == ProjectedShape::Kind::faces) {
        double twice = 0;
        for (const Vec3 area : shape.areas) twice += absolute(dot(area, direction));
        return 0.5 * twice;
    }
    const double along = absolute(dot(shape.axis, direction));
    const double across = square_root(maximum(1 - along * along, 0));
    if (shape.kind == ProjectedShape::Kind::cone) return area_of_cone(shape, along, across);
    const double ends = shape.kind == ProjectedShape::Kind::capsule ? 1 : along;
    return shape.round * ends + shape.side * across;
}

// Limits the panels of all shapes of a body in total.
void add_panels(BodyFieldData& record, const ShapeState& shape, double longest) {
    for (PanelSurface& surface : panel_surfaces(shape.geometry, shape.pose))
        record.panels.push_back(std::move(surface));
    if (record.panels.empty()) return;
    for (PanelSurface& surface : record.panels)
        refine(surface, longest, 1e30, panels_max / record.panels.size());
    for (const PanelSurface& surface : record.panels)
        for (const Vec3 v : surface.vertices) record.reach = maximum(record.reach, length(v));
}

}  // namespace

double projected_area(const BodyFieldData& record, Vec3 direction) {
    double area = 0;
    for (const ProjectedShape& shape : record.projected_shapes) area += area_of(shape, direction);
    return area;
}

void BodyFieldCache::refresh(const World& world, std::span<const BodyId> bodies) {
    for (const BodyId id : bodies) {
        if (id.index >= records_.size()) continue;
        BodyFieldData& record = records_[id.index];
        std::vector<ShapeId> shapes = world.shapes_of(id);
        const bool same = record.body == id && record.shapes == shapes;
        record.body = id;
        record.shapes = std::move(shapes);
        if (!same || (longest_panel_ > 0 && !record.has_panels)) rebuild(world, record);
        record.categories = categories_of(world, record.shapes);
        // The mass, and with it the inertia, may change at any time.
        if (const Result<BodyState> state = world.body(id); state.ok()) {
            const Mat3 axes = to_matrix(state->pose.rotation);
            record.inertia = transpose(axes) * state->inertia * axes;
            record.inverse_inertia = inverse(record.inertia);
        }
    }
}

void BodyFieldCache::rebuild(const World& world, BodyFieldData& record) {
    record.projected_shapes.clear();
    record.panels.clear();
    record.reach = 0;
    record.has_panels = longest_panel_ > 0;
    for (const ShapeId id : record.shapes) {
        const Result<ShapeState> shape = world.shape(id);
        if (!shape.ok() || shape->trigger) continue;
        add_projected_shape(record.projected_shapes, shape->geometry, shape->pose);
        if (record.has_panels) add_panels(record, *shape, longest_panel_);
    }
}

std::uint32_t categories_of(const World& world, std::span<const ShapeId> shapes) {
    std::uint32_t categories = 0;
    for (const ShapeId id : shapes)
        if (const Result<ShapeState> shape = world.shape(id); shape.ok())
            categories |= shape->filter.category;
    return categories;
}

std::uint32_t categories_of(const World& world, BodyId body) {
    return categories_of(world, world.shapes_of(body));
}

}  // namespace jostle::modules::fields_detail
