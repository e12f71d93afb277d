// SPDX-License-Identifier: MIT
#include "server/storage/store_head.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <utility>

#include "jostle/base/check.h"
#include "server/util/bytes.h"

namespace jostle::server {
namespace {

constexpr std::string_view magic = "JSTLHEAD1";
constexpr std::size_t slot_distance = 4096;  // in different blocks of the disk
constexpr std::size_t slot_bytes = 128;      // in one sector
constexpr std::size_t slots = 2;

// A slot: the head, zeros up to its digest, and the digest of all bytes before it.
constexpr std::size_t digest_at = slot_bytes - sizeof(Digest);

Digest digest_of_slot(std::string_view slot) {
    const std::string_view pieces[] = {slot.substr(0, digest_at)};
    return digest_of(pieces);
}

std::string encode(const StoreHead& head) {
    ASSERT(head.id.size() == StoreHead::id_bytes);
    ByteWriter to;
    to.text(magic);
    to.text(head.id);
    to.text(view_of(head.total.value()));
    to.number(head.commits);
    to.number(head.written);
    std::string slot = to.take();
    ASSERT(slot.size() <= digest_at);
    slot.resize(digest_at, '\0');
    slot += view_of(digest_of_slot(slot));
    return slot;
}

std::optional<StoreHead> decode(std::string_view slot) {
    if (slot.substr(digest_at) != view_of(digest_of_slot(slot))) return std::nullopt;
    ByteReader from(slot.substr(0, digest_at));
    if (from.text() != magic) return std::nullopt;
    StoreHead head{.id = std::string(from.text())};
    head.total.add(from.text());
    head.commits = from.number();
    head.written = from.number();
    if (!from.ok() || head.id.size() != StoreHead::id_bytes) return std::nullopt;
    return head;
}

Error failed(const std::string& path, const char* what) {
    const bool is_full = errno == ENOSPC || errno == EDQUOT;
    return {is_full ? ErrorCode::resource_exhausted : ErrorCode::unavailable,
            path + ": cannot " + what + ": " + std::strerror(errno)};
}

// Makes a new file of the folder survive a power failure.
Status sync_folder_of(const std::string& path) {
    std::string folder = std::filesystem::path(path).parent_path().string();
    if (folder.empty()) folder = ".";
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool ok = file >= 0 && ::fsync(file) == 0;
    if (file >= 0) ::close(file);
    return ok ? Status() : failed(folder, "synchronize the folder");
}

}  // namespace

void DigestTotal::add(std::string_view digest) {
    const std::string_view pieces[] = {digest};
    if (digest.size() != value_.size()) return add(view_of(digest_of(pieces)));
    for (std::size_t k = 0; k < value_.size(); k++)
        value_[k] ^= static_cast<std::uint8_t>(digest[k]);
}

HeadFile::~HeadFile() {
    if (file_ >= 0) ::close(file_);
}

Result<HeadFile::Content> HeadFile::read() const {
    const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (file < 0 && errno == ENOENT) return Content{};
    if (file < 0) return failed(path_, "open it");
    Content content{.exists = true};
    for (std::size_t k = 0; k < slots; k++) {
        std::array<char, slot_bytes> bytes{};
        const ssize_t size =
            ::pread(file, bytes.data(), bytes.size(), static_cast<off_t>(k * slot_distance));
        if (size < 0) {
            const Error error = failed(path_, "read it");
            ::close(file);
            return error;
        }
        const std::string_view slot(bytes.data(), bytes.size());
        const std::optional<StoreHead> head = decode(slot);
        const bool is_unused = std::ranges::all_of(slot, [](char c) { return c == 0; });
        if (!head && !is_unused) content.has_corrupt_slot = true;
        if (head && (!content.head || head->commits > content.head->commits)) content.head = head;
    }
    ::close(file);
    return content;
}

Status HeadFile::open_for_writing() {
    if (file_ >= 0) return {};
    const bool is_new = ::access(path_.c_str(), F_OK) != 0;
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (file_ < 0) return failed(path_, "open it");
    // Reserves the blocks of both slots, so that later writes also succeed on a full disk.
    const std::string zeros(slot_distance, '\0');
    if (is_new)
        for (std::size_t k = 0; k < slots; k++)
            if (::pwrite(file_, zeros.data(), zeros.size(),
                         static_cast<off_t>(k * slot_distance)) !=
                static_cast<ssize_t>(zeros.size())) {
                const Error error = failed(path_, "write it");
                ::close(std::exchange(file_, -1));
                ::unlink(path_.c_str());
                return error;
            }
    return is_new && sync_ ? sync_folder_of(path_) : Status();
}

Status HeadFile::write(const StoreHead& head) {
    if (Status s = open_for_writing(); !s.ok()) return s;
    const std::string slot = encode(head);
    const auto at = static_cast<off_t>(head.commits % slots * slot_distance);
    if (::pwrite(file_, slot.data(), slot.size(), at) != static_cast<ssize_t>(slot.size()))
        return failed(path_, "write it");
    if (sync_ && ::fdatasync(file_) != 0) return failed(path_, "synchronize it");
    return {};
}

std::string head_conflict(const StoreHead& stored, bool is_backup, const HeadFile::Content& file,
                          const std::string& file_path) {
    if (!file.exists)
        return is_backup ? ""
                         : "its file " + file_path +
                               " is missing, so the copy of the database is incomplete";
    if (!file.head) return "its file " + file_path + " is corrupt";
    const StoreHead& head = *file.head;
    if (head.id != stored.id) return "the file " + file_path + " belongs to another database";
    if (stored.commits < head.commits)
        return "it ends with commit " + std::to_string(stored.commits) + " of " +
               utc_text(stored.written) + ", but commit " + std::to_string(head.commits) + " of " +
               utc_text(head.written) +
               " was written: " + std::to_string(head.commits - stored.commits) +
               " commits are missing";
    if (stored.commits == head.commits && stored.total != head.total)
        return "its commit " + std::to_string(stored.commits) +
               " has other content than was written";
    return "";
}

std::string utc_text(std::uint64_t seconds_since_1970) {
    const auto time = static_cast<std::time_t>(seconds_since_1970);
    std::tm parts{};
    std::array<char, 64> text{};
    if (::gmtime_r(&time, &parts) == nullptr) return std::to_string(seconds_since_1970);
    const std::size_t size =
        std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &parts);
    return {text.data(), size};
}

}  // namespace jostle::server
