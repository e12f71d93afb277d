// SPDX-License-Identifier: MIT
#include "server/session/session_metrics.h"

#include <string>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

InputOutcome outcome_of(const Status& status) {
    if (status.ok()) return InputOutcome::applied;
    switch (status.error().code) {
        case ErrorCode::not_found:
            return InputOutcome::not_found;
        case ErrorCode::permission_denied:
            return InputOutcome::not_allowed;
        case ErrorCode::resource_exhausted:
            return InputOutcome::limit;
        default:
            return InputOutcome::invalid;
    }
}

void count_more(prometheus::Counter& counter, std::uint32_t total, std::uint32_t& counted) {
    ASSERT(total >= counted);
    if (total != counted) counter.Increment(total - counted);
    counted = total;
}

}  // namespace

void SessionMetrics::entered(ClientIdentity who, WorldHost& world) {
    ASSERT(client_ == 0 && who.id != 0);
    client_ = who.id;
    who.subject = subject_;
    connected_client_ = context_.connected_clients.add(std::move(who));
    world_ = world.tick_metrics().metrics();
    if (world_) world_->clients().Increment();
}

void SessionMetrics::left() {
    flush_traffic();
    if (client_ == 0) return;
    context_.connected_clients.remove(std::exchange(client_, 0));
    connected_client_ = nullptr;
    if (world_) world_->clients().Decrement();
    world_ = nullptr;
    count_in_class(std::nullopt);
}

void SessionMetrics::refused(ErrorCode reason) {
    if (context_.metrics) context_.metrics->refusals[reason].Increment();
}

void SessionMetrics::answered(std::span<const InputResult> results) {
    if (!context_.metrics) return;
    for (const InputResult& result : results)
        context_.metrics->inputs[outcome_of(result.status)].Increment();
}

void SessionMetrics::sent(const OutMessage& message, Clock::time_point now) {
    if (connected_client_) connected_client_->count_sent(message.size(), now);
    if (now < next_flush_) return;
    next_flush_ = now + std::chrono::seconds(1);
    flush_traffic();
}

void SessionMetrics::sent_other(const OutMessage& message) {
    const TrafficKind kind = message.shared ? TrafficKind::entities : TrafficKind::replies;
    traffic_[static_cast<std::size_t>(kind)] += message.size();
}

void SessionMetrics::add_traffic(TrafficKind rest, std::size_t bytes, const TrafficBytes& traffic) {
    for (std::size_t kind = 0; kind < traffic_kinds; kind++) {
        ASSERT(traffic[kind] <= bytes);
        traffic_[kind] += traffic[kind];
        bytes -= traffic[kind];
    }
    traffic_[static_cast<std::size_t>(rest)] += bytes;
}

void SessionMetrics::flush_traffic() {
    if (context_.metrics)
        for (std::size_t kind = 0; kind < traffic_kinds; kind++)
            if (traffic_[kind] > 0)
                context_.metrics->sent_bytes[static_cast<TrafficKind>(kind)].Increment(
                    static_cast<double>(traffic_[kind]));
    traffic_ = {};
}

void SessionMetrics::sent_update(std::size_t bytes, const TrafficBytes& traffic) {
    add_traffic(TrafficKind::results, bytes, traffic);
}

void SessionMetrics::sent_snapshot(std::size_t bytes, std::size_t channels,
                                   const TrafficBytes& traffic) {
    TrafficBytes parts = traffic;
    parts[static_cast<std::size_t>(TrafficKind::channels)] += channels;
    add_traffic(TrafficKind::poses, bytes, parts);
    if (!context_.metrics) return;
    context_.metrics->snapshots_sent.Increment();
    context_.metrics->snapshot_bytes.Increment(static_cast<double>(bytes));
}

void SessionMetrics::encoded_snapshot() {
    if (context_.metrics) context_.metrics->snapshot_encodings.Increment();
}

void SessionMetrics::on_frame(const SnapshotSchedule& schedule) {
    const FlowControl& flow = schedule.flow();
    if (connected_client_) connected_client_->set_flow(schedule.skipped(), flow.round_trip_s());
    if (!context_.metrics) return;
    const auto& skipped = context_.metrics->snapshots_skipped;
    count_more(skipped[SkipReason::window], flow.skipped(), counted_.window);
    count_more(skipped[SkipReason::pending], schedule.skipped_pending(), counted_.pending);
    count_more(skipped[SkipReason::rate], flow.rate_skipped(), counted_.rate);
    count_more(skipped[SkipReason::encodings], schedule.deferred(), counted_.encodings);
    if (client_ != 0) count_in_class(flow.served_class());
}

// Nothing: the client left.
void SessionMetrics::count_in_class(std::optional<int> number) {
    if (!context_.metrics || number == counted_class_) return;
    const auto size_of = [&](int of) -> prometheus::Gauge& {
        const int divisor = Cadence::divisors[static_cast<std::size_t>(of)];
        return context_.metrics->cadence_clients.Add({{"divisor", std::to_string(divisor)}});
    };
    if (counted_class_) size_of(*counted_class_).Decrement();
    if (number) size_of(*number).Increment();
    counted_class_ = number;
}

std::optional<std::string> SessionMetrics::kicked() const {
    return connected_client_ ? connected_client_->kicked() : std::nullopt;
}

}  // namespace jostle::server
