// Requirement R-908: rock and spectrum give for a wave of a campaign, and its body, what the campaign stores of that
// trial.
#include <string>
#include <vector>

#include "cli/python.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

std::string const campaign =
    "seed=3\n[waves]\nsource='filtered-noise'\nmodel='kanai-tajimi'\nrms='1 m/s2'\ncount=2\n"
    "duration='8 s'\ntime_step='0.02 s'\n[waves.envelope]\nshape='constant'\n"
    "[waves.vertical]\nratio=0.5\n[waves.transverse]\nratio=0.7\n"
    "[[bodies]]\nfile='b.toml'\n[levels]\nmeasure='factor'\nvalues=[1]\n";

std::string const body =
    "name='body'\nmass='1 t'\nbase_width='0.3 m'\ncentre_height='0.8 m'\n"
    "inertia='uniform-block'\nfriction=0.6\n";

/// Compares, bit by bit, all that both know; prints how many numbers that were.
std::string const compare = R"(
import h5py, json, re, sys
rock, spectrum = (json.load(open(name)) for name in ('rock.json', 'spectrum.json'))
spectrum.update(spectrum['energy'])
compared = []
def same(name, found, stored):
    found = float('nan') if found is None else float(found)
    assert found == stored or (found != found and stored != stored), (name, found, stored)
    compared.append(name)
with h5py.File('c.h5') as f:
    trials, last = f['trials'], 1
    own = {'contact': trials['contact'], 'spatial': trials['spatial']}.get(rock['rung'], {})
    def hold(key, value):
        name = re.sub('_(rad|mps|m|s|jpkg)$', '', key)
        group = trials if name in trials else own
        if name in group and not isinstance(value, (str, list, dict, bool)):
            same(name, value, group[name][last])
    for key, value in rock.items():
        hold(key, value)
    for name, value in rock['matching'].items():  # null where nothing was tuned
        same('matched ' + name, value, own[name][last] if own else float('nan'))
    names = h5py.check_enum_dtype(trials['verdict'].dtype)
    assert names[rock['verdict']] == trials['verdict'][last], rock['verdict']
    measured = {'v_wes': f['waves/body/v_wes'][last], 'ou_v_e': f['waves/body/ou_v_e'][last], 'pga': f['waves/pga'][last]}  # at factor 1
    for name, value in measured.items():
        found = [spectrum[key] for key in (name, name + '_mps', name + '_mps2') if key in spectrum]
        assert len(found) == 1, (name, list(spectrum))
        same(name, found[0], value)
print(len(compared))
)";

class SameNumbers : public ::testing::TestWithParam<std::string> {};

TEST_P(SameNumbers, AsTheRowOfTheCampaign) {
    Folder const folder;
    if (!has_python(folder, "h5py")) {
        GTEST_SKIP() << "nothing to read with (install python3-h5py)";
    }
    folder.write("c.toml", campaign);
    folder.write("b.toml", body + GetParam());
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "c.h5"}).code, 0);
    ASSERT_EQ(overturn(folder, {"wave", "c.toml", "--wave", "1", "-o", "w.csv"}).code, 0);
    for (std::string const verb : {"rock", "spectrum"}) {
        auto const ended = overturn(folder, {verb, "--wave", "w.csv", "--body", "b.toml", "--json"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        folder.write(verb + ".json", ended.out);
    }
    auto const ended = execute(folder, {OVERTURN_PYTHON, "-c", compare});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_GE(std::stoi(ended.out), 15);
}

INSTANTIATE_TEST_SUITE_P(OnEveryBase, SameNumbers,
                         ::testing::Values("axes=1\n",
                                           "axes=1\nbase={bedding='flat', points=5}\npad={strength='5 MPa'}\n",
                                           "base={shape='round', points=16}\n", "base={shape='square'}\n"));

}  // namespace
}  // namespace overturn::testing
