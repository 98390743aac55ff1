// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The lines typed into controller_only.
#include "../src/tools/panel.h"
#include "controller/bare_client.h"

using scan_cell_sim::Controller;
using scan_cell_sim::Panel;

namespace {

class TypedLines : public testing::Test {
 protected:
  bool refuses(const std::string& line) {
    return panel_.carry_out(line).rfind("refused: ", 0) == 0;
  }

  Controller controller_{any_port()};
  Panel panel_{controller_, {}};
  BareClient client_{controller_.port()};
};

}  // namespace

TEST_F(TypedLines, DoWhatAPersonAtThePanelDoes) {
  client_.open();
  EXPECT_EQ(panel_.carry_out("e_stop"), "ok");
  EXPECT_TRUE(refuses("drives on"));
  EXPECT_TRUE(refuses("reset"));
  EXPECT_NE(panel_.carry_out("state").find("mode remote, drives off, emergency stop, alarm"),
            std::string::npos)
      << panel_.carry_out("state");
  for (const char* line : {"release", "reset", "drives on", "mode programming", "drives on"})
    EXPECT_EQ(panel_.carry_out(line), "ok") << line;
  const json state = client_.ask(2, {{"cmd", "GET_STATIC_POSE"}})["state"];
  EXPECT_EQ(state["mode"], "programming");
  EXPECT_EQ(state["drives"], true);
  EXPECT_EQ(panel_.carry_out(" fail  following error of J2 \r"), "ok");
  EXPECT_EQ(client_.ask(3, {{"cmd", "GET_STATIC_POSE"}})["state"]["alarms"][0]["text"],
            "following error of J2");
}

TEST_F(TypedLines, SpoilTheCableAndRepairIt) {
  client_.open();
  EXPECT_EQ(panel_.carry_out("fault lost 1 to_client"), "ok");
  client_.send(json{{"c4g", 1}, {"session", 100}, {"seq", 2}, {"cmd", "STOP"}});
  EXPECT_TRUE(client_.receive("ack", 300).is_null());
  EXPECT_EQ(panel_.carry_out("well"), "ok");
  EXPECT_EQ(code(client_.ask(3, {{"cmd", "STOP"}})), 0);
  EXPECT_EQ(panel_.carry_out("link down"), "ok");
  client_.send(json{{"c4g", 1}, {"session", 100}, {"seq", 4}, {"cmd", "STOP"}});
  EXPECT_TRUE(client_.receive("ack", 300).is_null());
  EXPECT_EQ(panel_.carry_out("link up"), "ok");
  EXPECT_EQ(panel_.carry_out("fault delay 20"), "ok");
  EXPECT_EQ(panel_.carry_out("restart 10"), "ok");
}

TEST_F(TypedLines, AreRefusedOrExplainedWhereTheyMakeNoSense) {
  for (const char* line :
       {"fault lost 2", "fault lost", "fault colour 1", "fault lost 0.1 sideways", "mode fast",
        "drives up", "link", "restart soon", "restart -1", "restart 10 s", "well done"})
    EXPECT_TRUE(refuses(line)) << line;
  EXPECT_EQ(panel_.carry_out("  "), "");
  for (const char* line : {"help", "dance"})
    EXPECT_NE(panel_.carry_out(line).find("e_stop"), std::string::npos) << line;
}
