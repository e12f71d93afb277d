// SPDX-License-Identifier: MIT
//
// Records the messages of one client into a file as they arrive. on_message() is called on the
// loop's thread, all other functions on the program's thread.
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
    // Creates a file; an existing file is only overwritten with `replace`.
    Status open(const std::string& path, bool replace);
    void on_message(const std::string& bytes, client::Clock::time_point now);
    // Flushes the data to the file system, so that it survives a crash of the program.
    void flush();
    // Writes the index and closes the file; deletes a file without messages.
    Status finish();

    client::RecordingWriter::Counts counts() const;
    // Why recording stopped; empty: it is active.
    std::string error_message() const;

private:
    mutable std::mutex mutex_;  // guards all members
    std::string path_, error_message_;
    std::ofstream out_;
    std::optional<client::RecordingWriter> writer_;
    client::Clock::time_point start_{};
};

}  // namespace jostle::record
