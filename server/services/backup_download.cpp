// SPDX-License-Identifier: MIT
#include "server/services/backup_download.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "server/util/random_id.h"

namespace jostle::server {
namespace {

Error busy() {
    return {ErrorCode::resource_exhausted, "another backup is being made or read; retry later",
            5000};
}

}  // namespace

Result<BackupDownload::Piece> BackupDownload::begin(WorldPersistence& persistence,
                                                    Clock::time_point now) {
    {
        const std::lock_guard lock(mutex_);
        if (is_making_ || (file_ && !is_idle(now))) return busy();
        file_.reset();
        is_making_ = true;
    }
    Result<TemporaryFile> made = persistence.back_up();
    const std::lock_guard lock(mutex_);
    is_making_ = false;
    if (!made.ok()) return made.error();
    file_ = *std::move(made);
    id_ = random_id();
    last_read_ = Clock::now();
    const bool is_sized = ::fseeko(file_.get(), 0, SEEK_END) == 0;
    bytes_ = is_sized ? static_cast<std::uint64_t>(::ftello(file_.get())) : 0;
    return read_locked(0);
}

Result<BackupDownload::Piece> BackupDownload::read(const std::string& id, std::uint64_t offset,
                                                   Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (!file_ || id.empty() || id != id_)
        return Error{ErrorCode::not_found,
                     "there is no such backup; a backup that is not read for a minute is deleted"};
    if (offset > bytes_)
        return invalid_argument(
            fmt::format("offset is {}; the backup has {} bytes", offset, bytes_));
    last_read_ = now;
    Result<Piece> piece = read_locked(offset);
    if (piece.ok() && offset == bytes_) file_.reset();  // the client has everything
    return piece;
}

void BackupDownload::remove_idle(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (file_ && is_idle(now)) file_.reset();
}

Result<BackupDownload::Piece> BackupDownload::read_locked(std::uint64_t offset) {
    Piece piece{.id = id_, .bytes = bytes_, .data = {}};
    piece.data.resize(std::min<std::uint64_t>(piece_bytes_max, bytes_ - offset));
    const bool is_read =
        ::fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) == 0 &&
        std::fread(piece.data.data(), 1, piece.data.size(), file_.get()) == piece.data.size();
    if (is_read) return piece;
    return Error{ErrorCode::unavailable,
                 fmt::format("cannot read the backup: {}", std::strerror(errno))};
}

}  // namespace jostle::server
