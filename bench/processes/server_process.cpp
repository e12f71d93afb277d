// SPDX-License-Identifier: MIT
#include "bench/processes/server_process.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace jostle::bench {
namespace {

constexpr auto start_timeout = std::chrono::seconds(20);

std::vector<std::string> with_ports(std::vector<std::string> flags, const std::string& folder) {
    flags.insert(flags.end(), {"--port-file", folder + "/ports.json"});
    if (std::find(flags.begin(), flags.end(), "--admin") == flags.end())
        flags.insert(flags.end(), {"--admin", "127.0.0.1:0"});
    return flags;
}

}  // namespace

TemporaryFolder::TemporaryFolder()
    : path((std::filesystem::temp_directory_path() / "jostle-server-XXXXXX").string()) {
    if (mkdtemp(path.data()) == nullptr)
        throw std::runtime_error("cannot create a temporary folder");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

ServerProcess::ServerProcess(const std::string& path, std::vector<std::string> flags,
                             bool wait_for_ports)
    : program_(path, with_ports(std::move(flags), folder_.path), folder_.path + "/log") {
    if (!wait_for_ports) return;
    const auto deadline = std::chrono::steady_clock::now() + start_timeout;
    while (!read_ports() && is_running() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

bool ServerProcess::read_ports() {
    const std::string text = read_file(folder_.path + "/ports.json");
    return std::sscanf(text.c_str(), "{\"grpc\": %d, \"http\": %d, \"admin\": %d", &grpc_port_,
                       &http_port_, &admin_port_) >= 2;
}

double ServerProcess::cpu_seconds() const {
    const std::string text = read_file("/proc/" + std::to_string(program_.pid()) + "/stat");
    // The name in parentheses may contain any characters; the fields after it are numbers. utime
    // and stime are the 14th and 15th fields.
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace jostle::bench
