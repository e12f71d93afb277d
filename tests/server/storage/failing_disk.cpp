// SPDX-License-Identifier: MIT
#include "tests/server/storage/failing_disk.h"

#include <chrono>
#include <cstddef>
#include <mutex>
#include <thread>

namespace jostle::test {
namespace {

std::atomic<DiskFault> fault{DiskFault::none};

// State of an open file of SQLite: this struct, followed by the file of the default VFS.
struct File {
    sqlite3_file base;
    sqlite3_io_methods methods;
};
sqlite3_file* real_of(sqlite3_file* file) {
    return reinterpret_cast<sqlite3_file*>(reinterpret_cast<File*>(file) + 1);
}

int write(sqlite3_file* file, const void* data, int size, sqlite3_int64 at) {
    sqlite3_file* const real = real_of(file);
    switch (fault.load()) {
        case DiskFault::none:
        case DiskFault::slow:
            return real->pMethods->xWrite(real, data, size, at);
        case DiskFault::full:
            return SQLITE_FULL;
        case DiskFault::torn:
            real->pMethods->xWrite(real, data, size / 2, at);
            fault = DiskFault::error;
            return SQLITE_IOERR_WRITE;
        case DiskFault::error:
            break;
    }
    return SQLITE_IOERR_WRITE;
}
int sync(sqlite3_file* file, int flags) {
    sqlite3_file* const real = real_of(file);
    DiskFault slow = DiskFault::slow;
    if (fault.compare_exchange_strong(slow, DiskFault::none))
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    return fault == DiskFault::none ? real->pMethods->xSync(real, flags) : SQLITE_IOERR_FSYNC;
}

// Forwards a method to the real file.
template <auto member, class... Arguments>
int pass(sqlite3_file* file, Arguments... arguments) {
    sqlite3_file* const real = real_of(file);
    return (real->pMethods->*member)(real, arguments...);
}
int close(sqlite3_file* file) {
    sqlite3_file* const real = real_of(file);
    return real->pMethods != nullptr ? real->pMethods->xClose(real) : SQLITE_OK;
}

int open(sqlite3_vfs* vfs, sqlite3_filename name, sqlite3_file* file, int flags, int* out) {
    auto* const usual = static_cast<sqlite3_vfs*>(vfs->pAppData);
    using Methods = sqlite3_io_methods;
    auto* const ours = reinterpret_cast<File*>(file);
    ours->methods = {};
    ours->methods.iVersion = 1;  // no shared memory: the storage locks its file exclusively
    ours->methods.xClose = close;
    ours->methods.xRead = pass<&Methods::xRead>;
    ours->methods.xWrite = write;
    ours->methods.xTruncate = pass<&Methods::xTruncate>;
    ours->methods.xSync = sync;
    ours->methods.xFileSize = pass<&Methods::xFileSize>;
    ours->methods.xLock = pass<&Methods::xLock>;
    ours->methods.xUnlock = pass<&Methods::xUnlock>;
    ours->methods.xCheckReservedLock = pass<&Methods::xCheckReservedLock>;
    ours->methods.xFileControl = pass<&Methods::xFileControl>;
    ours->methods.xSectorSize = pass<&Methods::xSectorSize>;
    ours->methods.xDeviceCharacteristics = pass<&Methods::xDeviceCharacteristics>;
    const int opened = usual->xOpen(usual, name, real_of(file), flags, out);
    file->pMethods = opened == SQLITE_OK ? &ours->methods : nullptr;
    return opened;
}

}  // namespace

const char* failing_disk() {
    static sqlite3_vfs vfs;
    static std::once_flag once;
    std::call_once(once, [] {
        sqlite3_vfs* const usual = sqlite3_vfs_find(nullptr);
        vfs = *usual;
        vfs.pNext = nullptr;
        vfs.zName = "failing-disk";
        vfs.szOsFile = static_cast<int>(sizeof(File)) + usual->szOsFile;
        vfs.pAppData = usual;
        vfs.xOpen = open;
        sqlite3_vfs_register(&vfs, 0);
    });
    return vfs.zName;
}

void set_disk_fault(DiskFault now) {
    fault = now;
}

}  // namespace jostle::test
