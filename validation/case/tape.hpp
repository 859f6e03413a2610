/// Results as bytes, written and read by one function, so that what is read is what was written:
///
///     void exchange(Tape& tape, Wave& wave) { tape(wave.heights, wave.crest, wave.note); }
///
///     Tape written;                   Tape read(written.bytes());
///     written(wave);                  read(wave);
///
/// For the same program on the same machine: numbers, and structures of nothing but numbers, go as they lie in memory.
/// Never give it what refers to something else, such as a span.
#pragma once

#include <cstddef>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace seiche::validation {

class Tape {
 public:
  /// To be written.
  Tape() = default;
  /// To be read.
  explicit Tape(std::string bytes) : bytes_(std::move(bytes)), reading_(true) {}

  [[nodiscard]] bool reading() const { return reading_; }
  /// Whether all of it was read.
  [[nodiscard]] bool at_end() const { return place_ == bytes_.size(); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

  /// Writes the items, or reads them. Throws std::out_of_range where the tape ends.
  template <class... Items>
  void operator()(Items&... items) {
    (one(items), ...);
  }

 private:
  template <class Item>
  void one(Item& item) {
    if constexpr (std::is_trivially_copyable_v<Item>) {
      raw(&item, sizeof(Item));
    } else {
      exchange(*this, item);
    }
  }

  void one(std::string& text) {
    resize(text);
    raw(text.data(), text.size());
  }

  template <class Item>
  void one(std::vector<Item>& items) {
    resize(items);
    if constexpr (std::is_trivially_copyable_v<Item>) {
      raw(items.data(), items.size() * sizeof(Item));
    } else {
      for (Item& item : items) one(item);
    }
  }

  template <class Item>
  void one(std::optional<Item>& item) {
    bool there = item.has_value();
    one(there);
    if (reading_) item = there ? std::optional<Item>(std::in_place) : std::nullopt;
    if (there) one(*item);
  }

  template <class Container>
  void resize(Container& items) {
    std::size_t size = items.size();
    raw(&size, sizeof(size));
    if (!reading_) return;
    if (size > bytes_.size() - place_) throw std::out_of_range("a tape ends too early");
    items.resize(size);
  }

  void raw(void* place, std::size_t size) {
    if (size == 0) return;
    if (!reading_) {
      bytes_.append(static_cast<const char*>(place), size);
      return;
    }
    if (size > bytes_.size() - place_) throw std::out_of_range("a tape ends too early");
    std::memcpy(place, bytes_.data() + place_, size);
    place_ += size;
  }

  std::string bytes_;
  std::size_t place_ = 0;
  bool reading_ = false;
};

}  // namespace seiche::validation
