// SPDX-License-Identifier: MIT
//
// A file into which one client's messages go while they come. take() is called on the loop's
// thread, all else by the program's.
#pragma once

#include <fstream>
#include <mutex>
#include <optional>
#include <string>

#include "jostle/client/clock_sync.h"
#include "jostle/client/recording_writer.h"

namespace jostle::record {

class Recorder {
public:
    // Begins a new file; one that is there is only replaced when told so.
    Status open(const std::string& path, bool replace);
    void on_message(const std::string& bytes, client::Clock::time_point now);
    // What was taken so far will be there whatever becomes of the program.
    void flush();
    // Closes the file in order; one into which nothing came is removed.
    Status finish();

    client::RecordingWriter::Counts counts() const;
    // Why it takes nothing more; empty: it does.
    std::string error_message() const;

private:
    mutable std::mutex mutex_;  // guards all
    std::string path_, error_message_;
    std::ofstream out_;
    std::optional<client::RecordingWriter> writer_;
    client::Clock::time_point start_{};
};

}  // namespace jostle::record
