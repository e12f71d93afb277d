// SPDX-License-Identifier: MIT
#include "physics/src/collision/broadphase/uniform_grid.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

constexpr double cells_max = 64;  // per box; a box that covers more is large

}  // namespace

double UniformGrid::Range::count() const {
    double n = 1;
    ASSERT(low[0] <= high[0] && low[1] <= high[1] && low[2] <= high[2]);
    for (int k = 0; k < 3; k++) n *= static_cast<double>(high[k] - low[k] + 1);
    return n;
}

UniformGrid::Range UniformGrid::range_of(const Aabb& box) const {
    ASSERT(cell_ > 0);
    Range r{};
    for (int k = 0; k < 3; k++) {
        // Distant coordinates are clamped to one cell, so that integers do not overflow.
        r.low[k] = static_cast<std::int64_t>(std::floor(clamp(box.low[k] / cell_, -1e15, 1e15)));
        r.high[k] = static_cast<std::int64_t>(std::floor(clamp(box.high[k] / cell_, -1e15, 1e15)));
    }
    return r;
}

// Different cells may share a key, because queries test the exact boxes.
std::uint64_t UniformGrid::key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto mix = [](std::int64_t v, std::uint64_t prime) {
        return static_cast<std::uint64_t>(v) * prime;
    };
    return mix(x, 0x9e3779b97f4a7c15ull) ^ mix(y, 0xc2b2ae3d27d4eb4full) ^
           mix(z, 0x165667b19e3779f9ull);
}

template <class Visit>
void UniformGrid::for_each_cell(const Range& r, Visit&& visit) const {
    for (std::int64_t x = r.low[0]; x <= r.high[0]; x++)
        for (std::int64_t y = r.low[1]; y <= r.high[1]; y++)
            for (std::int64_t z = r.low[2]; z <= r.high[2]; z++) visit(key_of(x, y, z));
}

void UniformGrid::insert_into_cells(std::int32_t handle) {
    Entry& e = entries_[static_cast<std::size_t>(handle)];
    const Range r = range_of(e.box);
    e.large = r.count() > cells_max;
    if (e.large)
        large_.push_back(handle);
    else
        for_each_cell(r, [&](std::uint64_t key) { cells_[key].push_back(handle); });
}

void UniformGrid::remove_from_cells(std::int32_t handle) {
    const Entry& e = entries_[static_cast<std::size_t>(handle)];
    const auto drop = [&](std::vector<std::int32_t>& list) {
        const auto found = std::find(list.begin(), list.end(), handle);
        if (found == list.end()) return;
        *found = list.back();
        list.pop_back();
    };
    if (e.large) return drop(large_);
    for_each_cell(range_of(e.box), [&](std::uint64_t key) {
        const auto cell = cells_.find(key);
        if (cell == cells_.end()) return;
        drop(cell->second);
        if (cell->second.empty()) cells_.erase(cell);
    });
}

std::int32_t UniformGrid::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    std::int32_t handle;
    if (free_.empty()) {
        handle = static_cast<std::int32_t>(entries_.size());
        entries_.emplace_back();
    } else {
        handle = free_.back();
        free_.pop_back();
    }
    entries_[static_cast<std::size_t>(handle)] = {box, item, category, true, false};
    insert_into_cells(handle);
    return handle;
}

void UniformGrid::remove(std::int32_t handle) {
    ASSERT(entries_[static_cast<std::size_t>(handle)].alive);
    remove_from_cells(handle);
    entries_[static_cast<std::size_t>(handle)] = {};
    free_.push_back(handle);
}

void UniformGrid::move(std::int32_t handle, const Aabb& box) {
    Entry& e = entries_[static_cast<std::size_t>(handle)];
    const Range from = range_of(e.box), to = range_of(box);
    ASSERT(e.alive);
    const bool stays = !e.large && std::equal(from.low, from.low + 3, to.low) &&
                       std::equal(from.high, from.high + 3, to.high);
    if (stays) {
        e.box = box;
        return;
    }
    remove_from_cells(handle);
    e.box = box;
    insert_into_cells(handle);
}

// Recomputes the cell size when the number of boxes has doubled or halved since the last choice.
// The base size is twice the median of the longest sides. Every query tests all large boxes, so the
// cell may grow to twice that size if at most 1 % of the boxes are then large: a side of three
// cells overlaps at most four, and 4^3 is cells_max. With a few huge boxes a larger cell would not
// help and would only fill the cells.
void UniformGrid::flush() {
    const std::size_t count = entries_.size() - free_.size();
    if (count == 0 || (count < 2 * sized_for_ && 2 * count > sized_for_)) return;
    sized_for_ = count;
    std::vector<double> sides;
    for (const Entry& e : entries_) {
        if (!e.alive) continue;
        const Vec3 d = e.box.high - e.box.low;
        sides.push_back(maximum(d.x, maximum(d.y, d.z)));
    }
    const auto middle = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 2);
    ASSERT(sides.size() == count);
    std::nth_element(sides.begin(), middle, sides.end());
    const double usual = 2 * *middle;
    const auto longest = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() * 99 / 100);
    std::nth_element(middle, longest, sides.end());
    const double roomy = *longest / 3;
    cell_ = maximum(1e-3, usual < roomy && roomy < 2 * usual ? roomy : usual);
    cells_.clear();
    large_.clear();
    for (std::size_t k = 0; k < entries_.size(); k++)
        if (entries_[k].alive) insert_into_cells(static_cast<std::int32_t>(k));
}

void UniformGrid::query(const Aabb& box, std::uint32_t mask,
                        std::vector<std::uint32_t>& found) const {
    const std::size_t old_size = found.size();
    const auto consider = [&](const Entry& e) {
        if (e.alive && (e.category & mask) != 0 && overlap(e.box, box)) found.push_back(e.item);
    };
    const Range r = range_of(box);
    if (r.count() > static_cast<double>(entries_.size()) + cells_max) {
        for (const Entry& e : entries_) consider(e);
        return;
    }
    for_each_cell(r, [&](std::uint64_t key) {
        const auto cell = cells_.find(key);
        if (cell == cells_.end()) return;
        for (const std::int32_t handle : cell->second)
            consider(entries_[static_cast<std::size_t>(handle)]);
    });
    // A box that overlaps several cells was found several times.
    const auto begin = found.begin() + static_cast<std::ptrdiff_t>(old_size);
    std::sort(begin, found.end());
    found.erase(std::unique(begin, found.end()), found.end());
    for (const std::int32_t handle : large_) consider(entries_[static_cast<std::size_t>(handle)]);
}

void UniformGrid::cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                           const RayVisit& visit) const {
    double limit = 1;
    const auto consider = [&](std::int32_t handle) {
        const Entry& e = entries_[static_cast<std::size_t>(handle)];
        if (e.alive && (e.category & mask) != 0 &&
            ray_enters(e.box, origin, motion, limit) <= limit)
            limit = visit(e.item, limit);
    };
    for (const std::int32_t handle : large_) consider(handle);
    // Visit cell by cell (Amanatides and Woo, "A fast voxel traversal algorithm", 1987). A ray that
    // crosses more cells than there are boxes tests all boxes instead.
    const double crossings = (absolute(motion.x) + absolute(motion.y) + absolute(motion.z)) / cell_;
    if (crossings > static_cast<double>(entries_.size()) + 16) {
        for (std::size_t k = 0; k < entries_.size(); k++)
            if (!entries_[k].large) consider(static_cast<std::int32_t>(k));
        return;
    }
    const Range start = range_of({origin, origin});
    std::int64_t at[3];
    double next[3], step[3];
    for (int k = 0; k < 3; k++) {
        at[k] = start.low[k];
        const double border = static_cast<double>(motion[k] > 0 ? at[k] + 1 : at[k]) * cell_;
        step[k] = motion[k] != 0 ? cell_ / absolute(motion[k]) : 1e300;
        next[k] = motion[k] != 0 ? (border - origin[k]) / motion[k] : 1e300;
    }
    for (double entered = 0; entered <= limit;) {
        const auto cell = cells_.find(key_of(at[0], at[1], at[2]));
        if (cell != cells_.end())
            for (const std::int32_t handle : cell->second) consider(handle);
        const int k = next[0] <= next[1] && next[0] <= next[2] ? 0 : (next[1] <= next[2] ? 1 : 2);
        entered = next[k];
        if (entered > 1) break;
        at[k] += motion[k] > 0 ? 1 : -1;
        next[k] += step[k];
    }
}

std::unique_ptr<BroadPhaseIndex> UniformGrid::clone() const {
    return std::make_unique<UniformGrid>(*this);
}

void UniformGrid::assign(const BroadPhaseIndex& other) {
    *this = static_cast<const UniformGrid&>(other);
}

void UniformGrid::cells(std::vector<Aabb>& out) const {
    std::vector<std::array<std::int64_t, 3>> all;
    for (const Entry& e : entries_) {
        if (!e.alive || e.large) continue;
        const Range r = range_of(e.box);
        for (std::int64_t x = r.low[0]; x <= r.high[0]; x++)
            for (std::int64_t y = r.low[1]; y <= r.high[1]; y++)
                for (std::int64_t z = r.low[2]; z <= r.high[2]; z++) all.push_back({x, y, z});
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const auto& c : all) {
        const Vec3 low =
            Vec3{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])} *
            cell_;
        out.push_back({low, low + Vec3{cell_, cell_, cell_}});
    }
}

}  // namespace jostle::physics
