// SPDX-License-Identifier: MIT
#include "tools/load/load_metrics.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include <time.h>

namespace jostle::load {

void LoadMetrics::add_age(std::int64_t us, Clock::time_point now) {
    age.add(us);
    const auto window = static_cast<std::size_t>(std::max<std::int64_t>(
        0, std::chrono::duration_cast<std::chrono::seconds>(now - start_).count() / window_s));
    if (age_windows.size() <= window) age_windows.resize(window + 1);
    age_windows[window].add(us);
}

void LoadMetrics::add_error(const std::string& what) {
    errors++;
    last_error = what;
}

void LoadMetrics::begin(Clock::time_point now) {
    LoadMetrics fresh;
    fresh.errors = errors;
    fresh.last_error = std::move(last_error);
    fresh.start_ = now;
    *this = std::move(fresh);
}

void LoadMetrics::end(Clock::time_point now) {
    seconds = std::chrono::duration<double>(now - start_).count();
}

void LoadMetrics::merge(const LoadMetrics& other) {
    messages += other.messages;
    bytes += other.bytes;
    snapshots += other.snapshots;
    snapshot_bytes += other.snapshot_bytes;
    decoded += other.decoded;
    inputs_sent += other.inputs_sent;
    inputs_applied += other.inputs_applied;
    errors += other.errors;
    rendered += other.rendered;
    frozen += other.frozen;
    user_messages += other.user_messages;
    messages_missed += other.messages_missed;
    if (last_error.empty()) last_error = other.last_error;
    seconds = std::max(seconds, other.seconds);
    cpu_seconds += other.cpu_seconds;
    age.merge(other.age);
    gap.merge(other.gap);
    result_delay.merge(other.result_delay);
    effect_delay.merge(other.effect_delay);
    message_delay.merge(other.message_delay);
    age_windows.resize(std::max(age_windows.size(), other.age_windows.size()));
    for (std::size_t k = 0; k < other.age_windows.size(); k++)
        age_windows[k].merge(other.age_windows[k]);
}

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
