// SPDX-License-Identifier: MIT
#include "jostle/client/subdivision.h"

#include <algorithm>
#include <map>
#include <utility>

namespace jostle::client {
namespace {

PointPosition weighted(double a, const PointPosition& p, double b, const PointPosition& q) {
    return {a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2]};
}
void add(PointPosition& to, double weight, const PointPosition& p) {
    for (std::size_t c = 0; c < 3; c++) to[c] += weight * p[c];
}

// A row of points at `offset`, each `stride` after the one before it.
struct Row {
    std::span<const PointPosition> points;
    std::size_t offset, stride, size;

    // Beyond the ends the row continues straight.
    PointPosition at(std::ptrdiff_t k) const {
        const auto last = static_cast<std::ptrdiff_t>(size) - 1;
        if (k < 0) return weighted(2, point(0), -1, point(std::min<std::ptrdiff_t>(1, last)));
        if (k > last)
            return weighted(2, point(last), -1, point(std::max<std::ptrdiff_t>(0, last - 1)));
        return point(k);
    }
    const PointPosition& point(std::ptrdiff_t k) const {
        return points[offset + static_cast<std::size_t>(k) * stride];
    }
    // On the spline from point k to the next one.
    PointPosition between(std::ptrdiff_t k, double t) const {
        const double t2 = t * t, t3 = t2 * t;
        PointPosition p{};
        add(p, 0.5 * (-t3 + 2 * t2 - t), at(k - 1));
        add(p, 0.5 * (3 * t3 - 5 * t2 + 2), at(k));
        add(p, 0.5 * (-3 * t3 + 4 * t2 + t), at(k + 1));
        add(p, 0.5 * (t3 - t2), at(k + 2));
        return p;
    }
};

void append_spline(std::vector<PointPosition>& to, const Row& row, std::size_t parts) {
    for (std::size_t k = 0; k + 1 < row.size; k++)
        for (std::size_t part = 0; part < parts; part++)
            to.push_back(row.between(static_cast<std::ptrdiff_t>(k),
                                     static_cast<double>(part) / static_cast<double>(parts)));
    if (row.size > 0) to.push_back(row.point(static_cast<std::ptrdiff_t>(row.size) - 1));
}

// An edge of a mesh: the points opposite of it, and the point in its middle.
struct MeshEdge {
    PointPosition opposite{};
    std::size_t triangles = 0;
    std::uint32_t middle = 0;
};
using Edges = std::map<std::pair<std::uint32_t, std::uint32_t>, MeshEdge>;

std::pair<std::uint32_t, std::uint32_t> edge_key(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
}

struct Neighbours {
    PointPosition sum{}, border_sum{};
    std::size_t count = 0, borders = 0;
};

PointPosition smoothed(const PointPosition& p, const Neighbours& near) {
    PointPosition made{};
    if (near.borders == 2) {
        add(made, 0.75, p);
        add(made, 0.125, near.border_sum);
        return made;
    }
    // A corner, or a point of several borders, stays.
    if (near.borders != 0 || near.count == 0) return p;
    const auto n = static_cast<double>(near.count);
    const double beta = near.count == 3 ? 3.0 / 16 : 3 / (8 * n);
    add(made, 1 - n * beta, p);
    add(made, beta, near.sum);
    return made;
}

}  // namespace

std::vector<PointPosition> subdivide_strand(std::span<const PointPosition> points,
                                            std::size_t parts) {
    std::vector<PointPosition> made;
    append_spline(made, {points, 0, 1, points.size()}, std::max<std::size_t>(1, parts));
    return made;
}

std::vector<PointPosition> subdivide_grid(std::span<const PointPosition> points,
                                          std::size_t columns, std::size_t parts) {
    if (columns == 0) return {};
    const std::size_t rows = points.size() / columns, pieces = std::max<std::size_t>(1, parts);
    if (rows == 0) return {};
    std::vector<PointPosition> wide;
    for (std::size_t row = 0; row < rows; row++)
        append_spline(wide, {points, row * columns, 1, columns}, pieces);
    const std::size_t wide_columns = wide.size() / rows, tall_rows = (rows - 1) * pieces + 1;
    std::vector<PointPosition> made(wide_columns * tall_rows), column;
    for (std::size_t k = 0; k < wide_columns; k++) {
        column.clear();
        append_spline(column, {wide, k, wide_columns, rows}, pieces);
        for (std::size_t row = 0; row < tall_rows; row++)
            made[row * wide_columns + k] = column[row];
    }
    return made;
}

TriangleMesh subdivide_mesh(const TriangleMesh& mesh) {
    const auto& [points, corners] = mesh;
    Edges edges;
    std::vector<std::uint32_t> kept;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
        const std::uint32_t* t = &corners[k];
        if (std::max({t[0], t[1], t[2]}) >= points.size()) continue;
        kept.insert(kept.end(), t, t + 3);
        for (std::size_t side = 0; side < 3; side++) {
            MeshEdge& edge = edges[edge_key(t[side], t[(side + 1) % 3])];
            add(edge.opposite, 1, points[t[(side + 2) % 3]]);
            edge.triangles++;
        }
    }
    TriangleMesh made;
    made.points.resize(points.size());
    std::vector<Neighbours> near(points.size());
    for (auto& [ends, edge] : edges) {
        const PointPosition &a = points[ends.first], &b = points[ends.second];
        const bool is_inner = edge.triangles == 2;
        PointPosition middle = weighted(is_inner ? 0.375 : 0.5, a, is_inner ? 0.375 : 0.5, b);
        if (is_inner) add(middle, 0.125, edge.opposite);
        edge.middle = static_cast<std::uint32_t>(made.points.size());
        made.points.push_back(middle);
        const std::pair<std::uint32_t, const PointPosition*> sides[] = {{ends.first, &b},
                                                                        {ends.second, &a}};
        for (const auto& [point, other] : sides) {
            add(near[point].sum, 1, *other);
            near[point].count++;
            if (is_inner) continue;
            add(near[point].border_sum, 1, *other);
            near[point].borders++;
        }
    }
    for (std::size_t k = 0; k < points.size(); k++) made.points[k] = smoothed(points[k], near[k]);
    for (std::size_t k = 0; k < kept.size(); k += 3) {
        const std::uint32_t a = kept[k], b = kept[k + 1], c = kept[k + 2];
        const std::uint32_t ab = edges[edge_key(a, b)].middle, bc = edges[edge_key(b, c)].middle,
                            ca = edges[edge_key(c, a)].middle;
        for (const std::uint32_t corner : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca})
            made.triangles.push_back(corner);
    }
    return made;
}

}  // namespace jostle::client
