// SPDX-License-Identifier: MIT
#include "jostle/modules/fractured_shape.h"

#include <algorithm>
#include <string>

#include "convex_cell.h"
#include "section.h"

namespace jostle::modules {

using namespace physics;
using namespace destruction_detail;

namespace {

// Of the size: what is nearer to a plane than rounding can tell lies on it.
constexpr double grain_share = 1e-14;
// Of the square of the size: faces that are smaller hold nothing.
constexpr double least_face_share = 1e-8;

bool before(Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

Status check_seeds(std::span<const Vec3> seeds) {
    if (seeds.empty() || seeds.size() > most_chunks)
        return invalid_argument("there are " + std::to_string(seeds.size()) + " seeds; give 1 to " +
                                std::to_string(most_chunks));
    for (std::size_t k = 0; k < seeds.size(); k++)
        if (!is_finite(seeds[k]) || !(length_squared(seeds[k]) < 1e8))
            return invalid_argument("seeds[" + std::to_string(k) +
                                    "] is not finite or beyond 10 km");
    std::vector<std::size_t> order(seeds.size());
    for (std::size_t k = 0; k < order.size(); k++) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return before(seeds[a], seeds[b]); });
    for (std::size_t k = 1; k < order.size(); k++)
        if (seeds[order[k]] == seeds[order[k - 1]])
            return invalid_argument("seeds[" + std::to_string(std::max(order[k], order[k - 1])) +
                                    "] is there twice");
    return {};
}

// What of the whole is nearer to this seed than to any other. Others are cut off by distance: when
// one is so far that its plane lies beyond the furthest corner, so do all that follow.
ConvexCell voronoi_cell(const ConvexCell& whole, std::span<const Vec3> seeds, std::size_t own,
                        double grain) {
    const Vec3 here = seeds[own];
    std::vector<std::pair<double, std::uint32_t>> others;
    for (std::size_t k = 0; k < seeds.size(); k++)
        if (k != own)
            others.emplace_back(length_squared(seeds[k] - here), static_cast<std::uint32_t>(k));
    std::sort(others.begin(), others.end());
    ConvexCell cell = whole;
    double reach2 = furthest_squared(cell, here);
    for (const auto& [distance2, k] : others) {
        if (cell.empty() || distance2 > 4 * reach2) break;
        const Vec3 normal = (seeds[k] - here) / square_root(distance2);
        cell = clipped(cell, normal, dot(normal, (seeds[k] + here) * 0.5), k, grain);
        reach2 = furthest_squared(cell, here);
    }
    return cell;
}

Result<FractureChunk> chunk_of(const ConvexCell& cell, const CellMass& mass) {
    std::vector<Vec3> points;
    for (const CellFace& face : cell.faces)
        points.insert(points.end(), face.points.begin(), face.points.end());
    auto hull = build_hull(points);
    if (!hull.ok()) return hull.error();
    return FractureChunk{.geometry = Hull{*hull},
                         .center = mass.center,
                         .volume = mass.volume,
                         .unit_inertia = mass.inertia};
}

// The face of a's cell towards b.
FractureBond bond_of(const CellFace& face, std::uint32_t a, std::uint32_t b) {
    const Section s = section_of(face.points, face.normal);
    return {a,      b,          s.center,   face.normal, s.axis,
            s.area, s.moment_u, s.moment_v, s.reach_u,   s.reach_v};
}

Result<FracturedShape> fracture(const ConvexCell& whole, std::span<const Vec3> seeds) {
    if (Status s = check_seeds(seeds); !s.ok()) return s.error();
    const double size = square_root(furthest_squared(whole, mass_of(whole).center));
    FracturedShape shape;
    std::vector<ConvexCell> cells;
    std::vector<std::uint32_t> chunk_at(seeds.size(), outer_face);  // by seed
    for (std::size_t k = 0; k < seeds.size(); k++) {
        ConvexCell cell = voronoi_cell(whole, seeds, k, grain_share * size);
        const CellMass mass = mass_of(cell);
        if (!(mass.volume > 0)) continue;
        Result<FractureChunk> chunk = chunk_of(cell, mass);
        if (!chunk.ok())
            return invalid_argument("seeds[" + std::to_string(k) +
                                    "]: its chunk is too thin: " + chunk.error().message);
        chunk_at[k] = static_cast<std::uint32_t>(shape.chunks.size());
        shape.chunks.push_back(std::move(*chunk));
        cells.push_back(std::move(cell));
    }
    for (std::uint32_t a = 0; a < cells.size(); a++)
        for (const CellFace& face : cells[a].faces) {
            if (face.neighbour == outer_face) continue;
            const std::uint32_t b = chunk_at[face.neighbour];
            if (b == outer_face || b < a) continue;
            const FractureBond bond = bond_of(face, a, b);
            if (bond.area > least_face_share * size * size) shape.bonds.push_back(bond);
        }
    return shape;
}

Status check_extents(Vec3 e) {
    for (int k = 0; k < 3; k++)
        if (!(e[k] >= min_shape_size && e[k] <= max_shape_size))
            return invalid_argument(
                "half_extents are not within the sizes of shapes, 1e-4 to 1e4 m");
    return {};
}

// The face between two boxes of those half extents, one step along an axis apart.
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

// SplitMix64 (Steele, Lea, Flood, 2014), 0 to 1.
double next_chance(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

}  // namespace

Result<FracturedShape> fracture_hull(const ConvexHull& hull, std::span<const Vec3> seeds) {
    return fracture(cell_of(hull), seeds);
}

Result<FracturedShape> fracture_box(Vec3 half_extents, std::span<const Vec3> seeds) {
    if (Status s = check_extents(half_extents); !s.ok()) return s.error();
    return fracture(cell_of_box(half_extents), seeds);
}

Result<FracturedShape> split_box(Vec3 e, int nx, int ny, int nz) {
    if (Status s = check_extents(e); !s.ok()) return s.error();
    const int counts[3] = {nx, ny, nz};
    for (const int count : counts)
        if (count < 1 || count > 1000)
            return invalid_argument("a number of boxes is not 1 to 1000");
    if (static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) >
        most_chunks)
        return invalid_argument("there are more than " + std::to_string(most_chunks) + " boxes");
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

std::vector<Vec3> scattered_seeds(Vec3 e, int count, std::uint64_t seed) {
    std::vector<Vec3> points;
    for (int k = 0; k < count; k++) {
        const double x = next_chance(seed), y = next_chance(seed), z = next_chance(seed);
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
