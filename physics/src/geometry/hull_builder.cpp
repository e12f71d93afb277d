// SPDX-License-Identifier: MIT
//
// Builds convex hulls: exact topology on a grid (hull_topology.h), then coplanar triangles are
// merged into faces and derived data is computed.
#include "physics/src/geometry/hull_builder.h"

#include <algorithm>
#include <map>

#include "jostle/base/check.h"
#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/hull_lanes.h"
#include "physics/src/geometry/hull_topology.h"

namespace jostle::physics {
namespace {

// Of the size: maximum distance of a vertex from the plane of its face.
constexpr double merge_fraction = 1e-6;

Error hull_error(std::string message) {
    return invalid_argument("hull: " + std::move(message));
}

Vec3 normal_of(std::span<const Vec3> points, const HullTriangle& t) {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

// Merges coplanar triangles into polygons.
class FaceMerger {
public:
    FaceMerger(std::span<const Vec3> points, std::vector<HullTriangle> triangles, double tolerance)
        : points_(points), triangles_(std::move(triangles)), tolerance_(tolerance) {}

    // Returns closed loops of points, counter-clockwise; nullopt if a region has no simple border.
    std::optional<std::vector<std::vector<std::uint32_t>>> run() {
        find_neighbours();
        region_.assign(triangles_.size(), no_index);
        ASSERT(across_.size() == triangles_.size());
        // Start with large triangles, whose planes are the most accurate.
        std::vector<std::uint32_t> order(triangles_.size());
        for (std::uint32_t i = 0; i < order.size(); i++) order[i] = i;
        std::vector<double> area;
        for (const HullTriangle& t : triangles_)
            area.push_back(length_squared(normal_of(points_, t)));
        std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
            return area[x] > area[y] || (area[x] == area[y] && x < y);
        });
        std::vector<std::vector<std::uint32_t>> loops;
        for (const std::uint32_t seed : order) {
            if (region_[seed] != no_index) continue;
            const auto loop = grow(seed);
            if (!loop) return std::nullopt;
            loops.push_back(*loop);
        }
        return loops;
    }

private:
    static constexpr std::uint32_t no_index = 0xffffffff;

    void find_neighbours() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner;
        for (std::uint32_t t = 0; t < triangles_.size(); t++)
            for (std::size_t e = 0; e < 3; e++)
                owner[{triangles_[t][e], triangles_[t][(e + 1) % 3]}] = t;
        across_.resize(triangles_.size());
        for (std::uint32_t t = 0; t < triangles_.size(); t++)
            for (std::size_t e = 0; e < 3; e++)
                across_[t][e] = owner.at({triangles_[t][(e + 1) % 3], triangles_[t][e]});
    }

    std::optional<std::vector<std::uint32_t>> grow(std::uint32_t seed) {
        const Vec3 normal = normalized(normal_of(points_, triangles_[seed]));
        const double offset = dot(normal, points_[triangles_[seed][0]]);
        ASSERT(region_[seed] == no_index);
        std::vector<std::uint32_t> members{seed};
        region_[seed] = seed;
        for (std::size_t k = 0; k < members.size(); k++)
            for (std::size_t e = 0; e < 3; e++) {
                const std::uint32_t other = across_[members[k]][e];
                if (region_[other] != no_index) continue;
                // The normal of a sliver is unreliable, so the positions of its corners decide.
                bool flat = dot(normal_of(points_, triangles_[other]), normal) > -1e-300;
                for (const std::uint32_t p : triangles_[other])
                    flat = flat && absolute(dot(normal, points_[p]) - offset) <= tolerance_;
                if (!flat) continue;
                region_[other] = seed;
                members.push_back(other);
            }
        // Border edges, chained.
        std::map<std::uint32_t, std::uint32_t> next;
        for (const std::uint32_t t : members)
            for (std::size_t e = 0; e < 3; e++)
                if (region_[across_[t][e]] != seed)
                    if (!next.emplace(triangles_[t][e], triangles_[t][(e + 1) % 3]).second)
                        return std::nullopt;
        std::vector<std::uint32_t> loop;
        ASSERT(!next.empty());
        std::uint32_t at = next.begin()->first;
        do {
            loop.push_back(at);
            const auto found = next.find(at);
            if (found == next.end() || loop.size() > next.size()) return std::nullopt;
            at = found->second;
        } while (at != loop.front());
        if (loop.size() != next.size()) return std::nullopt;
        return loop;
    }

    std::span<const Vec3> points_;
    std::vector<HullTriangle> triangles_;
    double tolerance_;
    std::vector<std::array<std::uint32_t, 3>> across_;
    std::vector<std::uint32_t> region_;
};

// Removes vertices of only two faces, which lie on an edge between corners.
void drop_edge_vertices(std::vector<std::vector<std::uint32_t>>& loops, std::size_t points) {
    std::vector<int> uses(points, 0);
    for (const auto& loop : loops)
        for (const std::uint32_t p : loop) uses[p]++;
    for (auto& loop : loops) std::erase_if(loop, [&](std::uint32_t p) { return uses[p] < 3; });
}

}  // namespace

std::uint64_t hash_of(const ConvexHull& hull) {
    Hasher hasher;
    hasher.add(hull.vertices.size());
    for (const Vec3 v : hull.vertices)
        for (int k = 0; k < 3; k++) hasher.add(bits_of(v[k]));
    hasher.add(hull.faces.size());
    for (const HullFace& face : hull.faces) {
        hasher.add(face.count);
        for (const std::uint16_t v : hull.vertices_of(face)) hasher.add(v);
    }
    return hasher.value;
}

Result<std::shared_ptr<const ConvexHull>> assemble_hull(
    std::vector<Vec3> vertices, const std::vector<std::vector<std::uint16_t>>& faces) {
    auto hull = std::make_shared<ConvexHull>();
    hull->vertices = std::move(vertices);
    const auto& v = hull->vertices;
    ASSERT(!v.empty() && v.size() <= max_hull_vertices);
    Vec3 middle;
    hull->bounds = {v[0], v[0]};
    for (const Vec3 p : v) {
        middle += p * (1.0 / static_cast<double>(v.size()));
        hull->bounds = unite(hull->bounds, {p, p});
    }
    for (const auto& loop : faces) {
        HullFace face{.first = static_cast<std::uint32_t>(hull->face_vertices.size()),
                      .count = static_cast<std::uint32_t>(loop.size())};
        // Newell's method: the mean normal of a polygon that is flat up to the tolerance.
        Vec3 sum;
        for (std::size_t k = 0; k < loop.size(); k++)
            sum += cross(v[loop[k]] - middle, v[loop[(k + 1) % loop.size()]] - middle);
        ASSERT(loop.size() >= 3);
        face.normal = sum / length(sum);
        // Saved worlds are untrusted: the length may be zero, overflow or be too small to divide
        // by.
        if (!(absolute(length_squared(face.normal) - 1) < 1e-6))
            return hull_error("a face has no area");
        face.offset = -1e300;
        for (const Vec3 p : v) face.offset = maximum(face.offset, dot(face.normal, p));
        hull->face_vertices.insert(hull->face_vertices.end(), loop.begin(), loop.end());
        hull->faces.push_back(face);
    }
    // Edges: each one occurs once in each direction.
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint16_t> face_of;
    for (std::size_t f = 0; f < faces.size(); f++)
        for (std::size_t k = 0; k < faces[f].size(); k++)
            if (!face_of
                     .emplace(std::pair(faces[f][k], faces[f][(k + 1) % faces[f].size()]),
                              static_cast<std::uint16_t>(f))
                     .second)
                return hull_error("an edge occurs twice in the same direction");
    for (const auto& [edge, left] : face_of) {
        const auto right = face_of.find({edge.second, edge.first});
        if (right == face_of.end()) return hull_error("its faces do not form a closed surface");
        if (edge.first < edge.second)
            hull->edges.push_back({edge.first, edge.second, left, right->second});
    }
    if (v.size() + hull->faces.size() != hull->edges.size() + 2)
        return hull_error("its faces do not form a single solid");

    if (hull->faces.size() < 4) return hull_error("it has no volume");
    const PolyhedronMass mass = polyhedron_mass(*hull);
    if (!(mass.volume > 0)) return hull_error("it has no volume");
    hull->volume = mass.volume;
    ASSERT(hull->edges.size() >= 6);
    hull->center = mass.center;
    hull->unit_inertia = mass.inertia;
    hull->inner_radius = 1e300;
    for (const HullFace& face : hull->faces)
        hull->inner_radius =
            minimum(hull->inner_radius, face.offset - dot(face.normal, hull->center));
    hull->content_hash = hash_of(*hull);
    hull->lanes = std::make_shared<const HullLanes>(lanes_of(*hull));
    return std::shared_ptr<const ConvexHull>(std::move(hull));
}

namespace {

// Selects the vertices that the loops use and renumbers the loops.
Result<std::shared_ptr<const ConvexHull>> hull_of_loops(
    const std::vector<Vec3>& retained, const std::vector<std::vector<std::uint32_t>>& loops) {
    std::vector<std::uint32_t> used;
    for (const auto& loop : loops) used.insert(used.end(), loop.begin(), loop.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    ASSERT(used.empty() || used.back() < retained.size());
    if (used.size() > max_hull_vertices)
        return hull_error("it has " + std::to_string(used.size()) + " vertices; at most " +
                          std::to_string(max_hull_vertices) + " are allowed: simplify the shape");
    std::vector<Vec3> vertices;
    for (const std::uint32_t p : used) vertices.push_back(retained[p]);
    std::vector<std::vector<std::uint16_t>> faces;
    for (const auto& loop : loops) {
        if (loop.size() > max_face_vertices)
            return hull_error("a face has " + std::to_string(loop.size()) + " corners; at most " +
                              std::to_string(max_face_vertices) +
                              " are allowed: simplify the shape");
        std::vector<std::uint16_t> face;
        for (const std::uint32_t p : loop)
            face.push_back(static_cast<std::uint16_t>(
                std::lower_bound(used.begin(), used.end(), p) - used.begin()));
        faces.push_back(face);
    }
    return assemble_hull(std::move(vertices), faces);
}

// Checks that every corner of a face lies in its plane.
bool is_flat_and_convex(const ConvexHull& hull, double size) {
    for (const HullFace& face : hull.faces)
        for (const std::uint16_t v : hull.vertices_of(face))
            if (face.offset - dot(face.normal, hull.vertices[v]) > 4 * merge_fraction * size)
                return false;
    return true;
}

}  // namespace

Result<std::shared_ptr<const ConvexHull>> build_hull(std::span<const Vec3> points) {
    if (points.size() < 4)
        return hull_error("it has " + std::to_string(points.size()) +
                          " points; it must have at least 4");
    if (points.size() > max_hull_points)
        return hull_error("it has " + std::to_string(points.size()) + " points; at most " +
                          std::to_string(max_hull_points) + " are allowed");
    Aabb box{points[0], points[0]};
    for (std::size_t i = 0; i < points.size(); i++) {
        const Vec3 reach = abs(points[i]);
        if (!is_finite(points[i]) || maximum(reach.x, maximum(reach.y, reach.z)) > max_shape_size)
            return hull_error("points[" + std::to_string(i) + "] is (" + text(points[i].x) + ", " +
                              text(points[i].y) + ", " + text(points[i].z) +
                              "); coordinates must be finite and within " + text(max_shape_size) +
                              " m");
        box = unite(box, {points[i], points[i]});
    }
    const Vec3 extent = box.high - box.low;
    const double size = maximum(extent.x, maximum(extent.y, extent.z));
    if (size < min_shape_size)
        return hull_error("its points lie within " + text(size) + " m; it must be at least " +
                          text(min_shape_size) + " m long");

    // Round to the grid, one point per grid position.
    const Vec3 center = (box.low + box.high) * 0.5;
    const double scale = 0x1p30 / size;
    std::map<GridPoint, std::uint32_t> positions;
    for (std::uint32_t i = 0; i < points.size(); i++) {
        const Vec3 p = (points[i] - center) * scale;
        const auto round = [](double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); };
        positions.emplace(GridPoint{round(p.x), round(p.y), round(p.z)}, i);
    }
    std::vector<GridPoint> grid;
    std::vector<Vec3> retained;
    for (const auto& [slot, index] : positions) {
        grid.push_back(slot);
        retained.push_back(points[index]);
    }
    const auto triangles = hull_triangles(grid);
    ASSERT(grid.size() == retained.size());
    if (!triangles) return hull_error("its points lie in one plane; it has no volume");
    auto loops = FaceMerger(retained, *triangles, merge_fraction * size).run();
    if (loops) drop_edge_vertices(*loops, retained.size());
    // If a region has no simple border or a face has too few corners, use the triangles instead.
    const auto broken = [](const auto& all) {
        return std::any_of(all.begin(), all.end(), [](const auto& l) { return l.size() < 3; });
    };
    if (loops && !broken(*loops)) {
        auto merged = hull_of_loops(retained, *loops);
        if (merged.ok() && is_flat_and_convex(**merged, size) &&
            (*merged)->inner_radius >= 1e-6 * size)
            return merged;
        // A hull that is too large is rejected; a bent face falls back to triangles.
        if (!merged.ok() && merged.error().message.find("simplify") != std::string::npos)
            return merged;
    }
    loops.emplace();
    for (const HullTriangle& t : *triangles) loops->push_back({t.begin(), t.end()});
    auto hull = hull_of_loops(retained, *loops);
    if (hull.ok() && ((*hull)->inner_radius < 1e-6 * size || !is_flat_and_convex(**hull, size)))
        return hull_error(
            "it is too thin, or its points are too close to collinear, to determine its "
            "faces; make it thicker or remove points");
    return hull;
}

}  // namespace jostle::physics
