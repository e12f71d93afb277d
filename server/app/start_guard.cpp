// SPDX-License-Identifier: MIT
#include "server/app/start_guard.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

namespace jostle::server {

namespace {

// More than the stack of a thread. If this much address space is not available, memory is the cause
// of a failure.
constexpr std::size_t probe_bytes = 16u << 20;

std::terminate_handler previous_terminate = nullptr;
struct sigaction previous_abort {};
std::atomic<bool> is_starting{false};

// Text on the stack: there is no memory for a string when it is needed.
class Message {
public:
    Message& operator<<(std::string_view text) {
        for (const char c : text)
            if (size_ < buffer_.size()) buffer_[size_++] = c;
        return *this;
    }
    Message& operator<<(rlim_t number) {
        std::array<char, 24> digits{};
        const auto end = std::to_chars(digits.begin(), digits.end(), number).ptr;
        return *this << std::string_view(digits.data(),
                                         static_cast<std::size_t>(end - digits.data()));
    }
    std::string_view text() const { return {buffer_.data(), size_}; }

private:
    std::array<char, 512> buffer_{};
    std::size_t size_ = 0;
};

bool is_out_of_address_space() {
    void* const probe =
        ::mmap(nullptr, probe_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (probe == MAP_FAILED) return true;
    ::munmap(probe, probe_bytes);
    return false;
}

// False: there is no such limit.
bool write_limit(Message& out, std::string_view what, int resource, std::string_view name) {
    rlimit limit{};
    const auto kind = static_cast<__rlimit_resource_t>(resource);
    if (::getrlimit(kind, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
    out << what << limit.rlim_cur / (resource == RLIMIT_NPROC ? 1 : 1024)
        << (resource == RLIMIT_NPROC ? "" : " kB") << " (" << name
        << "); raise or remove the limit";
    return true;
}

void write_memory(Message& out) {
    out << "out of memory: ";
    if (write_limit(out, "the address space is limited to ", RLIMIT_AS, "RLIMIT_AS, ulimit -v"))
        return;
    if (write_limit(out, "the data segment is limited to ", RLIMIT_DATA, "RLIMIT_DATA, ulimit -d"))
        return;
    out << "the machine or the container has too little; add memory, or reduce scenes and "
           "world.bodies_max";
}

void write_threads(Message& out) {
    out << "cannot create a thread: ";
    if (!write_limit(out, "the processes and threads of this user are limited to ", RLIMIT_NPROC,
                     "RLIMIT_NPROC, ulimit -u"))
        out << "the machine or the container has reached its limit of threads; raise it";
}

[[noreturn]] void fail(const Message& why) {
    Message line;
    line << "jostle-server: cannot start: " << why.text() << "\n";
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, line.text().data(), line.text().size());
    ::_exit(1);
}

void on_terminate() {
    if (is_starting) {
        Message why;
        try {
            if (const std::exception_ptr error = std::current_exception())
                std::rethrow_exception(error);
        } catch (const std::bad_alloc&) {
            write_memory(why);
            fail(why);
        } catch (const std::system_error& error) {
            const bool is_limit = error.code() == std::errc::resource_unavailable_try_again ||
                                  error.code() == std::errc::not_enough_memory;
            if (is_limit && is_out_of_address_space()) {
                write_memory(why);
                fail(why);
            }
            if (is_limit) {
                write_threads(why);
                fail(why);
            }
        } catch (...) {
        }
    }
    if (previous_terminate) previous_terminate();
    std::abort();
}

// Libraries in C call abort() if an allocation fails. Any other abort takes its usual course.
void on_abort(int) {
    if (is_starting && is_out_of_address_space()) {
        Message why;
        write_memory(why);
        fail(why);
    }
    ::sigaction(SIGABRT, &previous_abort, nullptr);
}

std::string text_of(void (*write)(Message&)) {
    Message message;
    write(message);
    return std::string(message.text());
}

}  // namespace

std::string out_of_memory_text() {
    return text_of(write_memory);
}

std::string out_of_threads_text() {
    return text_of(write_threads);
}

void begin_start_guard() {
    previous_terminate = std::set_terminate(on_terminate);
    struct sigaction action {};
    action.sa_handler = on_abort;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGABRT, &action, &previous_abort);
    is_starting = true;
}

// A handler that was installed meanwhile stays: it is newer.
void end_start_guard() {
    if (!is_starting.exchange(false)) return;
    std::set_terminate(previous_terminate);
    struct sigaction current {};
    if (::sigaction(SIGABRT, nullptr, &current) == 0 && current.sa_handler == on_abort)
        ::sigaction(SIGABRT, &previous_abort, nullptr);
}

}  // namespace jostle::server
