#include "tests/fuzz/allocation_meter.h"

#include <cstdlib>
#include <new>

namespace {
thread_local std::size_t bytes = 0;
}

std::size_t trajan::testing::allocated_bytes() { return bytes; }

// The array and nothrow forms of the standard library call these.
void* operator new(std::size_t size) {
  bytes += size;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
