#pragma once

#include <cstdint>
#include <functional>

#include "server/hub.h"
#include "server/store.h"
#include "server/task_queue.h"

namespace trajan {

/// Leads targets from run to run: whenever all runs of one have ended, it adds the next or ends it. It keeps
/// nothing in memory: what comes next follows from what is in the store. Any thread may call.
class Targets {
 public:
  /// `assign` is called when a run was queued.
  Targets(store::Store& store, Hub& hub, std::function<void()> assign)
      : store_(store), hub_(hub), assign_(std::move(assign)) {}

  /// Goes on with what an earlier server left.
  void recover();

  /// A study changed. Returns at once.
  void look_at(std::int64_t study);

 private:
  void advance(std::int64_t study);

  store::Store& store_;
  Hub& hub_;
  const std::function<void()> assign_;
  TaskQueue tasks_{1};
};

}  // namespace trajan
