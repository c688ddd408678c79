// SPDX-License-Identifier: MIT
// Recordings: program, machine and trace in one file, so that a run can be run again.
//
// A zip of meta.json, program, the files it called, machine.toml, state.toml and trace.csv.zst, in
// this order.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/files/output_file.hpp"
#include "hal/files/temporary_file.hpp"
#include "hal/files/zip_file.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"

namespace softcnc::app {

/// Raised when a recording changes its form.
inline constexpr int kRecordingSchema = 2;

/// A file that the program called: its name as of ipr::FoundFile, and hash_hex() of it.
struct CalledFile {
  std::string name, hash;
  std::string path;  // of a run that is recorded; empty: it is that of a replay
};

/// meta.json. Hashes are hash_hex() of the entries' bytes.
struct RecordingMeta {
  std::string program_name, program_hash, machine_hash, trace_hash;
  std::string state_hash;  // empty: the start state, and there is no such entry
  std::int64_t rows = 0;
  std::vector<CalledFile> called;
  runtime::ChannelOptions options;  // the state in it is that of state.toml
};

/// Writes a recording of a run whose trace is `trace`, as trace.csv.zst. The hashes of `meta`
/// are filled in; the names of called files must be there. Errors: SC6003, SC6012, SC6013.
Status write_recording(hal::OutputFile& file, runtime::Program& program, const Machine& machine,
                       RecordingMeta meta, const hal::TemporaryFile& trace);

class Recording {
 public:
  /// Reads meta.json and checks all entries against their checksums, program, machine and state
  /// against their hashes as well; "-" is standard input. Errors: SC6021, SC6022, SC6024.
  static Result<Recording> open(const std::string& file);

  const RecordingMeta& meta() const noexcept { return meta_; }
  /// machine.toml
  const std::string& machine() const noexcept { return machine_; }
  /// The program, in an unlinked file of its own.
  Result<runtime::Program> program() const;
  /// Makes the files that the program called, and no others, those that are found in `folder` and
  /// in folders_of_called(). Errors: SC6003, SC6021.
  Status put_called(const std::string& folder, ipr::CalledTexts& texts) const;
  /// Returns the folders below `folder` that stand for the search path of the run.
  std::vector<std::string> folders_of_called(const std::string& folder) const;
  /// trace.csv.zst
  Result<hal::ZipEntry> trace() const { return zip_.entry("trace.csv.zst"); }
  /// Errors: SC6021, where the trace is not what was recorded.
  Status check_trace() const { return check_hash("trace.csv.zst", meta_.trace_hash); }

 private:
  Recording(std::string file, hal::ZipReader zip) : file_(std::move(file)), zip_(std::move(zip)) {}
  Status read();
  Status read_state();
  Status check_hash(const std::string& entry, const std::string& expected) const;

  std::string file_;
  hal::ZipReader zip_;
  RecordingMeta meta_;
  std::string machine_;
};

}  // namespace softcnc::app
