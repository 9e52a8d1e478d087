// SPDX-License-Identifier: GPL-3.0-or-later
// Draws every SVG below FOLDER/scalable in the usual sizes, where an icon theme has them:
// sparkout-icons FOLDER.
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QImageReader>

#include <cstdio>

int main(int argc, char** argv) {
    const QGuiApplication app(argc, argv);
    const QString root = QCoreApplication::arguments().value(1);
    QDirIterator drawings(root + QStringLiteral("/scalable"), {QStringLiteral("*.svg")},
                          QDir::Files, QDirIterator::Subdirectories);
    int drawn = 0;
    while (drawings.hasNext()) {
        const QFileInfo drawing(drawings.next());
        for (const int size : {16, 22, 24, 32, 48, 64, 128, 256}) {
            const QString folder =
                QStringLiteral("%1/%2x%2/%3").arg(root).arg(size).arg(drawing.dir().dirName());
            QImageReader reader(drawing.filePath()); // by Qt's plug-in for SVG
            reader.setScaledSize({size, size});
            const QImage image = reader.read();
            if (image.isNull() || !QDir().mkpath(folder)
                || !image.save(folder + u'/' + drawing.completeBaseName()
                               + QStringLiteral(".png"))) {
                std::fprintf(stderr, "sparkout-icons: %s: %s\n", qPrintable(drawing.filePath()),
                             qPrintable(reader.errorString()));
                return 1;
            }
            ++drawn;
        }
    }
    return drawn > 0 ? 0 : 1;
}
