#include "validation/case/checkpoints.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "reports/evidence/provenance.hpp"
#include "seiche/io/atomic_file.hpp"

namespace seiche::validation {
namespace {

/// First lines of a file; the bytes follow: the seconds that the run had taken, in a line, and what was kept.
std::string heading(const std::string& fingerprint, const std::string& name, std::string_view bytes) {
  return fmt::format("seiche checkpoint\n{}\n{}\n{}\n", fingerprint, name, evidence::sha256(bytes));
}

/// The rest of a text behind its first lines.
std::string_view after_lines(std::string_view text, int lines) {
  for (; lines > 0; --lines) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text;
}

}  // namespace

Checkpoints::Checkpoints(std::filesystem::path folder, std::string fingerprint, const Keeping& keeping)
    : folder_(std::move(folder)), fingerprint_(std::move(fingerprint)), every_(keeping.every) {
  if (!keeping.resume) {
    remove_all();
    return;
  }
  // What a killed process was writing.
  std::error_code failure;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, failure)) {
    if (entry.path().extension() == ".part") std::filesystem::remove(entry.path(), failure);
  }
}

std::filesystem::path Checkpoints::file(const std::string& name) const {
  std::string plain = name;
  for (char& c : plain) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
  }
  return folder_ / (plain + ".checkpoint");
}

std::optional<std::string> Checkpoints::read(const std::string& name) const {
  std::error_code unreachable;
  if (!active() || !std::filesystem::exists(file(name), unreachable)) return std::nullopt;
  try {
    const std::string text = io::read_file(file(name));
    const std::string_view bytes = after_lines(text, 4);
    const std::string expected = heading(fingerprint_, name, bytes);
    if (text.compare(0, text.size() - bytes.size(), expected) == 0) {
      double taken = 0;
      std::from_chars(bytes.data(), bytes.data() + bytes.size(), taken);
      const std::scoped_lock lock(mutex_);
      if (taken > before_) before_ = taken;
      return std::string(after_lines(bytes, 1));
    }
    const bool foreign = after_lines(text, 1).substr(0, fingerprint_.size()) != fingerprint_;
    note(foreign ? "checkpoints of another program or of other parameters are not used"
                 : "damaged checkpoints are not used");
  } catch (const std::exception& failure) {
    note(failure.what());
  }
  return std::nullopt;
}

void Checkpoints::write(const std::string& name, std::string_view bytes) const {
  if (!active()) return;
  try {
    const std::string content = fmt::format("{}\n", seconds()).append(bytes);
    io::write_file(file(name), heading(fingerprint_, name, content).append(content));
  } catch (const std::exception& failure) {
    note(failure.what());
  }
}

void Checkpoints::remove(const std::string& name) const {
  if (!active()) return;
  std::error_code failure;
  std::filesystem::remove(file(name), failure);
}

void Checkpoints::remove_all() const {
  if (!active()) return;
  std::error_code failure;
  std::filesystem::remove_all(folder_, failure);
  // The folder of all runs goes with the last one.
  std::filesystem::remove(folder_.parent_path(), failure);
}

double Checkpoints::seconds() const {
  const std::chrono::duration<double> own = std::chrono::steady_clock::now() - begin_;
  const std::scoped_lock lock(mutex_);
  return before_ + own.count();
}

std::vector<std::string> Checkpoints::notes() const {
  const std::scoped_lock lock(mutex_);
  return notes_;
}

void Checkpoints::note(const std::string& text) const {
  const std::scoped_lock lock(mutex_);
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end()) notes_.push_back(text);
}

Part::Part(const Checkpoints& checkpoints, std::string name) : checkpoints_(&checkpoints), name_(std::move(name)) {}

bool Part::resume(const std::function<void(Tape&)>& state) const {
  return read(name_ + unfinished, state);
}

void Part::keep(const std::function<void(Tape&)>& state) {
  const auto now = std::chrono::steady_clock::now();
  if (!checkpoints_->active() || now - kept_ < checkpoints_->every()) return;
  write(name_ + unfinished, state);
  kept_ = now;
}

bool Part::read(const std::string& name, const std::function<void(Tape&)>& state) const {
  std::optional<std::string> bytes = checkpoints_->read(name);
  if (!bytes) return false;
  Tape tape(std::move(*bytes));
  state(tape);
  if (!tape.at_end()) throw std::logic_error(fmt::format("checkpoint '{}' holds more than is read of it", name));
  return true;
}

void Part::write(const std::string& name, const std::function<void(Tape&)>& state) const {
  if (!checkpoints_->active()) return;
  Tape tape;
  state(tape);
  checkpoints_->write(name, tape.bytes());
}

}  // namespace seiche::validation
