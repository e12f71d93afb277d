// SPDX-License-Identifier: MIT
#include "bench/processes/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <thread>

namespace jostle::bench {
namespace {

constexpr auto poll_period = std::chrono::milliseconds(10);
constexpr auto kill_timeout = std::chrono::seconds(5);

[[noreturn]] void exec_program(const std::string& path, const std::vector<std::string>& flags,
                               const std::string& log) {
    const int out = open(log.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    std::vector<char*> argv = {const_cast<char*>(path.c_str())};
    for (const std::string& flag : flags) argv.push_back(const_cast<char*>(flag.c_str()));
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(127);
}

}  // namespace

Program::Program(const std::string& path, const std::vector<std::string>& flags,
                 const std::string& log)
    : log_(log) {
    pid_ = fork();
    if (pid_ == 0) exec_program(path, flags, log);
    if (pid_ < 0) status_ = 127;
}

Program::~Program() {
    if (!is_running()) return;
    signal(SIGKILL);
    wait(kill_timeout);
}

bool Program::is_running() {
    return !wait(std::chrono::milliseconds(0));
}

void Program::signal(int number) {
    if (is_running()) kill(pid_, number);
}

std::optional<int> Program::wait(std::chrono::milliseconds timeout) {
    const auto deadline = std::chrono::steady_clock::now() + timeout;
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

std::string Program::log() const {
    return read_file(log_);
}

std::string read_file(const std::string& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace jostle::bench
