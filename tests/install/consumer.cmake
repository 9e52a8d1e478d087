# SPDX-License-Identifier: GPL-3.0-or-later
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(Sparkout 1.0 CONFIG REQUIRED)
add_executable(simulate main.cpp)
target_link_libraries(simulate PRIVATE Sparkout::engine)
add_executable(search search.cpp)
target_link_libraries(search PRIVATE Sparkout::search)
