# SPDX-License-Identifier: GPL-3.0-or-later
# Options every target of the tree shares.

# Of a list of sources, drops those of the other system: NAME_posix.cpp and NAME_windows.cpp are the two
# sources of NAME.h.
function(sparkout_sources_of_system VARIABLE)
    set(SOURCES ${${VARIABLE}})
    if(WIN32)
        list(FILTER SOURCES EXCLUDE REGEX "_posix\\.cpp$")
    else()
        list(FILTER SOURCES EXCLUDE REGEX "_windows\\.cpp$")
    endif()
    set(${VARIABLE} ${SOURCES} PARENT_SCOPE)
endfunction()

add_library(sparkout_options INTERFACE)
# No contraction: results must not differ between processors with and without FMA.
target_compile_options(sparkout_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -ffp-contract=off)
target_compile_definitions(sparkout_options INTERFACE _GLIBCXX_ASSERTIONS)
target_include_directories(sparkout_options INTERFACE ${PROJECT_SOURCE_DIR})
if(WIN32)
    # Sources joined have more sections than objects have by default. The stack of a function is not
    # aligned for AVX (bug 54412 of GCC): its moves are to ask for no alignment. Which registers an
    # inline function leaves alone is not known from one copy of it: the linker may take another.
    target_compile_options(sparkout_options INTERFACE
        -Wa,-mbig-obj -Wa,-muse-unaligned-vector-move -fno-ipa-ra)
    target_compile_definitions(sparkout_options INTERFACE NOMINMAX WIN32_LEAN_AND_MEAN UNICODE)
    include(${CMAKE_CURRENT_LIST_DIR}/waking.cmake)
else()
    target_link_options(sparkout_options INTERFACE -Wl,-z,relro,-z,now)
endif()
if(SPARKOUT_WERROR)
    target_compile_options(sparkout_options INTERFACE -Werror)
endif()
# Where there is memory enough, GCC collects its garbage less often: a twelfth of the window's time of
# compiling, a twentieth of the core's, the same code.
cmake_host_system_information(RESULT SPARKOUT_HOST_MEMORY QUERY TOTAL_PHYSICAL_MEMORY) # MiB
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND SPARKOUT_HOST_MEMORY GREATER 12000)
    target_compile_options(sparkout_options INTERFACE --param=ggc-min-heapsize=3000000)
endif()
if(SPARKOUT_SANITIZE)
    # The address sanitizer sees a null pointer's use and an object's end itself, and x86-64 reads
    # unaligned; without these three checks a third of the time of compiling goes.
    target_compile_options(sparkout_options INTERFACE
        -fsanitize=address$<$<NOT:$<BOOL:$<TARGET_PROPERTY:WITHOUT_UBSAN>>>:,undefined>
        -fno-sanitize=null,alignment,object-size -fno-sanitize-recover=all
        -fno-omit-frame-pointer -Wno-pass-failed)
    target_link_options(sparkout_options INTERFACE -fsanitize=address,undefined)
elseif(WIN32)
    target_compile_options(sparkout_options INTERFACE -fstack-protector-strong)
    target_link_options(sparkout_options INTERFACE -fstack-protector-strong)
else()
    target_compile_options(sparkout_options INTERFACE -fstack-protector-strong -fcf-protection)
    # The linker notes what all objects of a program are compiled for, and the start files of Debian's C
    # library say nothing. Compiled code keeps to a shadow stack in any case: it returns where it was called.
    target_link_options(sparkout_options INTERFACE -Wl,-z,shstk)
endif()

# Notes as well that all places of a program that may be jumped to are marked, which is true of all
# objects but the start files (landing_pads.cpp) and libqpdf.a, which Debian compiles without marks.
function(sparkout_marked_entries TARGET)
    if(WIN32 OR SPARKOUT_SANITIZE)
        return()
    endif()
    target_sources(${TARGET} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/landing_pads.cpp)
    set_source_files_properties(${PROJECT_SOURCE_DIR}/cmake/landing_pads.cpp TARGET_DIRECTORY ${TARGET}
        PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
    target_link_options(${TARGET} PRIVATE -Wl,-z,ibt -Wl,-e,sparkout_start -Wl,-init,sparkout_init
        -Wl,-fini,sparkout_fini)
endfunction()
# To clang a local name shadows what another of the sources joined has in its own namespace.
if(SPARKOUT_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(sparkout_options INTERFACE -Wno-shadow)
endif()
# What the core and the window's libraries keep to besides; the macros of the tests do not.
add_library(sparkout_strict INTERFACE)
target_compile_options(sparkout_strict INTERFACE -Wconversion)
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()
