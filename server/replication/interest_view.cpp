// SPDX-License-Identifier: MIT
#include "server/replication/interest_view.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr auto second = std::chrono::seconds(1);
// Bytes of a second that the header of the last snapshot may need, which is not asked for.
constexpr double header_reserve = 200;
constexpr double huge_share = 0.75;   // of a second's bytes
constexpr double bucket_s = 0.05;     // seconds of the rate that the bucket holds
constexpr double fresh_share = 0.5;   // of the rate
constexpr double points_share = 0.5;  // of the rate
constexpr double leave_share = 0.25;  // in cells: how far beyond the radius a cell is left
// of the radius: where distant cells begin, and how much farther a near cell stays near
constexpr double far_begins = 0.5, far_hysteresis = 0.1;
constexpr double first_of_all = 1e12;  // rank of new cells, as long as their quota lasts
// Without a budget, new cells are still sent in pieces, with updates in between.
constexpr double fresh_bytes_per_second = 4e6;

double capacity(double rate) {
    return rate * bucket_s;
}

}  // namespace

void InterestView::refill(Clock::time_point now) {
    while (!last_second_.empty() && last_second_.front().at <= now - second) {
        sent_in_second_ -= last_second_.front().bytes;
        last_second_.pop_front();
    }
    const double seconds = refilled_ == Clock::time_point{}
                               ? bucket_s
                               : std::chrono::duration<double>(now - refilled_).count();
    refilled_ = now;
    const double fresh_rate = rate_ == 0 ? fresh_bytes_per_second : fresh_share * rate_;
    tokens_ = std::min(capacity(rate_), tokens_ + rate_ * seconds);
    fresh_tokens_ = std::min(capacity(fresh_rate), fresh_tokens_ + fresh_rate * seconds);
    const double point_rate = points_wait_ ? points_share * rate_ : 0;
    point_tokens_ = std::min(capacity(point_rate), point_tokens_ + point_rate * seconds);
}

double InterestView::point_tokens() const {
    if (rate_ == 0) return std::numeric_limits<double>::infinity();
    return cells_wait_ ? point_tokens_ : tokens_;
}

bool InterestView::point_bucket_is_full() const {
    return point_tokens() >= capacity(points_share * rate_);
}

void InterestView::count_sent(std::size_t bytes) {
    if (rate_ == 0) return;
    const auto sent = static_cast<double>(bytes);
    sent_in_second_ += sent;
    if (!last_second_.empty() && last_second_.back().at == refilled_)
        last_second_.back().bytes += sent;
    else
        last_second_.push_back({refilled_, sent});
}

void InterestView::spend_points(std::size_t bytes) {
    count_sent(bytes);
    tokens_ -= static_cast<double>(bytes);
    point_tokens_ -= static_cast<double>(bytes);
    // Points may use all bytes that cells do not need.
    if (!cells_wait_) point_tokens_ = std::max(0.0, point_tokens_);
}

bool InterestView::leaves(double distance_m) const {
    return distance_m > interest_.radius_m * (1 + leave_share);
}

// Tokens may become negative, so that no tokens are lost while a large piece waits for a full
// bucket. Only a piece that takes most of a second's bytes may exceed the rate of a second.
bool InterestView::affords(std::size_t bytes, bool fresh) const {
    if (fresh && fresh_tokens_ <= 0) return false;
    if (rate_ == 0) return true;
    const double most = rate_ - header_reserve;
    const auto wanted = static_cast<double>(bytes);
    const bool huge = wanted > huge_share * most && sent_in_second_ < (1 - huge_share) * most;
    if (sent_in_second_ + wanted > most && !huge) return false;
    return tokens_ - (points_wait_ ? point_tokens_ : 0) > 0;
}

void InterestView::spend(std::size_t bytes, bool fresh) {
    count_sent(bytes);
    tokens_ -= static_cast<double>(bytes);
    if (fresh) fresh_tokens_ -= static_cast<double>(bytes);
}

std::uint32_t InterestView::interval(double distance_m) const {
    ASSERT(distance_m >= 0);
    if (distance_m <= 0.5 * interest_.radius_m) return 1;
    return distance_m <= 0.75 * interest_.radius_m ? 2 : 4;
}

bool InterestView::is_far(double distance_m, bool was) const {
    return distance_m > interest_.radius_m * (was ? far_begins : far_begins + far_hysteresis);
}

std::vector<InterestView::PendingCell> InterestView::pending_cells(
    const CellSnapshotCache& cache, const std::vector<CellSnapshotCache::CellLevels>& cells,
    std::uint32_t tick, Clock::time_point now) {
    refill(now);
    struct Ranked {
        double rank;
        PendingCell part;
    };
    std::vector<Ranked> ranked;
    for (const CellSnapshotCache::CellLevels& levels : cells) {
        const CellId id = levels.near.id;
        const double distance = cache.distance(id, interest_.x_m, interest_.z_m);
        const auto known = known_.find(id);
        if (known == known_.end()) {
            const CellState& cell = is_far(distance, true) ? levels.far : levels.near;
            if (distance <= interest_.radius_m && !cell.content->entities.empty())
                ranked.push_back({first_of_all - distance, {cell, {}, true, true}});
            continue;
        }
        if (distance > interest_.radius_m + leave_share * cache.interest_cell_m()) {
            left_.push_back(id);
            known_.erase(known);
            continue;
        }
        ASSERT(tick >= known->second.sent_tick);
        const CellState& cell = is_far(distance, known->second.far) ? levels.far : levels.near;
        // The states of the other precision are no baselines.
        if (cell.far != known->second.far) known->second.states.reset();
        const std::uint32_t waited = tick - known->second.sent_tick;
        if (cell.number == known->second.states.last() || waited < interval(distance)) continue;
        const double near = 1 + distance / cache.interest_cell_m();
        ranked.push_back({waited / near,
                          {cell, known->second.states.baselines_for(cell.number), false,
                           cell.members != known->second.members}});
    }
    // Cells that were dropped because they were empty for long.
    std::erase_if(known_, [&](const auto& known) {
        const bool exists = std::ranges::binary_search(
            cells, known.first, {},
            [](const CellSnapshotCache::CellLevels& levels) { return levels.near.id; });
        if (!exists) left_.push_back(known.first);
        return !exists;
    });
    std::ranges::stable_sort(ranked, std::ranges::greater{}, &Ranked::rank);
    std::vector<PendingCell> parts;
    parts.reserve(ranked.size());
    for (Ranked& entry : ranked) parts.push_back(std::move(entry.part));
    ASSERT(parts.size() == ranked.size());
    return parts;
}

void InterestView::reset() {
    for (auto& [cell, known] : known_) known.states.reset();
}

void InterestView::on_sent(const PendingCell& part, bool is_keyframe, std::uint32_t tick) {
    Known& known = known_[part.state.id];
    if (is_keyframe) known.states.reset();  // the client drops its earlier states
    known.states.on_sent(part.state.number);
    ASSERT(tick >= known.sent_tick);
    known.sent_tick = tick;
    known.members = part.state.members;
    known.far = part.state.far;
}

}  // namespace jostle::server
