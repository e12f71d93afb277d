// SPDX-License-Identifier: MIT
#include "tls/private_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace jostle::server {

namespace {

Error failed(const std::string& what) {
    return {ErrorCode::failed_precondition, what + ": " + std::strerror(errno)};
}

bool write_all(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

}  // namespace

Result<std::unique_ptr<PrivateFolder>> PrivateFolder::make() {
    const char* chosen = std::getenv("TMPDIR");
    for (const std::string parent : {"/dev/shm", chosen && *chosen ? chosen : "/tmp", "/tmp"}) {
        std::string path = parent + "/jostle-XXXXXX";
        if (::mkdtemp(path.data()))  // with mode 0700
            return std::unique_ptr<PrivateFolder>(new PrivateFolder(std::move(path)));
    }
    return failed(
        "cannot make a folder for certificates in /dev/shm, TMPDIR or /tmp; set TMPDIR to a folder "
        "that may be written to");
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;  // what cannot be removed stays, and nobody else can read it
    std::filesystem::remove_all(path_, ignored);
}

Status PrivateFolder::write(const std::string& name, const std::string& text) {
    const std::string aside = path_ + "/.new", target = path_ + "/" + name;
    const int file = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) return failed("cannot write " + aside);
    last_time_ = std::max(std::time(nullptr), last_time_ + 1);
    const timespec times[2] = {{.tv_sec = last_time_}, {.tv_sec = last_time_}};
    const bool written = write_all(file, text) && ::futimens(file, times) == 0;
    const Status status = written ? Status() : failed("cannot write " + aside);
    ::close(file);
    if (!status.ok()) return status;
    if (::rename(aside.c_str(), target.c_str()) != 0) return failed("cannot rename " + aside);
    return {};
}

}  // namespace jostle::server
