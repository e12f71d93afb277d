// SPDX-License-Identifier: MIT
//
// The datagrams of one session (docs/design/datagrams.md): snapshots to the client, inputs and
// acknowledgements from it. Data that must not be lost stays with the stream. Used on the session's
// thread.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/messages/server_message.h"
#include "server/session/datagram_session.h"
#include "server/session/input_intake.h"
#include "server/session/snapshot_stream.h"
#include "server/udp/datagram_server.h"
#include "server/util/clock.h"
#include "server/world/world_host.h"

namespace jostle::server {

class DatagramTransport {
public:
    // The parts of the session that datagrams feed. They outlive the transport.
    struct Parts {
        const WorldHost& host;
        InputIntake& inputs;
        SnapshotStream& snapshots;
        ClientId client = 0;
    };
    // Opens a connection and adds it to the welcome. `wake`: called on any thread when inputs
    // arrive. Null: the server has no free connection.
    static std::unique_ptr<DatagramTransport> open(DatagramServer& server, const Parts& parts,
                                                   std::function<void()> wake, Welcome& welcome);
    DatagramTransport(DatagramServer& server, std::shared_ptr<DatagramConnection> connection,
                      const Parts& parts);
    ~DatagramTransport() { parts_.snapshots.stop_datagrams(); }
    DatagramTransport(const DatagramTransport&) = delete;
    DatagramTransport& operator=(const DatagramTransport&) = delete;

    bool has_messages() const { return session_.has_messages(); }
    std::vector<DatagramConnection::ReceivedMessage> take_messages() {
        return session_.take_messages();
    }
    // Datagrams beyond the message rate are dropped: a later one repeats their data. Errors: the
    // datagram is malformed, or has a message that belongs on the stream.
    Status receive(const DatagramConnection::ReceivedMessage& received, Clock::time_point now);
    // Sends a snapshot of the newest frame if one is due and fits.
    void send(Clock::time_point now);

private:
    void drop_lost(Clock::time_point now);
    ClientUpdate client_update();

    const Parts parts_;
    DatagramSession session_;
};

}  // namespace jostle::server
