// SPDX-License-Identifier: MIT
#include "modules/destruction/src/fracture_cells.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "jostle/modules/fractured_shape.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

bool before(Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

using Distance = std::pair<double, std::uint32_t>;  // squared; the seed

// Sorts incrementally: a cell has about twenty neighbours, regardless of the number of seeds.
class ByDistance {
public:
    explicit ByDistance(std::vector<Distance> all) : all_(std::move(all)) {}

    std::size_t size() const { return all_.size(); }
    const Distance& at(std::size_t k) {
        constexpr std::size_t first_lot = 64;
        if (k >= sorted_) {
            const std::size_t end = std::min(all_.size(), std::max(first_lot, 2 * sorted_));
            const auto from = all_.begin() + static_cast<std::ptrdiff_t>(sorted_);
            const auto to = all_.begin() + static_cast<std::ptrdiff_t>(end);
            std::nth_element(from, to, all_.end());
            std::sort(from, to);
            sorted_ = end;
        }
        return all_[k];
    }

private:
    std::vector<Distance> all_;
    std::size_t sorted_ = 0;
};

}  // namespace

Status check_seeds(std::span<const Vec3> seeds) {
    if (seeds.empty() || seeds.size() > chunks_max)
        return invalid_argument("seeds has " + std::to_string(seeds.size()) +
                                " elements; it must have 1 to " + std::to_string(chunks_max));
    for (std::size_t k = 0; k < seeds.size(); k++)
        if (!is_finite(seeds[k]) || !(length_squared(seeds[k]) < 1e8))
            return invalid_argument("seeds[" + std::to_string(k) +
                                    "] is out of range; it must be finite and within 10 km");
    std::vector<std::size_t> order(seeds.size());
    for (std::size_t k = 0; k < order.size(); k++) order[k] = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return before(seeds[a], seeds[b]); });
    for (std::size_t k = 1; k < order.size(); k++)
        if (seeds[order[k]] == seeds[order[k - 1]])
            return invalid_argument("seeds[" + std::to_string(std::max(order[k], order[k - 1])) +
                                    "] is a duplicate");
    return {};
}

ConvexCell clip_by_bisector(const ConvexCell& solid, std::span<const Vec3> seeds, std::size_t own,
                            std::uint32_t other, double plane_tolerance) {
    const Vec3 apart = seeds[other] - seeds[own];
    const Vec3 normal = apart / square_root(length_squared(apart));
    return clipped(solid, normal, dot(normal, (seeds[other] + seeds[own]) * 0.5), other,
                   plane_tolerance);
}

// Clips by the other seeds in order of distance. Once a bisector plane is beyond the farthest
// corner, so are all later ones.
ConvexCell voronoi_cell(const ConvexCell& solid, std::span<const Vec3> seeds, std::size_t own,
                        double plane_tolerance) {
    const Vec3 own_seed = seeds[own];
    std::vector<Distance> all;
    for (std::size_t k = 0; k < seeds.size(); k++)
        if (k != own)
            all.emplace_back(length_squared(seeds[k] - own_seed), static_cast<std::uint32_t>(k));
    ByDistance others(std::move(all));
    ConvexCell cell = solid;
    double reach2 = furthest_squared(cell, own_seed);
    for (std::size_t k = 0; k < others.size(); k++) {
        const auto& [distance2, other] = others.at(k);
        if (cell.empty() || distance2 > 4 * reach2) break;
        cell = clip_by_bisector(cell, seeds, own, other, plane_tolerance);
        reach2 = furthest_squared(cell, own_seed);
    }
    return cell;
}

}  // namespace jostle::modules::destruction_detail
