// SPDX-License-Identifier: MIT
//
// The certificates in force. An operator replaces files while the server runs (a new certificate, a
// link that Kubernetes swaps), not always both at once and not always good ones. The store reads
// what has changed, and takes it over only when all of it is good (material.h); else the old stays
// in force.
//
// Listeners get it in two ways: material() for those that are told, and two files for gRPC's
// FileWatcherCertificateProvider, which reads files by itself and would break every handshake on a
// pair that does not fit. Key and chain are one file, so they change together.
//
// material() and expiry() from any thread; poll() and reload() from whoever keeps time.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <string>

#include "base/watched_file.h"
#include "tls/material.h"
#include "tls/private_folder.h"

namespace jostle::server {

class CertificateStore {
public:
    enum class Change { none, taken, refused };

    // The files must be good the first time.
    static Result<std::unique_ptr<CertificateStore>> open(TlsSettings files, WallTime now);

    std::shared_ptr<const Material> material() const;
    // When the first certificate of the chain in force expires.
    WallTime expiry() const { return material()->expires; }

    // Looks at most once a second whether a file has changed, and reads them all if so. `refused`
    // was logged with its reason, once for each change; what is only wrong for now (it is good from
    // tomorrow) is tried again every minute.
    Change poll(WallTime now);
    // Reads them now (SIGHUP).
    Change reload(WallTime now);

    // For gRPC: key and chain in one PEM file, and whose certificates clients may show (empty
    // without tls.client_ca).
    std::string identity_file() const { return folder_->path() + "/identity.pem"; }
    std::string client_ca_file() const;

private:
    using Stamps = std::array<FileStamp, 3>;

    CertificateStore(TlsSettings files, std::unique_ptr<PrivateFolder> folder)
        : files_(std::move(files)), folder_(std::move(folder)) {}

    Stamps stamps() const;
    Status read(WallTime now);
    Change read_and_say(WallTime now);

    const TlsSettings files_;
    const std::unique_ptr<PrivateFolder> folder_;
    mutable std::mutex mutex_;  // of material_
    std::shared_ptr<const Material> material_;
    std::mutex reading_;   // of what follows
    Stamps stamps_;        // of the files when they were last read, good or not
    std::string refusal_;  // why what was last read is not in force; empty: it is
    WallTime last_look_, last_read_;
};

}  // namespace jostle::server
