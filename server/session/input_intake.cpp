// SPDX-License-Identifier: MIT
#include "server/session/input_intake.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <iterator>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr std::int64_t margin_us_max = 1'000'000'000;
constexpr int queue_full_retry_ms = 100;  // the queue is empty again after a few ticks

}  // namespace

std::int32_t clamp_margin(std::int64_t margin_us) {
    return static_cast<std::int32_t>(std::clamp(margin_us, -margin_us_max, margin_us_max));
}

InputIntake::InputIntake(CommandMailbox& mailbox, const Source& source, const ClientLimits& limits,
                         std::shared_ptr<ResultQueue> queue, Clock::time_point now)
    : mailbox_(mailbox),
      source_(source),
      inputs_per_batch_max_(static_cast<std::size_t>(limits.inputs_per_batch_max)),
      admission_(limits, source.spectator, now),
      queue_(std::move(queue)) {
    ASSERT(source_.client != 0);
    ASSERT(queue_ != nullptr);
}

Status InputIntake::receive(const InputBatch& batch, std::uint32_t tick, Clock::time_point now) {
    if (batch.inputs.size() > inputs_per_batch_max_)
        return Error{ErrorCode::invalid_argument,
                     fmt::format("input.inputs has {} entries; at most {} are allowed",
                                 batch.inputs.size(), inputs_per_batch_max_)};
    ASSERT(batch.ticks.size() >= batch.inputs.size());
    client_time_us_ = batch.client_time_us;
    std::uint32_t sequence = batch.first_sequence;
    for (std::size_t k = 0; k < batch.inputs.size(); k++, sequence++) {
        // Repeated inputs are neither applied again nor do they yield another result.
        if (sequence <= last_sequence_) continue;
        last_sequence_ = sequence;
        Status status = push(sequence, batch.inputs[k], batch.ticks[k], now);
        if (!status.ok())
            results_.push_back({.sequence = sequence, .status = std::move(status), .tick = tick});
    }
    return {};
}

Status InputIntake::push(std::uint32_t sequence, const Result<Action>& input, std::uint32_t tick,
                         Clock::time_point now) {
    if (!input.ok()) return Error{ErrorCode::invalid_argument, input.error().message};
    if (Status status = admission_.admit_input(*input, now); !status.ok()) return status;
    if (!mailbox_.push({.client = source_.client,
                        .account = source_.account,
                        .sequence = sequence,
                        .action = *input,
                        .reply = queue_,
                        .received = now,
                        .tick = tick}))
        return Error{ErrorCode::resource_exhausted,
                     "the input queue of the world is full; send the input again later",
                     queue_full_retry_ms};
    return {};
}

void InputIntake::collect_results() {
    std::vector<InputResult> fresh = queue_->take();
    for (const InputResult& result : fresh) {
        datagram_result_.sequence = std::max(datagram_result_.sequence, result.sequence);
        if (result.status.ok() || result.status.error().code != ErrorCode::unavailable)
            persisted_sequence_ = std::max(persisted_sequence_, result.sequence);
        datagram_result_.margin_us =
            clamp_margin(result.margin_us.value_or(datagram_result_.margin_us));
    }
    ASSERT(persisted_sequence_ <= last_sequence_);
    results_.insert(results_.end(), std::make_move_iterator(fresh.begin()),
                    std::make_move_iterator(fresh.end()));
}

void InputIntake::resume(std::uint32_t last_sequence, std::uint32_t persisted_sequence,
                         std::vector<InputResult> results) {
    ASSERT(last_sequence_ == 0 && results_.empty());
    ASSERT(persisted_sequence <= last_sequence);
    last_sequence_ = last_sequence;
    persisted_sequence_ = persisted_sequence;
    results_ = std::move(results);
}

}  // namespace jostle::server
