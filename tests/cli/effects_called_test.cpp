// Requirement R-505: where contact or space may act, what auto leaves out changes no end of a trial.
#include <cstdio>
#include <string>
#include <vector>

#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

/// Eight waves over the levels about which each body falls, on a stated pad, under two components.
std::string const campaign =
    "seed=5\n[waves]\nsource='spectrum-compatible'\ncount=8\nduration='40.96 s'\ntime_step='0.01 s'\n"
    "match='each'\n[waves.target]\nspectrum='mlit-ch1'\ntime_scale=0.632\n"
    "[waves.envelope]\nshape='jennings'\nrise='4 s'\nlevel_end='22 s'\nend='38 s'\n"
    "[waves.transverse]\nratio=0.3\n"
    "[[bodies]]\nname='plane'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\nfriction=0.6\naxes=1\npad={strength='30 MPa'}\n"
    "[[bodies]]\nname='space'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\nfriction=0.6\nbase={shape='square', bedding='corners'}\n"
    "[levels]\nmeasure='pga'\nvalues={from='300 gal', to='1500 gal', count=6}\n";

/// Ends that differ between two files, and how many trials of the first each model answered.
std::string const compare = R"(
import h5py, sys
def read(name):
    with h5py.File(name) as f:
        verdict = f['trials/verdict']
        rungs = h5py.check_enum_dtype(f['trials/rung'].dtype)
        return verdict[()] == h5py.check_enum_dtype(verdict.dtype)['overturned'], f['trials/rung'][()], rungs, f['trials/body'][()]
auto, rung, names, body = read('auto.h5')
differ = 0
for at, name in enumerate(('contact.h5', 'spatial.h5')):
    forced = read(name)[0]
    differ += ((auto != forced) & (body == at)).sum()
counts = {name: int((rung == value).sum()) for name, value in names.items()}
print(differ, auto.sum(), counts['rocking'] + counts['sliding'], counts['contact'], counts['spatial'])
)";

TEST(AutomaticEffects, EndTrialsAsContactAndSpaceDo) {
    Folder const folder;
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "nothing to read with (install python3-h5py)";
    }
    folder.write("c.toml", campaign);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "auto.h5"}).code, 0);
    for (std::string const effect : {"contact", "spatial"}) {
        auto const ended = overturn(folder, {"run", "c.toml", "-o", effect + ".h5", "--set",
                                             "effects.include=[\"sliding\", \"" + effect + "\"]"});
        ASSERT_EQ(ended.code, 0) << ended.err;
    }
    auto const ended = execute(folder, {OVERTURN_PYTHON, "-c", compare});
    ASSERT_EQ(ended.code, 0) << ended.err;
    int differ = -1, fell = 0, rigid = 0, contact = 0, spatial = 0;
    ASSERT_EQ(std::sscanf(ended.out.c_str(), "%d %d %d %d %d", &differ, &fell, &rigid, &contact, &spatial), 5)
        << ended.out;
    EXPECT_EQ(differ, 0) << ended.out;
    // It means something only where trials fall and stand, and each model answered some.
    EXPECT_GT(fell, 10) << ended.out;
    EXPECT_LT(fell, 86) << ended.out;
    EXPECT_GT(rigid, 0) << ended.out;
    EXPECT_GT(contact, 0) << ended.out;
    EXPECT_GT(spatial, 0) << ended.out;
}

}  // namespace
}  // namespace overturn::testing
