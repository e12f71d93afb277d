// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/input_outbox.h"

#include <algorithm>
#include <utility>

namespace jostle::client {
namespace {

// A server that confirms nothing: the oldest are not said again.
constexpr std::size_t unconfirmed_max = 8192;

}  // namespace

void InputOutbox::begin_anew() {
    inputs_.erase(inputs_.begin(), inputs_.begin() + (next_unsaid_ - first_));
    first_ = next_unsaid_ = 1;
    next_ = 1 + static_cast<std::uint32_t>(inputs_.size());
    stream_next_ = 0;
    open_since_ = {};
    unanswered_.clear();
    went_on_ = false;
}

void InputOutbox::go_on_after(std::uint32_t last_sequence, Clock::time_point now) {
    confirm(last_sequence, now);
    stream_next_ = 0;
    open_since_ = {};
    went_on_ = true;
}

void InputOutbox::forget_unsaid() {
    inputs_.erase(inputs_.begin() + (next_unsaid_ - first_), inputs_.end());
    next_ = next_unsaid_;
}

std::uint32_t InputOutbox::push(v1::Input input) {
    if (next_ - next_unsaid_ >= waiting_max) return 0;
    inputs_.push_back(std::move(input));
    return next_++;
}

void InputOutbox::confirm(std::uint32_t received, Clock::time_point now) {
    // A server may say anything.
    const std::uint32_t end = std::min(received, last_said());
    if (end < first_) return;
    inputs_.erase(inputs_.begin(), inputs_.begin() + (end + 1 - first_));
    first_ = end + 1;
    open_since_ = now;
}

bool InputOutbox::answered(std::uint32_t sequence, Clock::time_point now) {
    const auto at = std::ranges::lower_bound(unanswered_, sequence);
    if (at == unanswered_.end() || *at != sequence) return !went_on_;
    unanswered_.erase(at);
    // One before it may wait until it is kept: should the server end, it is to be said again.
    confirm(unanswered_.empty() ? last_said() : unanswered_.front() - 1, now);
    return true;
}

bool InputOutbox::fits(std::size_t bytes_max) const {
    if (inputs_.size() > batch_max) return false;
    std::size_t bytes = 0;
    for (const v1::Input& input : inputs_) bytes += input.ByteSizeLong() + 4;  // tag and length
    return bytes <= bytes_max;
}

bool InputOutbox::is_stuck(Clock::duration timeout, Clock::time_point now) const {
    return first_ < next_unsaid_ && open_since_ != Clock::time_point{} &&
           now - open_since_ > timeout;
}

std::uint32_t InputOutbox::next_for_stream() const {
    return std::max(stream_next_, first_);
}

std::size_t InputOutbox::put(v1::InputBatch& batch, std::uint32_t from) const {
    batch.set_first_sequence(from);
    std::size_t count = 0;
    for (auto at = inputs_.begin() + (from - first_); at != inputs_.end() && count < batch_max;
         ++at, count++)
        *batch.add_inputs() = *at;
    return count;
}

// How many of them were not said before.
std::size_t InputOutbox::said_until(std::uint32_t end) {
    if (end <= next_unsaid_) return 0;
    for (std::uint32_t k = next_unsaid_; k < end; k++) unanswered_.push_back(k);
    while (unanswered_.size() > unconfirmed_max) unanswered_.pop_front();
    const std::uint32_t fresh = end - std::exchange(next_unsaid_, end);
    if (next_unsaid_ - first_ > unconfirmed_max) {
        const std::uint32_t first = next_unsaid_ - static_cast<std::uint32_t>(unconfirmed_max);
        inputs_.erase(inputs_.begin(), inputs_.begin() + (first - first_));
        first_ = first;
    }
    return fresh;
}

std::size_t InputOutbox::take_for_stream(v1::InputBatch& batch) {
    const std::uint32_t from = next_for_stream();
    const auto end = static_cast<std::uint32_t>(from + put(batch, from));
    stream_next_ = end;
    const std::size_t fresh = said_until(end);
    if (!keeps_) {
        inputs_.erase(inputs_.begin(), inputs_.begin() + (end - first_));
        first_ = end;
    }
    return fresh;
}

std::size_t InputOutbox::take_for_datagram(v1::InputBatch& batch, Clock::time_point now) {
    const auto end = static_cast<std::uint32_t>(first_ + put(batch, first_));
    // What the stream says next must not follow what only a datagram said.
    if (end > next_for_stream()) stream_next_ = 0;
    if (first_ == next_unsaid_) open_since_ = now;
    return said_until(end);
}

}  // namespace jostle::client
