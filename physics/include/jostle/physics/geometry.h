// SPDX-License-Identifier: MIT
//
// Shape kinds as plain data. Each shape is defined in its local frame; sizes are in metres.
// Primitive shapes are values. Hulls, meshes, height fields and compounds are immutable shared
// objects, created by build_hull, build_mesh, build_height_field and build_compound.
#pragma once

#include <memory>
#include <variant>

#include "jostle/physics/vec3.h"

namespace jostle::physics {

/// Range of radii, half lengths, half extents and spacings, in m. Coordinates of points are within
/// +-max_shape_size. Beyond this range, masses overflow single precision in the contact solver.
inline constexpr double min_shape_size = 1e-4;
inline constexpr double max_shape_size = 1e4;

/// A sphere around the local origin.
struct Sphere {
    double radius = 0.5;  ///< m

    bool operator==(const Sphere&) const = default;
};

/// A capsule: the segment from -half_length to +half_length on the local y axis, inflated by the
/// radius.
struct Capsule {
    double radius = 0.25;      ///< m
    double half_length = 0.5;  ///< m, without the caps

    bool operator==(const Capsule&) const = default;
};

/// A box around the local origin, aligned with the local axes.
struct Box {
    Vec3 half_extents{0.5, 0.5, 0.5};  ///< m

    bool operator==(const Box&) const = default;
};

/// A half-space: everything below a plane through the local origin is solid. For static bodies
/// only.
struct Plane {
    Vec3 normal{0, 1, 0};  ///< not zero; the world normalizes it

    bool operator==(const Plane&) const = default;
};

/// A cylinder along the local y axis, from -half_length to +half_length.
struct Cylinder {
    double radius = 0.5;       ///< m
    double half_length = 0.5;  ///< m

    bool operator==(const Cylinder&) const = default;
};

/// A cone along the local y axis. The base is at -half_length, the apex at +half_length.
struct Cone {
    double radius = 0.5;       ///< m, of the base
    double half_length = 0.5;  ///< m

    bool operator==(const Cone&) const = default;
};

struct ConvexHull;     // hull.h
struct TriangleMesh;   // mesh.h
struct HeightGrid;     // height_field.h
struct CompoundShape;  // compound.h

/// The convex hull of a set of points. Equality compares the content.
struct Hull {
    std::shared_ptr<const ConvexHull> data;  ///< from build_hull(); not null

    bool operator==(const Hull& other) const;
};

/// A triangle mesh. Both sides collide. For static and kinematic bodies only. Equality compares the
/// content.
struct Mesh {
    std::shared_ptr<const TriangleMesh> data;  ///< from build_mesh(); not null

    bool operator==(const Mesh& other) const;
};

/// A grid of heights along y over the local xz plane. Both sides collide. For static and kinematic
/// bodies only. Equality compares the content.
struct HeightField {
    std::shared_ptr<const HeightGrid> data;  ///< from build_height_field(); not null

    bool operator==(const HeightField& other) const;
};

/// Several convex shapes as one, for bodies with many parts. Equality compares the content.
struct Compound {
    std::shared_ptr<const CompoundShape> data;  ///< from build_compound(); not null

    bool operator==(const Compound& other) const;
};

/// The geometry of a shape.
using Geometry =
    std::variant<Sphere, Capsule, Box, Plane, Cylinder, Cone, Hull, Mesh, HeightField, Compound>;

/// Shape kinds, in the order of the alternatives of Geometry.
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
/// Number of shape kinds.
inline constexpr int shape_kinds = 10;

/// Returns the kind of a geometry.
inline ShapeKind kind_of(const Geometry& geometry) {
    return static_cast<ShapeKind>(geometry.index());
}
/// Returns the name of a kind: "sphere", "height field". The string has static storage duration.
const char* kind_name(ShapeKind kind);

/// Returns true for sphere, capsule, box, cylinder, cone and hull. Children of a compound and
/// shapes of casts and overlap queries must be convex.
inline bool is_convex(ShapeKind kind) {
    return kind <= ShapeKind::hull && kind != ShapeKind::plane;
}

}  // namespace jostle::physics
