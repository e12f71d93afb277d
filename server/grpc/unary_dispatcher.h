// SPDX-License-Identifier: MIT
//
// Handles all RPCs except play streams. Each call is limited in size, time and number before any
// work is done for it; work waits in short queues, and calls beyond a limit are rejected with a
// time to retry. Calls, requests and completions arrive on the completion queue of a play shard, on
// its thread. Responses are computed on four pools (quick calls, queries, changes, and calls that
// wait for a world), so that health checks and lists never wait for a query or a scene.
#pragma once

#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/async_generic_service.h>

#include <atomic>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "server/grpc/rpc_tag.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/metrics/rpc_metrics.h"
#include "server/services/call_method.h"
#include "server/util/clock.h"
#include "server/util/work_pool.h"

namespace jostle::server {

struct CallLimits {
    std::size_t calls_max = 256;        // open calls
    int calls_per_peer_max = 32;        // open calls per connection
    std::size_t queue_max = 64;         // queued calls per pool
    std::size_t open_streams_max = 64;  // streams and watches
    double response_bytes_max = 64e6;   // computed, but not yet read by their clients
    int waiting_threads = 2;            // for calls that wait for a world
    // For a request to arrive, and for a response to be read.
    Clock::duration timeout = std::chrono::seconds(10);
};

class UnaryDispatcher {
public:
    // The authorizer and `metrics` outlive the dispatcher; null metrics: no counting.
    UnaryDispatcher(std::vector<CallMethod> methods, Authorizer& authorizer, CallLimits limits,
                    RpcMetrics* metrics = nullptr);
    ~UnaryDispatcher();

    grpc::AsyncGenericService& service() { return service_; }
    // Call after the server and before the queue's thread is started; queue and `connections` must
    // outlive the dispatcher's calls.
    void start(grpc::ServerCompletionQueue& queue, const ConnectionTable& connections);
    // Call after the server and before the queue is shut down: no further operation is started.
    void stop();

    // For the queue's thread.
    void handle(RpcTag& tag, bool ok);
    void housekeep(Clock::time_point now);                   // does nothing before it is due
    Clock::time_point housekeeping() const { return due_; }  // when it is due
    void drop_all();                                         // call when the queue is drained

private:
    struct Call;
    struct Tag;

    void forget(Call& call);
    void request_call();
    void begin(Call& call);
    void on_read(Call& call, bool ok);
    void on_wrote(Call& call, bool ok);
    void enqueue(Call& call);
    void respond(Call& call);
    void finish(Call& call, const Status& status);
    WorkPool& pool_of(const CallMethod& method);
    void count(const Call& call, grpc::StatusCode code) const;
    void notify_watches();
    void cancel_timed_out(Clock::time_point now);
    Status admit(Call& call) const;
    Status authorize(Call& call) const;
    CallContext context_of(const Call& call) const;

    const std::map<std::string, CallMethod> methods_;  // by path
    Authorizer& authorizer_;
    const CallLimits limits_;
    RpcMetrics* const metrics_;
    grpc::AsyncGenericService service_;
    grpc::ServerCompletionQueue* queue_ = nullptr;
    const ConnectionTable* connections_ = nullptr;
    Clock::time_point due_{};
    // including calls requested from gRPC that have not arrived
    std::list<std::unique_ptr<Call>> calls_;
    std::size_t open_ = 0, open_streams_ = 0;
    std::atomic<double> unsent_bytes_{0};
    std::atomic<bool> stopping_{false};
    WorkPool quick_pool_, query_pool_, mutation_pool_, blocking_pool_;
};

}  // namespace jostle::server
