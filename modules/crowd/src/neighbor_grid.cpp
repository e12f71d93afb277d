// SPDX-License-Identifier: MIT
#include "modules/crowd/src/neighbor_grid.h"

#include <algorithm>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr double cells_per_reach = 4;

std::uint32_t hash_of(std::int32_t row, std::int32_t layer) {
    const std::uint32_t mixed = static_cast<std::uint32_t>(row) * 0x9e3779b1u +
                                static_cast<std::uint32_t>(layer) * 0x85ebca77u;
    return mixed ^ (mixed >> 15);
}

}  // namespace

struct NeighborGrid::Query {
    const Entry& self;
    std::size_t most;
    double bound;  // m^2; a larger gap does not count
    NearPoints& found;

    void add(NearPoint point) {
        auto& list = found.points;
        if (found.count == most && !(point < list[most - 1])) return;
        std::size_t at = found.count < most ? found.count++ : most - 1;
        for (; at > 0 && point < list[at - 1]; at--) list[at] = list[at - 1];
        list[at] = point;
        if (found.count == most) bound = minimum(bound, list[most - 1].gap);
    }
};

std::int32_t NeighborGrid::cell_of(double x) const {
    const double cell = clamp(x * cells_per_meter_, -1e9, 1e9);
    const auto whole = static_cast<std::int32_t>(cell);
    return whole - (cell < whole ? 1 : 0);
}

void NeighborGrid::build(std::span<const Vec3> points, std::span<const double> radii,
                         std::span<const std::uint8_t> active, double reach, bool flat) {
    reach_ = reach;
    flat_ = flat;
    cells_per_meter_ = cells_per_reach / reach;
    std::uint32_t buckets = 64;
    while (buckets < 2 * points.size()) buckets *= 2;
    mask_ = buckets - 1;
    starts_.assign(buckets + 1, 0);
    buckets_.resize(points.size());
    places_.resize(points.size());
    entries_.resize(points.size());
    const auto [smallest, largest] = std::ranges::minmax(radii);
    smallest_radius_ = smallest, largest_radius_ = largest;
    const auto layer_of = [&](Vec3 p) { return flat ? 0 : cell_of(p.z); };
    for (std::size_t k = 0; k < points.size(); k++) {
        if (!active[k]) continue;
        const Vec3 p = points[k];
        buckets_[k] =
            (hash_of(cell_of(p.y), layer_of(p)) + static_cast<std::uint32_t>(cell_of(p.x))) & mask_;
        starts_[buckets_[k]]++;
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts_) {
        sum += start;
        start = sum;
    }
    // Backwards, so that the entries of a bucket are in order of their index.
    for (std::size_t k = points.size(); k-- > 0;) {
        if (!active[k]) continue;
        const std::uint32_t place = --starts_[buckets_[k]];
        places_[k] = place;
        entries_[place] = {points[k], radii[k], static_cast<std::uint32_t>(k), cell_of(points[k].y),
                           layer_of(points[k])};
    }
}

void NeighborGrid::scan(std::uint32_t begin, std::uint32_t end, std::int32_t row,
                        std::int32_t layer, Query& query) const {
    const Entry& self = query.self;
    for (std::uint32_t k = starts_[begin]; k < starts_[end]; k++) {
        const Entry& other = entries_[k];
        const Vec3 offset = other.point - self.point;
        const double radii = other.radius + self.radius;
        const double gap = dot(offset, offset) - radii * radii;
        if (gap > query.bound) continue;
        // A bucket may contain other cells.
        if (other.row != row || other.layer != layer || other.index == self.index) continue;
        query.add({gap, other.index});
    }
}

void NeighborGrid::find(std::size_t self_index, std::size_t most, double bound,
                        NearPoints& found) const {
    const Entry& self = entries_[places_[self_index]];
    found.count = 0;
    Query query{self, most, minimum(bound, reach_ * reach_), found};
    const double sum = self.radius + largest_radius_;
    const double radius = square_root(maximum(query.bound + sum * sum, 0)) * (1 + 1e-9);
    const Vec3 p = self.point;
    const std::int32_t left = cell_of(p.x - radius), right = cell_of(p.x + radius);
    const std::int32_t low = cell_of(p.y - radius), high = cell_of(p.y + radius);
    const std::int32_t below = flat_ ? 0 : cell_of(p.z - radius);
    const std::int32_t above = flat_ ? 0 : cell_of(p.z + radius);
    for (std::int32_t layer = below; layer <= above; layer++)
        for (std::int32_t row = low; row <= high; row++) {
            const std::uint32_t hash = hash_of(row, layer);
            const std::uint32_t first = (hash + static_cast<std::uint32_t>(left)) & mask_;
            const std::uint32_t last = (hash + static_cast<std::uint32_t>(right)) & mask_;
            if (first <= last) {
                scan(first, last + 1, row, layer, query);
            } else {
                scan(first, mask_ + 1, row, layer, query);
                scan(0, last + 1, row, layer, query);
            }
        }
}

}  // namespace jostle::modules::crowd_detail
