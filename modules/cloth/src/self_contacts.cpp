// SPDX-License-Identifier: MIT
#include "modules/cloth/src/self_contacts.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Of the distance between two primitives, the share that each may move before the next search. The
// rest is for rounding.
constexpr double share = 0.45;
// Primitives that are closer than this cross already, m.
constexpr double crossed = 1e-7;

Vec3 start_of(const SheetNode& n) {
    return {n.x, n.y, n.z};
}
Vec3 moved_of(const SheetNode& n) {
    return {n.moved_x, n.moved_y, n.moved_z};
}
Vec3 end_of(const SheetNode& n) {
    return start_of(n) + moved_of(n);
}

// Closest point of a triangle to p, as weights of its corners (Ericson, Real-Time Collision
// Detection, 5.1.5).
std::array<double, 3> closest_on_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const Vec3 bp = p - b;
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
        const double t = d1 / (d1 - d3);
        return {1 - t, t, 0};
    }
    const Vec3 cp = p - c;
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
        const double t = d2 / (d2 - d6);
        return {1 - t, 0, t};
    }
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const double sum = va + vb + vc;
    if (!(sum > 0)) return {1, 0, 0};
    return {va / sum, vb / sum, vc / sum};
}

// Closest points of two segments, as fractions from a0 and b0 (Ericson, 5.1.9).
std::array<double, 2> closest_on_segments(Vec3 a0, Vec3 a1, Vec3 b0, Vec3 b1) {
    const Vec3 d1 = a1 - a0, d2 = b1 - b0, r = a0 - b0;
    const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r);
    if (!(a > 0) || !(e > 0)) return {0, e > 0 ? clamp(f / e, 0, 1) : 0};
    const double b = dot(d1, d2), determinant = a * e - b * b;
    double s = determinant > 1e-12 * a * e ? clamp((b * f - c * e) / determinant, 0, 1) : 0;
    double t = (b * s + f) / e;
    if (t < 0) {
        t = 0;
        s = clamp(-c / a, 0, 1);
    } else if (t > 1) {
        t = 1;
        s = clamp((b - c) / a, 0, 1);
    }
    return {s, t};
}

// Cells of a uniform grid, sorted: the order of the pairs depends on indices only.
struct GridEntry {
    std::int64_t cell;
    std::uint32_t item;

    auto operator<=>(const GridEntry&) const = default;
};

class Grid {
public:
    explicit Grid(double size) : scale_(1 / size) {}

    template <class Use>
    void cells(Vec3 low, Vec3 high, Use&& use) const {
        const auto i = [&](double x) { return static_cast<std::int64_t>(std::floor(x * scale_)); };
        for (std::int64_t x = i(low.x); x <= i(high.x); x++)
            for (std::int64_t y = i(low.y); y <= i(high.y); y++)
                for (std::int64_t z = i(low.z); z <= i(high.z); z++)
                    use((x + 1000000) * 4000000000000 + (y + 1000000) * 2000000 + (z + 1000000));
    }
    void add(Vec3 low, Vec3 high, std::uint32_t item) {
        cells(low, high, [&](std::int64_t cell) { entries_.push_back({cell, item}); });
    }
    void sort() { std::sort(entries_.begin(), entries_.end()); }
    // Items of the cells of a box, sorted, each once.
    void find(Vec3 low, Vec3 high, std::vector<std::uint32_t>& found) const {
        found.clear();
        cells(low, high, [&](std::int64_t cell) {
            auto at = std::lower_bound(entries_.begin(), entries_.end(), GridEntry{cell, 0});
            for (; at != entries_.end() && at->cell == cell; ++at) found.push_back(at->item);
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
    }

private:
    double scale_;
    std::vector<GridEntry> entries_;
};

}  // namespace

void SelfContacts::find_edges(const Sheet& sheet) {
    mesh_edges_.clear();
    for (const auto& t : sheet.topology().triangles)
        for (std::size_t k = 0; k < 3; k++)
            mesh_edges_.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    std::sort(mesh_edges_.begin(), mesh_edges_.end());
    mesh_edges_.erase(std::unique(mesh_edges_.begin(), mesh_edges_.end()), mesh_edges_.end());
    triangle_count_ = sheet.topology().triangles.size();
}

void SelfContacts::search(const Sheet& sheet, double reach) {
    searches_++;
    if (mesh_edges_.empty() || triangle_count_ != sheet.topology().triangles.size())
        find_edges(sheet);
    const auto& triangles = sheet.topology().triangles;
    const auto nodes = sheet.nodes();
    start_.resize(sheet.size());
    for (std::size_t k = 0; k < sheet.size(); k++) start_[k] = start_of(nodes[k]);
    bounds_.assign(sheet.size(), static_cast<float>(share * reach));
    faces_.clear();
    edges_.clear();
    // Parts that cross already have no sides to stay on.
    const auto limit = [&](std::uint32_t v, double distance) {
        if (distance < crossed) return;
        bounds_[v] = std::min(bounds_[v], static_cast<float>(share * distance));
    };
    double longest = reach;
    for (const auto& [a, b] : mesh_edges_)
        longest = maximum(longest, length(start_[a] - start_[b]));
    const Vec3 more{reach, reach, reach};
    std::vector<std::uint32_t> found;

    Grid faces(longest);
    for (std::uint32_t f = 0; f < triangles.size(); f++) {
        const Vec3 a = start_[triangles[f][0]], b = start_[triangles[f][1]],
                   c = start_[triangles[f][2]];
        faces.add(min(a, min(b, c)), max(a, max(b, c)), f);
    }
    faces.sort();
    for (std::uint32_t v = 0; v < sheet.size(); v++) {
        const Vec3 p = start_[v];
        faces.find(p - more, p + more, found);
        for (const std::uint32_t f : found) {
            const auto& t = triangles[f];
            if (t[0] == v || t[1] == v || t[2] == v) continue;
            const Vec3 a = start_[t[0]], b = start_[t[1]], c = start_[t[2]];
            const Vec3 low = min(a, min(b, c)), high = max(a, max(b, c));
            if (p.x < low.x - reach || p.y < low.y - reach || p.z < low.z - reach ||
                p.x > high.x + reach || p.y > high.y + reach || p.z > high.z + reach)
                continue;
            const std::array<double, 3> w = closest_on_triangle(p, a, b, c);
            const double distance = length(p - (a * w[0] + b * w[1] + c * w[2]));
            if (distance > reach) continue;
            faces_.push_back({v, t});
            limit(v, distance);
            for (const std::uint32_t k : t) limit(k, distance);
        }
    }

    Grid edges(longest);
    for (std::uint32_t e = 0; e < mesh_edges_.size(); e++) {
        const Vec3 a = start_[mesh_edges_[e][0]], b = start_[mesh_edges_[e][1]];
        edges.add(min(a, b), max(a, b), e);
    }
    edges.sort();
    for (std::uint32_t e = 0; e < mesh_edges_.size(); e++) {
        const auto [a0, a1] = mesh_edges_[e];
        const Vec3 low = min(start_[a0], start_[a1]) - more,
                   high = max(start_[a0], start_[a1]) + more;
        edges.find(low, high, found);
        for (const std::uint32_t other : found) {
            if (other <= e) continue;
            const auto [b0, b1] = mesh_edges_[other];
            if (a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1) continue;
            const Vec3 p = start_[b0], q = start_[b1];
            const Vec3 l = min(p, q), u = max(p, q);
            if (u.x < low.x || u.y < low.y || u.z < low.z || l.x > high.x || l.y > high.y ||
                l.z > high.z)
                continue;
            const auto [s, t] = closest_on_segments(start_[a0], start_[a1], p, q);
            const double distance =
                length(start_[a0] + (start_[a1] - start_[a0]) * s - (p + (q - p) * t));
            if (distance > reach) continue;
            edges_.push_back({a0, a1, b0, b1});
            for (const std::uint32_t k : {a0, a1, b0, b1}) limit(k, distance);
        }
    }
    valid_ = true;
}

namespace {

// Pushes two points apart, weighted sums of up to four vertices: negative weights on one side.
void separate(Sheet& sheet, std::span<const std::uint32_t> vertices,
              std::span<const double> weights, double gap, double friction) {
    Vec3 apart, relative;
    double response = 0;
    for (std::size_t k = 0; k < vertices.size(); k++) {
        const SheetNode& n = sheet.nodes()[vertices[k]];
        apart += end_of(n) * weights[k];
        relative += moved_of(n) * weights[k];
        response += double{n.inverse_mass} * weights[k] * weights[k];
    }
    const double distance = length(apart);
    if (distance >= gap || !(distance > 1e-9) || !(response > 0)) return;
    const Vec3 n = apart * (1 / distance);
    const double push = (gap - distance) / response;
    Vec3 impulse = n * push;
    const Vec3 slip = relative - n * dot(n, relative);
    const double size = length(slip);
    if (size > 1e-12) impulse -= slip * (minimum(friction * push, size / response) / size);
    for (std::size_t k = 0; k < vertices.size(); k++)
        sheet.set_moved(vertices[k], sheet.moved(vertices[k]) +
                                         impulse * (weights[k] * sheet.inverse_mass(vertices[k])));
}

}  // namespace

void SelfContacts::push_apart(Sheet& sheet, double gap, double friction) {
    const auto at = [&](std::uint32_t k) { return end_of(sheet.nodes()[k]); };
    for (const VertexFace& pair : faces_) {
        const auto& [a, b, c] = pair.face;
        const std::array<double, 3> w = closest_on_triangle(at(pair.vertex), at(a), at(b), at(c));
        // Neighbours at rest are closer than the gap if the mesh is finer than it.
        const std::uint32_t vertices[] = {pair.vertex, a, b, c};
        const double weights[] = {1, -w[0], -w[1], -w[2]};
        const Vec3 rest = sheet.topology().rest[pair.vertex] -
                          (sheet.topology().rest[a] * w[0] + sheet.topology().rest[b] * w[1] +
                           sheet.topology().rest[c] * w[2]);
        separate(sheet, vertices, weights, minimum(gap, 0.8 * length(rest)), friction);
    }
    for (const EdgeEdge& pair : edges_) {
        const auto [s, t] = closest_on_segments(at(pair.a0), at(pair.a1), at(pair.b0), at(pair.b1));
        const std::uint32_t vertices[] = {pair.a0, pair.a1, pair.b0, pair.b1};
        const double weights[] = {1 - s, s, t - 1, -t};
        const auto& r = sheet.topology().rest;
        const Vec3 rest =
            r[pair.a0] * (1 - s) + r[pair.a1] * s - r[pair.b0] * (1 - t) - r[pair.b1] * t;
        separate(sheet, vertices, weights, minimum(gap, 0.8 * length(rest)), friction);
    }
}

// Returns whether a vertex reached its bound.
bool SelfContacts::bound(Sheet& sheet) {
    bool reached = false;
    for (std::uint32_t k = 0; k < sheet.size(); k++) {
        const SheetNode& n = sheet.nodes()[k];
        const Vec3 end = end_of(n), motion = end - start_[k];
        const double size = length(motion), most = double{bounds_[k]};
        if (size <= most) continue;
        reached = true;
        sheet.set_moved(k, start_[k] + motion * (most / size) - start_of(n));
    }
    return reached;
}

void SelfContacts::resolve(Sheet& sheet, double gap, double friction) {
    // A fast sheet gets a greater reach, so that it is rarely bounded by it.
    double most = 0;
    for (const SheetNode& n : sheet.nodes()) most = maximum(most, length_squared(moved_of(n)));
    const double reach = 2 * gap + 2 * square_root(most);
    if (!valid_) search(sheet, minimum(reach, 6 * gap));
    push_apart(sheet, gap, friction);
    // The next search starts from the bounded positions.
    if (bound(sheet)) valid_ = false;
}

}  // namespace jostle::modules::cloth_detail
