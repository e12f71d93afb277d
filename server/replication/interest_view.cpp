// SPDX-License-Identifier: MIT
#include "server/replication/interest_view.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr double bucket_s = 0.05;      // seconds of the rate that the bucket holds
constexpr double fresh_share = 0.5;    // of the rate
constexpr double points_share = 0.5;   // of the rate
constexpr double leave_share = 0.25;   // in cells: how far beyond the radius a cell is left
constexpr double first_of_all = 1e12;  // rank of new cells, as long as their quota lasts
// Without a budget, new cells are still sent in pieces, with updates in between.
constexpr double fresh_bytes_per_second = 4e6;

double capacity(double rate) {
    return rate * bucket_s;
}

}  // namespace

void InterestView::refill(Clock::time_point now) {
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

void InterestView::spend_points(std::size_t bytes) {
    tokens_ -= static_cast<double>(bytes);
    point_tokens_ -= static_cast<double>(bytes);
    // Points may use all bytes that cells do not need.
    if (!cells_wait_) point_tokens_ = std::max(0.0, point_tokens_);
}

bool InterestView::leaves(double distance_m) const {
    return distance_m > interest_.radius_m * (1 + leave_share);
}

// A piece larger than the bucket is sent when the bucket is full.
bool InterestView::affords(std::size_t bytes, bool fresh) const {
    const auto within = [&](double tokens, double rate) {
        return static_cast<double>(bytes) <= tokens || tokens >= capacity(rate);
    };
    if (fresh && !within(fresh_tokens_, rate_ == 0 ? fresh_bytes_per_second : fresh_share * rate_))
        return false;
    if (rate_ == 0) return true;
    if (!points_wait_) return within(tokens_, rate_);
    return within(tokens_ - point_tokens_, (1 - points_share) * rate_);
}

void InterestView::spend(std::size_t bytes, bool fresh) {
    tokens_ -= static_cast<double>(bytes);
    if (fresh) fresh_tokens_ -= static_cast<double>(bytes);
}

std::uint32_t InterestView::interval(double distance_m) const {
    ASSERT(distance_m >= 0);
    if (distance_m <= 0.5 * interest_.radius_m) return 1;
    return distance_m <= 0.75 * interest_.radius_m ? 2 : 4;
}

std::vector<InterestView::PendingCell> InterestView::pending_cells(
    const CellSnapshotCache& cache, const std::vector<CellState>& cells, std::uint32_t tick,
    Clock::time_point now) {
    refill(now);
    struct Ranked {
        double rank;
        PendingCell part;
    };
    std::vector<Ranked> ranked;
    for (const CellState& cell : cells) {
        const double distance = cache.distance(cell.id, interest_.x_m, interest_.z_m);
        const auto known = known_.find(cell.id);
        if (known == known_.end()) {
            if (distance <= interest_.radius_m && !cell.content->entities.empty())
                ranked.push_back({first_of_all - distance, {cell, {}, true, true}});
            continue;
        }
        if (distance > interest_.radius_m + leave_share * cache.interest_cell_m()) {
            left_.push_back(cell.id);
            known_.erase(known);
            continue;
        }
        ASSERT(tick >= known->second.sent_tick);
        const std::uint32_t waited = tick - known->second.sent_tick;
        if (cell.number == known->second.states.last() || waited < interval(distance)) continue;
        const double near = 1 + distance / cache.interest_cell_m();
        ranked.push_back({waited / near,
                          {cell, known->second.states.baselines_for(cell.number), false,
                           cell.members != known->second.members}});
    }
    // Cells that were dropped because they were empty for long.
    std::erase_if(known_, [&](const auto& known) {
        const bool exists = std::ranges::binary_search(cells, known.first, {}, &CellState::id);
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

void InterestView::on_sent(const PendingCell& part, std::uint32_t tick) {
    Known& known = known_[part.state.id];
    known.states.on_sent(part.state.number);
    ASSERT(tick >= known.sent_tick);
    known.sent_tick = tick;
    known.members = part.state.members;
}

}  // namespace jostle::server
