// SPDX-License-Identifier: MIT
#include "bench/processes/program.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

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

namespace {

void write_all(int file, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t wrote = write(file, text.data() + at, text.size() - at);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote <= 0) _exit(1);  // the parent has ended
        at += static_cast<std::size_t>(wrote);
    }
}

std::string read_all(int file) {
    std::string text;
    char part[4096];
    for (;;) {
        const ssize_t count = read(file, part, sizeof part);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(part, static_cast<std::size_t>(count));
    }
}

// _exit skips the parent's buffers and destructors, which belong to the parent.
[[noreturn]] void run_child(int out, const std::function<std::string()>& work) {
    try {
        write_all(out, work());
    } catch (const std::exception& error) {
        write_all(out, error.what());
        _exit(1);
    }
    _exit(0);
}

ChildResult child_result_of(std::string text, int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return {"", "ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")"};
    }
    if (WEXITSTATUS(status) == 0) return {std::move(text), ""};
    if (!text.empty()) return {"", std::move(text)};
    return {"", "ended with status " + std::to_string(WEXITSTATUS(status))};
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work) {
    int ends[2];
    if (pipe(ends) != 0) return {"", std::string("no pipe: ") + std::strerror(errno)};
    std::fflush(nullptr);  // otherwise the child would write the buffered output again
    const pid_t child = fork();
    if (child < 0) {
        const std::string reason = std::strerror(errno);
        close(ends[0]);
        close(ends[1]);
        return {"", "cannot start a child process: " + reason};
    }
    if (child == 0) {
        close(ends[0]);
        run_child(ends[1], work);
    }
    close(ends[1]);
    std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return child_result_of(std::move(text), status);
}

}  // namespace jostle::bench
