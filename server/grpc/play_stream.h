// SPDX-License-Identifier: MIT
//
// Runs one gRPC play stream as a ClientSession: at most one read and one write in flight, raw bytes
// in both directions. Used only on the thread of its PlayShard, which passes it the events of its
// completion queue.
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/async_stream.h>
#include <grpcpp/support/byte_buffer.h>

#include <functional>
#include <memory>
#include <string>

#include "jostle/v1/play.grpc.pb.h"
#include "server/grpc/rpc_tag.h"
#include "server/grpc_proxy/connection_table.h"
#include "server/session/client_session.h"

namespace jostle::server {

using RawPlayService = v1::PlayService::WithRawMethod_Play<v1::PlayService::Service>;

inline constexpr char play_path[] = "/jostle.v1.PlayService/Play";

class PlayStream;

// Tag of a completion queue event.
struct PlayTag : RpcTag {
    enum class Event { accepted, read, wrote, finished };

    PlayTag(PlayStream* stream_of_tag, Event of_event)
        : RpcTag(Owner::play), stream(stream_of_tag), event(of_event) {}

    PlayStream* stream;
    Event event;
};

class PlayStream {
public:
    // Requests the next call from gRPC; the accepted event reports its arrival.
    PlayStream(RawPlayService& service, grpc::ServerCompletionQueue& queue);
    ~PlayStream();
    PlayStream(const PlayStream&) = delete;
    PlayStream& operator=(const PlayStream&) = delete;

    // Starts the session of a connected client. `overload`: of the thread; outlives the stream.
    // `wake`: called on any thread when the session has datagrams.
    void begin(PlayContext& context, const ConnectionTable& connections, OverloadControl& overload,
               std::function<void()> wake, Clock::time_point now);
    void on_read(bool ok, Clock::time_point now);
    void on_wrote(bool ok, Clock::time_point now);
    void on_finished();
    // Records the end of an operation during queue shutdown, and starts no new one.
    void on_shutdown(PlayTag::Event event);

    // Starts the next write if none is in flight and a message is available, or ends the stream.
    void advance(Clock::time_point now);

    bool begun() const { return session_ != nullptr; }
    ClientSession& session() { return *session_; }  // only after begin()
    const std::string& network() const { return network_; }
    // No operation is in flight or will be started: the stream may be destroyed.
    bool is_finished() const { return finished_ && !reading_ && !writing_; }

private:
    void start_read();
    template <class Work>
    void guarded(Clock::time_point now, const Work& work);

    grpc::ServerContext context_;
    grpc::ServerAsyncReaderWriter<grpc::ByteBuffer, grpc::ByteBuffer> stream_;
    PlayTag accepted_{this, PlayTag::Event::accepted};
    PlayTag read_{this, PlayTag::Event::read};
    PlayTag wrote_{this, PlayTag::Event::wrote};
    PlayTag finished_tag_{this, PlayTag::Event::finished};
    std::unique_ptr<ClientSession> session_;
    std::shared_ptr<Connection> connection_;
    RpcMetrics* metrics_ = nullptr;
    std::string network_;
    grpc::ByteBuffer incoming_;
    std::string incoming_bytes_;
    bool reading_ = false, writing_ = false, finishing_ = false, finished_ = false;
};

}  // namespace jostle::server
