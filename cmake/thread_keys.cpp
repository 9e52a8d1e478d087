// SPDX-License-Identifier: GPL-3.0-or-later
// Before anything else runs: the order in which a thread that ends gives up what it has.
//
// GCC for Windows keeps each thread_local in memory that emutls frees at the end of the thread, and
// libstdc++ calls the destructors there; both are told by a key of winpthreads, which goes by the
// keys' numbers. The key of emutls is made with the first thread_local that is used, that of
// libstdc++ with the first that has a destructor: the memory went before what was in it (bug 80816
// of GCC). So a number below that of emutls is kept for libstdc++.
#include <pthread.h>

namespace {

thread_local volatile int plain = 0;

struct Destroyed {
    Destroyed() : number(plain) {}
    ~Destroyed() { number = 0; }
    volatile int number;
};
thread_local Destroyed destroyed;

} // namespace

extern "C" [[gnu::constructor(101)]] void sparkout_order_thread_keys() {
    pthread_key_t kept{};
    if (pthread_key_create(&kept, nullptr) == 0) {
        plain = 1;                // emutls makes its key
        pthread_key_delete(kept); // the next key takes this number
        destroyed.number = 1;     // that of libstdc++
    }
}
