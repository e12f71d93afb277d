// SPDX-License-Identifier: MIT
#include <cstdio>
#include <fstream>

#include "bench/stream/minimal_server.h"
#include "jostle/v1/play.pb.h"

namespace jostle::bench {

MinimalServerMessage make_minimal_server_message(int bytes, std::uint32_t frame) {
    v1::Snapshot snapshot;
    snapshot.set_frame(frame);
    snapshot.set_baselines(1);
    snapshot.set_crc(frame);
    const auto rest = bytes - static_cast<int>(snapshot.ByteSizeLong());
    std::string packed(static_cast<std::size_t>(rest > 3 ? rest - 3 : 0), '\0');
    for (std::size_t k = 0; k < packed.size(); k++)
        packed[k] = static_cast<char>((k * 2654435761u + frame) >> 7);
    snapshot.set_packed(packed);
    MinimalServerMessage message{.head = {}, .shared = snapshot.SerializeAsString()};
    // The tag of ServerMessage.snapshot and the length.
    message.head.push_back(v1::ServerMessage::kSnapshotFieldNumber << 3 | 2);
    std::size_t size = message.shared.size();
    for (; size >= 0x80; size >>= 7)
        message.head.push_back(static_cast<char>(0x80 | (size & 0x7f)));
    message.head.push_back(static_cast<char>(size));
    return message;
}

Status write_port_file(const std::string& port_file, int port) {
    const std::string temporary = port_file + ".new";
    std::ofstream out(temporary);
    out << "{\"grpc\": " << port << ", \"http\": " << port << ", \"admin\": 0}\n";
    out.close();
    if (out && std::rename(temporary.c_str(), port_file.c_str()) == 0) return {};
    return invalid_argument("cannot write " + port_file);
}

}  // namespace jostle::bench
