// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/load_parameters.h"

using scan_cell_common::InvalidParameter;
using scan_cell_common::RosParameters;

namespace {

class Parameters : public testing::Test {
 protected:
  void TearDown() override { node_.deleteParam(node_.getNamespace()); }

  /// Name of the parameter that `read` refuses.
  template <class Read>
  std::string refused(const Read& read) {
    try {
      read();
    } catch (const InvalidParameter& error) {
      return error.thing();
    }
    return "nothing";
  }

  ros::NodeHandle node_{"~parameters"};
  RosParameters reader_{node_};
};

}  // namespace

TEST_F(Parameters, KeepTheDefaultOfTheStructWhereNotSet) {
  double rate = 12.5;
  reader_.add("rate", rate, {1, 100}, "");
  EXPECT_EQ(rate, 12.5);
  node_.setParam("rate", 50);
  reader_.add("rate", rate, {1, 100}, "");
  EXPECT_EQ(rate, 50.0);
}

TEST_F(Parameters, AreRefusedByNameOutsideTheirRange) {
  double rate = 10;
  node_.setParam("rate", 1000.0);
  EXPECT_EQ(refused([&] { reader_.add("rate", rate, {1, 100}, ""); }), node_.resolveName("rate"));
  node_.setParam("rate", std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(refused([&] { reader_.add("rate", rate, {1, 100}, ""); }), node_.resolveName("rate"));
}

TEST_F(Parameters, AreRefusedByNameWithTheWrongType) {
  double rate = 10;
  node_.setParam("rate", "fast");
  EXPECT_EQ(refused([&] { reader_.add("rate", rate, {1, 100}, ""); }), node_.resolveName("rate"));
}

TEST_F(Parameters, TakeAWholeNumberForAFractionButNoFractionForAWholeNumber) {
  int port = 10;
  double rate = 10;
  node_.setParam("port", 5410.4);
  EXPECT_EQ(refused([&] { reader_.add("port", port, {1, 65535}, ""); }), node_.resolveName("port"));
  node_.setParam("port", "many");
  EXPECT_EQ(refused([&] { reader_.add("port", port, {1, 65535}, ""); }), node_.resolveName("port"));
  EXPECT_EQ(port, 10);
  node_.setParam("port", 5411);
  reader_.add("port", port, {1, 65535}, "");
  EXPECT_EQ(port, 5411);
  node_.setParam("rate", 20);
  reader_.add("rate", rate, {1, 100}, "");
  EXPECT_EQ(rate, 20.0);
}

TEST_F(Parameters, AreRefusedByNameWhereRequiredAndMissing) {
  std::string port;
  EXPECT_EQ(refused([&] { reader_.require("port", port, ""); }), node_.resolveName("port"));
}

TEST_F(Parameters, AreRefusedByNameWhereNoOneReadsThem) {
  double rate = 10;
  node_.setParam("rtae", 5.0);
  reader_.add("rate", rate, {1, 100}, "");
  EXPECT_EQ(refused([&] { reader_.refuse_unknown(); }), node_.resolveName("rtae"));
}

TEST_F(Parameters, AreRefusedByTheirOldNameWithTheNewOne) {
  double max_rate = 10;
  node_.setParam("most_rate", 5.0);
  reader_.add("max_rate", max_rate, {1, 100}, "");
  try {
    reader_.renamed("most_rate", "max_rate");
    FAIL();
  } catch (const InvalidParameter& error) {
    EXPECT_EQ(error.what(), node_.resolveName("most_rate") + ": renamed; use max_rate");
  }
}

TEST_F(Parameters, ChooseOnlyAmongTheWordsAllowed) {
  std::string method = "first_pose";
  node_.setParam("method", "nearest");
  EXPECT_EQ(refused([&] {
              reader_.choice("method", method, {"first_pose", "interpolate"}, "");
            }),
            node_.resolveName("method"));
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_load_parameters");
  ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
