// SPDX-License-Identifier: MIT
#include "tools/load/passive_client_pool.h"

#include <sys/epoll.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace jostle::load {

using namespace std::chrono_literals;

namespace {

constexpr std::size_t scratch_bytes = 256 * 1024;
// Interval of tick() per client; slow readers need a finer one.
constexpr auto default_tick_period = 10ms, slow_reader_tick_period = 1ms;
constexpr auto think_period = 33ms;
constexpr int events_at_once = 256;

double thread_cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Clock::duration seconds(double s) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

// Selects evenly distributed clients: with a share of 0.01 the first of every hundred.
bool is_selected(int number, double share) {
    return share > 0 && std::floor(number * share) != std::floor((number - 1) * share);
}

}  // namespace

PassiveClientThread::PassiveClientThread(const LoadOptions& plan,
                                         const common::SocketAddress& address, int first, int step,
                                         Clock::time_point begun)
    : plan_(plan), address_(address), start_(begun), epoll_(epoll_create1(EPOLL_CLOEXEC)) {
    for (int number = first; number < plan.clients; number += step)
        members_.push_back(make_member(number, number == first));
    thread_ = std::thread([this] { run(); });
}

PassiveClientThread::~PassiveClientThread() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    close(epoll_);
}

PassiveClientThread::Member PassiveClientThread::make_member(int number, bool has_view) {
    const bool plays = !plan_.script.empty();
    PassiveClientOptions options{
        .world = plan_.world,
        .name = "load " + std::to_string(number + 1),
        .token = plan_.transport == Transport::websocket ? plan_.security.token : "",
        .spectator = !plays,
        .decodes = is_selected(number, plan_.decode_ratio) || (plays && has_view),
        .ack_every = plan_.ack_every,
        .interest = plan_.interest_of(number),
        .max_kbps = plan_.max_kbps,
        .read_rate = plan_.read_rate_of(number),
        .snapshot_hz = plan_.snapshot_hz,
        .precision = plan_.precision,
        .receives_data = plan_.data.is_on()};
    Member member{
        .client = std::make_unique<PassiveClient>(plan_, std::move(options), epoll_, metrics_),
        .behaviour = {},
        .data = DataTraffic(plan_.data, number),
        .joins_at = start_ + seconds(plan_.ramp * number / plan_.clients),
        .thinks_at = {}};
    if (plays)
        member.behaviour.emplace(line_for(plan_.script, number),
                                 static_cast<std::uint32_t>(number + 1));
    return member;
}

void PassiveClientThread::run() {
    const auto sweep_period = plan_.read_rate > 0 ? slow_reader_tick_period : default_tick_period;
    std::vector<std::uint8_t> scratch(scratch_bytes);
    std::array<epoll_event, events_at_once> events{};
    Clock::time_point next_sweep = Clock::now();
    double cpu_before = thread_cpu_seconds();
    while (!stop_) {
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(
            std::max(Clock::duration::zero(), next_sweep - Clock::now()));
        const int count =
            epoll_wait(epoll_, events.data(), events_at_once, static_cast<int>(wait.count()));
        if (measure_.exchange(false)) {
            metrics_.begin(Clock::now());
            cpu_before = thread_cpu_seconds();
        }
        for (int k = 0; k < count; k++)
            static_cast<PassiveClient*>(events[static_cast<std::size_t>(k)].data.ptr)
                ->on_event(scratch, Clock::now());
        if (const auto now = Clock::now(); now >= next_sweep) {
            tick_all(now);
            next_sweep = now + sweep_period;
        }
    }
    metrics_.end(Clock::now());
    metrics_.cpu_seconds = thread_cpu_seconds() - cpu_before;
}

void PassiveClientThread::tick_all(Clock::time_point now) {
    int joined = 0;
    for (Member& member : members_) {
        if (!member.client->began()) {
            if (now >= member.joins_at) member.client->connect(address_);
            continue;
        }
        if (member.behaviour && now >= member.thinks_at) think(member, now);
        PassiveClientProtocol& protocol = member.client->protocol();
        if (member.client->joined()) protocol.play(member.data.take(now, protocol.client_id()));
        member.client->tick(now);
        joined += member.client->joined() ? 1 : 0;
    }
    joined_.store(joined, std::memory_order_relaxed);
    snapshots_.store(metrics_.snapshots, std::memory_order_relaxed);
    inputs_.store(metrics_.inputs_sent, std::memory_order_relaxed);
}

void PassiveClientThread::think(Member& member, Clock::time_point now) {
    const client::WorldView* view = members_.front().client->protocol().view();
    if (view == nullptr || !member.client->joined() || view->frame().frame == 0) return;
    member.thinks_at = now + think_period;
    const double since = std::chrono::duration<double>(now - start_).count();
    PassiveClientProtocol& protocol = member.client->protocol();
    protocol.play(member.behaviour->act(since, *view, protocol.client_id()));
}

ClientPool::Progress PassiveClientThread::progress() const {
    return {joined_.load(std::memory_order_relaxed), snapshots_.load(std::memory_order_relaxed),
            inputs_.load(std::memory_order_relaxed)};
}

LoadMetrics PassiveClientThread::end() {
    stop_ = true;
    thread_.join();
    members_.clear();  // closes the sockets
    return std::move(metrics_);
}

}  // namespace jostle::load
