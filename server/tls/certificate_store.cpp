// SPDX-License-Identifier: MIT
#include "server/tls/certificate_store.h"

#include <openssl/bio.h>
#include <openssl/x509.h>

#include <memory>

#include "jostle/base/check.h"
#include "server/util/free_with.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

using namespace std::chrono_literals;

constexpr auto poll_interval = 1s;
constexpr auto retry_interval = 1min;  // for rejected files that have not changed

}  // namespace

Result<std::unique_ptr<CertificateStore>> CertificateStore::open(TlsSettings files, WallTime now) {
    std::unique_ptr<CertificateStore> store(new CertificateStore(std::move(files)));
    const std::lock_guard reading(store->reading_);
    if (Status s = store->read(now); !s.ok()) return s.error();
    return store;
}

std::shared_ptr<const TlsMaterial> CertificateStore::material() const {
    const std::lock_guard lock(mutex_);
    ASSERT(material_);
    return material_;
}

CertificateStore::Change CertificateStore::poll(WallTime now) {
    const std::lock_guard reading(reading_);
    // the wall clock may jump
    if (now >= last_poll_ && now < last_poll_ + poll_interval) return Change::none;
    last_poll_ = now;
    const bool retry = !refusal_.empty() && now >= last_read_ + retry_interval;
    if (stamps() == stamps_ && !retry) return Change::none;
    return read_and_log(now);
}

CertificateStore::Change CertificateStore::reload(WallTime now) {
    const std::lock_guard reading(reading_);
    refusal_.clear();  // an explicit reload logs the reason again
    return read_and_log(now);
}

CertificateStore::Stamps CertificateStore::stamps() const {
    return {stamp_of(files_.certificate), stamp_of(files_.key),
            files_.client_ca.empty() ? FileStamp{} : stamp_of(files_.client_ca)};
}

// The stamps are taken before the read, so that a change during the read is detected by
// the next poll.
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
    const Stamps previous_stamps = stamps_;
    const Status status = read(now);
    if (status.ok()) {
        refusal_.clear();
        return Change::taken;
    }
    // replaced during the read: retried by the next poll
    if (stamps() != stamps_) return Change::none;
    const bool already_logged = status.error().message == refusal_ && stamps_ == previous_stamps;
    refusal_ = status.error().message;
    ASSERT(!refusal_.empty());
    if (already_logged) return Change::none;
    log_error("{}; the previous certificate stays in force", refusal_);
    return Change::refused;
}

std::string verified_subject(const SSL* connection) {
    if (SSL_get_verify_result(connection) != X509_V_OK) return {};
    const std::unique_ptr<X509, FreeWith<X509_free>> certificate(
        SSL_get1_peer_certificate(connection));
    if (!certificate) return {};
    const std::unique_ptr<BIO, FreeWith<BIO_free>> text(BIO_new(BIO_s_mem()));
    X509_NAME_print_ex(text.get(), X509_get_subject_name(certificate.get()), 0, XN_FLAG_RFC2253);
    char* data = nullptr;
    const long size = BIO_get_mem_data(text.get(), &data);
    return size > 0 ? std::string(data, static_cast<std::size_t>(size)) : std::string{};
}

}  // namespace jostle::server
