// SPDX-License-Identifier: MIT
#include "jostle/modules/companions.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::modules {

using namespace physics;

void Companions::find(std::span<const Reach> reaches, const MovesInto& moves_into) {
    const auto count = static_cast<std::uint32_t>(reaches.size());
    pairs_.clear();
    obstacles_.clear();
    awake_.assign(count, false);
    woken_.assign(count, false);
    parents_.resize(count);
    for (std::uint32_t k = 0; k < count; k++) {
        awake_[k] = reaches[k].awake;
        parents_[k] = k;
    }
    // Sorted by their low ends along x, so most pairs are not looked at.
    std::vector<std::uint32_t> order(parents_);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(reaches[a].box.low.x, a) < std::pair(reaches[b].box.low.x, b);
    });
    for (std::size_t k = 0; k < order.size(); k++)
        for (std::size_t n = k + 1; n < order.size(); n++) {
            const Reach &a = reaches[order[k]], &b = reaches[order[n]];
            if (b.box.low.x > a.box.high.x) break;
            if (!a.awake && !b.awake) continue;
            if (overlap(a.box, b.box)) pairs_.push_back(std::minmax(order[k], order[n]));
        }
    std::ranges::sort(pairs_);
    for (bool any = true; any;) {
        any = false;
        for (const auto& [a, b] : pairs_) {
            if (awake_[a] == awake_[b]) continue;
            const std::uint32_t moving = awake_[a] ? a : b, resting = awake_[a] ? b : a;
            if (!moves_into(moving, resting)) continue;
            awake_[resting] = woken_[resting] = any = true;
        }
    }
    for (const auto& [a, b] : pairs_) {
        if (!awake_[a] || !awake_[b]) continue;
        const std::uint32_t x = leader(a), y = leader(b);
        parents_[std::max(x, y)] = std::min(x, y);
    }
    for (const auto& [a, b] : pairs_)
        if (awake_[a] != awake_[b])
            obstacles_.push_back({leader(awake_[a] ? a : b), awake_[a] ? b : a});
    std::ranges::sort(obstacles_);
    obstacles_.erase(std::unique(obstacles_.begin(), obstacles_.end()), obstacles_.end());
}

std::uint32_t Companions::leader(std::uint32_t k) const {
    ASSERT(k < parents_.size());
    while (parents_[k] != k) k = parents_[k];
    return k;
}

}  // namespace jostle::modules
