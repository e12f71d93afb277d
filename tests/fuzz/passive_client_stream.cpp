// SPDX-License-Identifier: MIT
//
// What a server sends to a sink of jostle-load, over each transport: however the bytes are cut, the
// same messages arrive and the stream ends for the same reason.
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"
#include "tools/load/framing.h"
#include "tools/load/http2_framing.h"
#include "tools/load/passive_client_protocol.h"
#include "tools/load/websocket_framing.h"

namespace jostle::fuzz {

namespace {

using namespace std::chrono_literals;

std::unique_ptr<load::Framing> framing_of(std::uint8_t kind) {
    switch (kind % 4) {
        case 0:
            return std::make_unique<load::WebSocketFraming>("localhost:1");
        case 1:
            return std::make_unique<load::RawFraming>();
        case 2:
            return std::make_unique<load::Http2Framing>(load::Http2Request{.authority = "a:1"});
        default:
            return std::make_unique<load::Http2Framing>(load::Http2Request{
                .authority = "a:1", .token = "t", .window = load::Http2Request::window_max});
    }
}

// One sink, and what became of the bytes that it was given.
class PassiveClient final : private load::Framing::Reader {
public:
    explicit PassiveClient(std::uint8_t kind)
        : framing_(framing_of(kind)), protocol_({.spectator = false, .decodes = true}, metrics_) {
        send_messages();
    }

    // False: the stream is over.
    bool receive(Bytes bytes) {
        const Status taken = framing_->take(bytes, *this);
        if (!taken.ok()) received += "\nended: " + taken.error().message;
        return taken.ok();
    }

    std::string received;

private:
    void on_message(load::Bytes message) override {
        received += "\nmessage of " + std::to_string(message.size());
        now_ += 10ms;
        protocol_.receive(message, now_);
        framing_->consume(message.size());
        send_messages();
    }

    void send_messages() {
        protocol_.play({v1::Input()});
        for (int k = 0; k < 8; k++) {
            const auto message = protocol_.take_message(now_);
            if (!message) return;
            framing_->send(*message);
        }
    }

    load::LoadMetrics metrics_;
    std::unique_ptr<load::Framing> framing_;
    load::PassiveClientProtocol protocol_;
    load::Clock::time_point now_ = load::Clock::time_point() + 1000s;
};

std::string received_in_chunks(std::uint8_t kind, Bytes input, std::size_t piece) {
    PassiveClient sink(kind);
    for (std::size_t at = 0; at < input.size(); at += piece)
        if (!sink.receive(input.subspan(at, std::min(piece, input.size() - at)))) break;
    return sink.received;
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const auto kind = in.number<std::uint8_t>();
    const std::string whole = received_in_chunks(kind, in.rest(), input.size() + 1);
    for (const std::size_t piece : {1, 7, 24})
        expect(received_in_chunks(kind, in.rest(), piece) == whole,
               "how bytes are cut makes no difference");
}

}  // namespace jostle::fuzz
