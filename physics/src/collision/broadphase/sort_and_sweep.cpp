// SPDX-License-Identifier: MIT
#include "physics/src/collision/broadphase/sort_and_sweep.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {

std::int32_t SortAndSweep::insert(const Aabb& box, std::uint32_t item, std::uint32_t category) {
    std::int32_t handle;
    if (free_.empty()) {
        handle = static_cast<std::int32_t>(rank_.size());
        rank_.push_back(-1);
    } else {
        handle = free_.back();
        free_.pop_back();
    }
    rank_[static_cast<std::size_t>(handle)] = static_cast<std::int32_t>(entries_.size());
    ASSERT(entries_.size() + free_.size() + 1 == rank_.size());
    entries_.push_back({box, item, category, handle});
    sorted_ = false;
    return handle;
}

void SortAndSweep::remove(std::int32_t handle) {
    const auto at = static_cast<std::size_t>(rank_[static_cast<std::size_t>(handle)]);
    ASSERT(at < entries_.size() && entries_[at].handle == handle);
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(at));
    for (std::size_t k = at; k < entries_.size(); k++)
        rank_[static_cast<std::size_t>(entries_[k].handle)] = static_cast<std::int32_t>(k);
    rank_[static_cast<std::size_t>(handle)] = -1;
    free_.push_back(handle);
    sorted_ = false;  // reach_ must be recomputed
}

void SortAndSweep::move(std::int32_t handle, const Aabb& box) {
    ASSERT(rank_[static_cast<std::size_t>(handle)] >= 0);
    entries_[static_cast<std::size_t>(rank_[static_cast<std::size_t>(handle)])].box = box;
    sorted_ = false;
}

void SortAndSweep::flush() {
    if (sorted_) return;
    // Insertion sort while the list is nearly sorted, a full sort otherwise.
    std::size_t work = 0;
    const std::size_t patience = 8 * entries_.size() + 64;
    for (std::size_t k = 1; k < entries_.size() && work < patience; k++) {
        std::size_t j = k;
        while (j > 0 && entries_[j].box.low.x < entries_[j - 1].box.low.x && work < patience) {
            std::swap(entries_[j], entries_[j - 1]);
            j--;
            work++;
        }
    }
    if (work >= patience)
        std::stable_sort(entries_.begin(), entries_.end(),
                         [](const Entry& a, const Entry& b) { return a.box.low.x < b.box.low.x; });
    reach_.resize(entries_.size());
    ASSERT(entries_.size() + free_.size() == rank_.size());
    for (std::size_t k = 0; k < entries_.size(); k++) {
        rank_[static_cast<std::size_t>(entries_[k].handle)] = static_cast<std::int32_t>(k);
        reach_[k] =
            k == 0 ? entries_[k].box.high.x : maximum(reach_[k - 1], entries_[k].box.high.x);
    }
    sorted_ = true;
}

// The first entry from which any box can reach x.
std::size_t SortAndSweep::first_from(double x) const {
    if (!sorted_) return 0;
    ASSERT(reach_.size() == entries_.size());
    return static_cast<std::size_t>(std::lower_bound(reach_.begin(), reach_.end(), x) -
                                    reach_.begin());
}

void SortAndSweep::query(const Aabb& box, std::uint32_t mask,
                         std::vector<std::uint32_t>& found) const {
    for (std::size_t k = first_from(box.low.x); k < entries_.size(); k++) {
        const Entry& e = entries_[k];
        if (sorted_ && e.box.low.x > box.high.x) break;
        if ((e.category & mask) != 0 && overlap(e.box, box)) found.push_back(e.item);
    }
}

// Walks the list in the direction of the ray, up to the best hit so far.
void SortAndSweep::cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                            const RayVisit& visit) const {
    double limit = 1;
    const auto consider = [&](const Entry& e) {
        if ((e.category & mask) != 0 && ray_enters(e.box, origin, motion, limit) <= limit)
            limit = visit(e.item, limit);
    };
    if (!sorted_) {
        for (const Entry& e : entries_) consider(e);
        return;
    }
    // Rounding differs between this test and the slab test. The pad includes boxes that begin
    // exactly at the end of the ray.
    const double pad = 1e-9 * (absolute(origin.x) + absolute(motion.x));
    const auto end = [&] { return origin.x + motion.x * limit; };
    if (motion.x >= 0) {
        for (std::size_t k = first_from(origin.x - pad); k < entries_.size(); k++) {
            if (limit < 0 || entries_[k].box.low.x > end() + pad) break;
            consider(entries_[k]);
        }
        return;
    }
    const auto past = std::upper_bound(entries_.begin(), entries_.end(), origin.x + pad,
                                       [](double x, const Entry& e) { return x < e.box.low.x; });
    for (auto k = static_cast<std::size_t>(past - entries_.begin()); k-- > 0;) {
        if (limit < 0 || reach_[k] < end() - pad) break;
        consider(entries_[k]);
    }
}

std::unique_ptr<BroadPhaseIndex> SortAndSweep::clone() const {
    return std::make_unique<SortAndSweep>(*this);
}

void SortAndSweep::assign(const BroadPhaseIndex& other) {
    *this = static_cast<const SortAndSweep&>(other);
}

// The box of each entry. Its extent along x is the slab that a query of the entry scans.
void SortAndSweep::cells(std::vector<Aabb>& out) const {
    for (const Entry& e : entries_) out.push_back(e.box);
}

}  // namespace jostle::physics
