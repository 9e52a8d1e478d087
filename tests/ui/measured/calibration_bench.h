// SPDX-License-Identifier: GPL-3.0-or-later
// Work in the dialog "Calibrate from measurements" of a window.
#pragma once

#include "tests/ui/support/text_checks.h"
#include "tests/ui/support/traced_project.h"
#include "tests/ui/support/window_bench.h"

#include <QApplication>
#include <QDialog>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QTimer>

#include <functional>

namespace sparkout::calibration_bench {

template <typename Widget>
Widget* part(const QWidget& in, const char* name) {
    return in.findChild<Widget*>(QLatin1String(name));
}

/// Opens the dialog by its command and works in it; whatever happens, it is closed in the end.
inline void inDialog(const Bench& bench, const std::function<void(QDialog&)>& work) {
    bool seen = false;
    QTimer::singleShot(0, bench.window.get(), [&] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        if (dialog) {
            seen = true;
            work(*dialog);
            if (dialog->isVisible()) {
                dialog->reject();
            }
        }
    });
    bench.action("calibrate")->trigger();
    QVERIFY(seen);
}

inline QString cellOf(const QDialog& dialog, const char* table, int row, int column) {
    return part<QTableView>(dialog, table)->model()->index(row, column).data().toString();
}

} // namespace sparkout::calibration_bench
