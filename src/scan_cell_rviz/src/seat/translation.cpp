// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/translation.h"

#include <QCoreApplication>

namespace scan_cell_rviz {

std::unique_ptr<QTranslator> translation_to(const QLocale& locale) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(locale, "scan_cell_rviz", "_", ":/translations")) return nullptr;
  return translator;
}

void install_translation() {
  static const std::unique_ptr<QTranslator> translator = translation_to(QLocale());
  static const bool installed = translator && QCoreApplication::installTranslator(translator.get());
  static_cast<void>(installed);
}

}  // namespace scan_cell_rviz
