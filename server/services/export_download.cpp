// SPDX-License-Identifier: MIT
#include "server/services/export_download.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "server/util/random_id.h"

namespace jostle::server {

Status ExportDownload::admit(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    return admit_locked(now);
}

Status ExportDownload::admit_locked(Clock::time_point now) const {
    if (id_.empty() || now - last_read_ > idle_max) return {};
    return Error{ErrorCode::resource_exhausted, "another export is being read; retry later", 1000};
}

Result<ExportDownload::Piece> ExportDownload::begin(std::string world, std::string bytes,
                                                    Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (Status s = admit_locked(now); !s.ok()) return s.error();
    id_ = random_id();
    world_ = std::move(world);
    bytes_ = std::move(bytes);
    last_read_ = now;
    return piece_locked(0);
}

Result<ExportDownload::Piece> ExportDownload::read(const std::string& world, const std::string& id,
                                                   std::uint64_t offset, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (id.empty() || id != id_ || world != world_)
        return Error{ErrorCode::not_found,
                     "there is no such export of this world; an export that is not read for ten "
                     "seconds is deleted"};
    if (offset > bytes_.size())
        return invalid_argument(
            fmt::format("offset is {}; the export has {} bytes", offset, bytes_.size()));
    last_read_ = now;
    Piece piece = piece_locked(offset);
    if (piece.data.empty()) {  // the client has everything
        id_.clear();
        std::string().swap(bytes_);
    }
    return piece;
}

void ExportDownload::remove_idle(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (id_.empty() || now - last_read_ <= idle_max) return;
    id_.clear();
    std::string().swap(bytes_);
}

ExportDownload::Piece ExportDownload::piece_locked(std::uint64_t offset) const {
    return {.id = id_, .bytes = bytes_.size(), .data = bytes_.substr(offset, piece_bytes_max)};
}

}  // namespace jostle::server
