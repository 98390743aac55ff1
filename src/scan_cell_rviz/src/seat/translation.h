// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLocale>
#include <QTranslator>
#include <memory>

namespace scan_cell_rviz {

/// The texts of the seat in the language of a locale.
/// @return null: no translation, the texts stay English
std::unique_ptr<QTranslator> translation_to(const QLocale& locale);

/// Installs the translation for this process' locale (LANG, LC_ALL); calling it once is enough.
void install_translation();

}  // namespace scan_cell_rviz
