// SPDX-License-Identifier: MIT
#include "server/grpc/play_stream.h"

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/grpc_status/grpc_status.h"
#include "server/grpc/conversions.h"
#include "server/util/address.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

constexpr auto last_write_timeout = std::chrono::seconds(1);

}  // namespace

PlayStream::PlayStream(RawPlayService& service, grpc::ServerCompletionQueue& queue)
    : stream_(&context_) {
    service.RequestPlay(&context_, &stream_, &queue, &queue, &accepted_);
}

PlayStream::~PlayStream() {
    if (connection_) connection_->calls--;
}

void PlayStream::begin(PlayContext& context, const ConnectionTable& connections,
                       OverloadControl& overload, std::function<void()> wake,
                       Clock::time_point now) {
    ASSERT(!session_);
    connection_ = connections.of(context_.peer());
    ASSERT(connection_);
    const std::string address = client_address(context_, *connection_, connections);
    network_ = network_of(address);
    connection_->calls_accepted++;
    connection_->calls++;
    metrics_ = context.rpc_metrics;
    session_ = std::make_unique<ClientSession>(
        context,
        Peer{.name =
                 "grpc:" + (address == connection_->address ? std::string() : address + " via ") +
                 connection_->peer,
             .address = address,
             .call = "jostle.v1.PlayService/Play",
             .who = identify(context_, *connection_, address, context.authorizer),
             .wake = std::move(wake),
             .overload = &overload},
        now);
    start_read();
}

void PlayStream::start_read() {
    ASSERT(!reading_);
    reading_ = true;
    stream_.Read(&incoming_, &read_);
}

// If memory runs out while a message is read or written, only this stream ends.
template <class Work>
void PlayStream::guarded(Clock::time_point now, const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        log_error("grpc:{}: {}", connection_->peer, error.what());
        session_->on_fault(now);
    }
}

void PlayStream::on_read(bool ok, Clock::time_point now) {
    ASSERT(session_ && reading_);
    reading_ = false;
    guarded(now, [&] {
        if (!ok) {
            // The client half-closed the stream, or the connection was closed.
            session_->on_peer_closed(now);
            return;
        }
        connection_->consumed += incoming_.Length();
        copy_bytes(incoming_bytes_, incoming_);
        incoming_.Clear();
        session_->receive(incoming_bytes_, now);
        if (!session_->end()) start_read();
    });
    advance(now);
}

void PlayStream::on_wrote(bool ok, Clock::time_point now) {
    ASSERT(session_ && writing_);
    writing_ = false;
    // A write fails only if the connection was closed; the pending read then fails as well.
    if (!ok) session_->on_peer_closed(now);
    advance(now);
}

void PlayStream::on_finished() {
    finished_ = true;
}

void PlayStream::on_shutdown(PlayTag::Event event) {
    if (event == PlayTag::Event::read) reading_ = false;
    if (event == PlayTag::Event::wrote) writing_ = false;
    if (event == PlayTag::Event::finished) finished_ = true;
}

void PlayStream::advance(Clock::time_point now) {
    if (finishing_) return;
    guarded(now, [&] { session_->take_datagrams(now); });
    if (writing_) {
        session_->wait_for_write(now);
        // A client that no longer reads would block its last write, and with it the stream,
        // forever.
        if (session_->end() && now >= session_->end_time() + last_write_timeout)
            context_.TryCancel();
        return;
    }
    std::optional<OutMessage> message;
    guarded(now, [&] { message = session_->take_message(now); });
    if (message) {
        writing_ = true;
        stream_.Write(to_byte_buffer(*message), &wrote_);
        return;
    }
    if (const std::optional<Status>& end = session_->end()) {
        ASSERT(!writing_ && !finishing_);
        finishing_ = true;
        const grpc::Status status = to_grpc(*end);
        if (metrics_) metrics_->handled(play_path, status.error_code(), 0);
        stream_.Finish(status, &finished_tag_);
    }
}

}  // namespace jostle::server
