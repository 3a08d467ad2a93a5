#include "server/hub.h"

#include <algorithm>
#include <vector>

namespace trajan {

void Hub::subscribe(std::int64_t job, std::shared_ptr<Listener> listener) {
  bool ended = false;
  {
    const std::lock_guard lock(mutex_);
    listeners_.emplace(job, listener);
    ended = ended_;
  }
  if (ended) listener->end();
}

void Hub::unsubscribe(std::int64_t job, const Listener* listener) {
  const std::lock_guard lock(mutex_);
  const auto [first, last] = listeners_.equal_range(job);
  const auto found = std::find_if(first, last, [&](const auto& entry) { return entry.second.get() == listener; });
  if (found != last) listeners_.erase(found);
}

void Hub::publish(std::int64_t job) {
  std::vector<std::shared_ptr<Listener>> woken;
  {
    const std::lock_guard lock(mutex_);
    const auto [first, last] = listeners_.equal_range(job);
    std::transform(first, last, std::back_inserter(woken), [](const auto& entry) { return entry.second; });
  }
  for (const auto& listener : woken) listener->wake();
}

void Hub::wake_all() {
  std::vector<std::shared_ptr<Listener>> woken;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [job, listener] : listeners_) woken.push_back(listener);
  }
  for (const auto& listener : woken) listener->wake();
}

void Hub::end_all() {
  std::vector<std::shared_ptr<Listener>> ended;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    for (const auto& [job, listener] : listeners_) ended.push_back(listener);
  }
  for (const auto& listener : ended) listener->end();
}

}  // namespace trajan
