// SPDX-License-Identifier: MIT
#include "modules/cloth/src/sheet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/instruction_set.h"
#include "jostle/physics/scalar.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

namespace {

// Waves across threads are stable if their angular frequency times the sub-step is below 1.41
// (sheet_kernel_body.h).
constexpr double transverse_limit = 1.38;
constexpr int parts_max = 64;
// The root follows if the sheet is farther from it than this, m.
constexpr double root_distance = 8;

// Groups items of four nodes so that no node occurs twice in a group of eight; pads with `none`.
std::vector<std::uint32_t> blocks_of_eight(std::span<const std::array<std::uint32_t, 4>> items,
                                           std::size_t nodes) {
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::vector<std::uint32_t>> colors;
    std::vector<std::uint64_t> taken(nodes);  // colours of each node
    for (std::uint32_t k = 0; k < items.size(); k++) {
        std::uint64_t used = 0;
        for (const std::uint32_t v : items[k]) used |= taken[v];
        std::size_t color = 0;
        while (color < 63 && (used >> color & 1) != 0) color++;
        for (const std::uint32_t v : items[k]) taken[v] |= std::uint64_t{1} << color;
        if (colors.size() <= color) colors.resize(color + 1);
        colors[color].push_back(k);
    }
    std::vector<std::uint32_t> order;
    for (std::size_t c = 0; c < colors.size(); c++) {
        // The last colour takes what found no other one, one item per block.
        const std::size_t per_block = c == 63 ? 1 : 8;
        for (std::size_t k = 0; k < colors[c].size(); k++) {
            order.push_back(colors[c][k]);
            if ((k + 1) % per_block == 0 || k + 1 == colors[c].size())
                while (order.size() % 8 != 0) order.push_back(none);
        }
    }
    return order;
}

}  // namespace

const SheetKernel& sheet_kernel() {
#if defined(JOSTLE_CLOTH_AVX2)
    const InstructionSet set = instruction_set();
    if (set == InstructionSet::avx2 || set == InstructionSet::avx512) return avx2_kernel;
#endif
    return baseline_kernel;
}

Sheet::Sheet(const ClothDef& def) : topology_(sheet_topology(def)) {
    is_grid_ = def.triangles.empty();
    shear_stiffness_ = def.shear_stiffness;
    bending_stiffness_ = def.bending_stiffness;
    nodes_.resize(size() + 1);
    velocities_.assign(4 * size(), 0);
    torn_.assign(topology_.edges.size(), 0);
    for (std::size_t k = 0; k < size(); k++) set_inverse_mass(k, free_inverse_mass(k));
    build_arrays();
    initial_ = initial_positions(def);
    set_root({std::floor(initial_[0].x + 0.5), std::floor(initial_[0].y + 0.5),
              std::floor(initial_[0].z + 0.5)});
    for (std::size_t k = 0; k < size(); k++) set_position(k, initial_[k]);
    rebase();
}

void Sheet::build_arrays() {
    build_chains();
    build_cells(shear_stiffness_);
    build_hinges(bending_stiffness_);
}

void Sheet::build_chains() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
    for (std::uint32_t e = 0; e < topology_.edges.size(); e++)
        edges[std::minmax(topology_.edges[e].a, topology_.edges[e].b)] = e;
    // Chains without torn edges.
    std::vector<std::vector<std::uint32_t>> pieces;
    for (const std::vector<std::uint32_t>& chain : topology_.chains) {
        std::vector<std::uint32_t> piece{chain[0]};
        for (std::size_t k = 1; k < chain.size(); k++) {
            if (torn_[edges.at(std::minmax(chain[k - 1], chain[k]))] != 0) {
                if (piece.size() > 1) pieces.push_back(piece);
                piece.clear();
            }
            piece.push_back(chain[k]);
        }
        if (piece.size() > 1) pieces.push_back(piece);
    }
    // Colours: chains of one colour share no vertex. Blocks take chains of similar length.
    std::vector<std::vector<std::uint32_t>> colors;
    std::vector<std::uint64_t> taken(size());
    for (std::uint32_t k = 0; k < pieces.size(); k++) {
        std::uint64_t used = 0;
        for (const std::uint32_t v : pieces[k]) used |= taken[v];
        std::size_t color = 0;
        while (color < 63 && (used >> color & 1) != 0) color++;
        for (const std::uint32_t v : pieces[k]) taken[v] |= std::uint64_t{1} << color;
        if (colors.size() <= color) colors.resize(color + 1);
        colors[color].push_back(k);
    }
    chains_.clear();
    chain_nodes_.clear();
    rest_lengths_.clear();
    stretch_compliance_.clear();
    edge_lane_.assign(topology_.edges.size(), 0);
    const auto padding = static_cast<std::uint32_t>(size());
    std::size_t longest = 0;
    const auto add_block = [&](std::span<const std::uint32_t> lanes) {
        std::size_t links = 0;
        for (const std::uint32_t k : lanes) links = std::max(links, pieces[k].size() - 1);
        longest = std::max(longest, links);
        ChainBlock block;
        block.first = static_cast<std::uint32_t>(rest_lengths_.size() / 8);
        block.first_node = static_cast<std::uint32_t>(chain_nodes_.size() / 8);
        block.links = static_cast<std::uint32_t>(links);
        chains_.push_back(block);
        for (std::size_t n = 0; n <= links; n++)
            for (std::size_t lane = 0; lane < 8; lane++) {
                const bool has = lane < lanes.size() && n < pieces[lanes[lane]].size();
                chain_nodes_.push_back(has ? pieces[lanes[lane]][n] : padding);
            }
        for (std::size_t n = 0; n < links; n++)
            for (std::size_t lane = 0; lane < 8; lane++) {
                if (lane >= lanes.size() || n + 1 >= pieces[lanes[lane]].size()) {
                    // Never pulls: the compliance exceeds every inverse mass.
                    rest_lengths_.push_back(0);
                    stretch_compliance_.push_back(1e30f);
                    continue;
                }
                const std::vector<std::uint32_t>& piece = pieces[lanes[lane]];
                const std::uint32_t e = edges.at(std::minmax(piece[n], piece[n + 1]));
                edge_lane_[e] = static_cast<std::uint32_t>(rest_lengths_.size());
                rest_lengths_.push_back(static_cast<float>(topology_.edges[e].rest_length));
                stretch_compliance_.push_back(static_cast<float>(1 / topology_.edges[e].stiffness));
            }
    };
    for (std::size_t c = 0; c < colors.size(); c++) {
        std::ranges::stable_sort(colors[c], [&](std::uint32_t i, std::uint32_t j) {
            return pieces[i].size() > pieces[j].size();
        });
        const std::size_t per_block = c == 63 ? 1 : 8;
        for (std::size_t k = 0; k < colors[c].size(); k += per_block)
            add_block(std::span(colors[c]).subspan(k, std::min(per_block, colors[c].size() - k)));
    }
    // Torn edges have a lane that nothing writes.
    rest_lengths_.insert(rest_lengths_.end(), 8, 0.0f);
    stretch_compliance_.insert(stretch_compliance_.end(), 8, 1e30f);
    for (std::size_t e = 0; e < torn_.size(); e++)
        if (torn_[e] != 0) edge_lane_[e] = static_cast<std::uint32_t>(rest_lengths_.size() - 1);
    tensions_.assign(rest_lengths_.size(), 0);
    scratch_.assign(72 * std::max<std::size_t>(longest, 1), 0);
}

void Sheet::build_cells(double shear_stiffness) {
    cell_nodes_.clear();
    cell_scale_u_.clear();
    cell_scale_v_.clear();
    cell_compliance_.clear();
    if (shear_stiffness == 0) return;
    std::vector<std::array<std::uint32_t, 4>> items;
    for (const SheetCell& cell : topology_.cells) items.push_back(cell.nodes);
    const std::vector<std::uint32_t> order = blocks_of_eight(items, size());
    for (std::size_t first = 0; first < order.size(); first += 8) {
        for (std::size_t n = 0; n < 4; n++)
            for (std::size_t lane = 0; lane < 8; lane++) {
                const std::uint32_t k = order[first + lane];
                cell_nodes_.push_back(k == 0xffffffff ? static_cast<std::uint32_t>(size())
                                                      : items[k][n]);
            }
        for (std::size_t lane = 0; lane < 8; lane++) {
            const std::uint32_t k = order[first + lane];
            double u = 1, v = 1;
            if (k != 0xffffffff) {
                u = length(topology_.rest[items[k][1]] - topology_.rest[items[k][0]]);
                v = length(topology_.rest[items[k][2]] - topology_.rest[items[k][0]]);
            }
            cell_scale_u_.push_back(static_cast<float>(0.5 / u));
            cell_scale_v_.push_back(static_cast<float>(0.5 / v));
            cell_compliance_.push_back(static_cast<float>(1 / (shear_stiffness * u * v)));
        }
    }
}

void Sheet::build_hinges(double bending_stiffness) {
    hinge_nodes_.clear();
    hinge_weights_.clear();
    hinge_compliance_.clear();
    if (bending_stiffness == 0) return;
    std::vector<std::array<std::uint32_t, 4>> items;
    for (const SheetHinge& hinge : topology_.hinges) items.push_back(hinge.nodes);
    const std::vector<std::uint32_t> order = blocks_of_eight(items, size());
    const std::vector<Vec3>& rest = topology_.rest;
    // The energy of a cylinder: with the factor 3 of Bergou et al., right triangles are 3 times and
    // equilateral ones 1.5 times too stiff.
    const double hinge_share = is_grid_ ? 1 : 2;
    for (std::size_t first = 0; first < order.size(); first += 8) {
        std::array<double, 4> weights[8];
        for (std::size_t lane = 0; lane < 8; lane++) {
            const std::uint32_t k = order[first + lane];
            weights[lane] = {0, 0, 0, 0};
            double compliance = 1;
            if (k != 0xffffffff) {
                const auto& n = items[k];
                const auto cotangent = [&](std::uint32_t at, std::uint32_t a, std::uint32_t b) {
                    const Vec3 u = rest[a] - rest[at], v = rest[b] - rest[at];
                    return dot(u, v) / length(cross(u, v));
                };
                const double a2 = cotangent(n[0], n[1], n[2]), a3 = cotangent(n[0], n[1], n[3]);
                const double b2 = cotangent(n[1], n[0], n[2]), b3 = cotangent(n[1], n[0], n[3]);
                weights[lane] = {b2 + b3, a2 + a3, -a2 - b2, -a3 - b3};
                const double area =
                    0.5 * (length(cross(rest[n[1]] - rest[n[0]], rest[n[2]] - rest[n[0]])) +
                           length(cross(rest[n[1]] - rest[n[0]], rest[n[3]] - rest[n[0]])));
                compliance = area / (hinge_share * bending_stiffness);
            }
            hinge_compliance_.push_back(static_cast<float>(compliance));
        }
        for (std::size_t n = 0; n < 4; n++)
            for (std::size_t lane = 0; lane < 8; lane++) {
                const std::uint32_t k = order[first + lane];
                hinge_nodes_.push_back(k == 0xffffffff ? static_cast<std::uint32_t>(size())
                                                       : items[k][n]);
                hinge_weights_.push_back(static_cast<float>(weights[lane][n]));
            }
    }
}

SheetArrays Sheet::arrays() {
    SheetArrays a;
    a.nodes = nodes_.data();
    a.chains = chains_.data();
    a.chain_count = chains_.size();
    a.chain_nodes = chain_nodes_.data();
    a.rest_lengths = rest_lengths_.data();
    a.stretch_compliance = stretch_compliance_.data();
    a.tensions = tensions_.data();
    a.scratch = scratch_.data();
    a.pressed = pressed_.empty() ? nullptr : pressed_.data();
    a.cell_count = cell_nodes_.size() / 32;
    a.cell_nodes = cell_nodes_.data();
    a.cell_scale_u = cell_scale_u_.data();
    a.cell_scale_v = cell_scale_v_.data();
    a.cell_compliance = cell_compliance_.data();
    a.hinge_count = hinge_nodes_.size() / 32;
    a.hinge_nodes = hinge_nodes_.data();
    a.hinge_weights = hinge_weights_.data();
    a.hinge_compliance = hinge_compliance_.data();
    return a;
}

Vec3 Sheet::position(std::size_t k) const {
    const SheetNode& n = nodes_[k];
    return root_ + Vec3{n.x, n.y, n.z};
}
Vec3 Sheet::velocity(std::size_t k) const {
    return {velocities_[4 * k], velocities_[4 * k + 1], velocities_[4 * k + 2]};
}
void Sheet::set_position(std::size_t k, Vec3 position) {
    const Vec3 p = position - root_;
    nodes_[k].x = static_cast<float>(p.x);
    nodes_[k].y = static_cast<float>(p.y);
    nodes_[k].z = static_cast<float>(p.z);
}
void Sheet::set_velocity(std::size_t k, Vec3 v) {
    velocities_[4 * k] = static_cast<float>(v.x);
    velocities_[4 * k + 1] = static_cast<float>(v.y);
    velocities_[4 * k + 2] = static_cast<float>(v.z);
}
Vec3 Sheet::moved(std::size_t k) const {
    return {nodes_[k].moved_x, nodes_[k].moved_y, nodes_[k].moved_z};
}
void Sheet::set_moved(std::size_t k, Vec3 moved) {
    nodes_[k].moved_x = static_cast<float>(moved.x);
    nodes_[k].moved_y = static_cast<float>(moved.y);
    nodes_[k].moved_z = static_cast<float>(moved.z);
}

void Sheet::rebase() {
    Vec3 sum;
    for (const SheetNode& n : nodes()) sum += Vec3{n.x, n.y, n.z};
    const Vec3 mean = sum * (1 / static_cast<double>(size()));
    if (length_squared(mean) < root_distance * root_distance) return;
    const Vec3 to = root_ + mean;
    const Vec3 next{std::floor(to.x + 0.5), std::floor(to.y + 0.5), std::floor(to.z + 0.5)};
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < size(); k++) points.push_back(position(k));
    set_root(next);
    for (std::size_t k = 0; k < size(); k++) set_position(k, points[k]);
}

namespace {

// Four lanes: x, y, z and one that is 0.
using Four = float __attribute__((vector_size(16)));

Four load_four(const float* from) {
    Four v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
void store_four(float* to, Four v) {
    __builtin_memcpy(to, &v, sizeof v);
}
Four four_of(Vec3 v) {
    return Four{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}
Four all_four(float x) {
    return Four{x, x, x, x};
}

}  // namespace

void Sheet::predict(double step, Vec3 acceleration) {
    const Four h = all_four(static_cast<float>(step)), g = four_of(acceleration * step * step);
    const Four h2 = h * h;
    const float* a = accelerations_.empty() ? nullptr : accelerations_.data();
    for (std::size_t k = 0; k < size(); k++) {
        Four moved = load_four(&velocities_[4 * k]) * h + g;
        if (a != nullptr) moved += load_four(a + 4 * k) * h2;
        store_four(&nodes_[k].moved_x, moved);
    }
    nodes_.back() = {};
}

void Sheet::solve_bends(double step, int substeps) {
    const SheetKernel& kernel = sheet_kernel();
    const SheetArrays a = arrays();
    // The impulse of several sub-steps is that many times the force.
    const auto longer = static_cast<float>(step * square_root(double{1} * substeps));
    if (a.hinge_count > 0 && substeps > 0) kernel.solve_hinges(a, longer);
    if (a.cell_count > 0) kernel.solve_cells(a, static_cast<float>(step));
}

void Sheet::solve_threads(double step) {
    ASSERT(pressed_.empty() || pressed_.size() == 4 * nodes_.size());
    transverse_rate_ = sheet_kernel().solve_chains(arrays(), static_cast<float>(step));
}

// The velocity changes by what the displacement differs from the prediction, so that a vertex
// without forces keeps its velocity to the last bit.
void Sheet::finish(double step, Vec3 acceleration, double damping) {
    const Four h = all_four(static_cast<float>(step)), h2 = h * h;
    const Four per_h = all_four(static_cast<float>(1 / step));
    const Four kept = all_four(static_cast<float>(1 / (1 + damping * step)));
    const Four gv = four_of(acceleration * step), gx = four_of(acceleration * step * step);
    const float* a = accelerations_.empty() ? nullptr : accelerations_.data();
    for (std::size_t k = 0; k < size(); k++) {
        SheetNode& n = nodes_[k];
        const Four v = load_four(&velocities_[4 * k]), moved = load_four(&n.moved_x);
        // The fourth lane of the position is the inverse mass, to which 0 is added.
        store_four(&n.x, load_four(&n.x) + moved);
        Four predicted = v * h + gx, change = gv;
        if (a != nullptr) {
            predicted += load_four(a + 4 * k) * h2;
            change += load_four(a + 4 * k) * h;
        }
        store_four(&velocities_[4 * k], (v + (change + (moved - predicted) * per_h)) * kept);
    }
}

int Sheet::stable_parts(double h, int least) const {
    const double needed = h * square_root(double{transverse_rate_}) / transverse_limit;
    int parts = least;
    while (parts < needed && parts < parts_max) parts++;
    return parts;
}

void Sheet::tear(std::span<const std::uint32_t> edges) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const std::uint32_t e : edges) {
        torn_[e] = 1;
        ends.push_back(std::minmax(topology_.edges[e].a, topology_.edges[e].b));
    }
    std::ranges::sort(ends);
    const auto is_gone = [&](const auto& nodes) {
        for (std::size_t i = 0; i < nodes.size(); i++)
            for (std::size_t j = i + 1; j < nodes.size(); j++) {
                const std::pair<std::uint32_t, std::uint32_t> edge =
                    std::minmax(nodes[i], nodes[j]);
                if (std::ranges::binary_search(ends, edge)) return true;
            }
        return false;
    };
    std::erase_if(topology_.triangles, is_gone);
    std::erase_if(topology_.cells, [&](const SheetCell& cell) { return is_gone(cell.nodes); });
    std::erase_if(topology_.hinges, [&](const SheetHinge& hinge) { return is_gone(hinge.nodes); });
    build_arrays();
}

}  // namespace jostle::modules::cloth_detail
