# SPDX-License-Identifier: GPL-3.0-or-later
# What the window needs on top of the engine.
# Qt asks for them on behalf of programs that use its private parts: not found, nothing is missing.
set(XKB_FIND_QUIETLY TRUE)
set(WrapVulkanHeaders_FIND_QUIETLY TRUE)
find_package(Qt6 REQUIRED COMPONENTS Core Gui Widgets PrintSupport Charts LinguistTools)
find_package(QCustomPlotQt6 REQUIRED)
find_package(qpdf REQUIRED)
# libqpdf and what it needs are read for the first PDF alone: a module holds it, which the programs of a
# build find by their run path and installed ones relative to themselves.
set(SPARKOUT_PDF_MODULE ON)
if(WIN32 OR SPARKOUT_SANITIZE)
    set(SPARKOUT_PDF_MODULE OFF)
endif()
if(SPARKOUT_PDF_MODULE)
    file(RELATIVE_PATH SPARKOUT_PDF_FOLDER ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/sparkout)
endif()
find_library(STEMMER_LIBRARY stemmer REQUIRED)
find_path(STEMMER_INCLUDE_FOLDER libstemmer.h REQUIRED)
