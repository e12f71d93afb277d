// SPDX-License-Identifier: MIT
#include "tools/mesh/fracture_solid.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "tools/mesh/obj_file.h"

namespace jostle::mesh {

using namespace physics;

namespace {

using Part = std::shared_ptr<const ConvexHull>;

struct Parts {
    std::vector<Part> hulls;
    double max_volume_error = 0;
};

Result<Parts> single_hull(std::span<const Vec3> points) {
    auto hull = build_hull(points);
    if (!hull.ok()) return hull.error();
    return Parts{{std::move(*hull)}, 0};
}

Result<Parts> parts_of_mesh(const Solid& solid) {
    Result<ObjMesh> mesh = read_obj(solid.obj);
    if (!mesh.ok()) return mesh.error();
    for (Vec3& p : mesh->vertices) p = p * solid.scale;
    auto parts = modules::convex_decomposition::decompose(mesh->vertices, mesh->indices,
                                                          solid.decomposition);
    if (!parts.ok()) return parts.error();
    return Parts{std::move(parts->parts), parts->max_volume_error};
}

Result<Parts> parts_of(const Solid& solid) {
    if (!solid.box) return solid.points.empty() ? parts_of_mesh(solid) : single_hull(solid.points);
    const Vec3 half = *solid.box * 0.5;
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; k++)
        corners.push_back({(k & 1) != 0 ? half.x : -half.x, (k & 2) != 0 ? half.y : -half.y,
                           (k & 4) != 0 ? half.z : -half.z});
    return single_hull(corners);
}

bool is_inside(const Part& part, Vec3 p) {
    return std::all_of(part->faces.begin(), part->faces.end(),
                       [&](const HullFace& face) { return dot(face.normal, p) <= face.offset; });
}

double extent_along(const modules::FractureChunk& chunk, Vec3 direction) {
    double most = -1e300;
    for (const Vec3 p : std::get<Hull>(chunk.geometry).data->vertices)
        most = std::max(most, dot(direction, p));
    return most;
}

void anchor_side(modules::FracturedShape& shape, Vec3 direction, double size) {
    double furthest = -1e300;
    for (const modules::FractureChunk& chunk : shape.chunks)
        furthest = std::max(furthest, extent_along(chunk, direction));
    modules::anchor(shape, direction, furthest - 1e-6 * size);
}

}  // namespace

Result<FracturedSolid> fracture_solid(const Solid& solid, const modules::SeedPatternOptions& plan,
                                      std::optional<Vec3> anchor,
                                      const modules::FractureProgress& progress) {
    Result<Parts> parts = parts_of(solid);
    if (!parts.ok()) return parts.error();
    Aabb bounds = parts->hulls.front()->bounds;
    for (const Part& part : parts->hulls)
        bounds = {min(bounds.low, part->bounds.low), max(bounds.high, part->bounds.high)};
    const auto seeds = modules::generate_seeds(bounds, plan, [&](Vec3 p) {
        return std::any_of(parts->hulls.begin(), parts->hulls.end(),
                           [&](const Part& part) { return is_inside(part, p); });
    });
    if (!seeds.ok()) return seeds.error();
    Result<modules::FractureResult> made = modules::fracture_parts(parts->hulls, *seeds, progress);
    if (!made.ok()) return made.error();
    FracturedSolid result{std::move(made->shape), parts->hulls.size(), parts->max_volume_error,
                          made->volume, made->lost_volume};
    if (anchor) anchor_side(result.shape, *anchor, length(bounds.high - bounds.low));
    return result;
}

}  // namespace jostle::mesh
