// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/engine_info.h"

#include "core/process/pass_kernel.h"

#include <Eigen/Core>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>
#include <nlopt.h>

namespace sparkout {

namespace {

std::string dotted(int major, int minor, int patch) {
    return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

} // namespace

EngineInfo engineInfo() {
    EngineInfo info;
#if defined(__clang__)
    info.compiler = std::string("Clang ") + __clang_version__;
#else
    info.compiler = std::string("GCC ") + __VERSION__;
#endif
    info.eigen = dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    info.json = dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                       NLOHMANN_JSON_VERSION_PATCH);
    info.boost = dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
    int major = 0, minor = 0, bugfix = 0;
    nlopt_version(&major, &minor, &bugfix);
    info.nlopt = dotted(major, minor, bugfix);
    info.vectorUnit = widestUnit() == VectorUnit::avx2 ? "AVX2" : "SSE2";
    return info;
}

} // namespace sparkout
