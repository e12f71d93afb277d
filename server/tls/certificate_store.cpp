// SPDX-License-Identifier: MIT
#include "server/tls/certificate_store.h"

#include "server/util/log.h"

namespace jostle::server {

namespace {

using namespace std::chrono_literals;

constexpr auto poll_interval = 1s;
constexpr auto retry_interval = 1min;  // of files that were refused and have not changed

}  // namespace

Result<std::unique_ptr<CertificateStore>> CertificateStore::open(TlsSettings files, WallTime now) {
    std::unique_ptr<CertificateStore> store(new CertificateStore(std::move(files)));
    const std::lock_guard reading(store->reading_);
    if (Status s = store->read(now); !s.ok()) return s.error();
    return store;
}

std::shared_ptr<const TlsMaterial> CertificateStore::material() const {
    const std::lock_guard lock(mutex_);
    return material_;
}

CertificateStore::Change CertificateStore::poll(WallTime now) {
    const std::lock_guard reading(reading_);
    if (now >= last_poll_ && now < last_poll_ + poll_interval) return Change::none;  // clocks jump
    last_poll_ = now;
    const bool try_again = !refusal_.empty() && now >= last_read_ + retry_interval;
    if (stamps() == stamps_ && !try_again) return Change::none;
    return read_and_log(now);
}

CertificateStore::Change CertificateStore::reload(WallTime now) {
    const std::lock_guard reading(reading_);
    refusal_.clear();  // who asks is told again
    return read_and_log(now);
}

CertificateStore::Stamps CertificateStore::stamps() const {
    return {stamp_of(files_.certificate), stamp_of(files_.key),
            files_.client_ca.empty() ? FileStamp{} : stamp_of(files_.client_ca)};
}

// A change while they are read is seen the next time: the stamps are from before.
Status CertificateStore::read(WallTime now) {
    stamps_ = stamps();
    last_read_ = now;
    Result<TlsMaterial> read = read_tls_material(files_, now);
    if (!read.ok()) return read.error();
    for (const std::string& warning : read->warnings) log_warn("{}", warning);
    log_info("the certificate of {} is in force", read->subject);
    const std::lock_guard lock(mutex_);
    material_ = std::make_shared<const TlsMaterial>(std::move(*read));
    return {};
}

CertificateStore::Change CertificateStore::read_and_log(WallTime now) {
    const Stamps before = stamps_;
    const Status status = read(now);
    if (status.ok()) {
        refusal_.clear();
        return Change::taken;
    }
    if (stamps() != stamps_) return Change::none;  // they were replaced meanwhile: the next look
    const bool said_before = status.error().message == refusal_ && stamps_ == before;
    refusal_ = status.error().message;
    if (said_before) return Change::none;
    log_error("{}; the certificate of before stays in force", refusal_);
    return Change::refused;
}

}  // namespace jostle::server
