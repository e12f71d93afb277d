// SPDX-License-Identifier: MIT
#include "tools/load/library_client_pool.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

namespace jostle::load {

using namespace std::chrono_literals;

namespace {

constexpr auto play_period = 33ms;
constexpr auto leave_delay = 200ms;  // for the last messages to be sent

std::vector<std::string> topics_of(const DataOptions& data) {
    if (!data.is_on()) return {};
    return {chat_topic};
}

}  // namespace

LibraryClientThread::LibraryClientThread(const LoadOptions& plan, int first, int step,
                                         Clock::time_point begun)
    : options_(plan), first_(first), step_(step), start_(begun), thread_([this] { run(); }) {}

LibraryClientThread::~LibraryClientThread() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
}

void LibraryClientThread::run() {
    while (!stop_) {
        const auto now = Clock::now();
        if (measure_.exchange(false)) begin_measurement(now);
        join_due(now);
        think(now);
        std::this_thread::sleep_until(now + play_period);
    }
    count();
    for (const Member& member : members_) member.bot->client().leave();
    std::this_thread::sleep_for(leave_delay);
}

void LibraryClientThread::join_due(Clock::time_point now) {
    const double since = std::chrono::duration<double>(now - start_).count();
    for (;;) {
        const int number = first_ + step_ * static_cast<int>(members_.size());
        if (number >= options_.clients || since < options_.ramp * number / options_.clients) return;
        members_.push_back(
            {std::make_unique<bot::Bot>(
                 loop_,
                 client::ClientOptions{.target = options_.target,
                                       .security = options_.security,
                                       .world = options_.world,
                                       .name = "load " + std::to_string(number + 1),
                                       .snapshot_hz = options_.snapshot_hz,
                                       .players = options_.data.is_on(),
                                       .attributes = options_.data.is_on(),
                                       .topics = topics_of(options_.data),
                                       .max_kbps = options_.max_kbps,
                                       .interest = options_.interest_of(number),
                                       .precision = options_.precision,
                                       .datagrams = options_.datagrams},
                 line_for(options_.script, number), static_cast<std::uint32_t>(number + 1)),
             {},
             DataTraffic(options_.data, number)});
    }
}

void LibraryClientThread::think(Clock::time_point now) {
    int joined = 0;
    std::uint64_t snapshots = 0, inputs = 0;
    for (Member& member : members_) {
        member.bot->think(now);
        const client::ClientStats before = member.bot->client().stats();
        if (before.connected)
            for (v1::Input& input : member.data.take(now, before.client_id))
                member.bot->client().send(std::move(input));
        collect(member, now);
        const client::ClientStats stats = member.bot->client().stats();
        joined += stats.connected ? 1 : 0;
        snapshots += stats.snapshots;
        inputs += stats.inputs_sent;
    }
    joined_.store(joined, std::memory_order_relaxed);
    snapshots_.store(snapshots, std::memory_order_relaxed);
    inputs_.store(inputs, std::memory_order_relaxed);
}

// Rejections that valid clients can encounter are not errors: a body that was removed meanwhile, a
// full world.
void LibraryClientThread::collect(Member& member, Clock::time_point now) {
    client::Client& client = member.bot->client();
    for (const auto& result : client.take_results())
        if (result.code() == v1::INPUT_CODE_INVALID || result.code() == v1::INPUT_CODE_NOT_ALLOWED)
            metrics_.add_error(result.message());
    for (const v1::UserMessage& message : client.take_messages()) {
        metrics_.user_messages++;
        if (const auto sent = sent_us(message.data()))
            metrics_.message_delay.add(static_cast<std::int64_t>(client::to_us(now) - *sent));
    }
    for (const float age : client.take_ages_ms())
        metrics_.add_age(static_cast<std::int64_t>(1000 * age), now);
}

void LibraryClientThread::begin_measurement(Clock::time_point now) {
    for (Member& member : members_) {
        collect(member, now);
        member.before = member.bot->client().stats();
    }
    metrics_.begin(now);
}

void LibraryClientThread::count() {
    for (const Member& member : members_) {
        const client::ClientStats now = member.bot->client().stats(), &before = member.before;
        metrics_.snapshots += now.snapshots - before.snapshots;
        metrics_.bytes += now.bytes_received - before.bytes_received;
        metrics_.inputs_sent += now.inputs_sent - before.inputs_sent;
        metrics_.inputs_applied += now.inputs_applied - before.inputs_applied;
        metrics_.messages_missed += now.messages_missed - before.messages_missed;
        metrics_.errors += now.stream_failures + now.decode_errors;
        if (!now.last_error.empty()) metrics_.last_error = now.last_error;
    }
    metrics_.decoded = metrics_.snapshots;
    metrics_.end(Clock::now());
}

ClientPool::Progress LibraryClientThread::progress() const {
    return {joined_.load(std::memory_order_relaxed), snapshots_.load(std::memory_order_relaxed),
            inputs_.load(std::memory_order_relaxed)};
}

LoadMetrics LibraryClientThread::end() {
    stop_ = true;
    thread_.join();
    return std::move(metrics_);
}

}  // namespace jostle::load
