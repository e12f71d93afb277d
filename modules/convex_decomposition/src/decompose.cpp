// SPDX-License-Identifier: MIT
#include "jostle/modules/convex_decomposition.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "jostle/physics/scalar.h"
#include "modules/convex_decomposition/src/closed_mesh.h"
#include "modules/convex_decomposition/src/cut_mesh.h"

namespace jostle::modules::convex_decomposition {
namespace {

using namespace physics;
using HullPointer = std::shared_ptr<const ConvexHull>;

struct Part {
    Aabb box;                       // that bounds the part
    std::vector<Triangle> surface;  // triangles that affect the box
    Piece piece;
    HullPointer hull;      // null if it has too many corners for one hull
    bool reduced = false;  // the hull lacks corners of the piece, because it would have too many
    bool done = false;

    double max_volume_error() const {
        if (!hull) return 1e300;
        return reduced ? absolute(hull->volume - piece.volume)
                       : maximum(hull->volume - piece.volume, 0);
    }
};

// Returns the points that are farthest in evenly distributed directions: those through a grid of
// side x side points on each face of a cube.
std::vector<Vec3> farthest_points(const std::vector<Vec3>& points, int side) {
    std::vector<std::size_t> chosen;
    for (int axis = 0; axis < 3; axis++)
        for (const double sign : {-1.0, 1.0})
            for (int i = 0; i < side; i++)
                for (int j = 0; j < side; j++) {
                    const double u = (2 * i + 1.0) / side - 1, v = (2 * j + 1.0) / side - 1;
                    const Vec3 direction = axis == 0   ? Vec3{sign, u, v}
                                           : axis == 1 ? Vec3{u, sign, v}
                                                       : Vec3{u, v, sign};
                    std::size_t best = 0;
                    for (std::size_t k = 1; k < points.size(); k++)
                        if (dot(direction, points[k]) > dot(direction, points[best])) best = k;
                    chosen.push_back(best);
                }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<Vec3> farthest;
    for (const std::size_t k : chosen) farthest.push_back(points[k]);
    return farthest;
}

// Builds a hull of the farthest points only, as many as a hull can have: a smooth piece has more
// corners than a hull, or than one of its faces, can have.
void add_reduced_hull(Part& part) {
    for (const int side : {6, 5, 4, 3, 2})
        if (auto hull = build_hull(farthest_points(part.piece.points, side)); hull.ok()) {
            part.hull = *hull;
            part.reduced = true;
            return;
        }
}

// Returns nullopt for flat pieces, which have no volume.
std::optional<Part> part_in(const std::vector<Triangle>& surface, const Aabb& box) {
    Part part{.box = box, .surface = triangles_for_box(surface, box)};
    part.piece = cut_piece(part.surface, box);
    if (part.piece.points.size() < 4) return std::nullopt;
    const Vec3 size = box.high - box.low;
    if (part.piece.volume < 1e-9 * size.x * size.y * size.z) return std::nullopt;
    if (auto hull = build_hull(part.piece.points); hull.ok()) part.hull = *hull;
    return part;
}

using Halves = std::vector<Part>;

// A part with too many corners for a hull counts with the volume of its box.
double volume_of(const Halves& halves) {
    double volume = 0;
    for (const Part& half : halves) {
        const Vec3 size = half.piece.bounds.high - half.piece.bounds.low;
        volume += half.hull ? half.hull->volume : size.x * size.y * size.z;
    }
    return volume;
}

Aabb with_bound(Aabb box, int axis, double at, bool high) {
    Vec3& wall = high ? box.high : box.low;
    (axis == 0 ? wall.x : (axis == 1 ? wall.y : wall.z)) = at;
    return box;
}

// Returns the two sides of the best of the tried planes: the one with the smallest total hull
// volume.
Halves best_cut(const Part& part, int planes) {
    Halves best;
    double least = 1e300;
    for (int axis = 0; axis < 3; axis++)
        for (int k = 1; k <= planes; k++) {
            const double low = part.piece.bounds.low[axis], high = part.piece.bounds.high[axis];
            const double at = low + (high - low) * k / (planes + 1);
            if (!(at > low && at < high)) continue;
            Halves halves;
            for (const bool below : {true, false})
                if (auto half = part_in(part.surface, with_bound(part.box, axis, at, below)))
                    halves.push_back(std::move(*half));
            const double volume = volume_of(halves);
            if (halves.size() == 2 && volume < least) {
                least = volume;
                best = std::move(halves);
            }
        }
    return best;
}

double total_volume_error(const std::vector<Part>& parts) {
    double sum = 0;
    for (const Part& part : parts) sum += part.hull ? part.max_volume_error() : 0;
    return sum;
}

void cut(std::vector<Part>& parts, const Options& options, double allowed) {
    while (parts.size() < static_cast<std::size_t>(options.hulls_max)) {
        const auto worst = std::max_element(parts.begin(), parts.end(), [](auto& a, auto& b) {
            return (a.done ? -1 : a.max_volume_error()) < (b.done ? -1 : b.max_volume_error());
        });
        const bool in_one = std::all_of(parts.begin(), parts.end(),
                                        [](const Part& part) { return part.hull != nullptr; });
        if (worst->done || (in_one && total_volume_error(parts) <= allowed)) return;
        Halves halves = best_cut(*worst, options.planes_per_axis);
        if (halves.empty()) {
            worst->done = true;
            continue;
        }
        *worst = std::move(halves[0]);
        parts.push_back(std::move(halves[1]));
    }
}

bool are_neighbours(const Part& a, const Part& b) {
    const Vec3 size =
        max(a.piece.bounds.high, b.piece.bounds.high) - min(a.piece.bounds.low, b.piece.bounds.low);
    const double near = 1e-6 * length(size);
    for (int axis = 0; axis < 3; axis++)
        if (a.piece.bounds.low[axis] > b.piece.bounds.high[axis] + near ||
            b.piece.bounds.low[axis] > a.piece.bounds.high[axis] + near)
            return false;
    return true;
}

// Returns the common hull of two parts; nullopt if it has too many corners.
std::optional<Part> merged(const Part& a, const Part& b) {
    Part part;
    part.piece.points = a.hull->vertices;
    part.piece.points.insert(part.piece.points.end(), b.hull->vertices.begin(),
                             b.hull->vertices.end());
    part.piece.bounds = {min(a.piece.bounds.low, b.piece.bounds.low),
                         max(a.piece.bounds.high, b.piece.bounds.high)};
    part.piece.volume = a.piece.volume + b.piece.volume;
    const auto hull = build_hull(part.piece.points);
    if (!hull.ok()) return std::nullopt;
    part.hull = *hull;
    return part;
}

// Merges pairs in the order of the added volume while the total error is allowed.
void merge_parts(std::vector<Part>& parts, double allowed) {
    struct Pair {
        std::size_t a, b;
        double more;
    };
    const auto more_of = [&](std::size_t a, std::size_t b) {
        const auto both = merged(parts[a], parts[b]);
        return both ? both->max_volume_error() - parts[a].max_volume_error() -
                          parts[b].max_volume_error()
                    : 1e300;
    };
    std::vector<Pair> pairs;
    for (std::size_t b = 1; b < parts.size(); b++)
        for (std::size_t a = 0; a < b; a++)
            if (are_neighbours(parts[a], parts[b])) pairs.push_back({a, b, more_of(a, b)});
    std::vector<bool> removed(parts.size(), false);
    while (!pairs.empty()) {
        const auto least = std::min_element(pairs.begin(), pairs.end(),
                                            [](auto& x, auto& y) { return x.more < y.more; });
        if (total_volume_error(parts) + least->more > allowed) break;
        const auto [a, b, more] = *least;
        parts[a] = *merged(parts[a], parts[b]);
        parts[b] = {};
        removed[b] = true;
        std::erase_if(pairs,
                      [&](const Pair& p) { return p.a == a || p.b == a || p.a == b || p.b == b; });
        for (std::size_t k = 0; k < parts.size(); k++)
            if (k != a && !removed[k] && are_neighbours(parts[a], parts[k]))
                pairs.push_back({std::min(a, k), std::max(a, k), more_of(a, k)});
    }
    std::erase_if(parts, [](const Part& part) { return part.hull == nullptr; });
}

// Samples points on the faces of the hulls, limited to a bounded amount of work.
double furthest_outside(const ClosedMesh& mesh, const std::vector<Part>& parts) {
    std::size_t faces = 0;
    for (const Part& part : parts) faces += part.hull->faces.size();
    const double most = 4e7 / static_cast<double>(mesh.triangles.size());
    const int side =
        static_cast<int>(clamp(square_root(most / static_cast<double>(3 * faces + 1)), 1, 8));
    double max_distance = 0;
    const auto sample = [&](Vec3 p) {
        if (is_inside(mesh.triangles, p)) return;
        max_distance = maximum(max_distance, distance_to_surface(mesh.triangles, p));
    };
    for (const Part& part : parts)
        for (const HullFace& face : part.hull->faces) {
            const auto corners = part.hull->vertices_of(face);
            const auto at = [&](std::size_t k) { return part.hull->vertices[corners[k]]; };
            for (std::size_t k = 1; k + 1 < corners.size(); k++)
                for (int i = 0; i < side; i++)
                    for (int j = 0; j + i < side; j++) {
                        const double u = (i + 1.0 / 3) / side, v = (j + 1.0 / 3) / side;
                        sample(at(0) + (at(k) - at(0)) * u + (at(k + 1) - at(0)) * v);
                    }
        }
    return max_distance;
}

Status check(const Options& options) {
    const auto make_error = [](const char* what) {
        return Error{ErrorCode::invalid_argument, what};
    };
    if (options.hulls_max < 1 || options.hulls_max > 1024)
        return make_error("hulls_max must be from 1 to 1024");
    if (!(options.max_volume_error >= 0 && options.max_volume_error <= 10))
        return make_error("max_volume_error must be from 0 to 10");
    if (options.planes_per_axis < 1 || options.planes_per_axis > 127)
        return make_error("planes_per_axis must be from 1 to 127");
    return {};
}

}  // namespace

Result<Decomposition> decompose(std::span<const Vec3> vertices,
                                std::span<const std::uint32_t> indices, const Options& options) {
    if (Status s = check(options); !s.ok()) return s.error();
    const Result<ClosedMesh> mesh = make_closed_mesh(vertices, indices);
    if (!mesh.ok()) return mesh.error();
    auto complete = part_in(mesh->triangles, mesh->bounds);
    if (!complete) return Error{ErrorCode::invalid_argument, "the mesh encloses no volume"};
    std::vector<Part> parts;
    parts.push_back(std::move(*complete));
    const double allowed = options.max_volume_error * mesh->volume;
    // A smooth convex solid is one hull; cutting it would only create slivers.
    Part whole = parts.front();
    if (!whole.hull) add_reduced_hull(whole);
    if (whole.max_volume_error() <= allowed) {
        parts = {std::move(whole)};
    } else {
        cut(parts, options, allowed);
        for (Part& part : parts)
            if (!part.hull) add_reduced_hull(part);
    }
    if (std::any_of(parts.begin(), parts.end(), [](const Part& p) { return p.hull == nullptr; }))
        return Error{ErrorCode::resource_exhausted,
                     "a part has no valid convex hull; increase hulls_max"};
    merge_parts(parts, allowed);
    Decomposition found{.mesh_volume = mesh->volume,
                        .max_volume_error = total_volume_error(parts) / mesh->volume,
                        .max_distance = furthest_outside(*mesh, parts)};
    for (const Part& part : parts) found.parts.push_back(part.hull);
    return found;
}

}  // namespace jostle::modules::convex_decomposition
