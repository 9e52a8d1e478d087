// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_step_text.h"

#include "core/text.h"

namespace sparkout {

const char* fileStepText(FileStep step) {
    switch (step) {
    case FileStep::inspect:
        return SPARKOUT_NOOP("FileError", "the file or folder is not accessible");
    case FileStep::notRegular: return SPARKOUT_NOOP("FileError", "the path does not name a file");
    case FileStep::readOnly: return SPARKOUT_NOOP("FileError", "the file is read-only");
    case FileStep::open: return SPARKOUT_NOOP("FileError", "it cannot be opened");
    case FileStep::create:
        return SPARKOUT_NOOP("FileError", "no file can be created in the folder");
    case FileStep::permissions: return SPARKOUT_NOOP("FileError", "its permissions cannot be set");
    case FileStep::write:
    case FileStep::sync:
    case FileStep::close: return SPARKOUT_NOOP("FileError", "the data could not be written");
    case FileStep::backup: return SPARKOUT_NOOP("FileError", "the previous version cannot be kept");
    case FileStep::rename: return SPARKOUT_NOOP("FileError", "the new file cannot be put in place");
    case FileStep::verify:
        return SPARKOUT_NOOP("FileError",
                             "the data read back from the disk differ from the data written");
    case FileStep::read: return SPARKOUT_NOOP("FileError", "it cannot be read");
    case FileStep::tooLarge: return SPARKOUT_NOOP("FileError", "the file is too large");
    case FileStep::changed:
        return SPARKOUT_NOOP("FileError", "another program has changed it in the meantime");
    case FileStep::content:
        return SPARKOUT_NOOP("FileError", "this program could not read the saved content back");
    }
    return "";
}

} // namespace sparkout
