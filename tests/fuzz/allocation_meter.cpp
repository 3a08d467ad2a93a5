#include "tests/fuzz/allocation_meter.h"

#include <cstdlib>
#include <new>

namespace {
thread_local std::size_t bytes = 0;
}

std::size_t trajan::testing::allocated_bytes() { return bytes; }

// The array forms of the standard library call these. Its nothrow form would too, but the address
// sanitizer brings one of its own that does not.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  bytes += size;
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
