// Requirement R-905: how far a run has come, in words, with the command that goes on.
#include "output/status_text.hpp"

#include <gtest/gtest.h>

namespace overturn {
namespace {

using output::progress_text;

TEST(StatusText, AWholeRunReportsWhetherItEndedEarlyOrWasChanged) {
    EXPECT_EQ(output::complete_text({.title = "t", .trials = 24, .waves = 4, .planned = 4}),
              "complete, 24 trials of 't'");
    EXPECT_EQ(output::complete_text({.title = "t", .trials = 24, .waves = 4, .planned = 8, .waves_text = "4 waves"}),
              "complete, 24 trials of 't'; 4 waves; precise enough after 4 of 8 waves");
    EXPECT_EQ(output::complete_text({.title = "t", .trials = 1, .waves = 1, .planned = 1, .changed = true}),
              "complete but edited or damaged, 1 trials of 't'");
}

TEST(StatusText, ARunThatDidNotEndReportsWhatIsLeftAndHowToGoOn) {
    EXPECT_EQ(progress_text({.done = 3, .left = 5, .all = 8, .waves_left = "24 to 63", .next = "overturn run c.toml"}),
              "not complete, 3 of 8 blocks are done, 5 left (waves 24 to 63). Go on with: overturn run c.toml");
    EXPECT_EQ(progress_text({.done = 3, .left = 5, .waves_left = "24 to 63", .rare = true, .next = "x"}),
              "not complete, 3 blocks are done, at least 5 left (waves 24 to 63). Go on with: x");
    EXPECT_EQ(progress_text({.done = 8, .left = 0, .all = 8, .rare = true, .next = "x"}),
              "not complete, 8 of 8 blocks are done, 0 left; its rare events are not. Go on with: x");
    EXPECT_EQ(progress_text({.done = 8, .left = 0, .all = 8, .next = "x"}),
              "not complete, 8 of 8 blocks are done, 0 left; not merged yet. Go on with: x");
    EXPECT_EQ(progress_text({.done = 3, .left = 5, .all = 8, .under_way = true}),
              "not complete, 3 of 8 blocks are done, 5 left; a run is under way");
}

TEST(StatusText, AnExtensionReportsWhatIsDoneAndWhatIsLeft) {
    EXPECT_EQ(output::extension_text(
                  64, 2, 3, progress_text({.done = 3, .left = 5, .all = 8, .waves_left = "24 to 63", .next = "x"})),
              "an extension to 64 waves, 2 bodies and 3 levels is not complete, 3 of 8 blocks are done, 5 left (waves "
              "24 to 63). Go on with: x");
    EXPECT_TRUE(output::extension_text(1, 1, 1, "x").starts_with("an extension to 1 wave, 1 body and 1 level is x"));
    EXPECT_EQ(output::before_extension_text("complete, 24 trials"), "the file until then: complete, 24 trials");
}

}  // namespace
}  // namespace overturn
