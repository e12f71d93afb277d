// SPDX-License-Identifier: MIT
//
// What the C++ client library makes of a server that says anything: welcomes, rosters, snapshots,
// pongs with wild clocks. Snapshots whose bytes can be decoded get the right CRC, which no fuzzer
// guesses.
#include "clients/cpp/core/src/play_protocol.h"

#include "jostle/snapshot/baseline_frames.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace std::chrono_literals;
using client::Clock;

constexpr std::uint8_t kinds = 5;

class Listener {
public:
    Listener() { conversation_.begin(now_); }

    void handle(const Record& record) {
        Reader in(record.bytes);
        switch (record.kind % kinds) {
            case 0:
                return receive(std::string(text_of(record.bytes)));
            case 1:
                now_ += std::chrono::milliseconds(in.number<std::uint16_t>());
                return read_view(in.number<std::int32_t>());
            case 2:
                if (conversation_.view().frame().frame != 0) frames_.clear();
                conversation_.ended(Error{ErrorCode::unavailable, "gone"});
                return conversation_.begin(now_);
            case 3:
                static_cast<void>(conversation_.send({}));
                return send_messages();
            case 4:
                conversation_.leave();
                return send_messages();
        }
    }

private:
    void receive(std::string bytes) {
        v1::ServerMessage message;
        const bool whole = message.ParseFromString(bytes);
        if (whole && message.has_welcome()) frames_.clear();
        if (whole && message.has_snapshot() && set_crc(*message.mutable_snapshot()))
            bytes = message.SerializeAsString();
        const std::uint32_t before = conversation_.view().frame().frame;
        conversation_.receive(bytes, now_);
        const snapshot::QuantizedFrame& frame = conversation_.view().frame();
        if (frame.frame == before) return;
        frames_.push_back(frame);
        if (frames_.size() > client::WorldView::frame_history_max) frames_.pop_front();
    }

    const snapshot::QuantizedFrame* find(std::uint32_t number) const {
        for (const snapshot::QuantizedFrame& frame : frames_)
            if (frame.frame == number) return &frame;
        return nullptr;
    }

    bool set_crc(v1::Snapshot& snapshot) const {
        snapshot::Baselines baselines;
        const auto told = snapshot::decode_baseline_frames(snapshot.frame(), snapshot.baselines());
        if (!told.ok()) return false;
        const std::uint32_t numbers[] = {told->baseline, told->baseline2, told->baseline3};
        const snapshot::QuantizedFrame** const slots[] = {&baselines.baseline, &baselines.baseline2,
                                                          &baselines.baseline3};
        for (int k = 0; k < 3 && (*slots[k] = find(numbers[k])) != nullptr; k++) {
        }
        const auto* bytes = reinterpret_cast<const std::byte*>(snapshot.packed().data());
        const auto frame =
            snapshot::decode_frame(snapshot.frame(), {bytes, snapshot.packed().size()}, baselines,
                                   conversation_.view().spec(), snapshot::default_entities_max,
                                   conversation_.view().codec());
        if (!frame.ok()) return false;
        snapshot.set_crc(snapshot::frame_crc(*frame));
        return true;
    }

    // What a program asks of its client between two messages.
    void read_view(std::int32_t later_ms) {
        const client::WorldView& view = conversation_.view();
        const auto now = static_cast<std::int64_t>(client::to_us(now_));
        for (const std::int64_t us : {now, now + 1000 * std::int64_t{later_ms}}) {
            static_cast<void>(conversation_.buffer().sample(us, view.spec()));
            static_cast<void>(conversation_.input_clock().tick(us));
        }
        for (const auto& [id, entity] : view.entities()) static_cast<void>(view.pose_of(id));
        for (const snapshot::Channel& channel : view.channels())
            expect(channel.values != nullptr, "a channel that is there has values");
        static_cast<void>(conversation_.take_results());
        static_cast<void>(conversation_.take_events());
        static_cast<void>(conversation_.take_ages_ms());
        send_messages();
    }

    void send_messages() {
        for (int k = 0; k < 8; k++)
            if (!conversation_.take_message(now_)) return;
    }

    Clock::time_point now_ = Clock::time_point() + 1000s;
    client::PlayProtocol conversation_{client::ClientOptions{.events = true, .channels = {"*"}}};
    std::deque<snapshot::QuantizedFrame> frames_;  // as the view keeps them
};

}  // namespace

void run(Bytes input) {
    Listener listener;
    for (Reader in(input); !in.done();) listener.handle(take_record(in));
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    static jostle::v1::ServerMessage message;
    return jostle::fuzz::mutate_records(message, 0, jostle::fuzz::kinds, data, size, size_max,
                                        seed);
}
