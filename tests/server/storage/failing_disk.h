// SPDX-License-Identifier: MIT
//
// A VFS for SQLite that fails on request: an I/O error, a full disk or a torn write. One fault at a
// time, for tests.
#pragma once

#include <sqlite3.h>

#include <atomic>

namespace jostle::test {

enum class DiskFault {
    none,
    error,  // every write and sync fails
    full,   // the disk is full
    torn,   // the next write stores half of its bytes and fails; later writes fail as well
    slow,   // the next sync takes 2.5 s; then the disk works again
};

// Registers the VFS on the first call. Returns its name for sqlite3_open_v2.
const char* failing_disk();
// Sets the fault for all files from now on.
void set_disk_fault(DiskFault fault);

}  // namespace jostle::test
