// SPDX-License-Identifier: MIT
//
// The shape kinds as plain data. Each is in its own local frame; sizes are in metres. Small kinds
// are values. Hulls, meshes, height fields and compounds are immutable and shared; build_hull,
// build_mesh, build_height_field and build_compound make them.
#pragma once

#include <memory>
#include <variant>

#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Radii, half lengths, half extents and spacings lie in this range, coordinates of points within
// +-max_shape_size. Beyond it masses overflow single precision in the contact kernel.
inline constexpr double min_shape_size = 1e-4;  // m
inline constexpr double max_shape_size = 1e4;   // m

struct Sphere {
    double radius = 0.5;

    bool operator==(const Sphere&) const = default;
};

// A segment along the local y axis from -half_length to +half_length, thickened by the radius.
struct Capsule {
    double radius = 0.25;
    double half_length = 0.5;

    bool operator==(const Capsule&) const = default;
};

struct Box {
    Vec3 half_extents{0.5, 0.5, 0.5};

    bool operator==(const Box&) const = default;
};

// Everything below a plane through the local origin is solid. Only static bodies may carry one.
struct Plane {
    Vec3 normal{0, 1, 0};  // not zero; the world makes it unit length

    bool operator==(const Plane&) const = default;
};

// Along the local y axis, flat ends at -half_length and +half_length.
struct Cylinder {
    double radius = 0.5;
    double half_length = 0.5;

    bool operator==(const Cylinder&) const = default;
};

// Along the local y axis: a disc of the radius at -half_length, the tip at +half_length.
struct Cone {
    double radius = 0.5;
    double half_length = 0.5;

    bool operator==(const Cone&) const = default;
};

struct ConvexHull;     // hull.h
struct TriangleMesh;   // mesh.h
struct HeightGrid;     // height_field.h
struct CompoundShape;  // compound.h

// The convex hull of a set of points.
struct Hull {
    std::shared_ptr<const ConvexHull> data;  // not null

    bool operator==(const Hull& other) const;  // of content
};

// Triangles. Both sides collide. For static and kinematic bodies only.
struct Mesh {
    std::shared_ptr<const TriangleMesh> data;  // not null

    bool operator==(const Mesh& other) const;  // of content
};

// Heights along y on a regular grid in the local xz plane. Both sides collide. For static and
// kinematic bodies only.
struct HeightField {
    std::shared_ptr<const HeightGrid> data;  // not null

    bool operator==(const HeightField& other) const;  // of content
};

// Several convex shapes as one: for bodies of many parts.
struct Compound {
    std::shared_ptr<const CompoundShape> data;  // not null

    bool operator==(const Compound& other) const;  // of content
};

using Geometry =
    std::variant<Sphere, Capsule, Box, Plane, Cylinder, Cone, Hull, Mesh, HeightField, Compound>;

// In the order of Geometry's alternatives.
enum class ShapeKind {
    sphere,
    capsule,
    box,
    plane,
    cylinder,
    cone,
    hull,
    mesh,
    height_field,
    compound
};
inline constexpr int shape_kinds = 10;

inline ShapeKind kind_of(const Geometry& geometry) {
    return static_cast<ShapeKind>(geometry.index());
}
const char* kind_name(ShapeKind kind);  // "sphere", "height_field", ...

// Sphere, capsule, box, cylinder, cone or hull. The children of a compound and the shapes of casts
// and overlap queries must be convex.
inline bool is_convex(ShapeKind kind) {
    return kind <= ShapeKind::hull && kind != ShapeKind::plane;
}

}  // namespace jostle::physics
