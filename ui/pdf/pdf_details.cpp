// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pdf/pdf_details.h"

#include "ui/pdf/put_details.h"

#ifdef SPARKOUT_PDF_MODULE
#include <QCoreApplication>
#include <QFile>

#include <dlfcn.h>
#endif

namespace sparkout {

#ifdef SPARKOUT_PDF_MODULE

namespace {

/// Where it is installed, relative to the programs; else, in a build folder and the portable one,
/// where their run path says.
PutDetails loadModule() {
    const QByteArray installed = QFile::encodeName(QCoreApplication::applicationDirPath())
                                 + "/" SPARKOUT_PDF_FOLDER "/" SPARKOUT_PDF_MODULE;
    void* module = dlopen(installed.constData(), RTLD_NOW | RTLD_LOCAL);
    const QByteArray fault = module ? QByteArray() : QByteArray(dlerror());
    module = module ? module : dlopen(SPARKOUT_PDF_MODULE, RTLD_NOW | RTLD_LOCAL);
    void* const function = module ? dlsym(module, putDetailsName) : nullptr;
    if (!function) {
        qCritical("No PDF can be written: %s; %s", fault.constData(), dlerror());
    }
    return reinterpret_cast<PutDetails>(function);
}

} // namespace

QByteArray withDetails(const QByteArray& pdf, const PdfDetails& details,
                       const std::function<bool()>& goesOn) {
    static const PutDetails put = loadModule();
    QByteArray result;
    if (put) {
        put(result, pdf, details, goesOn);
    }
    return result;
}

#else

QByteArray withDetails(const QByteArray& pdf, const PdfDetails& details,
                       const std::function<bool()>& goesOn) {
    return putDetails(pdf, details, goesOn);
}

#endif

} // namespace sparkout
