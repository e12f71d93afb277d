// SPDX-License-Identifier: MIT
//
// One gRPC play stream on a completion queue: at most one pending read and one pending write of raw
// bytes. Used by its loop's thread only.
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
        void* owner;  // as passed to the constructor
    };

    // Starts to connect; the started event reports the result. Each event contains `owner`.
    Connection(const ClientOptions& options, grpc::CompletionQueue& queue, void* owner);

    // Handles an event of the queue. Returns the bytes of a received message, else null.
    const std::string* handle(Event event, bool ok);

    bool ready_to_write() const { return started_ && !writing_ && !broken_ && !closing_; }
    void write(const std::string& bytes);
    // Half-closes the stream: no more writes follow.
    void close_writes();
    void cancel();

    // Peer address in gRPC's format; valid after the first read.
    std::string peer() const { return context_.peer(); }

    bool finished() const { return finished_; }
    const grpc::Status& status() const { return status_; }
    // No operation is pending: the connection may be destroyed.
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
