// SPDX-License-Identifier: MIT
//
// A folder that only this process's user can look into, for as long as the object lives. Files in
// it change all at once: whoever reads one sees the old or the new, never a part.
#pragma once

#include <ctime>
#include <memory>
#include <string>

#include "jostle/base/result.h"

namespace jostle::server {

class PrivateFolder {
public:
    // In memory (/dev/shm) where that can be had; else in TMPDIR or /tmp.
    static Result<std::unique_ptr<PrivateFolder>> make();
    ~PrivateFolder();  // with all that is in it

    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    const std::string& path() const { return path_; }

    // Written aside, then renamed. Each write of a folder carries a modification time of its own, a
    // second or more after the one before: readers that compare whole seconds before and after they
    // read (gRPC does) notice every change.
    Status write(const std::string& name, const std::string& text);

private:
    explicit PrivateFolder(std::string path) : path_(std::move(path)) {}

    const std::string path_;
    std::time_t last_time_ = 0;
};

}  // namespace jostle::server
