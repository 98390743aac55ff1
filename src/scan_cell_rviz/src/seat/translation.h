// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLocale>
#include <QTranslator>
#include <memory>

namespace scan_cell_rviz {

/// The texts of the seat in the language of a locale.
/// @return null: there is no translation, they stay English
std::unique_ptr<QTranslator> translation_to(const QLocale& locale);

/// Gives this process that of its own locale (LANG, LC_ALL); once is enough.
void install_translation();

}  // namespace scan_cell_rviz
