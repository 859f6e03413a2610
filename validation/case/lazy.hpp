#pragma once

#include <concepts>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>

namespace seiche::validation {

/// A value, or what computes it when it is first asked for; copies share it. Not for several threads at a time.
template <class T>
class Lazy {
 public:
  Lazy(T known = {}) : kept_(std::make_shared<Kept>(Kept{std::move(known), {}})) {}
  template <class Element>
  Lazy(std::initializer_list<Element> known) : Lazy(T(known.begin(), known.end())) {}
  template <std::invocable Compute>
  Lazy(Compute compute) : kept_(std::make_shared<Kept>(Kept{{}, std::move(compute)})) {}

  const T& operator*() const {
    if (!kept_->value) kept_->value.emplace(kept_->compute());
    return *kept_->value;
  }
  const T* operator->() const { return &**this; }

 private:
  struct Kept {
    std::optional<T> value;
    std::function<T()> compute;
  };
  std::shared_ptr<Kept> kept_;
};

}  // namespace seiche::validation
