// SPDX-License-Identifier: MIT
//
// The protocol of one passive client without its network: a Hello, acks at a steady interval,
// pings, and inputs if it plays. It reads only the number and the time of a snapshot; a decoding
// client also maintains a view and verifies each CRC. One thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/client/client_options.h"
#include "jostle/client/clock_sync.h"
#include "jostle/client/render_clock.h"
#include "jostle/client/world_view.h"
#include "jostle/v1/play.pb.h"
#include "tools/load/load_metrics.h"
#include "tools/load/proto_field_reader.h"

namespace jostle::load {

struct PassiveClientOptions {
    std::string world;  // name or id; empty: the first world
    std::string name;
    std::string token;      // in the Hello; empty: none
    bool spectator = true;  // sends no inputs
    bool decodes = false;
    int ack_every = 0;  // snapshots per ack; 0: at the interval of the Welcome
    std::optional<client::AreaOfInterest> interest = {};  // nothing: the whole world
    std::uint32_t max_kbps = 0;                           // 0: no limit
    double read_rate = 0;                                 // messages per second; 0: unlimited
    std::uint32_t snapshot_hz = 0;                        // 0: the tick rate of the world
    std::optional<client::Precision> precision = {};      // nothing: that of the world
    bool receives_data = false;  // subscribes to players, attributes and chat
};

class PassiveClientProtocol {
public:
    // The metrics must outlive this object.
    PassiveClientProtocol(PassiveClientOptions options, LoadMetrics& metrics);

    // Handles a received message.
    void receive(Bytes message, Clock::time_point now);
    // Returns the next message to send, if one is due. The bytes are valid until the next call.
    std::optional<std::string_view> take_message(Clock::time_point now);
    void play(const std::vector<v1::Input>& inputs);
    // Renders a frame of a decoding client, at most 60 per second: counts the frames that show
    // nothing new because no snapshot of their time has arrived.
    void render(Clock::time_point now);
    const PassiveClientOptions& options() const { return options_; }

    bool joined() const { return joined_; }
    std::uint32_t client_id() const { return client_id_; }
    const std::string& notice() const { return notice_; }  // the newest; empty: none
    // The view of a decoding client, else null.
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
    struct Applied {  // an applied input whose tick was not yet received in a snapshot
        std::uint32_t tick;
        Clock::time_point sent;
    };

    void on_field(const Field& field, Clock::time_point now);
    void on_welcome(Bytes bytes);
    void on_snapshot(Bytes bytes, Clock::time_point now);
    void on_user_message(Bytes bytes, Clock::time_point now);
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

    // Whether the server shares this machine's clock: every pong so far contained a time between
    // its ping and its arrival. Then the age of a message in a queue is exact, even if pongs wait
    // in the same queue.
    client::ClockSync clock_;
    bool same_clock_ = true;
    Clock::time_point next_ping_{};
    int pings_ = 0;

    std::int64_t epoch_us_ = 0;  // due time of tick 0 on the server's clock
    double tick_us_ = 0;         // tick interval; 0: unknown

    int ack_every_, unacked_ = 0;  // 0: by time only
    Clock::duration ack_delay_;
    Clock::time_point last_received_{}, last_ack_{};
    std::uint32_t frame_ = 0;  // of the newest snapshot
    std::optional<Clock::time_point> last_snapshot_;
    bool need_keyframe_ = false;

    client::RenderClock render_clock_;  // of a decoding client
    std::int64_t newest_due_us_ = 0;    // due time of the newest snapshot
    Clock::time_point next_render_{};

    v1::InputBatch batch_;
    std::uint32_t next_sequence_ = 1;
    std::deque<Sent> sent_;        // inputs without a result
    std::deque<Arrival> arrived_;  // the newest snapshots
    std::vector<Applied> applied_;
};

}  // namespace jostle::load
