// SPDX-License-Identifier: MIT
//
// A whole conversation: what a client sends, whatever its order, while the world ticks and time
// passes when the input says so. What the server says is checked as the tests check it.
#include "server/session/client_session.h"

#include "jostle/v1/play.pb.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/small_server.h"
#include "tests/fuzz/target.h"
#include "tests/system/play_state.h"

namespace jostle::fuzz {

namespace {

using namespace std::chrono_literals;
using server::Clock;

constexpr int ticks_max = 40;  // of one input: a step takes as long as a hundred messages
constexpr std::uint8_t kinds = 6;

class PlayProtocol {
public:
    // A Hello may ask for events or not.
    PlayProtocol() { state_.wants_events = true; }

    void handle(const Record& record) {
        Reader in(record.bytes);
        switch (record.kind % kinds) {
            case 0:
                return link_.receive(text_of(record.bytes), now_);
            case 1:
                return tick(1 + in.number<std::uint8_t>() % 8);
            case 2:
                now_ += std::chrono::milliseconds(in.number<std::uint16_t>());
                return;
            case 3:
                return listen(in.number<std::uint8_t>());
            case 4:
                return link_.wait_for_write(now_);
            case 5:
                return acknowledge(in.number<std::uint8_t>() % 4 == 0);
        }
    }

    // All that is left to say, once the world has answered.
    void end() {
        tick(1);
        now_ += 1s;
        listen(0);
        expect(state_.violations == 0, state_.first_violation);
        link_.on_peer_closed(now_);
        expect(link_.end().has_value(), "who hangs up has ended the conversation");
        expect(!link_.take_message(now_), "nobody is there to be told");
        // A place that is kept for it is kept for so long.
        now_ += std::chrono::seconds(1) +
                std::chrono::ceil<std::chrono::seconds>(std::chrono::duration<double>(
                    server_.context.config.client.resume_timeout_seconds));
        server::remove_expired_clients(server_.context, now_);
        expect(server_.sessions.clients() == 0, "who has gone is not counted");
    }

private:
    void tick(int count) {
        for (; count > 0 && ticks_ < ticks_max; count--, ticks_++) {
            now_ += 16ms;
            server_.worlds.find("")->tick(now_);
        }
    }
    // So many messages; 0: all that there are.
    void listen(std::uint8_t most) {
        for (int taken = 0; most == 0 || taken < most; taken++) {
            const auto out = link_.take_message(now_);
            if (!out) return;
            v1::ServerMessage message;
            expect(message.ParseFromString(out->concatenated()),
                   "what the server sends is a ServerMessage");
            state_.take(message);
        }
    }
    void acknowledge(bool need_keyframe) {
        v1::ClientMessage message;
        message.mutable_ack()->set_frame(state_.newest_frame);
        message.mutable_ack()->set_need_keyframe(need_keyframe);
        link_.receive(message.SerializeAsString(), now_);
    }

    SmallServer server_;
    Clock::time_point now_ = Clock::time_point() + 1000s;
    server::ClientSession link_{server_.context,
                                server::Peer{.name = "fuzz",
                                             .address = "127.0.0.1",
                                             .call = "jostle.v1.PlayService/Play",
                                             .who = server_.anybody()},
                                now_};
    test::PlayState state_;
    int ticks_ = 0;
};

}  // namespace

void run(Bytes input) {
    PlayProtocol conversation;
    for (Reader in(input); !in.done();) conversation.handle(take_record(in));
    conversation.end();
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    static jostle::v1::ClientMessage message;
    return jostle::fuzz::mutate_records(message, 0, jostle::fuzz::kinds, data, size, size_max,
                                        seed);
}
