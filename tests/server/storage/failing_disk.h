// SPDX-License-Identifier: MIT
//
// A file system of SQLite's that fails when told to: an error, a full disk, or half of what is
// written. One at a time, for tests.
#pragma once

#include <sqlite3.h>

#include <atomic>

namespace jostle::test {

enum class DiskFault {
    none,
    error,  // each write and sync fails
    full,   // there is no space
    torn,   // the next write puts down half of its bytes and fails, and so do those after it
    slow,   // the next sync takes two and a half seconds, and then all is well
};

// Registers it when first called. Its name is what sqlite3_open_v2 takes.
const char* failing_disk();
// From now on, for all files.
void set_disk_fault(DiskFault fault);

}  // namespace jostle::test
