// SPDX-License-Identifier: MIT
#include "server/app/port_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace jostle::server {

Status write_port_file(const std::string& path, const Ports& ports) {
    if (path.empty()) return {};
    // Written to a temporary file and renamed, so that a reader never sees a partial file.
    const std::string temporary = path + ".new";
    std::ofstream out(temporary);
    out << "{\"grpc\": " << ports.grpc << ", \"http\": " << ports.http;
    if (ports.admin != 0) out << ", \"admin\": " << ports.admin;
    if (ports.datagrams != 0) out << ", \"datagrams\": " << ports.datagrams;
    out << "}\n";
    out.close();
    if (!out || std::rename(temporary.c_str(), path.c_str()) != 0)
        return Error{ErrorCode::unavailable,
                     "cannot write the port file " + path + ": " + std::strerror(errno)};
    return {};
}

}  // namespace jostle::server
