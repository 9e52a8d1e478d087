// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sparkout {

/// Compiler and libraries of the engine, and the vector unit that it uses.
struct EngineInfo {
    std::string compiler;   ///< "GCC 12.2.0"
    std::string eigen;      ///< version of the library
    std::string json;       ///< version of nlohmann-json
    std::string boost;      ///< version of its headers
    std::string nlopt;      ///< version of the library in use
    std::string vectorUnit; ///< vector unit of the inner loop: "AVX2"
};

[[nodiscard]] EngineInfo engineInfo();

} // namespace sparkout
