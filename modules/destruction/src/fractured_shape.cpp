// SPDX-License-Identifier: MIT
#include "jostle/modules/fractured_shape.h"

#include <string>

#include "modules/destruction/src/convex_cell.h"
#include "modules/destruction/src/fracture_cells.h"
#include "modules/destruction/src/next_uniform.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

Status check_extents(Vec3 e) {
    for (int k = 0; k < 3; k++)
        if (!(e[k] >= min_shape_size && e[k] <= max_shape_size))
            return invalid_argument("half_extents is out of range; it must be from 1e-4 to 1e4 m");
    return {};
}

// The face between two boxes with the given half extents that are adjacent along an axis.
FractureBond box_bond(std::uint32_t a, std::uint32_t b, Vec3 at, Vec3 h, int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    FractureBond bond{.a = a, .b = b, .center = at};
    bond.center[axis] += h[axis];
    bond.normal[axis] = 1;
    bond.axis[u] = 1;
    bond.area = 4 * h[u] * h[v];
    bond.moment_u = bond.area * h[v] * h[v] / 3;
    bond.moment_v = bond.area * h[u] * h[u] / 3;
    bond.reach_u = h[v];
    bond.reach_v = h[u];
    return bond;
}

FractureChunk box_chunk(Vec3 at, Vec3 h) {
    const double volume = 8 * h.x * h.y * h.z;
    const Vec3 s = scaled(h, h) * (volume / 3);
    return {.geometry = Box{h},
            .pose = {.position = at},
            .center = at,
            .volume = volume,
            .unit_inertia = diagonal({s.y + s.z, s.z + s.x, s.x + s.y})};
}

double reach_of(const FractureChunk& chunk, Vec3 direction) {
    if (const auto* box = std::get_if<Box>(&chunk.geometry)) {
        const Vec3 local = inverse_rotate(chunk.pose.rotation, direction);
        return dot(direction, chunk.pose.position) + dot(abs(local), box->half_extents);
    }
    double most = dot(direction, chunk.center);
    if (const auto* hull = std::get_if<Hull>(&chunk.geometry))
        for (const Vec3 p : hull->data->vertices)
            most = maximum(most, dot(direction, apply(chunk.pose, p)));
    return most;
}

}  // namespace

Result<FracturedShape> fracture_hull(const ConvexHull& hull, std::span<const Vec3> seeds) {
    const ConvexCell cell = cell_of(hull);
    return fracture_cell(cell, seeds);
}

Result<FracturedShape> fracture_box(Vec3 half_extents, std::span<const Vec3> seeds) {
    if (Status s = check_extents(half_extents); !s.ok()) return s.error();
    const ConvexCell cell = cell_of_box(half_extents);
    return fracture_cell(cell, seeds);
}

Result<FractureResult> fracture_parts(std::span<const std::shared_ptr<const ConvexHull>> parts,
                                      std::span<const Vec3> seeds,
                                      const FractureProgress& progress) {
    if (parts.empty() || parts.size() > fracture_parts_max)
        return invalid_argument("parts has " + std::to_string(parts.size()) +
                                " elements; it must have 1 to " +
                                std::to_string(fracture_parts_max));
    for (std::size_t k = 0; k < parts.size(); k++)
        if (!parts[k]) return invalid_argument("parts[" + std::to_string(k) + "] is null");
    const std::vector<ConvexCell> cells = disjoint_cells(parts);
    return fracture_cells(cells, seeds, progress);
}

Result<FracturedShape> split_box(Vec3 e, int nx, int ny, int nz) {
    if (Status s = check_extents(e); !s.ok()) return s.error();
    const int counts[3] = {nx, ny, nz};
    for (const int count : counts)
        if (count < 1 || count > 1000)
            return invalid_argument(
                "number of boxes along an axis is out of range; it must be from 1 to 1000");
    if (static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) >
        chunks_max)
        return invalid_argument("the box would be split into more than " +
                                std::to_string(chunks_max) + " boxes");
    const Vec3 h{e.x / nx, e.y / ny, e.z / nz};
    if (Status s = check_extents(h); !s.ok()) return s.error();
    const int stride[3] = {1, nx, nx * ny};
    FracturedShape shape;
    for (int z = 0; z < nz; z++)
        for (int y = 0; y < ny; y++)
            for (int x = 0; x < nx; x++) {
                const int cell[3] = {x, y, z};
                const Vec3 at = scaled(h, {2.0 * x + 1, 2.0 * y + 1, 2.0 * z + 1}) - e;
                const auto own = static_cast<std::uint32_t>(shape.chunks.size());
                shape.chunks.push_back(box_chunk(at, h));
                for (int axis = 0; axis < 3; axis++)
                    if (cell[axis] + 1 < counts[axis])
                        shape.bonds.push_back(box_bond(
                            own, own + static_cast<std::uint32_t>(stride[axis]), at, h, axis));
            }
    return shape;
}

std::vector<Vec3> random_seeds(Vec3 e, int count, std::uint64_t seed) {
    std::vector<Vec3> points;
    for (int k = 0; k < count; k++) {
        const double x = next_uniform(seed), y = next_uniform(seed), z = next_uniform(seed);
        points.push_back(scaled(e, {2 * x - 1, 2 * y - 1, 2 * z - 1}));
    }
    return points;
}

std::size_t anchor(FracturedShape& shape, Vec3 direction, double offset) {
    std::size_t count = 0;
    for (FractureChunk& chunk : shape.chunks)
        if (reach_of(chunk, direction) >= offset) {
            chunk.anchored = true;
            count++;
        }
    return count;
}

}  // namespace jostle::modules
