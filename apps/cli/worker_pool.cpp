// Many pieces of work of one kind, several at a time.
// SPDX-License-Identifier: MIT
#include "apps/cli/worker_pool.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

namespace kiri::cli {

namespace {

using PieceOfWork = std::function<void(std::size_t, const std::atomic<bool>&)>;

class WorkerPool {
 public:
  WorkerPool(std::size_t count, const PieceOfWork& work) : count_(count), work_(work) {}

  bool run(std::size_t threads, const std::function<bool(const PoolView&)>& watch) {
    stop_ = !watch(view_);
    std::vector<std::thread> workers;
    for (std::size_t i = 0; i < std::min(threads, count_); ++i) {
      workers.emplace_back([this] { workOn(); });
    }
    waitFor(watch);
    for (std::thread& worker : workers) worker.join();
    if (!thrown_.empty()) std::rethrow_exception(thrown_.begin()->second);
    return next_ == count_;
  }

 private:
  void waitFor(const std::function<bool(const PoolView&)>& watch) {
    constexpr std::chrono::milliseconds kBeat{100};
    std::unique_lock<std::mutex> lock(mutex_);
    while (!isOver()) {
      const PoolView view = view_;
      lock.unlock();
      if (!watch(view)) stop_ = true;
      lock.lock();
      if (isOver() || hasNews_) {
        hasNews_ = false;
        continue;
      }
      news_.wait_for(lock, kBeat, [this] { return hasNews_; });
      hasNews_ = false;
    }
  }

  bool isOver() const { return view_.atWork.empty() && (next_ == count_ || stop_); }

  void workOn() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (next_ < count_ && !stop_) {
      const std::size_t piece = next_++;
      view_.atWork.insert(std::upper_bound(view_.atWork.begin(), view_.atWork.end(), piece), piece);
      tell();
      lock.unlock();
      doPiece(piece);
      lock.lock();
      view_.atWork.erase(std::find(view_.atWork.begin(), view_.atWork.end(), piece));
      ++view_.done;
      tell();
    }
  }

  void doPiece(std::size_t piece) {
    try {
      work_(piece, stop_);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      thrown_.emplace(piece, std::current_exception());
      stop_ = true;
    }
  }

  void tell() {
    hasNews_ = true;
    news_.notify_one();
  }

  const std::size_t count_;
  const PieceOfWork& work_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  ///< guards what follows
  std::condition_variable news_;
  bool hasNews_ = false;
  std::size_t next_ = 0;
  PoolView view_;
  std::map<std::size_t, std::exception_ptr> thrown_;
};

}  // namespace

bool inParallel(std::size_t count, std::size_t threads, const PieceOfWork& work,
                const std::function<bool(const PoolView&)>& watch) {
  return WorkerPool(count, work).run(std::max<std::size_t>(1, threads), watch);
}

std::size_t processorCount() {
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

}  // namespace kiri::cli
