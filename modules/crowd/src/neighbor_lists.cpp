// SPDX-License-Identifier: MIT
#include "modules/crowd/src/neighbor_lists.h"

#include <algorithm>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr double reach_margin = 1.2;     // a search extends by this factor beyond the reach
constexpr std::size_t spare_points = 8;  // candidates in addition to the neighbours
constexpr int points_per_task = 64;

}  // namespace

void NeighborLists::update(const World& world, std::span<const Vec3> points,
                           std::span<const double> radii, std::span<const std::uint8_t> active,
                           const Settings& settings) {
    if (std::ranges::none_of(active, [](std::uint8_t is) { return is != 0; })) {
        lists_.clear();
        return;
    }
    if (lists_.size() != points.size() || settings.reach != settings_.reach ||
        settings.most != settings_.most || settings.flat != settings_.flat) {
        lists_.assign(points.size(), {});
        previous_.assign(points.begin(), points.end());
    }
    settings_ = settings;
    double farthest = 0;  // squared
    for (std::size_t k = 0; k < points.size(); k++) {
        if (!active[k]) continue;
        const Vec3 moved = points[k] - previous_[k];
        farthest = maximum(farthest, dot(moved, moved));
        previous_[k] = points[k];
    }
    travel_ += square_root(farthest);
    largest_radius_ = *std::ranges::max_element(radii);
    const int count = static_cast<int>(points.size());
    world.parallel_for(count, points_per_task, [&](int first, int last) {
        for (int k = first; k < last; k++)
            refresh(static_cast<std::size_t>(k), points, radii, active);
    });
    if (std::ranges::none_of(lists_, &List::expired)) return;
    grid_.build(points, radii, active, reach_margin * settings.reach, settings.flat);
    world.parallel_for(count, points_per_task, [&](int first, int last) {
        for (int k = first; k < last; k++)
            if (const auto self = static_cast<std::size_t>(k); lists_[self].expired)
                search(self, radii[self]);
    });
}

// Updates the gaps of the candidates and decides whether the first ones are the neighbours.
void NeighborLists::refresh(std::size_t self, std::span<const Vec3> points,
                            std::span<const double> radii, std::span<const std::uint8_t> active) {
    List& list = lists_[self];
    if (!active[self]) {
        list.count = list.near.count = 0;
        list.expired = false;
        return;
    }
    auto& near = list.near.points;
    // The order of the last step is almost the new one.
    for (std::size_t k = 0; k < list.near.count; k++) {
        NearPoint point = near[k];
        point.gap = active[point.index] ? gap_between(points[self], radii[self],
                                                      points[point.index], radii[point.index])
                                        : 1e300;
        std::size_t at = k;
        for (; at > 0 && point < near[at - 1]; at--) near[at] = near[at - 1];
        near[at] = point;
    }
    count_neighbors(list);
    // Points outside the list are at least this far away, and their gap is at least the second
    // value.
    const double clear = list.clear * (1 - 1e-9) - 2 * (travel_ - list.searched);
    const double sum = radii[self] + largest_radius_, gap = clear * clear - sum * sum;
    const bool full = list.count == settings_.most;
    const double needed = full ? near[list.count - 1].gap : settings_.reach * settings_.reach;
    list.expired = !(clear > 0 && needed < gap);
}

void NeighborLists::search(std::size_t self, double radius) {
    List& list = lists_[self];
    NearPoints& near = list.near;
    const std::size_t capacity = settings_.most + spare_points;
    const double reach = reach_margin * settings_.reach;
    const bool was_full = near.count == capacity;
    grid_.find(self, capacity, was_full ? near.points[capacity - 1].gap : 1e300, near);
    list.expired = false;
    list.searched = travel_;
    const double gap = near.count == capacity ? near.points[capacity - 1].gap : reach * reach;
    const double sum = radius + grid_.smallest_radius();
    list.clear = square_root(maximum(gap + sum * sum, 0));
    count_neighbors(list);
}

void NeighborLists::count_neighbors(List& list) const {
    const double gap_max = settings_.reach * settings_.reach;
    list.count = 0;
    while (list.count < list.near.count && list.count < settings_.most &&
           list.near.points[list.count].gap <= gap_max)
        list.count++;
}

}  // namespace jostle::modules::crowd_detail
