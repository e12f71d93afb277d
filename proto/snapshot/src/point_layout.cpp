// SPDX-License-Identifier: MIT
#include "jostle/snapshot/point_layout.h"

#include <algorithm>
#include <string>
#include <utility>

namespace jostle::snapshot {
namespace {

Error bad_layout(const std::string& what) {
    return {ErrorCode::corrupt_data, "point object: " + what};
}

std::string at_most(std::size_t size, const char* noun, std::size_t most) {
    return std::to_string(size) + " " + noun + "; must be at most " + std::to_string(most);
}

Status check_strands(const PointLayout& layout) {
    std::uint64_t sum = 0;
    for (const std::uint32_t size : layout.strands) {
        if (size == 0) return bad_layout("empty strand");
        sum += size;
    }
    if (sum != layout.points)
        return bad_layout("strands have " + std::to_string(sum) + " points; the object has " +
                          std::to_string(layout.points));
    return {};
}

Status check_triangles(const PointLayout& layout) {
    if (layout.triangles.size() > 3 * point_triangles_max)
        return bad_layout(at_most(layout.triangles.size() / 3, "triangles", point_triangles_max));
    if (layout.triangles.size() % 3 != 0) return bad_layout("incomplete triangle");
    for (const std::uint32_t corner : layout.triangles)
        if (corner >= layout.points)
            return bad_layout("triangle corner " + std::to_string(corner) +
                              " is not below the number of points, " +
                              std::to_string(layout.points));
    return {};
}

// The positions 0 to size - 1 of a row that belong to level `level` and those before it: every
// stride-th one, and the last.
std::uint32_t stride_of(std::size_t level) {
    return 1u << (point_levels - 1 - level);
}

bool belongs(std::uint32_t at, std::uint32_t size, std::uint32_t stride) {
    return at % stride == 0 || at == size - 1;
}

// The sources of position `at`, which is an odd multiple of `stride` and not the last position: its
// neighbours at that distance. Four regular neighbours form the interpolating cubic (Deslauriers
// and Dubuc, "Symmetric iterative interpolation processes", 1989); before an irregular end the
// two nearest ones are weighted by distance. `index`: from positions to points.
template <class Index>
void add_neighbours(PointPredictor& to, std::uint32_t at, std::uint32_t size, std::uint32_t stride,
                    const Index& index) {
    const std::uint32_t last = size - 1, before = at - stride;
    if (at + stride > last) {
        const auto right =
            static_cast<std::int32_t>((32 * stride + (last - before)) / (2 * (last - before)));
        to.add(index(before), 16 - right);
        to.add(index(last), right);
        return;
    }
    const bool is_cubic = at >= 3 * stride && at + 3 * stride <= last;
    to.add(index(before), is_cubic ? 9 : 8);
    to.add(index(at + stride), is_cubic ? 9 : 8);
    if (!is_cubic) return;
    to.add(index(at - 3 * stride), -1);
    to.add(index(at + 3 * stride), -1);
}

// Vertices of a mesh, or of a coarser version of it, and the vertices next to each.
class VertexGraph {
public:
    // Edges are pairs of vertices below `vertices`, in any order, with repetitions.
    VertexGraph(std::size_t vertices, std::vector<std::pair<std::uint32_t, std::uint32_t>> edges)
        : begin_(vertices + 1) {
        std::ranges::sort(edges);
        edges.erase(std::ranges::unique(edges).begin(), edges.end());
        for (const auto& [from, to] : edges) begin_[from + 1]++;
        for (std::size_t k = 0; k < vertices; k++) begin_[k + 1] += begin_[k];
        to_.reserve(edges.size());
        for (const auto& [from, to] : edges) to_.push_back(to);
    }
    // In ascending order.
    std::span<const std::uint32_t> next_to(std::uint32_t vertex) const {
        return std::span(to_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
    }

private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> to_;
};

VertexGraph graph_of(const PointLayout& layout) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(2 * layout.triangles.size());
    for (std::size_t k = 0; k + 2 < layout.triangles.size(); k += 3)
        for (std::size_t side = 0; side < 3; side++) {
            const std::uint32_t a = layout.triangles[k + side],
                                b = layout.triangles[k + (side + 1) % 3];
            if (a == b) continue;
            edges.emplace_back(a, b);
            edges.emplace_back(b, a);
        }
    return {layout.points, std::move(edges)};
}

// Limits the edges of a coarser graph, whose number could otherwise grow with the square of the
// number of neighbours.
constexpr std::size_t coarse_neighbours_max = 12;

// One step of coarsening. The coarse vertices are a maximal independent set: each fine vertex has
// at least one coarse neighbour.
struct Coarsening {
    std::vector<std::uint32_t> coarse, fine;
    std::vector<bool> is_coarse;  // by vertex
};

Coarsening coarsen(const VertexGraph& graph, const std::vector<std::uint32_t>& vertices,
                   std::size_t all) {
    Coarsening made{.coarse = {}, .fine = {}, .is_coarse = std::vector<bool>(all)};
    for (const std::uint32_t vertex : vertices) {
        const auto near = graph.next_to(vertex);
        const bool covered =
            std::ranges::any_of(near, [&](std::uint32_t n) { return made.is_coarse[n]; });
        (covered ? made.fine : made.coarse).push_back(vertex);
        if (!covered) made.is_coarse[vertex] = true;
    }
    return made;
}

// Connects coarse vertices that have a fine neighbour in common.
VertexGraph coarse_graph(const VertexGraph& graph, const Coarsening& step, std::size_t all) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<std::uint32_t> near;
    for (const std::uint32_t vertex : step.fine) {
        near.clear();
        for (const std::uint32_t n : graph.next_to(vertex))
            if (step.is_coarse[n] && near.size() < coarse_neighbours_max) near.push_back(n);
        for (const std::uint32_t a : near)
            for (const std::uint32_t b : near)
                if (a != b) edges.emplace_back(a, b);
    }
    return {all, std::move(edges)};
}

PointPredictor mean_of(std::uint32_t vertex, std::span<const std::uint32_t> near,
                       const std::vector<bool>& is_coarse) {
    PointPredictor made{.point = vertex};
    for (const std::uint32_t n : near)
        if (is_coarse[n] && made.sources < PointPredictor::sources_max) made.add(n, 0);
    const auto count = static_cast<std::int32_t>(made.sources);
    for (std::uint32_t k = 0; k < made.sources; k++)
        made.weight[k] = 16 / count + (k == 0 ? 16 % count : 0);
    return made;
}

}  // namespace

Status check_layout(const PointLayout& layout) {
    const PointForm form = layout.form;
    if (form < PointForm::loose || form > PointForm::heights)
        return bad_layout("unknown form " + std::to_string(static_cast<int>(form)));
    if (layout.points > points_max) return bad_layout(at_most(layout.points, "points", points_max));
    if ((form == PointForm::loose) != (layout.points == 0))
        return bad_layout(form == PointForm::loose ? "loose points with a fixed number"
                                                   : "no points");
    const bool has_columns = form == PointForm::grid || form == PointForm::heights;
    if (has_columns && (layout.columns == 0 || layout.points % layout.columns != 0))
        return bad_layout(std::to_string(layout.columns) + " columns do not divide " +
                          std::to_string(layout.points) + " points");
    if ((!has_columns && layout.columns != 0) ||
        (form != PointForm::strands && !layout.strands.empty()) ||
        (form != PointForm::triangles && !layout.triangles.empty()))
        return bad_layout("fields of another form");
    if (form == PointForm::strands) return check_strands(layout);
    if (form == PointForm::triangles) return check_triangles(layout);
    return {};
}

PointOrder::PointOrder(const PointLayout& layout) {
    points_.reserve(layout.points);
    if (layout.form == PointForm::triangles) {
        add_triangles(layout);
        return;
    }
    for (std::size_t level = 0; level < point_levels; level++) {
        if (layout.form == PointForm::strands) add_strands(layout, level);
        if (layout.columns != 0) add_grid(layout, level);
        begin_[level + 1] = points_.size();
    }
}

void PointOrder::add_strands(const PointLayout& layout, std::size_t level) {
    const std::uint32_t stride = stride_of(level);
    std::uint32_t first = 0;
    for (const std::uint32_t size : layout.strands) {
        const auto index = [first](std::uint32_t at) { return first + at; };
        std::uint32_t previous = first == 0 ? 0 : first - 1;  // the end of the previous strand
        for (std::uint32_t at = 0; at < size; at++) {
            if (!belongs(at, size, stride) || (level > 0 && belongs(at, size, 2 * stride)))
                continue;
            PointPredictor made{.point = index(at)};
            if (level > 0)
                add_neighbours(made, at, size, stride, index);
            else if (made.point != 0)
                made.add(previous, 16);
            previous = made.point;
            points_.push_back(made);
        }
        first += size;
    }
}

void PointOrder::add_grid(const PointLayout& layout, std::size_t level) {
    const std::uint32_t stride = stride_of(level), columns = layout.columns,
                        rows = layout.points / columns;
    const auto add_row = [&](std::uint32_t row, bool is_new_row) {
        for (std::uint32_t column = 0; column < columns; column++) {
            if (!belongs(column, columns, stride)) continue;
            PointPredictor made{.point = row * columns + column};
            if (level == 0) {
                const std::uint32_t back = column % stride == 0 ? stride : column % stride;
                const std::uint32_t up = row % stride == 0 ? stride : row % stride;
                if (column > 0)
                    made.add(made.point - back, 16);
                else if (row > 0)
                    made.add(made.point - up * columns, 16);
            } else if (is_new_row) {
                add_neighbours(made, row, rows, stride,
                               [&](std::uint32_t at) { return at * columns + column; });
            } else {
                if (belongs(column, columns, 2 * stride)) continue;
                add_neighbours(made, column, columns, stride,
                               [&](std::uint32_t at) { return row * columns + at; });
            }
            points_.push_back(made);
        }
    };
    // First the new columns of the old rows, from which the new rows are predicted.
    const std::uint32_t coarse = level == 0 ? stride : 2 * stride;
    for (std::uint32_t row = 0; row < rows; row++)
        if (belongs(row, rows, coarse)) add_row(row, false);
    for (std::uint32_t row = 0; level > 0 && row < rows; row++)
        if (belongs(row, rows, stride) && !belongs(row, rows, coarse)) add_row(row, true);
}

void PointOrder::add_triangles(const PointLayout& layout) {
    const std::size_t all = layout.points;
    VertexGraph graph = graph_of(layout);
    std::vector<std::uint32_t> vertices(all);
    for (std::size_t k = 0; k < all; k++) vertices[k] = static_cast<std::uint32_t>(k);
    std::array<std::vector<PointPredictor>, point_levels> levels;
    for (std::size_t level = point_levels - 1; level > 0; level--) {
        Coarsening step = coarsen(graph, vertices, all);
        for (const std::uint32_t vertex : step.fine)
            levels[level].push_back(mean_of(vertex, graph.next_to(vertex), step.is_coarse));
        graph = coarse_graph(graph, step, all);
        vertices = std::move(step.coarse);
    }
    std::vector<bool> coded(all);
    for (const std::uint32_t vertex : vertices) {
        PointPredictor made{.point = vertex};
        const auto near = graph.next_to(vertex);
        const auto source = std::ranges::find_if(near, [&](std::uint32_t n) { return coded[n]; });
        if (source != near.end())
            made.add(*source, 16);
        else if (!levels[0].empty())
            made.add(levels[0].back().point, 16);
        coded[vertex] = true;
        levels[0].push_back(made);
    }
    for (std::size_t level = 0; level < point_levels; level++) {
        points_.insert(points_.end(), levels[level].begin(), levels[level].end());
        begin_[level + 1] = points_.size();
    }
}

}  // namespace jostle::snapshot
