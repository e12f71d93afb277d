// SPDX-License-Identifier: MIT
#include "jostle/scenes/geometry_message_bytes.h"

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::scenes {

using namespace physics;

const void* shared_data(const Geometry& geometry) {
    return std::visit(
        [](const auto& shape) -> const void* {
            if constexpr (requires { shape.data; })
                return shape.data.get();
            else
                return nullptr;
        },
        geometry);
}

std::size_t geometry_message_bytes(const Geometry& geometry) {
    constexpr std::size_t head = 16, vector = 29, index = 5;
    if (const auto* hull = std::get_if<Hull>(&geometry))
        return head + hull->data->vertices.size() * vector;
    if (const auto* mesh = std::get_if<Mesh>(&geometry))
        return head + mesh->data->vertices.size() * vector +
               mesh->data->triangles.size() * 3 * index;
    if (const auto* field = std::get_if<HeightField>(&geometry))
        return head + 4 * vector + field->data->heights.size() * sizeof(double) +
               field->data->holes.size() * index;
    if (const auto* compound = std::get_if<Compound>(&geometry)) {
        std::size_t bytes = head;
        for (const CompoundChild& child : compound->data->children)
            bytes += 3 * vector + geometry_message_bytes(child.geometry);
        return bytes;
    }
    return head + vector;
}

}  // namespace jostle::scenes
