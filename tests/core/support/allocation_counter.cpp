// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/allocation_counter.h"

#include <cstddef>
#include <cstdlib>
#include <new>
#ifdef _WIN32
#include <malloc.h>
#endif

namespace allocations {

std::atomic<long long> count{0};

namespace {

void* allocate(std::size_t size, std::align_val_t alignment = std::align_val_t{16}) noexcept {
    ++count;
    const auto unit = static_cast<std::size_t>(alignment);
#ifdef _WIN32
    return ::_aligned_malloc(size + 1, unit);
#else
    return std::aligned_alloc(unit, (size / unit + 1) * unit);
#endif
}
void release(void* memory) noexcept {
#ifdef _WIN32
    ::_aligned_free(memory);
#else
    std::free(memory);
#endif
}
void* orThrow(void* memory) {
    return memory ? memory : throw std::bad_alloc();
}

} // namespace

} // namespace allocations

// Every form is replaced: a sanitizer brings its own of each and tells them apart. Not inlined, or
// the compiler takes the pair of new and free for a mistake.
#define SPARKOUT_REPLACED [[gnu::noinline]] void
SPARKOUT_REPLACED* operator new(std::size_t n) {
    return allocations::orThrow(allocations::allocate(n));
}
SPARKOUT_REPLACED* operator new[](std::size_t n) {
    return allocations::orThrow(allocations::allocate(n));
}
SPARKOUT_REPLACED* operator new(std::size_t n, std::align_val_t a) {
    return allocations::orThrow(allocations::allocate(n, a));
}
SPARKOUT_REPLACED* operator new[](std::size_t n, std::align_val_t a) {
    return allocations::orThrow(allocations::allocate(n, a));
}
SPARKOUT_REPLACED* operator new(std::size_t n, const std::nothrow_t&) noexcept {
    return allocations::allocate(n);
}
SPARKOUT_REPLACED* operator new[](std::size_t n, const std::nothrow_t&) noexcept {
    return allocations::allocate(n);
}
SPARKOUT_REPLACED* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept {
    return allocations::allocate(n, a);
}
SPARKOUT_REPLACED* operator new[](std::size_t n, std::align_val_t a,
                                  const std::nothrow_t&) noexcept {
    return allocations::allocate(n, a);
}
SPARKOUT_REPLACED operator delete(void* p) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete[](void* p) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete(void* p, std::size_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete[](void* p, std::size_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete(void* p, std::align_val_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete[](void* p, std::align_val_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete(void* p, std::size_t, std::align_val_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete(void* p, const std::nothrow_t&) noexcept {
    allocations::release(p);
}
SPARKOUT_REPLACED operator delete[](void* p, const std::nothrow_t&) noexcept {
    allocations::release(p);
}
