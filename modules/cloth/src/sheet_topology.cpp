// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/sheet.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

using Triangle = std::array<std::uint32_t, 3>;

double area_of(const std::vector<Vec3>& points, const Triangle& t) {
    return 0.5 * length(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
}

void add_masses(SheetTopology& sheet, double mass_per_area) {
    sheet.masses.assign(sheet.rest.size(), 0);
    for (const Triangle& t : sheet.triangles) {
        const double share = mass_per_area * area_of(sheet.rest, t) / 3;
        for (const std::uint32_t v : t) sheet.masses[v] += share;
    }
}

struct EdgeFaces {
    std::uint32_t opposite[2] = {0, 0};
    int count = 0;
    double area = 0;
};
using EdgeMap = std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeFaces>;

EdgeMap edges_of(const SheetTopology& sheet) {
    EdgeMap edges;
    for (const Triangle& t : sheet.triangles)
        for (std::size_t k = 0; k < 3; k++) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            EdgeFaces& edge = edges[{std::min(a, b), std::max(a, b)}];
            ASSERT(edge.count < 2);
            edge.opposite[edge.count++] = t[(k + 2) % 3];
            edge.area += area_of(sheet.rest, t);
        }
    return edges;
}

void add_hinges(SheetTopology& sheet, const EdgeMap& edges) {
    for (const auto& [ends, faces] : edges)
        if (faces.count == 2)
            sheet.hinges.push_back(
                {{ends.first, ends.second, faces.opposite[0], faces.opposite[1]}});
}

// ---- grids ----

void add_grid(SheetTopology& sheet, const ClothDef& def) {
    const ClothGrid& grid = def.grid;
    const std::uint32_t rows = grid.rows, columns = grid.columns;
    const double width = grid.width > 0 ? grid.width : length(grid.across);
    const double height = grid.height > 0 ? grid.height : length(grid.down);
    const double du = width / (columns - 1), dv = height / (rows - 1);
    const auto id = [&](std::uint32_t r, std::uint32_t c) { return r * columns + c; };
    for (std::uint32_t r = 0; r < rows; r++)
        for (std::uint32_t c = 0; c < columns; c++) sheet.rest.push_back({c * du, -(r * dv), 0});
    // Alternating diagonals have no preferred direction.
    for (std::uint32_t r = 0; r + 1 < rows; r++)
        for (std::uint32_t c = 0; c + 1 < columns; c++) {
            const std::uint32_t a = id(r, c), b = id(r, c + 1), d = id(r + 1, c),
                                e = id(r + 1, c + 1);
            if ((r + c) % 2 == 0) {
                sheet.triangles.push_back({a, d, b});
                sheet.triangles.push_back({b, d, e});
            } else {
                sheet.triangles.push_back({a, d, e});
                sheet.triangles.push_back({a, e, b});
            }
            sheet.cells.push_back({{a, b, d, e}});
        }
    sheet.masses.resize(sheet.rest.size());
    const auto share = [](std::uint32_t k, std::uint32_t count) {
        return k == 0 || k + 1 == count ? 0.5 : 1.0;
    };
    for (std::uint32_t r = 0; r < rows; r++)
        for (std::uint32_t c = 0; c < columns; c++)
            sheet.masses[id(r, c)] =
                def.mass_per_area * du * dv * share(r, rows) * share(c, columns);
    const auto add_thread = [&](std::uint32_t a, std::uint32_t b, double length, double strip) {
        sheet.edges.push_back({a, b, length, def.stretch_stiffness * strip / length, strip});
    };
    for (std::uint32_t r = 0; r < rows; r++) {
        std::vector<std::uint32_t>& chain = sheet.chains.emplace_back();
        for (std::uint32_t c = 0; c < columns; c++) {
            chain.push_back(id(r, c));
            if (c > 0) add_thread(id(r, c - 1), id(r, c), du, dv * share(r, rows));
        }
    }
    for (std::uint32_t c = 0; c < columns; c++) {
        std::vector<std::uint32_t>& chain = sheet.chains.emplace_back();
        for (std::uint32_t r = 0; r < rows; r++) {
            chain.push_back(id(r, c));
            if (r > 0) add_thread(id(r - 1, c), id(r, c), dv, du * share(c, columns));
        }
    }
}

// ---- meshes ----

// Pairs the edges at each vertex that continue each other best, within 45 degrees.
std::vector<std::array<std::uint32_t, 2>> continuations(const SheetTopology& sheet) {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::vector<std::uint32_t>> at(sheet.rest.size());
    for (std::uint32_t e = 0; e < sheet.edges.size(); e++) {
        at[sheet.edges[e].a].push_back(e);
        at[sheet.edges[e].b].push_back(e);
    }
    std::vector<std::array<std::uint32_t, 2>> next(sheet.edges.size(), {none, none});
    for (std::uint32_t v = 0; v < at.size(); v++) {
        const auto direction = [&](std::uint32_t e) {
            const std::uint32_t other = sheet.edges[e].a == v ? sheet.edges[e].b : sheet.edges[e].a;
            return normalized(sheet.rest[other] - sheet.rest[v]);
        };
        std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> pairs;
        for (std::size_t i = 0; i < at[v].size(); i++)
            for (std::size_t j = i + 1; j < at[v].size(); j++)
                if (const double bend = dot(direction(at[v][i]), direction(at[v][j])); bend < -0.7)
                    pairs.emplace_back(bend, at[v][i], at[v][j]);
        std::ranges::sort(pairs);
        const auto end = [&](std::uint32_t e) -> std::uint32_t& {
            return next[e][sheet.edges[e].a == v ? 0 : 1];
        };
        for (const auto& [bend, i, j] : pairs)
            if (end(i) == none && end(j) == none) {
                end(i) = j;
                end(j) = i;
            }
    }
    return next;
}

// Covers the edges with chains that visit each vertex at most once.
void add_chains(SheetTopology& sheet) {
    constexpr std::uint32_t none = 0xffffffff;
    const std::vector<std::array<std::uint32_t, 2>> next = continuations(sheet);
    std::vector<bool> used(sheet.edges.size());
    std::vector<std::uint32_t> visited(sheet.rest.size(), none);
    const auto other_end = [&](std::uint32_t e, std::uint32_t v) {
        return sheet.edges[e].a == v ? sheet.edges[e].b : sheet.edges[e].a;
    };
    // From the vertex along the edge until the chain ends.
    const auto follow = [&](std::uint32_t e, std::uint32_t v) {
        const auto id = static_cast<std::uint32_t>(sheet.chains.size());
        std::vector<std::uint32_t> chain{v};
        visited[v] = id;
        while (e != none && !used[e]) {
            const std::uint32_t to = other_end(e, v);
            if (visited[to] == id) break;
            used[e] = true;
            chain.push_back(to);
            visited[to] = id;
            v = to;
            e = next[e][sheet.edges[e].a == v ? 0 : 1];
        }
        sheet.chains.push_back(std::move(chain));
    };
    for (std::uint32_t e = 0; e < sheet.edges.size(); e++) {
        if (used[e]) continue;
        // Starts at an end of the chain, or anywhere of a ring.
        std::uint32_t at = e, from = sheet.edges[e].a;
        for (std::size_t n = 0; n < sheet.edges.size(); n++) {
            const std::uint32_t before = next[at][sheet.edges[at].a == from ? 0 : 1];
            if (before == none || used[before] || before == e) break;
            from = other_end(before, from);
            at = before;
        }
        follow(at, from);
        if (!used[e]) follow(e, sheet.edges[e].a);
    }
}

// Springs along the edges of an isotropic sheet (Van Gelder, Approximate simulation of elastic
// membranes by triangulated spring meshes, 1998).
void add_mesh(SheetTopology& sheet, const ClothDef& def) {
    sheet.rest = def.vertices;
    for (std::size_t k = 0; k + 2 < def.triangles.size(); k += 3)
        sheet.triangles.push_back({def.triangles[k], def.triangles[k + 1], def.triangles[k + 2]});
    add_masses(sheet, def.mass_per_area);
    for (const auto& [ends, faces] : edges_of(sheet)) {
        const double size = length(sheet.rest[ends.second] - sheet.rest[ends.first]);
        const double strip = faces.area / size;
        sheet.edges.push_back(
            {ends.first, ends.second, size, def.stretch_stiffness * strip / size, strip});
    }
    add_chains(sheet);
}

}  // namespace

std::vector<Vec3> initial_positions(const ClothDef& def) {
    if (!def.triangles.empty()) return def.vertices;
    std::vector<Vec3> points;
    const ClothGrid& grid = def.grid;
    for (std::uint32_t r = 0; r < grid.rows; r++)
        for (std::uint32_t c = 0; c < grid.columns; c++)
            points.push_back(grid.origin + grid.across * (double{1} * c / (grid.columns - 1)) +
                             grid.down * (double{1} * r / (grid.rows - 1)));
    return points;
}

SheetTopology sheet_topology(const ClothDef& def) {
    SheetTopology sheet;
    if (def.triangles.empty())
        add_grid(sheet, def);
    else
        add_mesh(sheet, def);
    if (def.bending_stiffness > 0) add_hinges(sheet, edges_of(sheet));
    return sheet;
}

}  // namespace jostle::modules::cloth_detail
