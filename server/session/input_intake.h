// SPDX-License-Identifier: MIT
//
// Accepts the inputs of one client: checks them, pushes them to the world's mailbox, and collects
// their results until a snapshot carries them. Each input yields exactly one result; an input that
// is repeated yields none. Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "server/config/config.h"
#include "server/limits/admission.h"
#include "server/messages/client_message.h"
#include "server/util/clock.h"
#include "server/world/command_mailbox.h"

namespace jostle::server {

// Clamps an input margin to the range of the client update: a client may schedule an input for any
// tick.
std::int32_t clamp_margin(std::int64_t margin_us);

class InputIntake {
public:
    struct Source {
        ClientId client = 0;
        AccountId account = 0;
        bool spectator = false;
        bool persisted = false;  // the world survives the process
    };
    InputIntake(CommandMailbox& mailbox, const Source& source, const ClientLimits& limits,
                std::shared_ptr<ResultQueue> queue, Clock::time_point now);

    // Charges a received message. False: the client exceeds its message or byte rate.
    bool admit_message(std::size_t bytes, Clock::time_point now) {
        return admission_.admit_message(bytes, now);
    }
    // Pushes the inputs that are newer than the last one received. `tick`: of the newest frame, for
    // the results of rejected inputs. An error rejects the entire batch.
    Status receive(const InputBatch& batch, std::uint32_t tick, Clock::time_point now);
    // Takes the results that the world has produced.
    void collect_results();

    // Results that no message has carried yet, oldest first.
    std::span<const InputResult> results() const { return results_; }
    void on_results_sent() { results_.clear(); }
    std::vector<InputResult> take_results() { return std::exchange(results_, {}); }

    bool is_spectator() const { return source_.spectator; }
    std::uint32_t last_sequence() const { return last_sequence_; }
    std::uint32_t persisted_sequence() const { return persisted_sequence_; }
    // The client need not send inputs up to this one again, whatever happens to this process.
    std::uint32_t confirmed() const {
        return source_.persisted ? persisted_sequence_ : last_sequence_;
    }
    // Client time of the newest batch, once; 0: already taken.
    std::uint32_t take_client_time_us() { return std::exchange(client_time_us_, 0); }
    const std::shared_ptr<ResultQueue>& queue() const { return queue_; }

    // Newest sequence and margin among the results since the last call, for datagrams; sequence 0:
    // there was none.
    struct DatagramResult {
        std::uint32_t sequence = 0;
        std::int32_t margin_us = 0;
    };
    DatagramResult take_datagram_result() { return std::exchange(datagram_result_, {}); }

    // Restores the state of a suspended session, with the results that its client may lack.
    void resume(std::uint32_t last_sequence, std::uint32_t persisted_sequence,
                std::vector<InputResult> results);

private:
    Status push(std::uint32_t sequence, const Result<Action>& input, std::uint32_t tick,
                Clock::time_point now);

    CommandMailbox& mailbox_;
    const Source source_;
    const std::size_t inputs_per_batch_max_;
    Admission admission_;
    const std::shared_ptr<ResultQueue> queue_;
    std::vector<InputResult> results_;
    std::uint32_t last_sequence_ = 0;       // received
    std::uint32_t persisted_sequence_ = 0;  // has a result, and is stored if the world is persisted
    std::uint32_t client_time_us_ = 0;
    DatagramResult datagram_result_;
};

}  // namespace jostle::server
