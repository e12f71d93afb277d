// SPDX-License-Identifier: MIT
#include "bench/speed/child_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

namespace jostle::bench {
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
