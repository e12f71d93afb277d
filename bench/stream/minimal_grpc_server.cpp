// SPDX-License-Identifier: MIT
#include <absl/synchronization/mutex.h>
#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <chrono>
#include <memory>
#include <vector>

#include "bench/stream/minimal_server.h"

namespace jostle::bench {
namespace {

using ServerClock = std::chrono::steady_clock;

struct MinimalStream;

struct CallTag {
    enum class Event { accepted, read, wrote };
    MinimalStream* stream;
    Event event;
};

struct MinimalStream {
    grpc::GenericServerContext context;
    grpc::GenericServerAsyncReaderWriter stream{&context};
    grpc::ByteBuffer incoming;
    CallTag accepted{this, CallTag::Event::accepted}, read{this, CallTag::Event::read},
        wrote{this, CallTag::Event::wrote};
    bool writing = false, over = false;
};

class MinimalGrpcServer {
public:
    explicit MinimalGrpcServer(const MinimalServerOptions& options) : options_(options) {}

    Status listen();
    void run(const std::atomic<bool>& stop);

private:
    void request_call();
    void handle(const CallTag& tag, bool ok);
    void write_to_all();

    const MinimalServerOptions& options_;
    grpc::AsyncGenericService service_;
    std::unique_ptr<grpc::ServerCompletionQueue> queue_;
    std::unique_ptr<grpc::Server> server_;
    // Finished streams are destroyed at the end; a benchmark has few.
    std::vector<std::unique_ptr<MinimalStream>> streams_;
    // number of accepted streams, at the start of streams_; they are accepted in order
    std::size_t accepted_ = 0;
    std::uint32_t frame_ = 0;
};

Status MinimalGrpcServer::listen() {
    grpc::ServerBuilder builder;
    int port = 0;
    builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
    builder.RegisterAsyncGenericService(&service_);
    queue_ = builder.AddCompletionQueue();
    server_ = builder.BuildAndStart();
    if (!server_) return Error{ErrorCode::unavailable, "gRPC cannot listen"};
    request_call();
    return write_port_file(options_.port_file, port);
}

void MinimalGrpcServer::request_call() {
    streams_.push_back(std::make_unique<MinimalStream>());
    MinimalStream& next = *streams_.back();
    service_.RequestCall(&next.context, &next.stream, queue_.get(), queue_.get(), &next.accepted);
}

// Acks are read and ignored.
void MinimalGrpcServer::handle(const CallTag& tag, bool ok) {
    MinimalStream& stream = *tag.stream;
    switch (tag.event) {
        case CallTag::Event::accepted:
            if (!ok) return;
            accepted_ = streams_.size();
            request_call();
            stream.stream.Read(&stream.incoming, &stream.read);
            return;
        case CallTag::Event::read:
            stream.incoming.Clear();
            if (ok)
                stream.stream.Read(&stream.incoming, &stream.read);
            else
                stream.over = true;
            return;
        case CallTag::Event::wrote:
            stream.writing = false;
            return;
    }
}

void MinimalGrpcServer::write_to_all() {
    const MinimalServerMessage message = make_minimal_server_message(options_.bytes, ++frame_);
    const grpc::Slice shared(message.shared);
    for (std::size_t k = 0; k < accepted_; k++) {
        MinimalStream& stream = *streams_[k];
        if (stream.writing || stream.over) continue;
        const std::array<grpc::Slice, 2> slices{grpc::Slice(message.head), shared};
        stream.writing = true;
        stream.stream.Write(grpc::ByteBuffer(slices.data(), slices.size()), &stream.wrote);
    }
}

void MinimalGrpcServer::run(const std::atomic<bool>& stop) {
    const auto period = std::chrono::duration_cast<ServerClock::duration>(
        std::chrono::duration<double>(1 / options_.hz));
    auto next = ServerClock::now() + period;
    while (!stop) {
        void* tag = nullptr;
        bool ok = false;
        const auto wait = std::max(ServerClock::duration::zero(), next - ServerClock::now());
        const auto deadline = std::chrono::system_clock::now() + wait;
        if (queue_->AsyncNext(&tag, &ok, deadline) == grpc::CompletionQueue::GOT_EVENT)
            handle(*static_cast<CallTag*>(tag), ok);
        if (ServerClock::now() < next) continue;
        write_to_all();
        next += period;
    }
    server_->Shutdown(std::chrono::system_clock::now());
    queue_->Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_->Next(&tag, &ok)) {
    }
}

}  // namespace

Status serve_minimal_grpc(const MinimalServerOptions& options, const std::atomic<bool>& stop) {
    // Debian builds absl with deadlock detection; it costs a tenth of the CPU time and is not
    // needed in this server.
    absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
    MinimalGrpcServer server(options);
    if (Status listening = server.listen(); !listening.ok()) return listening;
    server.run(stop);
    return {};
}

}  // namespace jostle::bench
