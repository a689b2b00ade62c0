#include "app/window/notices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skydrop::app {
namespace {

std::vector<std::string> shown(const Notices& notices) {
  game::Snapshot snapshot;
  snapshot.messages.push_back({"of the game", 1});
  notices.addTo(snapshot);
  std::vector<std::string> texts;
  for (const game::Message& message : snapshot.messages) texts.push_back(message.text);
  return texts;
}

TEST(Notices, eachIsShownForItsOwnTime) {
  // After the game's messages, in the order in which they came, until their seconds have passed.
  using testing::ElementsAre;
  Notices notices;
  notices.add("long", Notices::kUnrequestedSeconds);
  notices.add("short");
  EXPECT_THAT(shown(notices), ElementsAre("of the game", "long", "short"));
  notices.pass(Notices::kSeconds / 2);
  EXPECT_THAT(shown(notices), ElementsAre("of the game", "long", "short"));
  notices.pass(Notices::kSeconds / 2);
  EXPECT_THAT(shown(notices), ElementsAre("of the game", "long"));
  notices.pass(Notices::kUnrequestedSeconds);
  EXPECT_THAT(shown(notices), ElementsAre("of the game"));
}

}  // namespace
}  // namespace skydrop::app
