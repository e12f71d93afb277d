// SPDX-License-Identifier: MIT
//
// All RPCs but the play streams, behind one door: each call is bounded in size, time and number
// before any work is done for it, the work waits in short queues, and what has no room is told to
// come again. Calls, requests and endings come off the completion queue of a play shard, on its
// thread; answers are made on the threads of four pools: what is quick, what asks worlds, what
// changes them and what waits for them, so that health and lists never wait for a question or a
// scene.
#pragma once

#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/async_generic_service.h>

#include <atomic>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "server/grpc/call_method.h"
#include "server/grpc/rpc_tag.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/metrics/rpc_metrics.h"
#include "server/util/clock.h"
#include "server/util/work_pool.h"

namespace jostle::server {

struct CallLimits {
    std::size_t calls_max = 256;        // open at once
    int calls_per_peer_max = 32;        // of one connection
    std::size_t queue_max = 64;         // that wait for a thread, of each pool
    std::size_t open_streams_max = 64;  // streams and watches
    double response_bytes_max = 64e6;   // made but not yet taken by their clients
    int waiting_threads = 2;            // for what waits for a world
    // For a request to come in, and for an answer to be taken.
    Clock::duration timeout = std::chrono::seconds(10);
};

class UnaryDispatcher {
public:
    // The gate outlives the front, and so do `metrics`; null: nobody counts.
    UnaryDispatcher(std::vector<CallMethod> methods, Authorizer& authorizer, CallLimits limits,
                    RpcMetrics* metrics = nullptr);
    ~UnaryDispatcher();

    grpc::AsyncGenericService& service() { return service_; }
    // After the server was started, before the queue's thread is; queue and `connections` outlive
    // the front's calls.
    void start(grpc::ServerCompletionQueue& queue, const ConnectionTable& connections);
    // After the server was shut down, and before the queue is: nothing is begun any more.
    void stop();

    // For the thread of the queue.
    void handle(RpcTag& tag, bool ok);
    void housekeep(Clock::time_point now);                   // does nothing before it is due
    Clock::time_point housekeeping() const { return due_; }  // when it is
    void drop_all();                                         // the queue is empty

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
    std::list<std::unique_ptr<Call>> calls_;  // also those that were asked for and did not come
    std::size_t open_ = 0, open_streams_ = 0;
    std::atomic<double> unsent_bytes_{0};
    std::atomic<bool> stopping_{false};
    WorkPool quick_pool_, query_pool_, mutation_pool_, waiting_;
};

}  // namespace jostle::server
