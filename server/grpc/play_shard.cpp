// SPDX-License-Identifier: MIT
#include "server/grpc/play_shard.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Sufficient for timeouts and statistics; frames and messages wake the thread directly.
constexpr auto shard_housekeeping_period = std::chrono::milliseconds(50);
// For a shard without streams: each wake-up costs an idle server.
constexpr auto idle_shard_period = std::chrono::milliseconds(250);
// Calls that can arrive at the same time without waiting for the thread.
constexpr std::size_t plays_requested = 16;
constexpr std::size_t streams_without_hello_max = 256;
constexpr std::size_t streams_without_hello_of_address_max = 64;
// An alarm for the current time would wait for the next millisecond and wake the threads of gRPC's
// timers.
const gpr_timespec long_ago = gpr_inf_past(GPR_CLOCK_MONOTONIC);

}  // namespace

PlayShard::PlayShard(PlayContext& context, RawPlayService& service,
                     const ConnectionTable& connections,
                     std::unique_ptr<grpc::ServerCompletionQueue> queue)
    : context_(context), service_(service), connections_(connections), queue_(std::move(queue)) {}

PlayShard::~PlayShard() {
    stop();
}

void PlayShard::start(UnaryDispatcher* dispatcher) {
    ASSERT(!thread_.joinable());
    dispatcher_ = dispatcher;
    for (std::size_t i = 0; i < plays_requested; ++i) request_call();
    thread_ = std::thread([this] { run(); });
}

// The client limit of the server covers streams after their Hello; this limit covers the others.
std::size_t PlayShard::streams_max() const {
    return static_cast<std::size_t>(context_.config.world.clients_max) + streams_without_hello_max;
}

// No single address may use the entire limit of streams without a Hello.
bool PlayShard::too_many_without_hello_from(const std::string& network) const {
    const auto same = std::ranges::count_if(streams_, [&](const auto& stream) {
        return !stream->session().hello_received() && stream->network() == network;
    });
    return static_cast<std::size_t>(same) >= streams_without_hello_of_address_max;
}

void PlayShard::request_call() {
    waiting_.push_back(std::make_unique<PlayStream>(service_, *queue_));
}

// An alarm that is due at once is gRPC's way to post an external event to a completion queue. Its
// tag is null.
void PlayShard::wake() {
    if (streams() == 0) return;
    const std::lock_guard lock(wake_mutex_);
    if (stopping_ || awake_.exchange(true)) return;
    alarm_.Set(queue_.get(), long_ago, nullptr);
}

// Its tag is the alarm itself.
void PlayShard::wake_for_datagrams() {
    const std::lock_guard lock(wake_mutex_);
    if (stopping_ || datagrams_came_.exchange(true)) return;
    datagram_alarm_.Set(queue_.get(), long_ago, &datagram_alarm_);
}

void PlayShard::stop() {
    {
        const std::lock_guard lock(wake_mutex_);
        if (stopping_) return;
        stopping_ = true;
    }
    if (thread_.joinable()) {
        thread_.join();
    } else {
        run();  // never started; gRPC still requires that the queue is drained
    }
}

void PlayShard::run() {
    housekeeping_ = Clock::now() + idle_shard_period;
    bool shut_down = false;
    for (;;) {
        // Shut down on this thread, which starts all calls, reads and writes: gRPC aborts the
        // process if an operation is started on a queue that shuts down.
        if (stopping_ && !shut_down) {
            const std::lock_guard lock(wake_mutex_);
            queue_->Shutdown();
            shut_down = true;
        }
        void* tag = nullptr;
        bool ok = false;
        // gRPC takes deadlines on the system clock; only the difference matters.
        const Clock::time_point due =
            dispatcher_ ? std::min(housekeeping_, dispatcher_->housekeeping()) : housekeeping_;
        const auto wait = std::max(Clock::duration::zero(), due - Clock::now());
        const auto deadline = std::chrono::system_clock::now() + wait;
        const auto next = queue_->AsyncNext(&tag, &ok, deadline);
        if (next == grpc::CompletionQueue::SHUTDOWN) break;

        const Clock::time_point now = Clock::now();
        if (next == grpc::CompletionQueue::GOT_EVENT) {
            if (tag == &datagram_alarm_) {
                datagrams_came_ = false;  // before processing, as below
                if (!stopping_) advance_with_datagrams(now);
            } else if (tag != nullptr) {
                dispatch(*static_cast<RpcTag*>(tag), ok, now);
            } else if (!stopping_) {
                // before processing: a frame that arrives meanwhile wakes the thread again
                awake_ = false;
                advance_all();
            }
        }
        if (dispatcher_) dispatcher_->housekeep(now);
        if (now >= housekeeping_ && !stopping_) {
            housekeep();
            housekeeping_ = now + (streams_.empty() ? Clock::duration(idle_shard_period)
                                                    : Clock::duration(shard_housekeeping_period));
        }
    }
    streams_.clear();
    waiting_.clear();
    if (dispatcher_) dispatcher_->drop_all();
}

void PlayShard::dispatch(RpcTag& tag, bool ok, Clock::time_point now) {
    ASSERT(tag.owner != RpcTag::Owner::call || dispatcher_);
    if (tag.owner == RpcTag::Owner::call)
        dispatcher_->handle(tag, ok);
    else
        handle(static_cast<PlayTag&>(tag), ok, now);
}

void PlayShard::handle(PlayTag& tag, bool ok, Clock::time_point now) {
    ASSERT(tag.stream);
    PlayStream& stream = *tag.stream;
    if (stopping_)
        // no operation may be started on a queue that shuts down
        return stream.on_shutdown(tag.event);
    switch (tag.event) {
        case PlayTag::Event::accepted: {
            const auto at =
                std::find_if(waiting_.begin(), waiting_.end(),
                             [&](const auto& waiting) { return waiting.get() == &stream; });
            ASSERT(at != waiting_.end());
            std::unique_ptr<PlayStream> owned = std::move(*at);
            waiting_.erase(at);
            if (!ok) return;  // the server is shutting down
            request_call();
            owned->begin(
                context_, connections_, overload_, [this] { wake_for_datagrams(); }, now);
            if (streams_.size() >= streams_max() || too_many_without_hello_from(owned->network()))
                owned->session().refuse(Error{ErrorCode::resource_exhausted, "too many streams"},
                                        now);
            streams_.push_back(std::move(owned));
            housekeeping_ = std::min(housekeeping_, now + shard_housekeeping_period);
            stream_count_.store(streams_.size(), std::memory_order_relaxed);
            break;
        }
        case PlayTag::Event::read:
            stream.on_read(ok, now);
            break;
        case PlayTag::Event::wrote:
            stream.on_wrote(ok, now);
            break;
        case PlayTag::Event::finished:
            stream.on_finished();
            break;
    }
}

void PlayShard::housekeep() {
    advance_all();
    drop_finished();
}

// Each round starts with the next client: with many clients the last one waits longest, and it
// should not always be the same one. A round takes a while, so each client has its own time.
void PlayShard::advance_all() {
    const std::size_t count = streams_.size();
    if (count == 0) return;
    first_ = (first_ + 1) % count;
    ASSERT(first_ < count);
    for (std::size_t i = 0; i < count; ++i) streams_[(first_ + i) % count]->advance(Clock::now());
}

void PlayShard::advance_with_datagrams(Clock::time_point now) {
    for (const auto& stream : streams_)
        if (stream->session().has_datagrams()) stream->advance(now);
}

void PlayShard::drop_finished() {
    std::erase_if(streams_, [](const auto& stream) { return stream->is_finished(); });
    stream_count_.store(streams_.size(), std::memory_order_relaxed);
}

}  // namespace jostle::server
