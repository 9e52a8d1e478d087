# SPDX-License-Identifier: GPL-3.0-or-later
# Where the system has no wait of its own for an atomic, as for mingw-w64, the library of GCC 12 may lose
# a wake-up: it looks at the value before it locks, and wakes without the lock. Whoever removes the
# callback of a stop while it is called (std::stop_callback, a wait with a stop token) may then wait for
# good. All sources take this header of the library with both under the lock.
find_file(ATOMIC_WAIT_HEADER bits/atomic_wait.h PATHS ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(READ ${ATOMIC_WAIT_HEADER} GIVEN)
set(LOOKS "\t__platform_wait_t __val;
\t__atomic_load(__addr, &__val, __ATOMIC_SEQ_CST);
\tif (__val == __old)
\t  {
\t    lock_guard<mutex> __l(_M_mtx);
\t    _M_cv.wait(_M_mtx);
\t  }
")
set(LOCKS_AND_LOOKS "\tlock_guard<mutex> __l(_M_mtx);
\t__platform_wait_t __val;
\t__atomic_load(__addr, &__val, __ATOMIC_SEQ_CST);
\tif (__val == __old)
\t  _M_cv.wait(_M_mtx);
")
string(REPLACE "${LOOKS}" "${LOCKS_AND_LOOKS}" WAITS_LOCKED "${GIVEN}")
string(REPLACE "#else\n\tif (__all)\n\t  _M_cv.notify_all();"
    "#else\n\tlock_guard<mutex> __l(_M_mtx);\n\tif (__all)\n\t  _M_cv.notify_all();"
    MENDED "${WAITS_LOCKED}")
if(WAITS_LOCKED STREQUAL GIVEN OR MENDED STREQUAL WAITS_LOCKED)
    message(FATAL_ERROR "${ATOMIC_WAIT_HEADER} is not that of GCC 12: see cmake/waking.cmake")
endif()
file(WRITE ${PROJECT_BINARY_DIR}/waking/atomic_wait.h "${MENDED}")
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/waking/bits)
file(COPY_FILE ${PROJECT_BINARY_DIR}/waking/atomic_wait.h
    ${PROJECT_BINARY_DIR}/waking/bits/atomic_wait.h ONLY_IF_DIFFERENT)
include_directories(BEFORE SYSTEM ${PROJECT_BINARY_DIR}/waking)
