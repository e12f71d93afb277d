// SPDX-License-Identifier: MIT
#include "tools/record/recorder.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>

namespace jostle::record {

Status Recorder::open(const std::string& path, bool replace) {
    const std::lock_guard lock(mutex_);
    std::error_code ignored;
    if (!replace && std::filesystem::exists(path, ignored))
        return Error{ErrorCode::already_exists,
                     path + " exists; choose another file or use --replace"};
    path_ = path;
    out_.open(path, std::ios::binary | std::ios::trunc);
    if (!out_) return invalid_argument("cannot write " + path + ": " + std::strerror(errno));
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    writer_.emplace(out_, static_cast<std::uint64_t>(
                              std::chrono::duration_cast<std::chrono::microseconds>(now).count()));
    start_ = client::Clock::now();
    return {};
}

void Recorder::on_message(const std::string& bytes, client::Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    // A server that rejects the client sends a Notice before any Welcome; the client reports its
    // text.
    v1::ServerMessage message;
    if (writer_->counts().records == 0 && message.ParseFromString(bytes) && message.has_notice())
        return;
    if (!error_message_.empty()) return;
    if (const Status s = writer_->add(bytes, client::to_us(now) - client::to_us(start_)); !s.ok())
        error_message_ = path_ + ": " + s.error().message;
}

void Recorder::flush() {
    const std::lock_guard lock(mutex_);
    out_.flush();
}

Status Recorder::finish() {
    const std::lock_guard lock(mutex_);
    if (writer_->counts().records == 0) {
        out_.close();
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        return {};
    }
    if (const Status s = writer_->finish(); !s.ok())
        return Error{s.error().code, path_ + ": " + s.error().message};
    return {};
}

client::RecordingWriter::Counts Recorder::counts() const {
    const std::lock_guard lock(mutex_);
    return writer_->counts();
}

std::string Recorder::error_message() const {
    const std::lock_guard lock(mutex_);
    return error_message_;
}

}  // namespace jostle::record
