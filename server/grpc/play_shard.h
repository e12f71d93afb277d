// SPDX-License-Identifier: MIT
//
// A network thread: a completion queue and the play streams that arrived on it. One of the shards
// also handles all other calls (unary_dispatcher.h), because gRPC lets any waiting queue thread
// read all connections, and would have to wake another thread for foreign events. All reading,
// encoding and writing for these clients happens on this thread, so that nothing is locked and no
// write wakes another thread. The thread sleeps until gRPC has an event, a world has a new frame,
// or housekeeping is due.
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/server_builder.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "server/grpc/play_stream.h"
#include "server/grpc/unary_dispatcher.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/limits/overload_control.h"

namespace jostle::server {

class PlayShard {
public:
    // The queue comes from the ServerBuilder that registered the service. All arguments must
    // outlive the shard.
    PlayShard(PlayContext& context, RawPlayService& service, const ConnectionTable& connections,
              std::unique_ptr<grpc::ServerCompletionQueue> queue);
    ~PlayShard();

    // Call after the server was started. `dispatcher`: its calls arrive on this shard; null: on
    // another shard.
    void start(UnaryDispatcher* dispatcher);
    grpc::ServerCompletionQueue& queue() { return *queue_; }
    // Any thread: a world has a new frame, or the context has started to drain. Cheap if the shard
    // is already awake or has no stream.
    void wake();
    // Any thread: datagrams arrived for some of the streams.
    void wake_for_datagrams();
    // Call after the server was shut down: drains the queue and ends the thread.
    void stop();

    // Any thread; may be slightly outdated.
    std::size_t streams() const { return stream_count_.load(std::memory_order_relaxed); }

private:
    void run();
    void dispatch(RpcTag& tag, bool ok, Clock::time_point now);
    void handle(PlayTag& tag, bool ok, Clock::time_point now);
    void advance_all();
    void advance_with_datagrams(Clock::time_point now);
    void housekeep();
    void drop_finished();
    void request_call();
    std::size_t streams_max() const;
    bool too_many_without_hello_from(const std::string& network) const;

    PlayContext& context_;
    RawPlayService& service_;
    const ConnectionTable& connections_;
    std::unique_ptr<grpc::ServerCompletionQueue> queue_;
    UnaryDispatcher* dispatcher_ = nullptr;
    OverloadControl overload_;                          // outlives the streams
    std::vector<std::unique_ptr<PlayStream>> waiting_;  // requested from gRPC, without a client yet
    std::vector<std::unique_ptr<PlayStream>> streams_;
    std::size_t first_ = 0;  // the stream that starts the next round
    Clock::time_point housekeeping_{};
    std::atomic<std::size_t> stream_count_{0};
    grpc::Alarm alarm_, datagram_alarm_;
    std::atomic<bool> datagrams_came_{false};  // like awake_, for the other alarm
    std::mutex wake_mutex_;                    // no alarm may be set on a queue that shuts down
    std::atomic<bool> awake_{false};           // an alarm is set and not processed yet
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::server
