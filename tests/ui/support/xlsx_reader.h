// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>

#include <charconv>
#include <optional>

/// A workbook as another program reads it: openpyxl, by tests/ui/support/read_xlsx.py.
class XlsxReader {
public:
    explicit XlsxReader(const QString& path) {
        QProcess reader;
        // Debian's own, which has the package.
        reader.start(QStringLiteral("/usr/bin/python3"),
                     {QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/ui/support/read_xlsx.py"), path});
        reader.waitForFinished(60'000);
        m_fault = QString::fromUtf8(reader.readAllStandardError());
        m_book = QJsonDocument::fromJson(reader.readAllStandardOutput()).object();
    }

    [[nodiscard]] QString fault() const { return m_fault; } ///< what openpyxl had against it
    [[nodiscard]] QString text(const char* key) const {
        return m_book.value(QLatin1StringView(key)).toString();
    }
    [[nodiscard]] QStringList names() const {
        QStringList names;
        for (const QJsonValue& sheet : sheets()) {
            names << sheet[QStringLiteral("name")].toString();
        }
        return names;
    }
    [[nodiscard]] QJsonObject sheet(int i) const { return sheets().at(i).toObject(); }
    [[nodiscard]] QString frozen(int sheet) const {
        return this->sheet(sheet).value(QStringLiteral("frozen")).toString();
    }
    [[nodiscard]] int rows(int sheet) const { return static_cast<int>(rowsOf(sheet).size()); }
    [[nodiscard]] int columns(int sheet) const {
        return static_cast<int>(rowsOf(sheet).at(0).toArray().size());
    }
    /// "n" a number, "s" a text, "f" a formula; empty for an empty cell.
    [[nodiscard]] QString type(int sheet, int row, int column) const {
        return part(sheet, row, column, 0).toString();
    }
    [[nodiscard]] QString text(int sheet, int row, int column) const {
        return part(sheet, row, column, 1).toString();
    }
    [[nodiscard]] QString format(int sheet, int row, int column) const {
        return part(sheet, row, column, 2).toString();
    }
    [[nodiscard]] bool quoted(int sheet, int row, int column) const {
        return part(sheet, row, column, 3).toBool();
    }
    /// The number with all its bits; nothing where there is none.
    [[nodiscard]] std::optional<double> number(int sheet, int row, int column) const {
        if (type(sheet, row, column) != u"n") {
            return {};
        }
        const QByteArray hex = text(sheet, row, column).toLatin1().replace("0x", "");
        double value = 0; // "-1.8p+3", whatever the locale
        const auto read = std::from_chars(hex.begin(), hex.end(), value, std::chars_format::hex);
        return read.ec == std::errc() ? std::optional(value) : std::nullopt;
    }

private:
    [[nodiscard]] QJsonArray sheets() const {
        return m_book.value(QStringLiteral("sheets")).toArray();
    }
    [[nodiscard]] QJsonArray rowsOf(int sheet) const {
        return this->sheet(sheet).value(QStringLiteral("rows")).toArray();
    }
    [[nodiscard]] QJsonValue part(int sheet, int row, int column, int i) const {
        return rowsOf(sheet).at(row).toArray().at(column).toArray().at(i);
    }

    QString m_fault;
    QJsonObject m_book;
};
