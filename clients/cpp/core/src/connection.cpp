// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/connection.h"

#include <grpcpp/create_channel.h>

#include <vector>

#include "clients/cpp/core/src/security.h"

namespace jostle::client {
namespace {

std::shared_ptr<grpc::Channel> make_channel(const ClientOptions& options) {
    grpc::ChannelArguments arguments;
    // One connection per client, as with real players; by default gRPC would share one socket among
    // all.
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
    // for the first snapshot of a large world
    arguments.SetMaxReceiveMessageSize(64 * 1024 * 1024);
    return grpc::CreateCustomChannel(options.target, channel_credentials(options.security),
                                     arguments);
}

}  // namespace

Connection::Connection(const ClientOptions& options, grpc::CompletionQueue& queue, void* owner)
    : channel_(make_channel(options)),
      stub_(channel_),
      started_tag_{this, Event::started, owner},
      read_tag_{this, Event::read, owner},
      wrote_tag_{this, Event::wrote, owner},
      finished_tag_{this, Event::finished, owner} {
    attach_token(context_, options.security);
    stream_ = stub_.PrepareCall(&context_, "/jostle.v1.PlayService/Play", &queue);
    in_flight_++;
    stream_->StartCall(&started_tag_);
}

void Connection::read() {
    in_flight_++;
    stream_->Read(&incoming_, &read_tag_);
}

void Connection::write(const std::string& bytes) {
    grpc::Slice slice(bytes.data(), bytes.size());
    writing_ = true;
    in_flight_++;
    stream_->Write(grpc::ByteBuffer(&slice, 1), &wrote_tag_);
}

void Connection::close_writes() {
    if (!ready_to_write()) return;
    closing_ = true;
    writing_ = true;
    in_flight_++;
    stream_->WritesDone(&wrote_tag_);
}

void Connection::cancel() {
    context_.TryCancel();
}

void Connection::finish() {
    if (finishing_) return;
    finishing_ = true;
    in_flight_++;
    stream_->Finish(&status_, &finished_tag_);
}

const std::string* Connection::handle(Event event, bool ok) {
    in_flight_--;
    switch (event) {
        case Event::started:
            if (!ok) {
                broken_ = true;
                finish();
                return nullptr;
            }
            started_ = true;
            read();
            return nullptr;
        case Event::read: {
            if (!ok) {
                broken_ = true;
                finish();
                return nullptr;
            }
            bytes_.clear();
            std::vector<grpc::Slice> slices;
            if (incoming_.Dump(&slices).ok())
                for (const grpc::Slice& slice : slices)
                    bytes_.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
            incoming_.Clear();
            read();
            return &bytes_;
        }
        case Event::wrote:
            writing_ = false;
            if (!ok) broken_ = true;  // the pending read fails as well and finishes the stream
            return nullptr;
        case Event::finished:
            finished_ = true;
            return nullptr;
    }
    return nullptr;
}

}  // namespace jostle::client
