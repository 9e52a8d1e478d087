# SPDX-License-Identifier: GPL-3.0-or-later
# What the window needs on top of the engine.
# Qt asks for them on behalf of programs that use its private parts: not found, nothing is missing.
set(XKB_FIND_QUIETLY TRUE)
set(WrapVulkanHeaders_FIND_QUIETLY TRUE)
find_package(Qt6 REQUIRED COMPONENTS Core Gui Widgets PrintSupport Charts LinguistTools)
find_package(QCustomPlotQt6 REQUIRED)
find_package(qpdf REQUIRED)
find_library(STEMMER_LIBRARY stemmer REQUIRED)
find_path(STEMMER_INCLUDE_FOLDER libstemmer.h REQUIRED)
