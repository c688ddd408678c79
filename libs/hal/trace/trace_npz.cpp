// SPDX-License-Identifier: MIT
#include "hal/trace/trace_npz.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/axis_name.hpp"
#include "hal/files/npz_file.hpp"
#include "hal/files/temporary_file.hpp"
#include "hal/files/zip_file.hpp"
#include "hal/trace/trace_csv.hpp"
#include "motion/core/disk_backed_vector.hpp"

namespace softcnc::hal {

std::size_t longest_limit() noexcept {
  std::size_t longest = 0;
  for (int i = 0; i < kLimits; ++i) longest = std::max(longest, name(static_cast<Limit>(i)).size());
  return longest;
}

namespace {

/// An array that grows at its end. Its head, which holds its length, comes last: heads of arrays of
/// one dimension are all of one size.
class NpzColumn {
 public:
  NpzColumn(std::string column_name, std::string type, std::size_t size)
      : name_(std::move(column_name)), type_(std::move(type)), size_(size) {
    const std::string head = head_of(0);
    bytes_.reserve(head.size() + kNpzRows * size);
    for (const char c : head) add(c);
  }

  template <typename T>
  void add(T value) {
    const auto* from = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), from, from + sizeof value);
  }

  /// Adds text as characters of four bytes, padded with zeros.
  void add_text(std::string_view text) {
    const std::size_t end = bytes_.size() + size_;
    for (const char c : text) add(static_cast<char32_t>(c));
    bytes_.resize(end);
  }

  Status hand_on() {
    const Status kept = file_.add(bytes_);
    bytes_.clear();
    return kept;
  }

  Status add_to(ZipWriter& zip, std::int64_t rows) {
    const std::string head = head_of(rows);
    assert(head.size() == head_of(0).size());
    if (Status put = file_.put(0, std::as_bytes(std::span(head))); !put) return put;
    zip.add_descriptor(name_ + ".npy", file_.descriptor(), Compression::store);
    return {};
  }

 private:
  std::string head_of(std::int64_t rows) const { return npy_head(type_, std::span(&rows, 1)); }

  std::string name_, type_;
  std::size_t size_;  // bytes of a value
  std::vector<std::byte> bytes_;
  OverflowFile file_;
};

class NpzTrace final : public TraceWriter {
 public:
  NpzTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header, const Machine& machine,
           std::span<const std::string> backend_columns);

  void row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept override;
  void flush() noexcept override {}
  void add_program_hash(const std::string& hash) override { header_.program_hash = hash; }
  bool ok() const noexcept override { return status_.has_value(); }
  Status finish() override;

 private:
  void add_column(const std::string& column_name);
  void hand_on();
  Status write_archive(const TemporaryFile& file);

  std::unique_ptr<ByteSink> out_;
  TraceHeader header_;
  TraceTime time_;
  std::vector<int> axes_;
  std::vector<NpzColumn> columns_;
  std::vector<bool> whole_;  // of the backend's columns: counts
  std::int64_t rows_ = 0;
  Status status_;
};

NpzTrace::NpzTrace(std::unique_ptr<ByteSink> out, const TraceHeader& header, const Machine& machine,
                   std::span<const std::string> backend_columns)
    : out_(std::move(out)), header_(header), time_(header.period) {
  const std::size_t text = longest_limit();
  add_column("t_s");
  for (const char* whole : {"line", "block"}) columns_.emplace_back(whole, "<i8", 8);
  for (const char* real : {"s_mm", "v_mm_s", "a_mm_s2"}) add_column(real);
  columns_.emplace_back("limit", "<U" + std::to_string(text), 4 * text);
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!machine.axes[static_cast<std::size_t>(axis)].present) continue;
    axes_.push_back(axis);
    add_column(axis_name(axis) + "_mm");
  }
  add_column("feed_mm_s");
  for (const std::string& column : backend_columns) {
    whole_.push_back(column.ends_with("_count"));
    if (whole_.back())
      columns_.emplace_back(column, "<i8", 8);
    else
      add_column(column);
  }
}

void NpzTrace::add_column(const std::string& column_name) {
  columns_.emplace_back(column_name, "<f8", sizeof(double));
}

void NpzTrace::row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept {
  if (!ok()) return;
  auto column = columns_.begin();
  const auto real = [&column](double value) { (column++)->add(value + 0.0); };  // no -0
  const auto whole = [&column](std::int64_t value) { (column++)->add(value); };
  real(time_(setpoint.period));
  whole(setpoint.line);
  whole(setpoint.block);
  real(setpoint.s);
  real(setpoint.v);
  real(setpoint.a);
  (column++)->add_text(name(setpoint.limit));
  for (const int axis : axes_) real(setpoint.position[axis]);
  real(setpoint.feed);
  for (std::size_t i = 0; i < backend_values.size(); ++i)
    whole_[i] ? whole(static_cast<std::int64_t>(backend_values[i])) : real(backend_values[i]);
  if (++rows_ % std::int64_t{kNpzRows} == 0) hand_on();
}

void NpzTrace::hand_on() {
  for (NpzColumn& column : columns_)
    if (ok()) status_ = column.hand_on();
}

Status NpzTrace::write_archive(const TemporaryFile& file) {
  ZipWriter zip(file.descriptor());
  zip.set_comment(trace_comment(header_));
  for (NpzColumn& column : columns_)
    if (Status added = column.add_to(zip, rows_); !added) return added;
  return zip.finish();
}

Status NpzTrace::finish() {
  if (ok()) hand_on();
  if (!ok()) return status_;
  auto archive = TemporaryFile::make();
  if (!archive) return tl::make_unexpected(std::move(archive.error()));
  if (Status done = write_archive(*archive); !done) return done;
  columns_.clear();
  return archive->copy_to(*out_);
}

}  // namespace

std::unique_ptr<TraceWriter> npz_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns) {
  return std::make_unique<NpzTrace>(std::move(out), header, machine, backend_columns);
}

}  // namespace softcnc::hal
