// SPDX-License-Identifier: MIT
//
// Files that operators replace while the server runs: detects a replacement, and reads a file
// without trusting it. Symbolic links are followed, so a swapped link (as in Kubernetes secrets)
// counts as a new file.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>

#include "jostle/base/check.h"
#include "jostle/base/result.h"

namespace jostle::server {

struct FileStamp {
    bool exists = false;
    std::uint64_t device = 0, inode = 0, mode = 0;
    std::int64_t bytes = 0, modified_s = 0, modified_ns = 0, changed_s = 0, changed_ns = 0;

    bool operator==(const FileStamp&) const = default;
};

inline FileStamp stamp_of(const std::string& path) {
    struct stat s {};
    if (::stat(path.c_str(), &s) != 0) return {};
    return {.exists = true,
            .device = s.st_dev,
            .inode = s.st_ino,
            .mode = s.st_mode,
            .bytes = s.st_size,
            .modified_s = s.st_mtim.tv_sec,
            .modified_ns = s.st_mtim.tv_nsec,
            .changed_s = s.st_ctim.tv_sec,
            .changed_ns = s.st_ctim.tv_nsec};
}

// Reads an entire regular file of at most `bytes_max` bytes. A pipe or a device is rejected without
// waiting for it.
inline Result<std::string> read_bounded(const std::string& path, std::size_t bytes_max) {
    const auto failed = [&](const std::string& why) {
        return Error{ErrorCode::failed_precondition, "cannot read " + path + ": " + why};
    };
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) return failed(std::strerror(errno));
    struct Closer {
        int fd;
        ~Closer() { ::close(fd); }
    } const closer{file};
    struct stat s {};
    if (::fstat(file, &s) != 0) return failed(std::strerror(errno));
    if (!S_ISREG(s.st_mode)) return failed("it is not a regular file");
    std::string text(bytes_max + 1, '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t got = ::read(file, text.data() + size, text.size() - size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return failed(std::strerror(errno));
        if (got == 0) break;
        size += static_cast<std::size_t>(got);
        ASSERT(size <= text.size());
    }
    if (size > bytes_max)
        return failed("it is longer than " + std::to_string(bytes_max) + " bytes");
    text.resize(size);
    return text;
}

}  // namespace jostle::server
