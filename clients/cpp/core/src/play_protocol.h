// SPDX-License-Identifier: MIT
//
// The client side of the play stream, independent of the network: takes received messages and
// returns messages to send. One thread at a time (Client's lock).
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "clients/cpp/core/src/input_outbox.h"
#include "jostle/base/result.h"
#include "jostle/client/client_options.h"
#include "jostle/client/client_stats.h"
#include "jostle/client/clock_sync.h"
#include "jostle/client/input_clock.h"
#include "jostle/client/interpolation.h"
#include "jostle/client/rendered_time.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

class PlayProtocol {
public:
    explicit PlayProtocol(ClientOptions options) : options_(std::move(options)) {}

    // Starts a new stream with a Hello. Unsent inputs stay queued. After a lost stream it requests
    // to resume the session.
    void begin(Clock::time_point now);
    void receive(const std::string& bytes, Clock::time_point now);
    // Takes a message received as a datagram, which may be outdated and is always a snapshot.
    void receive_datagram(const std::string& bytes, Clock::time_point now);
    // The stream ended, normally or with an error.
    void ended(const Status& end);
    // Returns the next message to write, if one is due.
    std::optional<std::string> take_message(Clock::time_point now);
    // Likewise for datagrams, which may be lost.
    std::optional<std::string> take_datagram(Clock::time_point now);
    // Credentials for datagrams, once the server has sent them; nothing: no datagrams.
    const std::optional<v1::DatagramCredentials>& datagram_ticket() const { return ticket_; }
    // Reports whether datagrams get through, or whether the attempt timed out.
    void set_datagrams(bool alive, bool timed_out);
    // Datagrams cannot be used; discards the credentials.
    void datagrams_failed(const Error& reason);

    std::uint32_t send(v1::Input input);  // 0: too many inputs are queued
    // World time of the last rendered frame, or of the newest frame without rendering. Tick 0:
    // none.
    v1::ViewTime rendered_time() const;
    // At the time of the last sample of buffer().
    std::vector<SmoothPoints> interpolated_points();
    void set_interest(const AreaOfInterest& interest);
    void request_keyframe() { keyframe_requested_ = true; }
    void leave() { leaving_ = true; }
    // Like leave(), but without sending the queued inputs.
    void abandon();
    bool leaving() const { return leaving_; }
    // The Leave, if any, was returned by take_message().
    bool leave_sent() const { return leave_sent_; }

    const WorldView& view() const { return view_; }
    const ClockSync& clock() const { return clock_; }
    InterpolationBuffer& buffer() { return buffer_; }
    InputClock& input_clock() { return input_clock_; }
    const ClientOptions& options() const { return options_; }
    const ClientStats& stats() const { return stats_; }
    const std::optional<v1::WorldStats>& world_stats() const { return world_stats_; }
    std::vector<v1::InputResult> take_results();
    std::vector<v1::Events> take_events();
    std::vector<v1::UserMessage> take_messages();
    std::vector<v1::PlayerEvent> take_player_events();
    std::vector<float> take_ages_ms() { return std::exchange(ages_ms_, {}); }

private:
    void start_new_session();
    void on_message(Clock::time_point now);
    void note_error(const Status& applied);
    void on_welcome(const v1::Welcome& welcome, Clock::time_point now);
    void on_snapshot(const v1::Snapshot& snapshot, Clock::time_point now);
    void on_points(const v1::Snapshot& snapshot);
    bool needs_keyframe() const { return need_keyframe_ || view_.points().needs_keyframe(); }
    std::string hello();
    bool sends_inputs_on_stream(Clock::time_point now) const;
    Clock::duration batch_period() const;
    std::string datagram_with_inputs(Clock::time_point now);
    void adjust_input_clock(const v1::Snapshot& snapshot, double age_us, Clock::time_point now);
    void on_results(const v1::ClientUpdate& own, Clock::time_point now);
    void on_events(v1::Events&& events);
    void on_data(v1::Snapshot& snapshot);
    void fill_ack(v1::Ack& ack, Clock::time_point now);
    std::string take_inputs(Clock::time_point now);

    ClientOptions options_;
    WorldView view_;
    ClockSync clock_;
    InterpolationBuffer buffer_;
    InputClock input_clock_;
    ClientStats stats_;
    std::optional<v1::WorldStats> world_stats_;
    std::deque<v1::InputResult> results_;
    std::deque<v1::Events> events_;
    std::deque<v1::UserMessage> messages_;
    std::deque<v1::PlayerEvent> player_events_;
    std::uint32_t last_message_ = 0;  // number of the last user message of this session
    std::vector<float> ages_ms_;

    v1::ServerMessage message_;  // reused, so that parsing rarely allocates
    InputOutbox inputs_;
    std::string resume_token_;  // empty: the session is not resumable
    std::optional<v1::DatagramCredentials> ticket_;
    bool datagram_ack_due_ = false, blocked_reported_ = false;
    Clock::time_point last_datagram_{}, last_datagram_batch_{}, ticket_received_at_{};
    bool interest_due_ = false;
    bool hello_due_ = false, ack_due_ = false;
    bool need_keyframe_ = false;       // snapshots cannot be decoded without one
    bool keyframe_requested_ = false;  // requested by the application
    Clock::duration ack_period_{};
    NewestFrame newest_;
    double tick_us_ = 0;
    bool leaving_ = false, leave_sent_ = false;
    int pings_sent_ = 0;
    Clock::time_point last_batch_{}, last_ack_{}, next_ping_{}, decoded_at_{};
};

}  // namespace jostle::client
