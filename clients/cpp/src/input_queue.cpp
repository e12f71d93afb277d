// SPDX-License-Identifier: MIT
#include "input_queue.h"

#include <algorithm>

namespace jostle::client {
namespace {

// A server that answers nothing: the oldest are not sent again.
constexpr std::size_t unanswered_max = 8192;

}  // namespace

std::uint32_t InputQueue::push(v1::Input input) {
    if (waiting_.size() >= waiting_max) return 0;
    waiting_.push_back(std::move(input));
    return next_unsent_ + static_cast<std::uint32_t>(waiting_.size()) - 1;
}

std::size_t InputQueue::take(v1::InputBatch& batch, std::size_t most) {
    batch.set_first_sequence(next_unsent_);
    const std::size_t count = std::min(most, waiting_.size());
    for (std::size_t k = 0; k < count; k++) {
        *batch.add_inputs() = waiting_.front();
        unanswered_.push_back({next_unsent_++, std::move(waiting_.front())});
        waiting_.pop_front();
        if (unanswered_.size() > unanswered_max) unanswered_.pop_front();
    }
    return count;
}

bool InputQueue::answered(std::uint32_t sequence) {
    const auto at = std::ranges::lower_bound(unanswered_, sequence, {}, &Sent::sequence);
    if (at == unanswered_.end() || at->sequence != sequence) return !went_on_;
    unanswered_.erase(at);
    return true;
}

void InputQueue::begin_anew() {
    unanswered_.clear();
    next_unsent_ = 1;
    went_on_ = false;
}

std::size_t InputQueue::go_on_after(std::uint32_t last_sequence) {
    const std::uint32_t last = std::min(last_sequence, last_sent());
    const auto first = std::ranges::upper_bound(unanswered_, last, {}, &Sent::sequence);
    const auto again = static_cast<std::size_t>(unanswered_.end() - first);
    for (auto at = unanswered_.end(); at != first;) waiting_.push_front(std::move((--at)->input));
    unanswered_.erase(first, unanswered_.end());
    next_unsent_ = last + 1;
    went_on_ = true;
    return again;
}

void InputQueue::forget_waiting() {
    waiting_.clear();
}

}  // namespace jostle::client
