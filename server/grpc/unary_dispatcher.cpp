// SPDX-License-Identifier: MIT
#include "server/grpc/unary_dispatcher.h"

#include <algorithm>
#include <optional>

#include "jostle/base/check.h"
#include "server/grpc/conversions.h"
#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

// Period of checks for timeouts and watches, and without calls.
constexpr auto dispatcher_housekeeping_period = std::chrono::milliseconds(100);
constexpr auto idle_dispatcher_period = std::chrono::seconds(1);
// Calls that can arrive at the same time without waiting for the thread.
constexpr int calls_requested = 16;
// Queries and changes run at a lower priority than play streams.
constexpr int query_niceness = 10, mutation_niceness = 5;

Error too_much(std::string what) {
    return {ErrorCode::resource_exhausted, std::move(what) + "; retry in 1 s"};
}

}  // namespace

struct UnaryDispatcher::Tag : RpcTag {
    enum class Event { accepted, read, wrote, finished, done };

    Tag(Call* of_call, Event of_event) : RpcTag(Owner::call), call(of_call), event(of_event) {}

    Call* call;
    Event event;
};

// Owned by the queue's thread, except while a pool thread responds; the write that the pool thread
// starts returns the ownership.
struct UnaryDispatcher::Call {
    grpc::GenericServerContext context;
    grpc::GenericServerAsyncReaderWriter stream{&context};
    Tag accepted{this, Tag::Event::accepted}, read{this, Tag::Event::read},
        wrote{this, Tag::Event::wrote}, finished{this, Tag::Event::finished},
        done{this, Tag::Event::done};
    const CallMethod* method = nullptr;
    std::shared_ptr<Connection> connection;
    std::string address;  // of the client
    std::string request;
    Clock::time_point since{};  // time of arrival
    Identity who;
    grpc::ByteBuffer incoming;
    ResponseBytes last_sent;  // of a watch: the last response
    double unsent = 0;
    std::atomic<Clock::rep> waiting_since{0};  // for its client; 0: not waiting
    std::atomic<bool> is_cancelled{false};
    bool begun = false, has_request = false, writing = false, finishing = false;
    bool is_finished = false, is_done = false;

    bool over() const { return is_finished && is_done; }
    void start_waiting() { waiting_since = Clock::now().time_since_epoch().count(); }
};

UnaryDispatcher::UnaryDispatcher(std::vector<CallMethod> methods, Authorizer& authorizer,
                                 CallLimits limits, RpcMetrics* metrics)
    : methods_([&] {
          std::map<std::string, CallMethod> by_path;
          for (CallMethod& method : methods) by_path.emplace(method.path, std::move(method));
          return by_path;
      }()),
      authorizer_(authorizer),
      limits_(limits),
      metrics_(metrics),
      quick_pool_(1, limits.queue_max, 0),
      query_pool_(1, limits.queue_max, query_niceness),
      mutation_pool_(1, limits.queue_max, mutation_niceness),
      blocking_pool_(limits.waiting_threads, limits.queue_max, 0) {}

UnaryDispatcher::~UnaryDispatcher() {
    stop();
}

void UnaryDispatcher::start(grpc::ServerCompletionQueue& queue,
                            const ConnectionTable& connections) {
    ASSERT(!queue_);
    queue_ = &queue;
    connections_ = &connections;
    due_ = Clock::now() + dispatcher_housekeeping_period;
    for (int i = 0; i < calls_requested; i++) request_call();
}

// The pools stop first: their responses start operations, which a queue that shuts down forbids.
void UnaryDispatcher::stop() {
    if (stopping_.exchange(true)) return;
    quick_pool_.stop();
    query_pool_.stop();
    mutation_pool_.stop();
    blocking_pool_.stop();
}

void UnaryDispatcher::request_call() {
    ASSERT(queue_);
    calls_.push_back(std::make_unique<Call>());
    Call& call = *calls_.back();
    call.context.AsyncNotifyWhenDone(&call.done);
    service_.RequestCall(&call.context, &call.stream, queue_, queue_, &call.accepted);
}

// No operation is started while the dispatcher stops: the server has cancelled all open calls.
void UnaryDispatcher::handle(RpcTag& any, bool ok) {
    Tag& tag = static_cast<Tag&>(any);
    Call& call = *tag.call;
    ASSERT(any.owner == RpcTag::Owner::call);
    switch (tag.event) {
        case Tag::Event::accepted:
            // Not ok: the server is shutting down; such a call gets no other event.
            if (!ok) call.is_finished = call.is_done = true;
            if (!ok || stopping_) break;
            request_call();
            begin(call);
            break;
        case Tag::Event::read:
            call.waiting_since = 0;
            if (!stopping_) on_read(call, ok);
            break;
        case Tag::Event::wrote:
            call.writing = false;
            call.waiting_since = 0;
            unsent_bytes_.fetch_sub(std::exchange(call.unsent, 0));
            if (!stopping_) on_wrote(call, ok);
            break;
        case Tag::Event::finished:
            call.is_finished = true;
            unsent_bytes_.fetch_sub(std::exchange(call.unsent, 0));
            break;
        case Tag::Event::done:
            call.is_done = true;
            call.is_cancelled = call.context.IsCancelled();
            break;
    }
    if (call.over()) forget(call);
}

void UnaryDispatcher::forget(Call& call) {
    if (call.begun) {
        ASSERT(open_ > 0 && open_streams_ <= open_);
        open_--;
        call.connection->calls--;
        call.connection->unary_calls--;
        if (call.method && call.method->stays_open()) open_streams_--;
    }
    std::erase_if(calls_, [&](const auto& entry) { return entry.get() == &call; });
}

Status UnaryDispatcher::admit(Call& call) const {
    if (open_ > limits_.calls_max && !call.method->is_probe)
        return too_much("too many calls are open");
    if (!call.connection->is_proxy && call.connection->unary_calls > limits_.calls_per_peer_max)
        return too_much("too many calls are open on this connection");
    if (call.method->stays_open() && open_streams_ > limits_.open_streams_max)
        return too_much("too many streams of this kind are open");
    return authorize(call);
}

// Identifies the caller and authorizes the call. A call about a world is authorized later, when the
// world is known.
Status UnaryDispatcher::authorize(Call& call) const {
    Result<Identity> who = identify(call.context, *call.connection, call.address, authorizer_);
    if (!who.ok()) return who.error();
    call.who = *std::move(who);
    if (call.method->authorizes_world) return {};
    return authorizer_.admit(call.who, context_of(call).access_request({}));
}

CallContext UnaryDispatcher::context_of(const Call& call) const {
    ASSERT(call.method && call.connection);
    return {.authorizer = authorizer_,
            .call = std::string_view(call.method->path).substr(1),
            .who = call.who,
            .address = call.address,
            .deadline = call.context.deadline(),
            .is_cancelled = [&call] { return call.is_cancelled.load(); }};
}

void UnaryDispatcher::begin(Call& call) {
    ASSERT(!call.begun);
    call.begun = true;
    call.since = Clock::now();
    due_ = std::min(due_, call.since + dispatcher_housekeeping_period);
    call.connection = connections_->of(call.context.peer());
    call.address = client_address(call.context, *call.connection, *connections_);
    call.connection->calls_accepted++;
    call.connection->calls++;
    call.connection->unary_calls++;
    open_++;
    const auto known = methods_.find(call.context.method());
    if (known != methods_.end()) call.method = &known->second;
    if (call.method && call.method->stays_open()) open_streams_++;
    if (!call.method) {
        call.finishing = true;
        count(call, grpc::StatusCode::UNIMPLEMENTED);
        return call.stream.Finish({grpc::StatusCode::UNIMPLEMENTED,
                                   "there is no method " + printable(call.context.method(), 200)},
                                  &call.finished);
    }
    if (Status s = admit(call); !s.ok()) return finish(call, s);
    call.start_waiting();
    call.stream.Read(&call.incoming, &call.read);
}

void UnaryDispatcher::on_read(Call& call, bool ok) {
    if (!ok) {
        // The client sends no more: the regular end of a stream, an error for all other calls.
        if (call.method->work == CallWork::stream) return finish(call, {});
        return finish(call, Error{ErrorCode::invalid_argument, "the request is missing"});
    }
    ASSERT(call.method);
    const std::size_t size = call.incoming.Length();
    call.connection->consumed += size;
    if (size > call.method->request_bytes_max)
        return finish(call, Error{ErrorCode::resource_exhausted,
                                  fmt::format("the request has {} bytes; at most {} are allowed",
                                              size, call.method->request_bytes_max)});
    copy_bytes(call.request, call.incoming);
    call.incoming.Clear();
    call.has_request = true;
    if (call.method->work != CallWork::watch) enqueue(call);
}

void UnaryDispatcher::enqueue(Call& call) {
    // Quick responses are small.
    ASSERT(call.has_request && !call.finishing);
    if (unsent_bytes_ > limits_.response_bytes_max && call.method->work != CallWork::quick)
        return finish(call, too_much("too many responses wait for clients that do not read"));
    if (!pool_of(*call.method).add([this, &call] { respond(call); }))
        finish(call, too_much("too many calls are queued"));
}

WorkPool& UnaryDispatcher::pool_of(const CallMethod& method) {
    switch (method.work) {
        case CallWork::query:
            return query_pool_;
        case CallWork::control:
            return mutation_pool_;
        case CallWork::blocking:
            return blocking_pool_;
        default:
            return quick_pool_;
    }
}

// Runs on a pool thread. The last operation it starts returns the call to the queue's thread.
void UnaryDispatcher::respond(Call& call) {
    const CallContext context = context_of(call);
    Status status;
    ResponseBytes bytes;
    try {
        if (context.is_too_late())
            status = Error{ErrorCode::deadline_exceeded, "the deadline has passed"};
        else
            status = call.method->run(context, call.request, bytes);
    } catch (const std::exception& error) {
        // For example out of memory: only this call fails.
        log_error("{} failed: {}", call.method->path, error.what());
        status = Error{ErrorCode::resource_exhausted,
                       "the response needs more memory than is available"};
    }
    call.request.clear();
    if (!status.ok()) return finish(call, status);
    ASSERT(bytes && call.unsent == 0);
    call.unsent = static_cast<double>(bytes->size());
    unsent_bytes_.fetch_add(call.unsent);
    call.start_waiting();
    const grpc::ByteBuffer buffer = to_byte_buffer({{}, bytes});
    if (call.method->work == CallWork::stream) return call.stream.Write(buffer, &call.wrote);
    count(call, grpc::StatusCode::OK);
    call.stream.WriteAndFinish(buffer, {}, grpc::Status::OK, &call.finished);
}

void UnaryDispatcher::on_wrote(Call& call, bool ok) {
    if (!ok || call.is_cancelled)
        return finish(call, Error{ErrorCode::unavailable, "the connection was closed"});
    if (call.method->work != CallWork::stream) return;
    call.start_waiting();
    call.stream.Read(&call.incoming, &call.read);
}

void UnaryDispatcher::finish(Call& call, const Status& status) {
    call.finishing = true;
    call.start_waiting();
    ASSERT(call.method);
    const grpc::Status rich = to_rich_status(status);
    count(call, rich.error_code());
    call.stream.Finish(rich, &call.finished);
}

// Called once per call, when its status is known.
void UnaryDispatcher::count(const Call& call, grpc::StatusCode code) const {
    if (!metrics_) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - call.since).count();
    ASSERT(seconds >= 0);
    metrics_->handled(call.context.method(), code, seconds);
}

void UnaryDispatcher::notify_watches() {
    for (const auto& entry : calls_) {
        Call& call = *entry;
        if (!call.has_request || call.finishing || call.writing ||
            call.method->work != CallWork::watch)
            continue;
        if (call.is_cancelled) {
            finish(call, Error{ErrorCode::aborted, "the client disconnected"});
            continue;
        }
        ResponseBytes now;
        const CallContext context = context_of(call);
        if (const Status s = call.method->run(context, call.request, now); !s.ok()) {
            finish(call, s);
        } else if (!call.last_sent || *call.last_sent != *now) {
            ASSERT(now);
            call.last_sent = now;
            call.writing = true;
            call.start_waiting();
            call.stream.Write(to_byte_buffer({{}, now}), &call.wrote);
        }
    }
}

// A client that neither sends nor reads occupies a call and its bytes, so its time is limited.
void UnaryDispatcher::cancel_timed_out(Clock::time_point now) {
    for (const auto& call : calls_) {
        const Clock::rep since = call->waiting_since.load();
        if (since == 0 || call->is_done) continue;
        if (now - Clock::time_point(Clock::duration(since)) > limits_.timeout)
            call->context.TryCancel();
    }
}

void UnaryDispatcher::housekeep(Clock::time_point now) {
    if (now < due_) return;
    const bool is_idle = open_ == 0;
    due_ = now + (is_idle ? Clock::duration(idle_dispatcher_period)
                          : Clock::duration(dispatcher_housekeeping_period));
    if (stopping_) return;
    notify_watches();
    cancel_timed_out(now);
}

void UnaryDispatcher::drop_all() {
    calls_.clear();
}

}  // namespace jostle::server
