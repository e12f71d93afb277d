// SPDX-License-Identifier: MIT
#include "server/session/points_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "jostle/base/check.h"
#include "server/messages/server_message.h"

namespace jostle::server {
namespace {

using snapshot::point_levels;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double fresh_rank = 1e6;     // of objects that the client does not have
constexpr double refined_rank = 1e-6;  // factor: changed objects come before refinements
constexpr double near_m = 10;          // distance at which the rank is halved
constexpr std::size_t baselines_max = 3;

std::uint32_t id_of(const std::shared_ptr<const PointObjectState>& state) {
    return state->object->id;
}

}  // namespace

double PointsSection::distance(const PointObjectState& state) const {
    if (!view_) return 0;
    const Interest& interest = view_->interest();
    const double dx = state.center.x - interest.x_m, dz = state.center.z - interest.z_m;
    return std::max(0.0, std::sqrt(dx * dx + dz * dz) - state.reach);
}

bool PointsSection::is_due(const PointObjectState& state, const Known& known,
                           std::uint32_t tick) const {
    if (!view_) return true;
    const auto period = static_cast<std::uint32_t>(
        broadcast_.host().properties().channel_kinds[state.object->kind].divisor);
    return tick - known.sent_tick >= period * view_->interval(distance(state));
}

// The objects to send, the most urgent first.
std::vector<PointsSection::Candidate> PointsSection::candidates(const PointObjects& objects,
                                                                std::uint32_t tick) {
    std::vector<Candidate> made;
    for (const StatePtr& state : objects) {
        if ((kinds_ >> state->object->kind & 1) == 0) continue;
        const double far = distance(*state), nearness = 1 / (1 + far / near_m);
        const auto at = known_.find(id_of(state));
        if (at == known_.end()) {
            if (!view_ || far <= view_->interest().radius_m)
                made.push_back({state, fresh_rank * nearness, false});
            continue;
        }
        const Known& known = at->second;
        const bool is_new = known.sent.empty() || known.sent.front().number != state->number;
        const bool refines = !is_new && known.sent.front().levels < point_levels;
        if (!refines && !(is_new && is_due(*state, known, tick))) continue;
        const double waited = tick - known.sent_tick;
        made.push_back({state, (refines ? refined_rank : 1) * waited * nearness, refines});
    }
    std::ranges::stable_sort(made, std::ranges::greater{}, &Candidate::rank);
    return made;
}

// Objects that ended or left the area of interest.
void PointsSection::remove_ended(const PointObjects& objects, SnapshotParts& parts) {
    std::vector<std::uint32_t> ended;
    std::erase_if(known_, [&](const auto& entry) {
        const auto at = std::ranges::lower_bound(objects, entry.first, {}, id_of);
        const bool exists = at != objects.end() && id_of(*at) == entry.first;
        if (exists && !(view_ && view_->leaves(distance(**at)))) return false;
        ended.push_back(entry.first);
        return true;
    });
    if (!ended.empty()) parts.fields += encode_points_ended_field(ended);
}

void PointsSection::append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) {
    const std::shared_ptr<const PointObjects> objects = broadcast_.points().objects(frame);
    last_tick_ = frame->tick;
    remove_ended(*objects, parts);
    std::vector<Candidate> all = candidates(*objects, frame->tick);
    if (view_) view_->refill(now);
    std::size_t left = all.size();
    for (const Candidate& candidate : all) {
        const double tokens = view_ ? view_->point_tokens() : unlimited;
        const std::size_t before = parts.shared_fields.size();
        send(candidate, tokens / static_cast<double>(left--), frame->tick, parts);
        has_pending_ = parts.shared_fields.size() == before;
        if (has_pending_) break;
    }
    if (all.empty()) has_pending_ = false;
    if (view_) {
        view_->set_points_waiting(!all.empty());
        has_pending_ =
            has_pending_ || std::ranges::any_of(known_, [](const auto& entry) {
                return entry.second.sent.empty() || entry.second.sent.front().levels < point_levels;
            });
    }
}

// The largest number of levels whose bytes are allowed; 0: not even one.
std::size_t PointsSection::levels_within(const PointCache::Encoding& complete, double bytes) const {
    const std::size_t head = complete.field->size() - complete.bytes_of_levels[point_levels - 1];
    std::size_t levels = point_levels;
    while (levels > 0 && static_cast<double>(head + complete.bytes_of_levels[levels - 1]) > bytes)
        levels--;
    return levels;
}

// The baselines of the encoding whose size selects the levels. Limited clients have baselines of
// their own, so an encoding with all levels for each of them would be wasted; that of a client
// without limit is shared.
SentStates PointsSection::estimate_from(const Candidate& candidate, const SentStates& sent) {
    if (candidate.refines || sent.empty()) return sent;
    SentStates typical;
    for (std::uint32_t back = 1; back <= baselines_max && back < candidate.state->number; back++)
        typical.push_back({candidate.state->number - back, point_levels});
    return typical;
}

void PointsSection::send(const Candidate& candidate, double allowed_bytes, std::uint32_t tick,
                         SnapshotParts& parts) {
    const PointObjectState& state = *candidate.state;
    PointCache& cache = broadcast_.points();
    const auto at = known_.find(state.object->id);
    SentStates sent = at == known_.end() ? SentStates() : at->second.sent;
    // The client replaces the refined state, so the states before it are of no use.
    if (candidate.refines) sent.resize(1);
    std::size_t levels = point_levels;
    const bool is_limited = view_ && view_->is_limited();
    if (is_limited) {
        levels = levels_within(cache.encoding(state, point_levels, estimate_from(candidate, sent)),
                               allowed_bytes);
        const bool refines_nothing = candidate.refines && levels <= sent.front().levels;
        if (levels == 0 || refines_nothing) {
            // Something is sent at least while the budget is not used for anything else.
            if (!view_->point_bucket_is_full()) return;
            levels = candidate.refines ? sent.front().levels + 1 : 1;
        }
    }
    const PointCache::Encoding encoding = cache.encoding(state, levels, sent);
    if (is_limited) view_->spend_points(encoding.field->size());
    if (at == known_.end()) parts.fields += *cache.description(*state.object);
    parts.shared_fields.push_back(encoding.field);
    Known& known = known_[state.object->id];
    if (encoding.baselines == 0 || candidate.refines) known.sent.clear();
    known.sent.insert(known.sent.begin(), {state.number, levels});
    if (known.sent.size() > baselines_max) known.sent.resize(baselines_max);
    known.sent_tick = tick;
}

}  // namespace jostle::server
