// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sparkout {

/// Whether a disk is being waited for: the window stays responsive meanwhile, and a command that
/// must not run then checks busy().
class DiskWait {
public:
    [[nodiscard]] bool busy() const { return m_busy; }
    void during(const std::function<void()>& work); ///< work that keeps the window alive itself
    void aside(const std::function<void()>& work);  ///< without freezing the window

private:
    bool m_busy = false;
};

} // namespace sparkout
