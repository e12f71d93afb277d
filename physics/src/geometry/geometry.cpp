// SPDX-License-Identifier: MIT
#include "jostle/physics/geometry.h"

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::physics {
namespace {

template <class T>
bool same(const std::shared_ptr<T>& a, const std::shared_ptr<T>& b) {
    return a == b || (a && b && a->content_hash == b->content_hash);
}

}  // namespace

bool Hull::operator==(const Hull& other) const {
    return same(data, other.data);
}
bool Mesh::operator==(const Mesh& other) const {
    return same(data, other.data);
}
bool HeightField::operator==(const HeightField& other) const {
    return same(data, other.data);
}
bool Compound::operator==(const Compound& other) const {
    return same(data, other.data);
}

const char* kind_name(ShapeKind kind) {
    switch (kind) {
        case ShapeKind::sphere:
            return "sphere";
        case ShapeKind::capsule:
            return "capsule";
        case ShapeKind::box:
            return "box";
        case ShapeKind::plane:
            return "plane";
        case ShapeKind::cylinder:
            return "cylinder";
        case ShapeKind::cone:
            return "cone";
        case ShapeKind::hull:
            return "hull";
        case ShapeKind::mesh:
            return "mesh";
        case ShapeKind::height_field:
            return "height field";
        case ShapeKind::compound:
            return "compound";
    }
    return "unknown";
}

}  // namespace jostle::physics
