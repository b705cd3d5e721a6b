#include "python/module/watched.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace isoloop::python {
namespace {

namespace py = pybind11;

/// What the work throws once nobody waits for it.
struct GivenUp {};

struct Watch {
  std::mutex mutex;  // guards all but `stop`, `thread` and `kept`
  std::condition_variable changed;
  bool ended = false;
  bool told = false;  // of a stage that has not been passed on
  std::string stage;
  double share = 0.0;
  std::exception_ptr thrown;
  std::atomic<bool> stop{false};
  std::thread thread;
  py::object kept;

  void tell(const char* stage_now, double share_now) {
    if (stop) throw GivenUp{};
    const std::lock_guard held(mutex);
    stage = stage_now;
    share = share_now;
    told = true;
    changed.notify_all();
  }
};

/// Given up, and maybe not yet ended. Touched with the interpreter's lock alone.
std::vector<std::shared_ptr<Watch>>& leftovers() {
  static std::vector<std::shared_ptr<Watch>> list;
  return list;
}

void start(const std::shared_ptr<Watch>& watch, std::function<void(const Progress&)> work) {
  watch->thread = std::thread([watch, work = std::move(work)]() mutable {
    std::exception_ptr thrown;
    try {
      work([&](const char* stage, double share) { watch->tell(stage, share); });
    } catch (...) {
      thrown = std::current_exception();
    }
    work = {};
    const std::lock_guard held(watch->mutex);
    watch->thrown = thrown;
    watch->ended = true;
    watch->changed.notify_all();
  });
}

/// Waits, without the interpreter's lock, until the work has ended or there is something to tell.
bool ended_within(Watch& watch, std::chrono::milliseconds time, bool or_told) {
  const py::gil_scoped_release unlocked;
  std::unique_lock held(watch.mutex);
  watch.changed.wait_for(held, time, [&] { return watch.ended || (or_told && watch.told); });
  return watch.ended;
}

void join(Watch& watch) {
  {
    const py::gil_scoped_release unlocked;
    watch.thread.join();
  }
  watch.kept = {};
}

void reap() {
  std::erase_if(leftovers(), [](const std::shared_ptr<Watch>& watch) {
    {
      const std::lock_guard held(watch->mutex);
      if (!watch->ended) return false;
    }
    join(*watch);
    return true;
  });
}

void give_up(const std::shared_ptr<Watch>& watch) {
  watch->stop = true;
  if (ended_within(*watch, std::chrono::seconds(1), false)) {
    join(*watch);
  } else {
    leftovers().push_back(watch);
  }
}

/// Calls `progress` if there is news.
void pass_on(Watch& watch, const py::object& progress) {
  std::string stage;
  double share = 0.0;
  {
    const std::lock_guard held(watch.mutex);
    if (!std::exchange(watch.told, false)) return;
    stage = watch.stage;
    share = watch.share;
  }
  if (!progress.is_none()) progress(stage, share);
}

}  // namespace

void run_watched(const py::object& progress, py::object kept,
                 std::function<void(const Progress&)> work) {
  reap();
  const auto watch = std::make_shared<Watch>();
  watch->kept = std::move(kept);
  start(watch, std::move(work));
  try {
    while (!ended_within(*watch, std::chrono::milliseconds(50), true)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      pass_on(*watch, progress);
    }
    pass_on(*watch, progress);
  } catch (...) {
    give_up(watch);
    throw;
  }
  join(*watch);
  if (watch->thrown) std::rethrow_exception(watch->thrown);
}

void end_leftovers() {
  for (const std::shared_ptr<Watch>& watch : std::exchange(leftovers(), {})) join(*watch);
}

}  // namespace isoloop::python
