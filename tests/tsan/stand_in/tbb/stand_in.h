// What core/ uses of TBB, by std::thread: ThreadSanitizer knows nothing of what happens within a
// TBB that was built without it, and reports races that are none. A loop runs on as many threads as
// TBB would let it; a loop within a loop runs on the thread that meets it.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace tbb {
namespace stand_in {

inline std::atomic<std::size_t> allowed = 4;  // by global_control
inline thread_local int arena_threads = 4;    // of the arena that this thread runs in
inline thread_local int index_in_arena = 0;
inline thread_local bool is_within_loop = false;

/// Threads that outlive their jobs: to start one takes far longer than most loops. Invariant: there
/// is a thread for every job that is under way or waits.
class Pool {
 public:
  Pool() = default;
  ~Pool() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void add(std::function<void()> job) {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    if (jobs_.size() > idle_) threads_.emplace_back([this] { serve(); });
    wake_.notify_one();
  }

 private:
  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      ++idle_;
      wake_.wait(lock, [this] { return is_over_ || !jobs_.empty(); });
      --idle_;
      if (jobs_.empty()) return;
      const std::function<void()> job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      job();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool is_over_ = false;
};

inline Pool pool;

/// Calls body(k) for k from 0 to count, itself not included, each on one of the threads.
template <class Body>
void run(std::size_t count, const Body& body) {
  const auto threads = std::min({count, allowed.load(), static_cast<std::size_t>(arena_threads)});
  if (is_within_loop || threads < 2) {
    for (std::size_t k = 0; k < count; ++k) body(k);
    return;
  }
  std::atomic<std::size_t> next = 0;
  std::exception_ptr thrown;
  std::mutex mutex;
  std::condition_variable done;
  std::size_t left = threads - 1;
  const int arena = arena_threads;
  const auto work = [&](int index) {
    arena_threads = arena;
    index_in_arena = index;
    is_within_loop = true;
    try {
      for (std::size_t k = next++; k < count; k = next++) body(k);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  };
  for (std::size_t t = 1; t < threads; ++t)
    pool.add([&, t] {
      work(static_cast<int>(t));
      const std::lock_guard lock(mutex);
      if (--left == 0) done.notify_one();
    });
  const int own_index = index_in_arena;
  work(0);
  index_in_arena = own_index;
  is_within_loop = false;
  std::unique_lock lock(mutex);
  done.wait(lock, [&] { return left == 0; });
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace stand_in

template <class Value>
class blocked_range {
 public:
  blocked_range(Value begin, Value end, std::size_t grain = 1)
      : begin_(begin), end_(end), grain_(grain) {}
  Value begin() const { return begin_; }
  Value end() const { return end_; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  bool empty() const { return !(begin_ < end_); }
  std::size_t grainsize() const { return grain_; }

 private:
  Value begin_;
  Value end_;
  std::size_t grain_;
};

struct simple_partitioner {};

namespace stand_in {

/// The range in at most 16 parts, none shorter than its grain but the last.
template <class Value>
std::vector<blocked_range<Value>> parts_of(const blocked_range<Value>& range) {
  std::vector<blocked_range<Value>> parts;
  const std::size_t length = std::max(range.grainsize(), (range.size() + 15) / 16);
  for (Value at = range.begin(); at < range.end();) {
    const std::size_t left = static_cast<std::size_t>(range.end() - at);
    const auto end = static_cast<Value>(at + static_cast<Value>(std::min(length, left)));
    parts.emplace_back(at, end, range.grainsize());
    at = end;
  }
  return parts;
}

}  // namespace stand_in

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body) {
  const auto parts = stand_in::parts_of(range);
  stand_in::run(parts.size(), [&](std::size_t k) { body(parts[k]); });
}

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body, simple_partitioner) {
  parallel_for(range, body);
}

template <class Value, class Body, class = std::enable_if_t<std::is_integral_v<Value>>>
void parallel_for(Value begin, Value end, const Body& body) {
  parallel_for(blocked_range<Value>(begin, end), [&](const auto& range) {
    for (Value i = range.begin(); i < range.end(); ++i) body(i);
  });
}

template <class Value, class Body, class = std::enable_if_t<std::is_integral_v<Value>>>
void parallel_for(Value begin, Value end, const Body& body, simple_partitioner) {
  parallel_for(begin, end, body);
}

template <class Value, class Result, class Body, class Join>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
                       const Join& join) {
  const auto parts = stand_in::parts_of(range);
  std::vector<Result> results(parts.size(), identity);
  stand_in::run(parts.size(), [&](std::size_t k) { results[k] = body(parts[k], identity); });
  Result sum = identity;
  for (const Result& result : results) sum = join(sum, result);
  return sum;
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
  stand_in::run(2, [&](std::size_t k) { k == 0 ? first() : second(); });
}

/// Several at a time allow the least of their values, whatever threads they live on.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t value) {
    const std::lock_guard lock(mutex_);
    mine_ = values_.insert(value);
    stand_in::allowed = *values_.begin();
  }
  ~global_control() {
    const std::lock_guard lock(mutex_);
    values_.erase(mine_);
    stand_in::allowed = values_.empty() ? without_control_ : *values_.begin();
  }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;
  static std::size_t active_value(parameter) { return stand_in::allowed; }

 private:
  static inline const std::size_t without_control_ = stand_in::allowed;
  static inline std::mutex mutex_;
  static inline std::multiset<std::size_t> values_;
  std::multiset<std::size_t>::iterator mine_;
};

class task_arena {
 public:
  explicit task_arena(int threads) : threads_(threads) {}
  template <class Work>
  auto execute(const Work& work) {
    struct Entered {
      int before = stand_in::arena_threads;
      ~Entered() { stand_in::arena_threads = before; }
    } const entered;
    stand_in::arena_threads = threads_;
    return work();
  }

 private:
  int threads_;
};

namespace this_task_arena {
inline int max_concurrency() { return stand_in::arena_threads; }
inline int current_thread_index() { return stand_in::index_in_arena; }
}  // namespace this_task_arena

}  // namespace tbb
