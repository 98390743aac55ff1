// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <set>

#include "seat/translation.h"

namespace scan_cell_rviz {
namespace {

/// A text in the translation file.
struct Entry {
  QString source;
  QStringList forms;  // one, or one a plural
  bool unfinished = false;
};

std::vector<Entry> entries_of(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  QXmlStreamReader xml(&file);
  std::vector<Entry> entries;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == "message") entries.emplace_back();
    if (xml.name() == "source") entries.back().source = xml.readElementText();
    if (xml.name() == "numerusform") entries.back().forms.append(xml.readElementText());
    if (xml.name() != "translation") continue;
    entries.back().unfinished = xml.attributes().hasAttribute("type");
    if (xml.readNext() == QXmlStreamReader::Characters && !xml.isWhitespace())
      entries.back().forms.append(xml.text().toString());
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return entries;
}

/// %1, %2, %n ...
std::set<QString> places_of(const QString& text) {
  std::set<QString> places;
  auto found = QRegularExpression("%(\\d|n)").globalMatch(text);
  while (found.hasNext())
    places.insert(found.next().captured());
  return places;
}

bool has_mnemonic(const QString& text) {
  return text.contains(QRegularExpression("&\\w"));
}

}  // namespace

TEST(Translation, IsTheLanguageOfTheLocale) {
  const auto german = translation_to(QLocale("de_AT"));
  ASSERT_TRUE(german);
  EXPECT_EQ(german->translate("scan_cell_rviz::PartPage", "&Scan and fit").toStdString(),
            "&Scannen und anpassen");
  EXPECT_EQ(german->translate("scan_cell_rviz::PolygonTool", "No point is there. ").toStdString(),
            "Dort ist kein Punkt. ");
  EXPECT_FALSE(translation_to(QLocale("fi_FI")));
}

TEST(Translation, HasEveryTextOfTheSeat) {
  const QTemporaryDir folder;
  const QString copy = folder.filePath("scan_cell_rviz_de.ts");
  ASSERT_TRUE(QFile::copy(TRANSLATION, copy));
  ASSERT_EQ(QProcess::execute(
                LUPDATE, {"-silent", "-locations", "none", "-no-obsolete", SOURCES, "-ts", copy}),
            0);
  const std::vector<Entry> entries = entries_of(copy);
  EXPECT_GT(entries.size(), 150u);
  EXPECT_EQ(entries.size(), entries_of(TRANSLATION).size()) << "texts that are no longer there";
  for (const Entry& entry : entries)
    EXPECT_FALSE(entry.unfinished) << entry.source.toStdString();
}

TEST(Translation, KeepsThePlacesOfFiguresAndTheKeys) {
  for (const Entry& entry : entries_of(TRANSLATION)) {
    ASSERT_FALSE(entry.forms.isEmpty()) << entry.source.toStdString();
    for (const QString& form : entry.forms) {
      EXPECT_EQ(places_of(form), places_of(entry.source)) << entry.source.toStdString();
      EXPECT_EQ(has_mnemonic(form), has_mnemonic(entry.source)) << entry.source.toStdString();
    }
  }
}

TEST(Translation, GivesTheKeyThatStopsToNothingElse) {
  const QRegularExpression key("&[tT]");  // a key shared by two buttons presses neither
  QStringList english, german;
  for (const Entry& entry : entries_of(TRANSLATION)) {
    if (entry.source.contains(key)) english.append(entry.source);
    if (entry.forms.first().contains(key)) german.append(entry.forms.first());
  }
  EXPECT_EQ(english.join(", ").toStdString(), "S&top");
  EXPECT_EQ(german.join(", ").toStdString(), "S&topp");
}

}  // namespace scan_cell_rviz
