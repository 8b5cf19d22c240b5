// Requirement: an independent reader finds what the contract of the results file promises.
#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

char const* const check = R"python(
import h5py, hashlib, numpy as np
f = h5py.File('c.h5')
need = ['format', 'format_version', 'program_version', 'git_revision', 'library_versions', 'campaign', 'input_sha256',
        'seed', 'complete']
for name in need:
    assert name in f.attrs, name
assert f.attrs['format'] == b'overturn-results' or f.attrs['format'] == 'overturn-results'
assert f.attrs['complete'] == 1 and f.attrs['seed'] == 2013
text = f.attrs['campaign']
assert (text.decode() if isinstance(text, bytes) else text) == open('c.toml').read()

def told(name, o):
    if isinstance(o, h5py.Dataset):
        for key in ('units', 'description'):
            assert len(o.attrs[key]) > 0, (name, key)
f.visititems(told)
assert bytes(f['inputs/0000'][:]) == open('target.csv', 'rb').read()

names = h5py.check_enum_dtype(f['trials/verdict'].dtype)
assert names == {'at-rest': 0, 'slid': 1, 'rocked': 2, 'overturned': 3, 'contact-lost': 4, 'failed': 5}, names
assert h5py.check_enum_dtype(f['trials/body'].dtype) == {'type-a': 0, 'type-b': 1}
assert f['trials/verdict'].attrs['decided'] in (b'at-rest, slid, rocked, overturned', 'at-rest, slid, rocked, overturned')
t = {k: v[:] for k, v in f['trials'].items() if isinstance(v, h5py.Dataset)}
own = {k: v[:] for k, v in f['trials/contact'].items()}
n = len(t['verdict'])
assert n == 2 * 3 * 12 and all(len(v) == n for v in [*t.values(), *own.values()])
assert len(f['waves/id']) == 12 and len(f['waves/type-a/v_wes']) == 12
assert set(t['wave']) == set(f['waves/id'][:])

for b, body in enumerate(['type-a', 'type-b']):
    s = f['stripes'][body]
    assert h5py.h5ds.is_scale(s['amplitude'].id), 'amplitude is no dimension scale'
    assert s['probability'].dims[0][0].name == s['amplitude'].name
    for l, amplitude in enumerate(s['amplitude']):
        mine = (t['body'] == b) & (t['level'] == l)
        assert (t['amplitude'][mine] == amplitude).all()
        overturned = mine & (t['verdict'] == names['overturned'])
        failed = mine & (t['verdict'] == names['failed'])
        assert s['trials'][l] == mine.sum() and s['failed'][l] == failed.sum()
        failed = failed | mine & (t['verdict'] == names['contact-lost'])  # undecided from here on
        assert s['overturned'][l] == overturned.sum()
        assert s['probability'][l] == overturned.sum() / (mine.sum() - failed.sum())
        assert s['lower'][l] <= s['probability'][l] <= s['upper'][l]
        for m in ('v_wes', 'ou_v_e'):
            said = t[m + '_safe'] == 1
            assert (said == (t[m] < t['v_ereq'])).all()
            c = f['criterion'][body][m]
            assert h5py.h5ds.is_scale(c['amplitude'].id)
            assert c['false_safe'][l] == (overturned & said).sum()
            assert c['true_overturn'][l] == (overturned & ~said).sum()
            assert c['true_safe'][l] == (mine & ~overturned & ~failed & said).sum()
            assert c['false_alarm'][l] == (mine & ~overturned & ~failed & ~said).sum()
    g = f['fragility'][body]
    measures = h5py.check_enum_dtype(g['measure'].dtype)
    assert [k for m in g['measure'] for k, v in measures.items() if v == m] == ['pga', 'pgv', 'v_wes', 'ou_v_e', 'v_wes_ratio']
    known = g['identifiable'][:] == 1
    for name in ('median', 'beta', 'hclpf', 'median_lower', 'beta_upper'):
        assert (np.isnan(g[name][:]) == ~known).all(), name
    assert (g['flags'][:][~known] > 0).all()
    assert g.attrs['confidence'] == 0.95 and len(g.attrs['flag_names'].split()) == 17
assert (t['restitution'][t['body'] == 1] <= 1).all() and len(set(t['restitution'][t['body'] == 1])) == 12
assert np.allclose(t['peak_rotation'][t['verdict'] == 3], np.pi / 2)
assert ((t['effects'] & 1) == 1).all()
print('checked')
)python";

TEST(ResultsFile, IsReadByH5py) {
    Folder folder;
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import h5py"}).code != 0) {
        GTEST_SKIP() << "no h5py to read with (install python3-h5py)";
    }
    folder.write("target.csv", target_csv);
    folder.write("c.toml", small_campaign());
    folder.write("check.py", check);
    auto const run = execute(folder, mpirun(2, {"run", "c.toml"}));
    ASSERT_EQ(run.code, 0) << run.err;

    auto const read = execute(folder, {OVERTURN_PYTHON, "check.py"});
    EXPECT_EQ(read.code, 0) << read.err;
    EXPECT_EQ(read.out, "checked\n");
}

}  // namespace
}  // namespace overturn::testing
