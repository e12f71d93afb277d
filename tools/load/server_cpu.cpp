// SPDX-License-Identifier: MIT
#include "tools/load/server_cpu.h"

#include <time.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace jostle::load {

namespace fs = std::filesystem;

namespace {

// Inode of a listening socket, from a /proc/net/tcp table: state 0A means listening, and the local
// address ends with the port in hexadecimal.
std::optional<std::string> listening_inode(const char* table, int port) {
    std::ifstream in(table);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream words(line);
        std::string slot, local, remote, state, skip, inode;
        words >> slot >> local >> remote >> state >> skip >> skip >> skip >> skip >> skip >> inode;
        const std::size_t colon = local.rfind(':');
        if (state != "0A" || colon == std::string::npos) continue;
        if (std::strtol(local.c_str() + colon + 1, nullptr, 16) == port) return inode;
    }
    return std::nullopt;
}

}  // namespace

std::optional<int> find_listener(const std::string& target) {
    const std::size_t colon = target.rfind(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string host = target.substr(0, colon);
    if (host != "localhost" && host != "127.0.0.1" && host != "[::1]") return std::nullopt;
    const int port = std::atoi(target.c_str() + colon + 1);
    auto inode = listening_inode("/proc/net/tcp", port);
    if (!inode) inode = listening_inode("/proc/net/tcp6", port);
    if (!inode) return std::nullopt;
    const std::string link_text = "socket:[" + *inode + "]";
    std::error_code error;
    for (const auto& process : fs::directory_iterator("/proc", error)) {
        const std::string pid = process.path().filename();
        if (pid.find_first_not_of("0123456789") != std::string::npos) continue;
        std::error_code denied;
        for (const auto& fd : fs::directory_iterator(process.path() / "fd", denied))
            if (fs::read_symlink(fd.path(), denied) == link_text) return std::atoi(pid.c_str());
    }
    return std::nullopt;
}

std::optional<double> cpu_seconds(int pid) {
    clockid_t clock{};
    timespec t{};
    if (clock_getcpuclockid(pid, &clock) != 0 || clock_gettime(clock, &t) != 0) return std::nullopt;
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace jostle::load
