// SPDX-License-Identifier: MIT
#include "server/recovery/crash_markers.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "jostle/base/check.h"

namespace jostle::server {

struct CrashMarkers::File {
    static constexpr char written_mark[8] = {'J', 's', 't', 'M', 'r', 'k', '0', '1'};
    char mark[8];
    CrashMarker::Slot slots[worlds_max];
};

namespace {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
static_assert(sizeof(CrashMarker::Slot) == 52);

std::atomic<CrashMarkers*> active_markers{nullptr};

void on_fatal_signal(int number) {
    if (CrashMarkers* const marks = active_markers.load()) marks->on_crash();
    std::signal(number, SIG_DFL);
    raise(number);
}

}  // namespace

void CrashMarker::forget() const {
    if (slot_) slot_->tick = slot_->crashes = 0;
}

Result<std::unique_ptr<CrashMarkers>> CrashMarkers::open(const std::string& path) {
    const auto failed = [&] {
        return Error{ErrorCode::unavailable, path + ": " + std::strerror(errno)};
    };
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return failed();
    struct stat info {};
    const bool fits =
        fstat(file, &info) == 0 && static_cast<std::size_t>(info.st_size) == sizeof(File);
    void* at = MAP_FAILED;
    bool is_stored = false;
    if (fits || (ftruncate(file, 0) == 0 && ftruncate(file, sizeof(File)) == 0)) {
        // A write to a mapped page for which the disk has no block would end the process.
        const int reserved = posix_fallocate(file, 0, sizeof(File));
        is_stored = reserved == 0 || reserved == EOPNOTSUPP;
        at = mmap(nullptr, sizeof(File), PROT_READ | PROT_WRITE,
                  is_stored ? MAP_SHARED : MAP_PRIVATE, file, 0);
    }
    const Error error = failed();
    ::close(file);
    if (at == MAP_FAILED) return error;
    File* const mapped = static_cast<File*>(at);
    if (std::memcmp(mapped->mark, File::written_mark, sizeof mapped->mark) != 0) {
        std::memset(at, 0, sizeof(File));
        std::memcpy(mapped->mark, File::written_mark, sizeof mapped->mark);
    }
    // Ticks that ran when the process was killed did not crash.
    for (CrashMarker::Slot& slot : mapped->slots) {
        slot.running_tick.store(0);
        slot.world[sizeof slot.world - 1] = '\0';
    }
    return std::unique_ptr<CrashMarkers>(new CrashMarkers(mapped, is_stored));
}

CrashMarkers::~CrashMarkers() {
    CrashMarkers* self = this;
    active_markers.compare_exchange_strong(self, nullptr);
    munmap(file_, sizeof(File));
}

CrashMarker CrashMarkers::of(const std::string& world) {
    if (world.empty() || world.size() >= sizeof(CrashMarker::Slot::world)) return {};
    CrashMarker::Slot* unused = nullptr;
    for (CrashMarker::Slot& slot : file_->slots) {
        if (world == slot.world) return CrashMarker(&slot);
        if (!unused && slot.world[0] == '\0') unused = &slot;
    }
    if (!unused) return {};
    ASSERT(world.size() < sizeof unused->world);
    std::memcpy(unused->world, world.c_str(), world.size() + 1);
    unused->tick = unused->crashes = 0;
    return CrashMarker(unused);
}

void CrashMarkers::drop(const std::string& world) {
    for (CrashMarker::Slot& slot : file_->slots)
        if (world == slot.world) slot.world[0] = '\0';
}

void CrashMarkers::on_crash() {
    for (CrashMarker::Slot& slot : file_->slots) {
        const std::uint32_t tick = slot.running_tick.load(std::memory_order_relaxed);
        if (tick == 0) continue;
        slot.crashes = slot.tick == tick ? slot.crashes + 1 : 1;
        slot.tick = tick;
        slot.running_tick.store(0);
    }
}

void CrashMarkers::count_fatal_signals(CrashMarkers* marks) {
    active_markers.store(marks);
    struct sigaction action {};
    action.sa_handler = marks ? on_fatal_signal : SIG_DFL;
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        sigaction(number, &action, nullptr);
}

}  // namespace jostle::server
