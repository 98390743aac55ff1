// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_recording.h"

#include <fmt/format.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>

#include <set>
#include <unordered_map>

#include "scan_cell_common/ros/bag_errors.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::UnusableInput;

std::string to_text(const Region& region) {
  return fmt::format("{} x {} at {}, {}", region.width, region.height, region.x, region.y);
}

/// The topic `name` in the namespace of another.
std::string beside(const std::string& topic, const std::string& name) {
  return topic.substr(0, topic.rfind('/') + 1) + name;
}

/// Bytes of a pixel; 0: it is not grey.
int bytes_of(const sensor_msgs::Image& image) {
  namespace encodings = sensor_msgs::image_encodings;
  if (image.encoding == encodings::MONO8 || image.encoding == encodings::TYPE_8UC1) return 1;
  if (image.encoding == encodings::MONO16 || image.encoding == encodings::TYPE_16UC1) return 2;
  return 0;
}

/// The number that a profile gives to the image with the same stamp.
struct Number {
  std::uint32_t acquisition;
  std::uint64_t counter;
  Nanoseconds device_time;
};

class BagRecording : public Recording {
 public:
  BagRecording(const std::string& path, const std::string& topic) : path_(path) {
    scan_cell_common::name_bag_in_errors(path, [&] {
      bag_.open(path, rosbag::bagmode::Read);
      topic_ = find_topic(topic);
      read_numbers_and_place();
      rewind();
      read_first_image();
    });
  }

  CameraDescription describe() override { return description_; }

  void rewind() override {
    images_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic_));
    at_ = images_->begin();
    count_ = 0;
    acquisition_ = 0;
  }

  std::optional<Frame> next() override {
    try {
      return read_next();
    } catch (const std::exception& error) {
      throw StreamEnded(path_, fmt::format("damaged after {} images", count_),
                        std::string("record it again, or try rosbag reindex: ") + error.what());
    }
  }

 private:
  std::string find_topic(const std::string& wanted) {
    std::set<std::string> topics;
    rosbag::View all(bag_);
    for (const rosbag::ConnectionInfo* connection : all.getConnections())
      if (connection->datatype == "sensor_msgs/Image") topics.insert(connection->topic);
    std::string names;
    for (const std::string& topic : topics)
      names += (names.empty() ? "" : ", ") + topic;
    if (topics.empty()) throw UnusableInput(path_, "holds no images", "record image_raw");
    if (wanted.empty() && topics.size() == 1) return *topics.begin();
    if (topics.count(wanted) > 0) return wanted;
    throw UnusableInput(
        path_, wanted.empty() ? "holds several topics of images" : "no images on " + wanted,
        "give bag_topic, one of " + names);
  }

  void read_numbers_and_place() {
    description_.id = "bag:" + path_;
    description_.model = "recording";
    description_.transport = "bag";
    description_.counter = kCounter64;
    const std::vector<std::string> topics = {beside(topic_, "profiles"),
                                             beside(topic_, "camera_info")};
    rosbag::View others(bag_, rosbag::TopicQuery(topics));
    for (const rosbag::MessageInstance& message : others) {
      if (const auto profile = message.instantiate<scan_cell_msgs::PeakProfile>()) {
        numbers_[profile->header.stamp.toNSec()] = {profile->acquisition, profile->frame_counter,
                                                    static_cast<Nanoseconds>(profile->device_time)};
      } else if (const auto info = message.instantiate<sensor_msgs::CameraInfo>()) {
        take_place(*info);
      } else {
        throw UnusableInput(
            path_, message.getTopic() + " has another definition of " + message.getDataType(),
            "convert it with rosbag fix");
      }
    }
  }

  void take_place(const sensor_msgs::CameraInfo& info) {
    const Region region{static_cast<int>(info.roi.x_offset), static_cast<int>(info.roi.y_offset),
                        static_cast<int>(info.roi.width), static_cast<int>(info.roi.height)};
    if (place_known_ && region != description_.region) {
      throw UnusableInput(
          path_,
          "the region changes from " + to_text(description_.region) + " to " + to_text(region),
          "cut it in two with rosbag filter");
    }
    place_known_ = true;
    description_.region = region;
    description_.sensor_columns = static_cast<int>(info.width);
    description_.sensor_rows = static_cast<int>(info.height);
  }

  void read_first_image() {
    if (at_ == images_->end()) throw UnusableInput(path_, "no images on " + topic_, "record some");
    const auto image = at_->instantiate<sensor_msgs::Image>();
    if (!image)
      throw UnusableInput(path_, "images with another message definition", "record them again");
    description_.grey_bits = bytes_of(*image) == 2 ? 16 : 8;
    Region& region = description_.region;
    if (region.width == 0) region.width = static_cast<int>(image->width);
    if (region.height == 0) region.height = static_cast<int>(image->height);
    if (description_.sensor_columns == 0) description_.sensor_columns = region.x + region.width;
    if (description_.sensor_rows == 0) description_.sensor_rows = region.y + region.height;
  }

  std::optional<Frame> read_next() {
    if (at_ == images_->end()) return std::nullopt;
    image_ = at_->instantiate<sensor_msgs::Image>();
    Frame frame;
    frame.time = static_cast<Nanoseconds>(
        (image_ && !image_->header.stamp.isZero() ? image_->header.stamp : at_->getTime())
            .toNSec());
    ++at_;
    ++count_;
    number(frame);
    const Region& region = description_.region;
    frame.image.columns = region.width;
    frame.image.rows = region.height;
    frame.image.first_column = region.x;
    frame.image.first_row = region.y;
    frame.image.bits = description_.grey_bits;
    frame.fault = find_fault();
    if (frame.fault.empty()) {
      frame.image.pixels = image_->data.data();
      frame.image.stride = image_->step / bytes_of(*image_);
    }
    return frame;
  }

  void number(Frame& frame) {
    if (numbers_.empty()) {
      frame.counter = count_;
      return;
    }
    const auto found = numbers_.find(static_cast<std::uint64_t>(frame.time));
    if (found == numbers_.end()) return;
    frame.counter = found->second.counter;
    frame.device_time = found->second.device_time;
    frame.restarted = acquisition_ != 0 && found->second.acquisition != acquisition_;
    acquisition_ = found->second.acquisition;
  }

  /// Why image_ cannot be used; empty if it can.
  std::string find_fault() const {
    if (!image_) return path_ + ": an image with another message definition; record it again";
    if (bytes_of(*image_) == 0)
      return path_ + ": encoding '" + image_->encoding + "'; record grey (mono8, mono16)";
    if (8 * bytes_of(*image_) != description_.grey_bits)
      return path_ + ": encoding '" + image_->encoding + "', unlike the first image";
    if (bytes_of(*image_) == 2 && image_->is_bigendian != 0)
      return path_ + ": big-endian pixels; record them little-endian";
    const Region& region = description_.region;
    if (static_cast<int>(image_->width) != region.width ||
        static_cast<int>(image_->height) != region.height || region.width < 1 ||
        region.height < 1) {
      return fmt::format("{}: an image of {} x {} pixels; the region is {}", path_, image_->width,
                         image_->height, to_text(region));
    }
    const std::size_t needed = static_cast<std::size_t>(image_->step) * image_->height;
    const std::size_t bytes = static_cast<std::size_t>(bytes_of(*image_));
    if (image_->step < image_->width * bytes || image_->step % bytes != 0 ||
        image_->data.size() < needed) {
      return fmt::format("{}: an image of {} bytes; step and height need {}", path_,
                         image_->data.size(), needed);
    }
    return "";
  }

  std::string path_;
  rosbag::Bag bag_;
  std::string topic_;
  CameraDescription description_;
  bool place_known_ = false;
  std::unordered_map<std::uint64_t, Number> numbers_;  // by stamp [ns]
  std::unique_ptr<rosbag::View> images_;
  rosbag::View::iterator at_;
  std::uint64_t count_ = 0;        // images that next() gave
  std::uint32_t acquisition_ = 0;  // of the last image that had a number; 0: none had
  sensor_msgs::ImageConstPtr image_;
};

}  // namespace

std::unique_ptr<Recording> open_bag_recording(const std::string& path, const std::string& topic) {
  return std::make_unique<BagRecording>(path, topic);
}

}  // namespace tecnogamma_camera
