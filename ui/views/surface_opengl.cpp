// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/surface_opengl.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLibrary>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace sparkout {

namespace {

/// Drawn by the processor: the painter is quicker, its first picture too.
bool isSoftware(QOpenGLFunctions& gl) {
    const QByteArray renderer(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
    for (const char* name : {"llvmpipe", "softpipe", "SWR", "Software Rasterizer"}) {
        if (renderer.contains(name)) {
            return qEnvironmentVariableIsEmpty("SPARKOUT_SOFTWARE_OPENGL");
        }
    }
    return false;
}

bool makesContext() {
    const QString platform = QGuiApplication::platformName();
    for (const char* without : {"offscreen", "minimal", "vnc", "linuxfb"}) {
        if (platform == QLatin1String(without)) {
            return false;
        }
    }
    if (!qEnvironmentVariableIsEmpty("SPARKOUT_NO_OPENGL")) {
        return false;
    }
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface)) {
        return false;
    }
    const bool enough = context.functions()->hasOpenGLFeature(QOpenGLFunctions::Shaders)
                        && context.functions()->hasOpenGLFeature(QOpenGLFunctions::Framebuffers)
                        && !isSoftware(*context.functions());
    context.doneCurrent();
    return enough;
}

using MakeDrawer = SurfaceDrawer* (*)();

/// Once loaded it stays.
MakeDrawer loadModule() {
    const QString name = QStringLiteral("sparkout_surface");
    for (const QString& folder :
         {QCoreApplication::applicationDirPath(), QString::fromUtf8(SPARKOUT_MODULES)}) {
        QLibrary module(folder + QStringLiteral("/lib") + name + QStringLiteral(".so"));
        module.setLoadHints(QLibrary::PreventUnloadHint);
        if (const QFunctionPointer make = module.resolve("sparkout_make_surface_drawer")) {
            return reinterpret_cast<MakeDrawer>(make);
        }
    }
    return nullptr;
}

} // namespace

bool openGlWorks() {
    static const bool works = makesContext();
    return works;
}

std::unique_ptr<SurfaceDrawer> makeOpenGlDrawer() {
    if (!openGlWorks()) {
        return nullptr;
    }
    static const MakeDrawer make = loadModule();
    return std::unique_ptr<SurfaceDrawer>(make ? make() : nullptr);
}

} // namespace sparkout
