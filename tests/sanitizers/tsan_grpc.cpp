// Tells the thread sanitizer what it cannot see in Debian's gRPC, which is compiled without it: how gRPC orders
// the threads that meet in it. Linked into every program of a thread-sanitizer build; it replaces the functions
// below and calls the real ones.
//
// All of gRPC counts as one lock: whoever leaves it has seen whatever others did before they entered it. That
// hides a race between two callbacks that never touch the same memory at the same moment; it hides nothing in code
// that does not go through gRPC, and it makes every report that is left worth reading.
#include <absl/synchronization/mutex.h>
#include <absl/time/time.h>
#include <dlfcn.h>
#include <grpc/grpc.h>
#include <sanitizer/tsan_interface.h>

extern "C" void __tsan_ignore_thread_begin();
extern "C" void __tsan_ignore_thread_end();

namespace {

char grpc_as_a_whole;

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

// While it lives, the thread is inside gRPC: its own memory accesses there are not looked at.
class InsideGrpc {
 public:
  InsideGrpc() {
    __tsan_release(&grpc_as_a_whole);
    __tsan_ignore_thread_begin();
  }
  ~InsideGrpc() {
    __tsan_ignore_thread_end();
    __tsan_acquire(&grpc_as_a_whole);
  }
  InsideGrpc(const InsideGrpc&) = delete;
  InsideGrpc& operator=(const InsideGrpc&) = delete;
};

}  // namespace

extern "C" {

grpc_call_error grpc_call_start_batch(grpc_call* call, const grpc_op* operations, size_t count, void* tag,
                                      void* reserved) {
  static const auto start = real<decltype(grpc_call_start_batch)>("grpc_call_start_batch");
  InsideGrpc inside;
  return start(call, operations, count, tag, reserved);
}

grpc_event grpc_completion_queue_next(grpc_completion_queue* queue, gpr_timespec deadline, void* reserved) {
  static const auto next = real<decltype(grpc_completion_queue_next)>("grpc_completion_queue_next");
  InsideGrpc inside;
  return next(queue, deadline, reserved);
}

grpc_event grpc_completion_queue_pluck(grpc_completion_queue* queue, void* tag, gpr_timespec deadline,
                                       void* reserved) {
  static const auto pluck = real<decltype(grpc_completion_queue_pluck)>("grpc_completion_queue_pluck");
  InsideGrpc inside;
  return pluck(queue, tag, deadline, reserved);
}

void* grpc_call_arena_alloc(grpc_call* call, size_t size) {
  static const auto allocate = real<decltype(grpc_call_arena_alloc)>("grpc_call_arena_alloc");
  InsideGrpc inside;
  return allocate(call, size);
}

void grpc_call_unref(grpc_call* call) {
  static const auto release = real<decltype(grpc_call_unref)>("grpc_call_unref");
  InsideGrpc inside;
  release(call);
}

}  // extern "C"

// gRPC's own mutexes and condition variables.
namespace absl {
ABSL_NAMESPACE_BEGIN

void Mutex::Lock() {
  static const auto lock = real<void(Mutex*)>("_ZN4absl7debian35Mutex4LockEv");
  lock(this);
  __tsan_acquire(&grpc_as_a_whole);
}

void Mutex::Unlock() {
  static const auto unlock = real<void(Mutex*)>("_ZN4absl7debian35Mutex6UnlockEv");
  __tsan_release(&grpc_as_a_whole);
  unlock(this);
}

bool Mutex::TryLock() {
  static const auto try_lock = real<bool(Mutex*)>("_ZN4absl7debian35Mutex7TryLockEv");
  const bool locked = try_lock(this);
  __tsan_acquire(&grpc_as_a_whole);
  return locked;
}

void CondVar::Wait(Mutex* mutex) {
  static const auto wait = real<void(CondVar*, Mutex*)>("_ZN4absl7debian37CondVar4WaitEPNS0_5MutexE");
  InsideGrpc inside;
  wait(this, mutex);
}

bool CondVar::WaitWithTimeout(Mutex* mutex, Duration timeout) {
  static const auto wait = real<bool(CondVar*, Mutex*, Duration)>(
      "_ZN4absl7debian37CondVar15WaitWithTimeoutEPNS0_5MutexENS0_8DurationE");
  InsideGrpc inside;
  return wait(this, mutex, timeout);
}

bool CondVar::WaitWithDeadline(Mutex* mutex, Time deadline) {
  static const auto wait =
      real<bool(CondVar*, Mutex*, Time)>("_ZN4absl7debian37CondVar16WaitWithDeadlineEPNS0_5MutexENS0_4TimeE");
  InsideGrpc inside;
  return wait(this, mutex, deadline);
}

ABSL_NAMESPACE_END
}  // namespace absl
