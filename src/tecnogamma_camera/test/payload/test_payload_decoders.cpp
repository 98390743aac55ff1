// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "payload/payloads.h"
#include "tecnogamma_camera/photonfocus_3d03.h"
#include "tecnogamma_camera/tecnogamma_relief.h"

using payloads::Photonfocus;
using payloads::Relief;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;
using tecnogamma_camera::CameraDescription;
using tecnogamma_camera::DecodedFrame;
using tecnogamma_camera::PayloadDecoder;
using tecnogamma_camera::Photonfocus3D03Decoder;
using tecnogamma_camera::Photonfocus3D03Settings;
using tecnogamma_camera::TecnogammaDecoder;
using tecnogamma_camera::TecnogammaSettings;

namespace {

std::vector<DecodedFrame> decode(const PayloadDecoder& decoder, const std::string& bytes,
                                 int columns = 0, int first_column = 0) {
  std::vector<DecodedFrame> frames;
  auto payload = payloads::view(bytes, columns);
  payload.first_column = first_column;
  frames.resize(decoder.decode(payload, frames));
  for (DecodedFrame& frame : frames)  // the copy's pixels are its own
    if (frame.image.pixels && !frame.pixels.empty()) frame.image.pixels = frame.pixels.data();
  return frames;
}

/// The error of a decoder about bytes that it refuses.
std::string refusal(const PayloadDecoder& decoder, const std::string& bytes, int columns = 0) {
  try {
    decode(decoder, bytes, columns);
  } catch (const UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TecnogammaDecoder tecnogamma(double tick = 1e-6) {
  TecnogammaSettings settings;
  settings.tick = tick;
  return TecnogammaDecoder(settings);
}

Photonfocus3D03Decoder photonfocus(int scan_first_row, int scan_rows, bool with_image = false) {
  Photonfocus3D03Settings settings;
  settings.scan_first_row = scan_first_row;
  settings.scan_rows = scan_rows;
  settings.with_image = with_image;
  Photonfocus3D03Decoder decoder(settings);
  decoder.adapt([](const std::string&) { return std::nullopt; });
  return decoder;
}

}  // namespace

TEST(TecnogammaRelief, GivesTheMiddleOfEachSpotOnTheSensor) {
  Relief relief;
  relief.spot(40, 5).spot(0, 0).spot(41, 6).spot(90, 1);
  const auto frames = decode(tecnogamma(), relief.bytes());
  ASSERT_EQ(frames.size(), 1U);
  const auto& peaks = frames[0].peaks;
  EXPECT_TRUE(frames[0].has_peaks);
  EXPECT_EQ(frames[0].image.pixels, nullptr);
  EXPECT_EQ(peaks.first_row, 100);
  ASSERT_EQ(peaks.rows(), 4);
  EXPECT_EQ(peaks.position[0], 64 + 42);  // pixels 40 to 44 of a region that starts at 64
  EXPECT_EQ(peaks.width[0], 5);
  EXPECT_TRUE(std::isnan(peaks.intensity[0])) << "the camera does not send it";
  EXPECT_TRUE(std::isnan(peaks.position[1])) << "width 0: no spot";
  EXPECT_TRUE(std::isnan(peaks.width[1]));
  EXPECT_EQ(peaks.position[2], 64 + 43.5);
  EXPECT_EQ(peaks.position[3], 64 + 90);
}

TEST(TecnogammaRelief, ReadsCounterAndTimeWhole) {
  Relief relief;  // all four bytes of the time differ, and its halves look negative as shorts
  relief.time = 0x81829394;
  relief.counter = 0xFFFE;
  relief.spot(1, 1).spot(1, 1).spot(1, 1).spot(1, 1);
  const auto frames = decode(tecnogamma(), relief.bytes());
  EXPECT_EQ(frames[0].counter, 65534U);
  EXPECT_EQ(frames[0].ticks, 0x81829394U);
  EXPECT_FALSE(decode(tecnogamma(0), relief.bytes())[0].ticks) << "its unit is not known";
  CameraDescription camera;
  tecnogamma().describe(camera);
  EXPECT_EQ(camera.counter.last, 65535U);
  EXPECT_EQ(camera.sensor_columns, 1696);
}

TEST(TecnogammaRelief, GivesTheCentreOfGravityWhereItIsSent) {
  Relief relief;
  relief.center(40, 5, 42.375).center(0, 0, 0).center(40, 5, 41.625).center(70, 9, 74 + 1 / 65536.);
  const auto frames = decode(tecnogamma(), relief.bytes());
  const auto& peaks = frames.at(0).peaks;
  EXPECT_EQ(peaks.position[0], 64 + 42.375F);
  EXPECT_TRUE(std::isnan(peaks.position[1]));
  EXPECT_EQ(peaks.position[2], 64 + 41.625F);
  EXPECT_NEAR(peaks.position[3], 64 + 74, 2e-5);
  EXPECT_EQ(peaks.width[3], 9);
}

TEST(TecnogammaRelief, LeavesOutAndCountsSpotsThatCannotBe) {
  Relief relief;  // a region of 96 columns
  relief.spot(90, 7).spot(65535, 65535).spot(40, 2).spot(95, 2);
  auto frames = decode(tecnogamma(), relief.bytes());
  EXPECT_EQ(frames.at(0).impossible_peaks, 3U);
  EXPECT_TRUE(std::isnan(frames[0].peaks.position[0]));
  EXPECT_FALSE(std::isnan(frames[0].peaks.position[2]));
  Relief centers;
  centers.center(40, 5, 95.5).center(40, 5, 95).center(40, 5, 42).center(40, 5, 65535);
  frames = decode(tecnogamma(), centers.bytes());
  EXPECT_EQ(frames.at(0).impossible_peaks, 2U);
}

TEST(TecnogammaRelief, GivesNoPeakWhereTheSpotIsCutByTheRegionsBorder) {
  Relief relief;
  relief.spot(0, 5).spot(90, 6).spot(1, 5).spot(89, 6);
  const auto frames = decode(tecnogamma(), relief.bytes());
  const auto& peaks = frames.at(0).peaks;
  EXPECT_TRUE(std::isnan(peaks.position[0]));
  EXPECT_TRUE(std::isnan(peaks.position[1]));
  EXPECT_FALSE(std::isnan(peaks.position[2]));
  EXPECT_FALSE(std::isnan(peaks.position[3]));
  EXPECT_EQ(frames[0].impossible_peaks, 0U);
}

TEST(TecnogammaRelief, GivesTheLiveImageOfAHybridFrame) {
  Relief live;
  live.first_kernel = 1;
  live.kernels = 1;
  for (int i = 0; i < 32 * 4; ++i)
    live.payload += static_cast<char>(i);
  const auto frames = decode(tecnogamma(), live.bytes());
  EXPECT_FALSE(frames.at(0).has_peaks);
  const auto& image = frames[0].image;
  EXPECT_EQ(image.columns, 32);
  EXPECT_EQ(image.rows, 4);
  EXPECT_EQ(image.first_column, 32);
  EXPECT_EQ(image.first_row, 100);
  EXPECT_EQ(image.row(2)[3], 2 * 32 + 3);
}

TEST(TecnogammaRelief, GivesNeitherPeaksNorPixelsOfAFrameThatLostPackets) {
  Relief relief;
  relief.packets_lost = 7;
  relief.spot(40, 5).spot(40, 5).spot(40, 5).spot(40, 5);
  const auto frames = decode(tecnogamma(), relief.bytes());
  EXPECT_EQ(frames.at(0).packets_lost, 7U);
  EXPECT_FALSE(frames[0].has_peaks);
  EXPECT_EQ(frames[0].image.pixels, nullptr);
  EXPECT_EQ(frames[0].image.rows, 4);
  EXPECT_EQ(frames[0].counter, 0xABCDU) << "its number is known";
}

TEST(TecnogammaRelief, RefusesWhatIsCutOffAnywhere) {
  Relief relief;
  relief.spot(40, 5).spot(40, 5).spot(40, 5).spot(40, 5);
  const std::string whole = relief.bytes();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(holds(refusal(tecnogamma(), whole.substr(0, size)), "cut off")) << size;
  EXPECT_EQ(refusal(tecnogamma(), whole + "more memory"), "nothing");
}

TEST(TecnogammaRelief, RefusesAPayloadOfTheWrongSizeAndARegionThatCannotBe) {
  Relief relief;
  relief.spot(40, 5).spot(40, 5).spot(40, 5);
  EXPECT_TRUE(holds(refusal(tecnogamma(), relief.bytes()), "payload of 12 bytes"));
  relief.spot(40, 5);
  EXPECT_EQ(refusal(tecnogamma(), relief.bytes()), "nothing");
  Relief empty = relief;
  empty.kernels = 0;
  EXPECT_TRUE(holds(refusal(tecnogamma(), empty.bytes()), "region of 0 x 4"));
  Relief upside_down = relief;
  upside_down.last_row = 99;
  EXPECT_TRUE(holds(refusal(tecnogamma(), upside_down.bytes()), "region of 96 x 0"));
  Relief beyond = relief;
  beyond.first_kernel = 51;
  EXPECT_TRUE(holds(refusal(tecnogamma(), beyond.bytes()), "1696 x 1710"));
  Relief below = relief;
  below.first_row = 1707;
  below.last_row = 1710;
  EXPECT_TRUE(holds(refusal(tecnogamma(), below.bytes()), "1696 x 1710"));
}

TEST(TecnogammaRelief, DoesNotTakeADecimatedImageForRows) {
  Relief live;  // 64 x 8 pixels
  live.kernels = 2;
  live.last_row = live.first_row + 7;
  live.decimation = 4;
  live.payload.assign(16 * 2, '\x55');  // 4 bytes for each of 8 rows
  EXPECT_TRUE(holds(refusal(tecnogamma(), live.bytes()), "decimated by 4"));
  live.decimation = 0;
  EXPECT_EQ(refusal(tecnogamma(), live.bytes()), "nothing") << "these are rows";
}

TEST(TecnogammaRelief, RefusesAnOffsetThatLeadsOutOfTheMemory) {
  Relief relief;
  relief.spot(40, 5).spot(40, 5).spot(40, 5).spot(40, 5);
  std::string bytes = relief.bytes();
  for (int i = 24; i < 28; ++i)
    bytes[static_cast<std::size_t>(i)] = '\xFF';  // offset + size overflows 32 bits
  EXPECT_TRUE(holds(refusal(tecnogamma(), bytes), "cut off"));
}

TEST(Photonfocus3D03, DecodesTheManualsExample) {
  constexpr auto peak = tecnogamma_camera::decode_photonfocus_peak(14, 176, 10, 128);
  EXPECT_EQ(peak.position, 58.75);
  EXPECT_EQ(peak.width, 10);
  EXPECT_EQ(peak.height, 8);
}

TEST(Photonfocus3D03, PutsAPeakWhereItsColumnIsOnTheTurnedSensor) {
  Photonfocus sent(32, 1);
  sent.set(0, 5, 14, 176, 10, 128);
  const auto frames = decode(photonfocus(200, 400), sent.bytes, 32, 640);
  ASSERT_EQ(frames.size(), 1U);
  const auto& peaks = frames[0].peaks;
  EXPECT_EQ(peaks.first_row, 2048 - 640 - 32);
  ASSERT_EQ(peaks.rows(), 32);
  const int row = (2048 - 1 - (640 + 5)) - peaks.first_row;
  EXPECT_EQ(peaks.position[row], 258.75) << "the scan area starts at 200";
  EXPECT_EQ(peaks.width[row], 10);
  EXPECT_GE(peaks.intensity[row], 128) << "at 12 bits 0x800 to 0x8ff (manual), at 8 128 to 143";
  EXPECT_LE(peaks.intensity[row], 143);
  EXPECT_TRUE(std::isnan(peaks.position[row + 1])) << "coordinate 0: no peak";
  CameraDescription camera;
  photonfocus(200, 400).describe(camera);
  EXPECT_EQ(camera.sensor_columns, 1088);
  EXPECT_EQ(camera.sensor_rows, 2048);
}

TEST(Photonfocus3D03, ReadsCounterAndTimeFromTheStatusNibbles) {
  Photonfocus sent(32, 1);
  sent.number(0, 0xABCDEF, 0x89ABCDEF);
  sent.status(0, 24, 2, 0xFF);  // what lies between them is not read
  sent.status(0, 64, 6, 0x5A5A5A);
  const auto frames = decode(photonfocus(0, 100), sent.bytes, 32);
  EXPECT_EQ(frames.at(0).counter, 0xABCDEFU);
  EXPECT_EQ(frames[0].ticks, 0x89ABCDEFU);
  EXPECT_EQ(photonfocus(0, 100).tick(), 1000) << "1 us";
}

TEST(Photonfocus3D03, GivesEachOfTheCombinedFramesButNotTheFillers) {
  Photonfocus sent(32, 4);
  for (int block = 0; block < 2; ++block) {
    sent.number(block, 100 + block, 5000 * block);
    sent.set(block, 3, 10, 64 * block, 4, 0x90);
  }
  sent.fill(2);
  sent.fill(3);
  const auto frames = decode(photonfocus(0, 100), sent.bytes, 32);
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[1].counter, 101U);
  EXPECT_EQ(frames[0].peaks.position[28], 40);
  EXPECT_EQ(frames[1].peaks.position[28], 41);
}

TEST(Photonfocus3D03, TurnsTheImageOf2DAnd3DAsItTurnsThePeaks) {
  constexpr int kScan = 20, kColumns = 32;
  Photonfocus sent(kColumns, 1);
  std::string image;
  for (int row = 0; row < kScan; ++row)
    for (int column = 0; column < kColumns; ++column)
      image += static_cast<char>(row == 12 && column == 7 ? 200 : 3);
  sent.set(0, 7, 12 * 64 >> 8, 12 * 64 & 0xFF, 1, 0xC0);  // the bright pixel
  const auto frames = decode(photonfocus(300, kScan, true), image + sent.bytes, kColumns);
  ASSERT_EQ(frames.size(), 1U);
  const auto& view = frames[0].image;
  EXPECT_EQ(view.columns, kScan);
  EXPECT_EQ(view.rows, kColumns);
  int found = 0;
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < view.columns; ++column) {
      if (view.row(row)[column] != 200) continue;
      ++found;
      EXPECT_EQ(frames[0].peaks.position[row], view.first_column + column);
      EXPECT_EQ(frames[0].peaks.first_row, view.first_row);
    }
  }
  EXPECT_EQ(found, 1);
}

TEST(Photonfocus3D03, LeavesOutAndCountsPeaksBelowTheScanArea) {
  Photonfocus sent(32, 1);
  sent.set(0, 1, 99 >> 2, (99 & 3) << 6, 4, 0x90);        // 99, the last row of 100
  sent.set(0, 2, 99 >> 2, ((99 & 3) << 6) | 1, 4, 0x90);  // 1/64 px below it
  const auto frames = decode(photonfocus(0, 100), sent.bytes, 32);
  EXPECT_EQ(frames.at(0).impossible_peaks, 1U);
  EXPECT_EQ(frames[0].peaks.position[30], 99);
  EXPECT_TRUE(std::isnan(frames[0].peaks.position[29]));
}

TEST(Photonfocus3D03, RefusesFramesOfTheWrongSize) {
  Photonfocus sent(32, 2);
  const auto decoder = photonfocus(0, 100);
  for (int rows = 0; rows < 10; ++rows) {
    const std::string cut = sent.bytes.substr(0, static_cast<std::size_t>(32 * rows));
    EXPECT_EQ(refusal(decoder, cut, 32) == "nothing", rows == 5) << rows;
  }
  EXPECT_TRUE(holds(refusal(decoder, std::string(15 * 5, '\0'), 15), "15 x 5"));
  EXPECT_TRUE(holds(refusal(decoder, std::string(4096 * 5, '\0'), 4096), "4096 x 5"));
  EXPECT_TRUE(holds(refusal(decoder, ""), "0 x 0"));
  EXPECT_TRUE(holds(refusal(photonfocus(0, 100, true), sent.bytes, 32), "105"));
}

TEST(Photonfocus3D03, AsksTheCameraForItsScanAreaAndRefusesWhatItCannotRead) {
  std::map<std::string, std::int64_t> features = {{"Peak0_3DY", 200}, {"Peak0_3DH", 400}};
  const auto reader = [&](const std::string& name) -> std::optional<std::int64_t> {
    const auto found = features.find(name);
    if (found == features.end()) return std::nullopt;
    return found->second;
  };
  Photonfocus3D03Decoder decoder{Photonfocus3D03Settings()};
  decoder.adapt(reader);
  Photonfocus sent(32, 1);
  sent.set(0, 0, 14, 176, 10, 128);
  EXPECT_EQ(decode(decoder, sent.bytes, 32).at(0).peaks.position[31], 258.75);
  features["PeakDetector_NrOfPeaks"] = 2;
  EXPECT_THROW(decoder.adapt(reader), UnusableInput);
  features["PeakDetector_NrOfPeaks"] = 1;
  features["DataFormat3D"] = 1;
  EXPECT_THROW(decoder.adapt(reader), UnusableInput);
  features.clear();
  EXPECT_THROW(decoder.adapt(reader), InvalidParameter);
}

TEST(PayloadSettings, NameTheOneThatIsOutOfRange) {
  const auto refused = [](const auto& settings) -> std::string {
    try {
      settings.check();
    } catch (const InvalidParameter& error) {
      return error.thing();
    }
    return "nothing";
  };
  TecnogammaSettings tecnogamma_settings;
  EXPECT_EQ(refused(tecnogamma_settings), "nothing");
  tecnogamma_settings.tick = std::nan("");
  EXPECT_EQ(refused(tecnogamma_settings), "payload_tick");
  Photonfocus3D03Settings settings;
  settings.scan_first_row = 1088;
  EXPECT_EQ(refused(settings), "scan_first_row");
  settings = {};
  settings.scan_rows = 0;
  EXPECT_EQ(refused(settings), "scan_rows");
}
