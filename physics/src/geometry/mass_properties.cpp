// SPDX-License-Identifier: MIT
#include "physics/src/geometry/mass_properties.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"

namespace jostle::physics {
namespace {

MassProperties mass_of_sphere(const Sphere& s, double density) {
    const double m = density * 4 / 3 * pi * s.radius * s.radius * s.radius;
    const double i = 0.4 * m * s.radius * s.radius;
    return {m, {}, diagonal({i, i, i})};
}

// A cylinder and two half balls, whose centres of mass are 3/8 r beyond the ends of the segment.
MassProperties mass_of_capsule(const Capsule& c, double density) {
    const double r = c.radius, h = c.half_length;
    const double cylinder = density * pi * r * r * 2 * h;
    const double ball = density * 4 / 3 * pi * r * r * r;
    const double along = cylinder * 0.5 * r * r + ball * 0.4 * r * r;
    const double across =
        cylinder * (0.25 * r * r + h * h / 3) + ball * (0.4 * r * r + h * h + 0.75 * h * r);
    return {cylinder + ball, {}, diagonal({across, along, across})};
}

MassProperties mass_of_box(const Box& b, double density) {
    const Vec3 h = b.half_extents;
    const double m = density * 8 * h.x * h.y * h.z, third = m / 3;
    return {m,
            {},
            diagonal({third * (h.y * h.y + h.z * h.z), third * (h.x * h.x + h.z * h.z),
                      third * (h.x * h.x + h.y * h.y)})};
}

MassProperties mass_of_cylinder(const Cylinder& c, double density) {
    const double r2 = c.radius * c.radius, h = 2 * c.half_length;
    const double m = density * pi * r2 * h, across = m * (3 * r2 + h * h) / 12;
    return {m, {}, diagonal({across, 0.5 * m * r2, across})};
}

// The centre of mass is a quarter of the height above the base.
MassProperties mass_of_cone(const Cone& c, double density) {
    const double r2 = c.radius * c.radius, h = 2 * c.half_length;
    const double m = density * pi * r2 * h / 3, across = m * (0.15 * r2 + 0.0375 * h * h);
    return {m, {0, -0.5 * c.half_length, 0}, diagonal({across, 0.3 * m * r2, across})};
}

MassProperties mass_of_hull(const ConvexHull& hull, double density) {
    return {density * hull.volume, hull.center, hull.unit_inertia * density};
}

MassProperties mass_of_compound(const CompoundShape& compound, double density) {
    MassProperties sum;
    for (const CompoundChild& child : compound.children)
        sum = combined(sum, moved(mass_of(child.geometry, density), child.pose));
    return sum;
}

// Inertia of a point mass m at offset d: m (|d|^2 1 - d d^T).
Mat3 offset_inertia(double m, Vec3 d) {
    const double d2 = length_squared(d);
    ASSERT(m >= 0);
    return Mat3{{d2 - d.x * d.x, -d.x * d.y, -d.x * d.z},
                {-d.y * d.x, d2 - d.y * d.y, -d.y * d.z},
                {-d.z * d.x, -d.z * d.y, d2 - d.z * d.z}} *
           m;
}

}  // namespace

MassProperties mass_of(const Geometry& geometry, double density) {
    ASSERT(density >= 0);
    switch (kind_of(geometry)) {
        case ShapeKind::sphere:
            return mass_of_sphere(std::get<Sphere>(geometry), density);
        case ShapeKind::capsule:
            return mass_of_capsule(std::get<Capsule>(geometry), density);
        case ShapeKind::box:
            return mass_of_box(std::get<Box>(geometry), density);
        case ShapeKind::cylinder:
            return mass_of_cylinder(std::get<Cylinder>(geometry), density);
        case ShapeKind::cone:
            return mass_of_cone(std::get<Cone>(geometry), density);
        case ShapeKind::hull:
            return mass_of_hull(*std::get<Hull>(geometry).data, density);
        case ShapeKind::compound:
            return mass_of_compound(*std::get<Compound>(geometry).data, density);
        case ShapeKind::plane:
        case ShapeKind::mesh:
        case ShapeKind::height_field:
            break;
    }
    return {};
}

MassProperties moved(const MassProperties& properties, const Transform& pose) {
    // Without rotation, preserve exact zeros off the diagonal, so that a cube stays isotropic.
    if (pose.rotation == Quat{})
        return {properties.mass, pose.position + properties.center, properties.inertia};
    const Mat3 r = to_matrix(pose.rotation);
    return {properties.mass, apply(pose, properties.center), r * properties.inertia * transpose(r)};
}

MassProperties combined(const MassProperties& a, const MassProperties& b) {
    if (a.mass == 0) return b;
    if (b.mass == 0) return a;
    const double mass = a.mass + b.mass;
    ASSERT(a.mass > 0 && b.mass > 0);
    const Vec3 center = (a.center * a.mass + b.center * b.mass) / mass;
    return {mass, center,
            a.inertia + b.inertia + offset_inertia(a.mass, a.center - center) +
                offset_inertia(b.mass, b.center - center)};
}

}  // namespace jostle::physics
