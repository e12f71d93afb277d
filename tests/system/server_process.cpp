// SPDX-License-Identifier: MIT
#include "system/server_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace jostle::test {

namespace {

constexpr auto start_patience = std::chrono::seconds(20);
constexpr auto poll_period = std::chrono::milliseconds(10);

std::string text_of(const std::string& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

[[noreturn]] void become_server(const std::vector<std::string>& arguments, const std::string& log) {
    const int out = open(log.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

}  // namespace

ServerProcess::ServerProcess(std::vector<std::string> flags, bool wait_for_ports) {
    std::string name = (std::filesystem::temp_directory_path() / "jostle-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    flags.insert(flags.begin(), JOSTLE_SERVER);
    flags.insert(flags.end(), {"--port-file", folder_ + "/ports.json"});
    if (std::find(flags.begin(), flags.end(), "--admin") == flags.end())
        flags.insert(flags.end(), {"--admin", "127.0.0.1:0"});
    pid_ = fork();
    if (pid_ == 0) become_server(flags, folder_ + "/log");
    if (!wait_for_ports) return;
    const auto deadline = std::chrono::steady_clock::now() + start_patience;
    while (!read_ports() && runs() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(poll_period);
    }
}

ServerProcess::~ServerProcess() {
    if (runs()) {
        signal(SIGKILL);
        wait(std::chrono::seconds(5));
    }
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

bool ServerProcess::read_ports() {
    const std::string text = text_of(folder_ + "/ports.json");
    return std::sscanf(text.c_str(), "{\"grpc\": %d, \"http\": %d, \"admin\": %d", &grpc_port_,
                       &http_port_, &admin_port_) >= 2;
}

bool ServerProcess::runs() {
    return !wait(std::chrono::milliseconds(0));
}

void ServerProcess::signal(int number) {
    if (runs()) kill(pid_, number);
}

std::optional<int> ServerProcess::wait(std::chrono::milliseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!status_) {
        int status = 0;
        if (waitpid(pid_, &status, WNOHANG) == pid_) {
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        } else if (std::chrono::steady_clock::now() >= deadline) {
            return std::nullopt;
        } else {
            std::this_thread::sleep_for(poll_period);
        }
    }
    return status_;
}

std::string ServerProcess::log() const {
    return text_of(folder_ + "/log");
}

double ServerProcess::cpu_seconds() const {
    const std::string text = text_of("/proc/" + std::to_string(pid_) + "/stat");
    // The name in brackets may hold anything; the fields after it are numbers. utime and stime are
    // the 14th and 15th.
    std::istringstream fields(text.substr(text.rfind(')') + 1));
    std::string skipped;
    for (int i = 3; i < 14; ++i) fields >> skipped;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace jostle::test
