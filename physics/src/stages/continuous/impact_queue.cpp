// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/impact_queue.h"

#include <algorithm>
#include <functional>

#include "jostle/base/check.h"

namespace jostle::physics {

void ImpactQueue::update(const ToiState& state, std::size_t index) {
    const ToiBody& t = state.bodies[index];
    ASSERT(t.fast && !t.queued);
    if (next_at_.size() < state.bodies.size()) next_at_.resize(state.bodies.size(), Impact::never);
    const double leg_end = t.sweep.until < 1 ? t.sweep.until : Impact::never;
    next_at_[index] = std::min(t.fraction, leg_end);
    if (t.fraction <= 1) {
        ASSERT(t.fraction >= t.sweep.from && t.closing >= 0);
        ASSERT(state.world.shapes.shapes[t.own_shape].body == t.body);
        dependents_.add(state.world.shapes.shapes[t.other_shape].body, index);
    }
    heap_.push_back({next_at_[index], t.fraction <= t.sweep.until ? t.closing : 0, index});
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

std::optional<std::size_t> ImpactQueue::next() {
    while (!heap_.empty() && heap_.front().at != next_at_[heap_.front().index]) {
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        heap_.pop_back();
    }
    if (heap_.empty() || heap_.front().at > 1) return std::nullopt;
    return heap_.front().index;
}

}  // namespace jostle::physics
