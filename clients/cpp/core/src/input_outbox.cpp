// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/input_outbox.h"

#include <algorithm>
#include <utility>

namespace jostle::client {
namespace {

// Limit for servers that do not confirm: the oldest inputs are not sent again.
constexpr std::size_t unconfirmed_max = 8192;

}  // namespace

void InputOutbox::start_new_session() {
    inputs_.erase(inputs_.begin(), inputs_.begin() + (next_unsent_ - first_));
    first_ = next_unsent_ = 1;
    next_ = 1 + static_cast<std::uint32_t>(inputs_.size());
    stream_next_ = 0;
    unconfirmed_since_ = {};
    awaiting_result_.clear();
    resumed_ = false;
}

void InputOutbox::resume_after(std::uint32_t last_sequence, Clock::time_point now) {
    confirm(last_sequence, now);
    stream_next_ = 0;
    unconfirmed_since_ = {};
    resumed_ = true;
}

void InputOutbox::drop_unsent() {
    inputs_.erase(inputs_.begin() + (next_unsent_ - first_), inputs_.end());
    next_ = next_unsent_;
}

std::uint32_t InputOutbox::push(v1::Input input) {
    if (next_ - next_unsent_ >= waiting_max) return 0;
    inputs_.push_back(std::move(input));
    return next_++;
}

void InputOutbox::confirm(std::uint32_t received, Clock::time_point now) {
    // The server's number is untrusted.
    const std::uint32_t end = std::min(received, last_sent());
    if (end < first_) return;
    inputs_.erase(inputs_.begin(), inputs_.begin() + (end + 1 - first_));
    first_ = end + 1;
    unconfirmed_since_ = now;
}

bool InputOutbox::on_result(std::uint32_t sequence, Clock::time_point now) {
    const auto at = std::ranges::lower_bound(awaiting_result_, sequence);
    if (at == awaiting_result_.end() || *at != sequence) return !resumed_;
    awaiting_result_.erase(at);
    // An earlier input may still wait to be persisted: if the server restarts, it must be sent
    // again.
    confirm(awaiting_result_.empty() ? last_sent() : awaiting_result_.front() - 1, now);
    return true;
}

bool InputOutbox::fits(std::size_t bytes_max) const {
    if (inputs_.size() > batch_max) return false;
    std::size_t bytes = 0;
    for (const v1::Input& input : inputs_) bytes += input.ByteSizeLong() + 4;  // tag and length
    return bytes <= bytes_max;
}

bool InputOutbox::is_stalled(Clock::duration timeout, Clock::time_point now) const {
    return first_ < next_unsent_ && unconfirmed_since_ != Clock::time_point{} &&
           now - unconfirmed_since_ > timeout;
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

// Returns the number of inputs sent for the first time.
std::size_t InputOutbox::mark_sent_until(std::uint32_t end) {
    if (end <= next_unsent_) return 0;
    for (std::uint32_t k = next_unsent_; k < end; k++) awaiting_result_.push_back(k);
    while (awaiting_result_.size() > unconfirmed_max) awaiting_result_.pop_front();
    const std::uint32_t fresh = end - std::exchange(next_unsent_, end);
    if (next_unsent_ - first_ > unconfirmed_max) {
        const std::uint32_t first = next_unsent_ - static_cast<std::uint32_t>(unconfirmed_max);
        inputs_.erase(inputs_.begin(), inputs_.begin() + (first - first_));
        first_ = first;
    }
    return fresh;
}

std::size_t InputOutbox::take_for_stream(v1::InputBatch& batch) {
    const std::uint32_t from = next_for_stream();
    const auto end = static_cast<std::uint32_t>(from + put(batch, from));
    stream_next_ = end;
    const std::size_t fresh = mark_sent_until(end);
    if (!retains_) {
        inputs_.erase(inputs_.begin(), inputs_.begin() + (end - first_));
        first_ = end;
    }
    return fresh;
}

std::size_t InputOutbox::take_for_datagram(v1::InputBatch& batch, Clock::time_point now) {
    const auto end = static_cast<std::uint32_t>(first_ + put(batch, first_));
    // The stream must not continue after inputs that only a datagram carried.
    if (end > next_for_stream()) stream_next_ = 0;
    if (first_ == next_unsent_) unconfirmed_since_ = now;
    return mark_sent_until(end);
}

}  // namespace jostle::client
