// SPDX-License-Identifier: MIT
//
// What one sink says and hears, without its network: a hello, acks at a steady cadence, pings, and
// inputs when it plays. Of a snapshot it reads the number and the time; a sink that decodes keeps a
// view as well and compares each CRC. One thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/client/client_options.h"
#include "jostle/client/clock_sync.h"
#include "jostle/client/world_view.h"
#include "jostle/v1/play.pb.h"
#include "tools/load/load_metrics.h"
#include "tools/load/proto_field_reader.h"

namespace jostle::load {

struct PassiveClientOptions {
    std::string world;  // name or id; empty: the first
    std::string name;
    std::string token;      // in the hello; empty: none
    bool spectator = true;  // sends no inputs
    bool decodes = false;
    int ack_every = 0;  // snapshots; 0: as often as the server's welcome asks for
    std::optional<client::AreaOfInterest> interest = {};  // nothing: all of the world
    std::uint32_t max_kbps = 0;                           // 0: what the world takes
};

class PassiveClientProtocol {
public:
    // The figures outlive it.
    PassiveClientProtocol(PassiveClientOptions options, LoadMetrics& metrics);

    // A message was read.
    void receive(Bytes message, Clock::time_point now);
    // The next thing to say, if there is one. The bytes are good until the next call.
    std::optional<std::string_view> take_message(Clock::time_point now);
    void play(const std::vector<v1::Input>& inputs);

    bool joined() const { return joined_; }
    std::uint32_t client_id() const { return client_id_; }
    const std::string& notice() const { return notice_; }  // the newest; empty: none
    // Of a sink that decodes, else null.
    const client::WorldView* view() const { return view_.get(); }

private:
    struct Sent {
        std::uint32_t sequence;
        Clock::time_point at;
    };
    struct Arrival {
        std::uint32_t frame;
        Clock::time_point at;
    };
    struct Applied {  // an input whose tick is known, and of which no snapshot came yet
        std::uint32_t tick;
        Clock::time_point sent;
    };

    void on_field(const Field& field, Clock::time_point now);
    void on_welcome(Bytes bytes);
    void on_snapshot(Bytes bytes, Clock::time_point now);
    void on_client_update(Bytes bytes, Clock::time_point now);
    void on_result(const v1::InputResult& result, Clock::time_point now);
    void on_pong(Bytes bytes, Clock::time_point now);
    void record_effect_delays(std::uint32_t frame, Clock::time_point now);
    void decode(Bytes message);
    std::int64_t server_us(Clock::time_point now) const;
    std::int64_t due_us(std::uint32_t frame, std::uint64_t late) const;
    bool ack_is_due(Clock::time_point now) const;
    void fill_ack(v1::Ack& ack, Clock::time_point now);
    std::string_view serialized();

    const PassiveClientOptions options_;
    LoadMetrics& metrics_;
    std::unique_ptr<client::WorldView> view_;
    v1::ClientMessage out_;
    std::string out_bytes_;
    std::string notice_;
    bool hello_sent_ = false, joined_ = false;
    std::uint32_t client_id_ = 0;

    // Whether the server's clock is ours, because it runs on this machine: every pong so far said a
    // time between its ping and now. Then the age of what waits in a queue is known however long
    // pongs wait there, too.
    client::ClockSync clock_;
    bool same_clock_ = true;
    Clock::time_point next_ping_{};
    int pings_ = 0;

    std::int64_t epoch_us_ = 0;  // on the server's clock: tick 0
    double tick_us_ = 0;         // from tick to tick; 0: not known

    int ack_every_, unacked_ = 0;  // 0: only by time
    Clock::duration ack_delay_;
    Clock::time_point last_received_{}, last_ack_{};
    std::uint32_t frame_ = 0;  // of the newest snapshot
    std::optional<Clock::time_point> last_snapshot_;
    bool need_keyframe_ = false;

    v1::InputBatch batch_;
    std::uint32_t next_sequence_ = 1;
    std::deque<Sent> sent_;        // without a result
    std::deque<Arrival> arrived_;  // the newest snapshots
    std::vector<Applied> applied_;
};

}  // namespace jostle::load
