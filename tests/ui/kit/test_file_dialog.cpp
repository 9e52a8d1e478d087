// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog of files where the desktop has none: everything in it is read in full, in the
// program's language whatever the system's.
#include "ui/kit/file_dialog.h"

#include "tests/registry.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/on_disk.h"
#include "ui/chart/svg_device.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/font_size.h"
#include "ui/text/language.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QListView>
#include <QLocale>
#include <QPainter>
#include <QScopeGuard>
#include <QScreen>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>

#include <functional>

namespace sparkout::test_file_dialog {

/// The texts of a widget as they are drawn, elided or not.
QString drawnOn(QWidget& widget) {
    SvgDevice device(widget.size(), 96, {});
    QPainter painter(&device);
    widget.render(&painter);
    painter.end();
    return QString::fromUtf8(device.document());
}

class TestFileDialog : public QObject {
    Q_OBJECT

private slots:
    void init() {
        const QDir folder(m_folder.path());
        QVERIFY(folder.mkpath(QStringLiteral("Валы")));
        on_disk::write(folder.filePath(QStringLiteral("Вал 30h6.sparkout")), QByteArray(9600, ' '));
    }

    void whatStandsInItIsReadInFull_data() { addLanguagesAndSizes(); }

    void whatStandsInItIsReadInFull() {
        QFETCH(QString, language);
        QFETCH(int, percent);
        const auto usual = qScopeGuard([] { applyFontSize(usualFontSize); });
        applyFontSize(percent);
        Language words;
        words.apply(language);
        look([&](QFileDialog& dialog) {
            auto* files = dialog.findChild<QTreeView*>(QStringLiteral("treeView"));
            QTRY_COMPARE(files->model()->rowCount(files->rootIndex()), 2);
            QTest::qWait(100);
            const QString drawn = drawnOn(*files->viewport());
            QVERIFY2(!drawn.contains(u'…'), qPrintable(drawn));
            const QString folder =
                language == u"ru" ? QStringLiteral("Папка") : QStringLiteral("Folder");
            QVERIFY(drawn.contains(u'>' + folder + u'<'));
            QVERIFY2(drawn.contains(QStringLiteral("h6.sparkout")), qPrintable(drawn));
            const QString today = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
            QVERIFY2(drawn.contains(today), qPrintable(today));
            QVERIFY(drawn.contains(language == u"ru" ? QStringLiteral("10 кБ")
                                                     : QStringLiteral("10 kB")));
            if (dialog.width() < dialog.screen()->availableSize().width()) {
                QVERIFY(files->header()->length() <= files->viewport()->width());
            }
            auto* places = dialog.findChild<QListView*>(QStringLiteral("sidebar"));
            QVERIFY(!drawnOn(*places->viewport()).contains(u'…'));
        });
    }

    void aLongNameEndsWithAWord() {
        const QString word = QStringLiteral("поверхностями");
        const QString name = fileNameOf({QString(word + u' ').repeated(9)});
        QCOMPARE(name, QString(word + u' ').repeated(5).trimmed());
        QCOMPARE(fileNameOf({QString(200, u'x')}).size(), 80);
        QCOMPARE(fileNameOf({QStringLiteral("a: b/c"), QString(), QStringLiteral(" d ")}),
                 QStringLiteral("a_ b_c – d"));
    }

    void whatIsChosenIsGivenBack() {
        const QString path = QDir(m_folder.path()).filePath(QStringLiteral("Вал 30h6.sparkout"));
        const auto take = [](const QString& name) {
            return [name](QFileDialog& dialog) {
                dialog.selectFile(name);
                static_cast<QDialog&>(dialog).accept();
            };
        };
        QCOMPARE(look(take(path)), path);
        QCOMPARE(look([](QFileDialog& dialog) { dialog.reject(); }), QString());
        const QString another = QDir(m_folder.path()).filePath(QStringLiteral("another"));
        act(take(another));
        QCOMPARE(FileDialog::savePath(nullptr, {}, path, QStringLiteral("Tables (*.csv)"),
                                      QStringLiteral("csv")),
                 another + QStringLiteral(".csv"));
    }

private:
    /// Does something with the dialog as soon as it is there, and closes it if that did not.
    static void act(const std::function<void(QFileDialog&)>& what) {
        QTimer::singleShot(0, [what] {
            QTRY_VERIFY(qobject_cast<QFileDialog*>(QApplication::activeModalWidget()));
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            const auto close = qScopeGuard([dialog] { dialog->close(); });
            what(*dialog);
        });
    }

    QString look(const std::function<void(QFileDialog&)>& what) {
        act(what);
        return FileDialog::openPath(nullptr, QStringLiteral("Open"), m_folder.path(),
                                    QStringLiteral("All files (*)"));
    }

    QTemporaryDir m_folder;
};

} // namespace sparkout::test_file_dialog

SPARKOUT_TEST(test_file_dialog, TestFileDialog)
#include "test_file_dialog.moc"
