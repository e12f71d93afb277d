// SPDX-License-Identifier: MIT
#include "bench/broadphase/kd_tree.h"

#include <algorithm>
#include <array>
#include <limits>

namespace jostle::bench {

using physics::Aabb;
using physics::maximum;
using physics::minimum;
using physics::Vec3;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
// boxes in a cell above which it is divided if that reduces the cost
constexpr std::size_t crowded_cell = 16;
constexpr int depth_max = 48;
constexpr int bins = 16;          // the planes between them are candidates
constexpr double plane_cost = 1;  // of passing a plane, in box tests

// Sides of a plane that the box overlaps; it may overlap both.
bool is_below(const Aabb& box, int axis, double plane) {
    return box.low[axis] < plane;
}
bool is_above(const Aabb& box, int axis, double plane) {
    return box.high[axis] >= plane;
}

bool contains(const Aabb& region, Vec3 p) {
    for (int k = 0; k < 3; k++)
        if (p[k] < region.low[k] || p[k] >= region.high[k]) return false;
    return true;
}

}  // namespace

std::int32_t KdTree::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    std::int32_t handle;
    if (free_.empty()) {
        handle = static_cast<std::int32_t>(entries_.size());
        entries_.emplace_back();
    } else {
        handle = free_.back();
        free_.pop_back();
    }
    entry(handle) = {box, item, category, handle};
    if (nodes_.empty())
        rebuild();
    else
        insert_into(0, entry(handle), 0);
    changes_++;
    return handle;
}

void KdTree::remove(std::int32_t handle) {
    remove_from(0, entry(handle).box, handle);
    entry(handle) = {};
    free_.push_back(handle);
    changes_++;
}

void KdTree::move(std::int32_t handle, const Aabb& box) {
    const Aabb old = entry(handle).box;
    entry(handle).box = box;
    replace(0, old, entry(handle), 0);
    changes_++;
}

void KdTree::flush() {
    if (changes_ > 2 * (entries_.size() - free_.size()) + 64) rebuild();
}

void KdTree::rebuild() {
    changes_ = 0;
    nodes_.assign(1, {.below = 0});
    if (cells_.empty()) cells_.emplace_back();
    // Cells reuse their memory in the next tree.
    for (Cell& c : cells_) c.entries.clear();
    spare_.clear();
    for (auto k = static_cast<std::int32_t>(cells_.size()); k-- > 1;) spare_.push_back(k);
    Cell& all = cell(0);
    all.split_threshold = crowded_cell;
    all.region = {{-endless, -endless, -endless}, {endless, endless, endless}};
    for (const Entry& e : entries_)
        if (e.handle >= 0) all.entries.push_back(e);
    if (all.entries.size() > crowded_cell) divide(0, 0);
}

std::int32_t KdTree::new_cell(const Aabb& region) {
    if (spare_.empty()) {
        spare_.push_back(static_cast<std::int32_t>(cells_.size()));
        cells_.emplace_back();
    }
    const std::int32_t made = spare_.back();
    spare_.pop_back();
    cell(made).region = region;
    cell(made).split_threshold = crowded_cell;
    return made;
}

// The plane between two bins with the lowest cost; none if testing all boxes costs less.
KdTree::Split KdTree::best_split(const Cell& c) const {
    Aabb bounds = c.entries[0].box;
    for (const Entry& e : c.entries) bounds = physics::unite(bounds, e.box);
    bounds = {physics::max(bounds.low, c.region.low), physics::min(bounds.high, c.region.high)};
    const double whole_area = physics::half_area(bounds);
    double best = static_cast<double>(c.entries.size());
    Split split;
    if (!(whole_area > 0)) return split;
    for (int axis = 0; axis < 3; axis++) {
        const double low = bounds.low[axis], size = bounds.high[axis] - low;
        if (!(size > 0)) continue;
        std::array<int, bins> begins{}, ends{};
        const auto bin = [&](double x) {
            return static_cast<std::size_t>(physics::clamp((x - low) * (bins / size), 0, bins - 1));
        };
        for (const Entry& e : c.entries) {
            begins[bin(e.box.low[axis])]++;
            ends[bin(e.box.high[axis])]++;
        }
        int below = 0, above = static_cast<int>(c.entries.size());
        for (int k = 1; k < bins; k++) {
            below += begins[static_cast<std::size_t>(k - 1)];
            above -= ends[static_cast<std::size_t>(k - 1)];
            const double plane = low + size * k / bins;
            Aabb left = bounds, right = bounds;
            left.high[axis] = right.low[axis] = plane;
            const double cost =
                plane_cost +
                (below * physics::half_area(left) + above * physics::half_area(right)) / whole_area;
            if (cost < best) {
                best = cost;
                split = {axis, plane};
            }
        }
    }
    return split;
}

void KdTree::divide(std::int32_t at, int depth) {
    const std::int32_t low = node(at).below;
    const Split split = depth < depth_max ? best_split(cell(low)) : Split{};
    if (split.axis < 0) {
        cell(low).split_threshold = 2 * cell(low).entries.size();
        return;
    }
    Aabb region = cell(low).region;
    region.low[split.axis] = split.plane;
    const std::int32_t high = new_cell(region);
    Cell &below = cell(low), &above = cell(high);
    below.region.high[split.axis] = split.plane;
    below.split_threshold = crowded_cell;
    for (const Entry& e : below.entries)
        if (is_above(e.box, split.axis, split.plane)) above.entries.push_back(e);
    std::erase_if(below.entries,
                  [&](const Entry& e) { return !is_below(e.box, split.axis, split.plane); });
    const auto pair = static_cast<std::int32_t>(nodes_.size());
    nodes_.push_back({.below = low});
    nodes_.push_back({.below = high});
    node(at) = {split.plane, split.axis, pair};
    for (const std::int32_t side : {pair, pair + 1})
        if (cell(node(side).below).entries.size() > crowded_cell) divide(side, depth + 1);
}

void KdTree::insert_into(std::int32_t at, const Entry& e, int depth) {
    const Node n = node(at);
    if (n.axis >= 0) {
        if (is_below(e.box, n.axis, n.plane)) insert_into(n.below, e, depth + 1);
        if (is_above(e.box, n.axis, n.plane)) insert_into(n.below + 1, e, depth + 1);
        return;
    }
    Cell& c = cell(n.below);
    c.entries.push_back(e);
    if (c.entries.size() > c.split_threshold) divide(at, depth);
}

void KdTree::remove_from(std::int32_t at, const Aabb& box, std::int32_t handle) {
    const Node n = node(at);
    if (n.axis >= 0) {
        if (is_below(box, n.axis, n.plane)) remove_from(n.below, box, handle);
        if (is_above(box, n.axis, n.plane)) remove_from(n.below + 1, box, handle);
        return;
    }
    std::vector<Entry>& entries = cell(n.below).entries;
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.handle == handle; });
    *found = entries.back();
    entries.pop_back();
}

// Descends into the nodes that the old or the new box overlaps. Nodes that both overlap keep the
// entry.
void KdTree::replace(std::int32_t at, const Aabb& old, const Entry& e, int depth) {
    const Node n = node(at);
    if (n.axis < 0) {
        for (Entry& stored : cell(n.below).entries)
            if (stored.handle == e.handle) stored.box = e.box;
        return;
    }
    const bool was[] = {is_below(old, n.axis, n.plane), is_above(old, n.axis, n.plane)};
    const bool is[] = {is_below(e.box, n.axis, n.plane), is_above(e.box, n.axis, n.plane)};
    for (int side = 0; side < 2; side++) {
        if (was[side] && is[side]) replace(n.below + side, old, e, depth + 1);
        if (was[side] && !is[side]) remove_from(n.below + side, old, e.handle);
        if (!was[side] && is[side]) insert_into(n.below + side, e, depth + 1);
    }
}

void KdTree::query(const Aabb& box, std::uint32_t mask, std::vector<std::uint32_t>& found) const {
    if (!nodes_.empty()) query_below(0, box, mask, found);
}

void KdTree::query_below(std::int32_t at, const Aabb& box, std::uint32_t mask,
                         std::vector<std::uint32_t>& found) const {
    const Node& n = node(at);
    if (n.axis >= 0) {
        if (is_below(box, n.axis, n.plane)) query_below(n.below, box, mask, found);
        if (is_above(box, n.axis, n.plane)) query_below(n.below + 1, box, mask, found);
        return;
    }
    const Cell& c = cell(n.below);
    for (const Entry& e : c.entries)
        if ((e.category & mask) != 0 && overlap(e.box, box) &&
            contains(c.region, physics::max(e.box.low, box.low)))
            found.push_back(e.item);
}

void KdTree::cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask, const RayVisit& visit) const {
    if (!nodes_.empty()) cast_below(0, {origin, motion, mask, &visit}, 0, 1, 1);
}

// Casts the part of the ray from `from` to `to`, the nearer side of a plane first. Returns the new
// limit.
double KdTree::cast_below(std::int32_t at, const Ray& ray, double from, double to,
                          double limit) const {
    if (from > limit) return limit;
    const Node& n = node(at);
    if (n.axis < 0) {
        for (const Entry& e : cell(n.below).entries)
            if ((e.category & ray.mask) != 0 &&
                physics::ray_enters(e.box, ray.origin, ray.motion, limit) <= limit)
                limit = (*ray.visit)(e.item, limit);
        return limit;
    }
    const double plane_offset = n.plane - ray.origin[n.axis], motion = ray.motion[n.axis];
    const std::int32_t near = plane_offset > 0 ? n.below : n.below + 1;
    const std::int32_t far = plane_offset > 0 ? n.below + 1 : n.below;
    // The ray moves away from the plane or parallel to it.
    if (motion == 0 || (motion > 0) != (plane_offset > 0))
        return cast_below(near, ray, from, to, limit);
    // The padding keeps boxes that lie where the ray crosses the plane, despite rounding.
    constexpr double pad = 1e-9;
    const double pass = plane_offset / motion;
    if (pass > to + pad) return cast_below(near, ray, from, to, limit);
    if (pass < from - pad) return cast_below(far, ray, from, to, limit);
    limit = cast_below(near, ray, from, minimum(to, pass + pad), limit);
    return cast_below(far, ray, maximum(from, pass - pad), to, limit);
}

std::unique_ptr<physics::BroadPhaseIndex> KdTree::clone() const {
    return std::make_unique<KdTree>(*this);
}

void KdTree::assign(const BroadPhaseIndex& other) {
    *this = static_cast<const KdTree&>(other);
}

// The parts of the non-empty cells that their boxes cover.
void KdTree::cells(std::vector<Aabb>& out) const {
    for (const Node& n : nodes_) {
        if (n.axis >= 0 || cell(n.below).entries.empty()) continue;
        const Cell& c = cell(n.below);
        Aabb bounds = c.entries[0].box;
        for (const Entry& e : c.entries) bounds = physics::unite(bounds, e.box);
        out.push_back(
            {physics::max(bounds.low, c.region.low), physics::min(bounds.high, c.region.high)});
    }
}

}  // namespace jostle::bench
