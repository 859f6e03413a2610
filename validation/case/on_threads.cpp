#include "validation/case/on_threads.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <omp.h>

namespace seiche::validation {

std::size_t workers_of(Tier tier) {
  return tier == Tier::quick ? 1 : std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
}

void on_threads(std::size_t count, std::size_t workers, const std::function<void(std::size_t)>& work,
                const std::function<void(std::size_t)>& done) {
  std::mutex mutex;
  std::atomic<std::size_t> begun = 0;
  std::atomic<bool> stopped = false;
  std::size_t finished = 0;
  std::vector<std::exception_ptr> failures(count);
  const auto loop = [&] {
    omp_set_num_threads(1);
    for (std::size_t k = 0; !stopped && (k = begun++) < count;) {
      try {
        work(k);
        const std::scoped_lock lock(mutex);
        ++finished;
        if (done) done(finished);
      } catch (...) {
        failures[k] = std::current_exception();
        stopped = true;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t w = 0; w < std::min(workers, count); ++w) threads.emplace_back(loop);
  }
  const auto first = std::ranges::find_if(failures, [](const auto& failure) { return failure != nullptr; });
  if (first != failures.end()) std::rethrow_exception(*first);
}

void on_threads(const Run& run, std::size_t count, const std::function<void(std::size_t)>& work) {
  on_threads(count, workers_of(run.tier()), work,
             [&](std::size_t finished) { run.progress(static_cast<double>(finished) / static_cast<double>(count)); });
}

void one_by_one(const Run& run, const std::vector<std::function<void()>>& work) {
  on_threads(
      work.size(), 1, [&](std::size_t k) { work[k](); },
      [&](std::size_t finished) { run.progress(static_cast<double>(finished) / static_cast<double>(work.size())); });
}

}  // namespace seiche::validation
