// SPDX-License-Identifier: MIT
#include "jostle/physics/compound.h"
#include "jostle/base/check.h"

#include "jostle/physics/hull.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/geometry_checks.h"
#include "physics/src/geometry/shape_measures.h"

namespace jostle::physics {
namespace {

Error compound_error(std::string message) {
    return invalid_argument("compound: " + std::move(message));
}

void add_to(Hasher& hasher, const Geometry& geometry) {
    hasher.add(geometry.index());
    const auto add = [&](double x) { hasher.add(bits_of(x)); };
    if (const auto* s = std::get_if<Sphere>(&geometry)) add(s->radius);
    if (const auto* c = std::get_if<Capsule>(&geometry)) add(c->radius), add(c->half_length);
    if (const auto* c = std::get_if<Cylinder>(&geometry)) add(c->radius), add(c->half_length);
    if (const auto* c = std::get_if<Cone>(&geometry)) add(c->radius), add(c->half_length);
    if (const auto* b = std::get_if<Box>(&geometry))
        for (int k = 0; k < 3; k++) add(b->half_extents[k]);
    if (const auto* h = std::get_if<Hull>(&geometry)) hasher.add(h->data->content_hash);
}

}  // namespace

Result<std::shared_ptr<const CompoundShape>> build_compound(std::vector<CompoundChild> children) {
    if (children.empty()) return compound_error("it has no children");
    if (children.size() > max_compound_children)
        return compound_error("it has " + std::to_string(children.size()) + " children; at most " +
                              std::to_string(max_compound_children) + " are allowed");
    auto compound = std::make_shared<CompoundShape>();
    Hasher hasher;
    std::vector<Aabb> boxes;
    compound->inner_radius = 1e300;
    for (std::size_t i = 0; i < children.size(); i++) {
        CompoundChild& child = children[i];
        const std::string name = "children[" + std::to_string(i) + "]";
        if (!is_convex(kind_of(child.geometry)))
            return compound_error(name + " is a " + kind_name(kind_of(child.geometry)) +
                                  "; it must be a sphere, capsule, box, cylinder, cone or hull");
        if (Status s = check_geometry(name.c_str(), child.geometry); !s.ok()) return s.error();
        const double norm = norm_squared(child.pose.rotation);
        const Vec3 reach = abs(child.pose.position);
        if (!is_finite(child.pose) || norm < 1e-6 ||
            maximum(reach.x, maximum(reach.y, reach.z)) > max_shape_size)
            return compound_error(
                name +
                ".pose is invalid; it must be finite, within 10000 m and have a non-zero rotation");
        child.pose.rotation = unit(child.pose.rotation);
        boxes.push_back(bounds_of(transformed_shape(child.geometry, child.pose)));
        compound->bounds = i == 0 ? boxes[0] : unite(compound->bounds, boxes[i]);
        compound->inner_radius = minimum(compound->inner_radius, inner_radius_of(child.geometry));
        add_to(hasher, child.geometry);
        for (int k = 0; k < 3; k++) hasher.add(bits_of(child.pose.position[k]));
        const Quat q = child.pose.rotation;
        for (const double x : {q.x, q.y, q.z, q.w}) hasher.add(bits_of(x));
    }
    compound->children = std::move(children);
    compound->tree = std::make_shared<const Bvh>(boxes);
    ASSERT(boxes.size() == compound->children.size() && compound->inner_radius < 1e300);
    compound->content_hash = hasher.value;
    return std::shared_ptr<const CompoundShape>(std::move(compound));
}

}  // namespace jostle::physics
