// SPDX-License-Identifier: MIT
//
// One gRPC play stream on a completion queue: at most one read and one write in flight, raw bytes
// both ways. Lives on its loop's thread.
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>

#include <memory>
#include <string>

#include "jostle/client/client_options.h"

namespace jostle::client {

class Connection {
public:
    enum class Event { started, read, wrote, finished };
    struct Tag {
        Connection* connection;
        Event event;
        void* owner;  // as given to the constructor
    };

    // Begins to connect; the started event tells how it went. `owner` comes back with each event.
    Connection(const ClientOptions& options, grpc::CompletionQueue& queue, void* owner);

    // What the queue gave back. Returns received bytes when a message came, else null.
    const std::string* handle(Event event, bool ok);

    bool ready_to_write() const { return started_ && !writing_ && !broken_ && !closing_; }
    void write(const std::string& bytes);
    // We said all we had to say.
    void close_writes();
    void cancel();

    // Where it is connected, as gRPC names it; once something was read.
    std::string peer() const { return context_.peer(); }

    bool finished() const { return finished_; }
    const grpc::Status& status() const { return status_; }
    // Nothing is in flight any more: may be destroyed.
    bool idle() const { return in_flight_ == 0; }

private:
    void read();
    void finish();

    std::shared_ptr<grpc::Channel> channel_;
    grpc::GenericStub stub_;
    grpc::ClientContext context_;
    std::unique_ptr<grpc::GenericClientAsyncReaderWriter> stream_;
    Tag started_tag_, read_tag_, wrote_tag_, finished_tag_;
    grpc::ByteBuffer incoming_;
    std::string bytes_;
    grpc::Status status_;
    int in_flight_ = 0;
    bool started_ = false, writing_ = false, broken_ = false, closing_ = false, finishing_ = false,
         finished_ = false;
};

}  // namespace jostle::client
