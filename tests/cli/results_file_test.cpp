// Requirement R-1003: an independent reader finds what the contract of the results file promises.
#include "cli/campaign_files.hpp"
#include "support/command.hpp"

namespace overturn::testing {
namespace {

char const* const check = R"python(
import h5py, hashlib, numpy as np
f = h5py.File('c.h5')
need = ['format', 'format_version', 'program_version', 'git_revision', 'sources_sha256', 'library_versions', 'campaign', 'input_sha256',
        'seed', 'complete']
for name in need:
    assert name in f.attrs, name
assert f.attrs['format'] == b'overturn-results' or f.attrs['format'] == 'overturn-results'
assert f.attrs['complete'] == 1 and f.attrs['seed'] == 2013
text = f.attrs['campaign']
assert (text.decode() if isinstance(text, bytes) else text) == open('c.toml').read()

def told(name, o):
    if isinstance(o, h5py.Dataset):
        assert len(o.attrs['description']) > 0 and o.attrs['long_name'] == o.attrs['description'], name
        units = np.bytes_(o.attrs['units']).decode()
        assert len(units) > 0 and 'unit' not in units, name
        if 'units_from' in o.attrs:  # rows are of different measures: the unit of each, in their order
            assert np.bytes_(o.attrs['units_from']) == b'units', name
            of_rows = o.parent['units']
            names = {v: k for k, v in (h5py.check_enum_dtype(of_rows.dtype) or {}).items()}
            assert units.split('; ') == [names[u] if names else u.decode() for u in of_rows], name
f.visititems(told)
assert bytes(f['inputs/0000'][:]) == open('target.csv', 'rb').read()

names = h5py.check_enum_dtype(f['trials/verdict'].dtype)
assert names == {'at-rest': 0, 'slid': 1, 'rocked': 2, 'overturned': 3, 'contact-lost': 4, 'failed': 5, 'slid-and-rocked': 6}, names
assert h5py.check_enum_dtype(f['trials/body'].dtype) == {'type-a': 0, 'type-b': 1}
assert f['trials/verdict'].attrs['decided'] in (b'at-rest, slid, rocked, slid-and-rocked, overturned', 'at-rest, slid, rocked, slid-and-rocked, overturned')
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
            c = f['criterion_by_level'][body][m]
            assert h5py.h5ds.is_scale(c['amplitude'].id)
            assert c['false_safe'][l] == (overturned & said).sum()
            assert c['true_overturn'][l] == (overturned & ~said).sum()
            assert c['true_safe'][l] == (mine & ~overturned & ~failed & said).sum()
            assert c['false_alarm'][l] == (mine & ~overturned & ~failed & ~said).sum()
    g = f['fragility'][body]
    measures = h5py.check_enum_dtype(g['measure'].dtype)
    assert [k for m in g['measure'] for k, v in measures.items() if v == m] == ['pga', 'pgv', 'v_wes', 'ou_v_e', 'v_wes_ratio']
    units = {v: k for k, v in h5py.check_enum_dtype(g['units'].dtype).items()}
    assert [units[u] for u in g['units']] == ['m/s2', 'm/s', 'm/s', 'm/s', '1']
    known = g['identifiable'][:] == 1
    for name in ('median', 'beta', 'median_lower', 'beta_upper'):
        assert (np.isnan(g[name][:]) == ~known).all(), name
    assert (np.isnan(g['five_percent_point'][:]) == ~known).all()  # of a rejected curve too, beside its flag
    assert (np.isnan(g['hclpf'][:]) == ~(known & (g['flags'][:] & 1 << 17 == 0))).all()
    drawn = known & (g['flags'][:] & 1 << 17 == 0)
    assert np.allclose(g['median_at_95'][:][drawn], (g['median'][:] * np.exp(-1.6448536269514722 * g['beta_u'][:]))[drawn])
    assert np.isnan(g['median_at_95'][:][~drawn]).all()
    assert (g['flags'][:][~known] > 0).all()
    assert g.attrs['confidence'] == 0.95 and len(g['flags'].attrs['flag_names'].split()) == 19
assert (t['restitution'][t['body'] == 1] <= 1).all() and len(set(t['restitution'][t['body'] == 1])) == 12
assert np.allclose(t['peak_rotation'][t['verdict'] == 3], np.pi / 2)
assert ((t['effects'] & 1) == 1).all()
print('checked')
)python";

// Bodies whose order in the campaign is not that of the alphabet, on models of their own, with a limit state.
std::string many_groups() {
    auto campaign = campaign_on_points(4);
    campaign.replace(campaign.find("type-a"), std::string("type-a").size(), "wide one");
    return campaign + "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='0.1 m'\n";
}

char const* const check_all_groups = R"python(
import sys, h5py, numpy as np, xarray
engine = sys.argv[1]
f = h5py.File('c.h5')
groups = []
f.visititems(lambda name, o: groups.append(name) if isinstance(o, h5py.Group) else None)
columns = kinds = 0
for group in groups:
    stored = {name: o for name, o in f[group].items() if isinstance(o, h5py.Dataset)}
    if not stored:
        continue
    with xarray.open_dataset('c.h5', group=group, engine=engine) as seen:
        assert set(seen.variables) == set(stored), (group, set(stored) ^ set(seen.variables))
        for name, data in stored.items():
            column = seen[name]
            if data.dtype.kind == 'S':  # engines give texts as bytes or as str
                plain = lambda value: value.decode() if isinstance(value, bytes) else str(value)
                assert [plain(v) for v in column.values] == [plain(v) for v in data[()]], (group, name)
            else:
                assert column.shape == data.shape and column.dtype == data.dtype.base, (group, name, column.dtype)
                assert np.array_equal(column.values, data[()], equal_nan=data.dtype.kind == 'f'), (group, name)
            assert column.attrs['long_name'] == column.attrs['description'], (group, name)
            columns += 1
            names = h5py.check_enum_dtype(data.dtype)
            if names:
                told = zip(column.attrs['flag_meanings'].split(), np.atleast_1d(column.attrs['flag_values']))
                assert dict(told) == {n.replace(' ', '_'): v for n, v in names.items()}, (group, name)
                kinds += 1
with xarray.open_dataset('c.h5', group='trials', engine=engine) as trials:
    assert trials.verdict.dims == ('trial',) and (trials.trial.values == np.arange(len(trials.verdict))).all()
    assert trials.body.attrs['flag_meanings'] == 'wide_one type-b flat round scatters'
    with xarray.open_dataset('c.h5', group='trials/spatial', engine=engine) as own:
        assert set(own.sizes.items()) == {('trial', len(trials.verdict))}
for group, axis in (('waves', 'wave'), ('waves/flat', 'wave'), ('stripes/flat', 'amplitude'),
                    ('fragility/flat', 'measure'), ('limits/touches/stripes/flat', 'amplitude')):
    with xarray.open_dataset('c.h5', group=group, engine=engine) as seen:
        assert axis in seen.sizes, (group, dict(seen.sizes))
with xarray.open_dataset('c.h5', group='stripes/flat', engine=engine) as seen:
    assert seen.purpose.attrs['flag_meanings'] == 'ordinary design-basis beyond-design'
    assert list(seen.purpose.values) == [0, 1, 0]
    counted = seen.trials.sum().item()
with xarray.open_dataset('c.h5', group='models/flat', engine=engine) as seen:
    assert seen.trials.dims == ('model',) and seen.trials.sum().item() == counted
assert columns > 300 and kinds > 20, (columns, kinds)
print('checked')
)python";

char const* const check_order = R"python(
import h5py
f = h5py.File('c.h5')
campaign = ['wide one', 'type-b', 'flat', 'round', 'scatters']
assert h5py.check_enum_dtype(f['trials/body'].dtype) == {name: i for i, name in enumerate(campaign)}
for place in ('bodies', 'stripes', 'fragility', 'criterion', 'quantiles', 'waves', 'limits/touches/stripes',
              'limits/touches/fragility'):
    of_bodies = {name: g.attrs['index'] for name, g in f[place].items() if isinstance(g, h5py.Group)}
    assert of_bodies == {name: i for i, name in enumerate(campaign)}, (place, of_bodies)
assert list(f['bodies']) != campaign  # else nothing was at stake
assert all(f['bodies'][name]['body'][0] == i for i, name in enumerate(campaign))
print('checked')
)python";

class ResultsElsewhere : public ::testing::Test {
  protected:
    void run_campaign() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", many_groups());
        auto const run = execute(folder, mpirun(2, {"run", "c.toml"}));
        ASSERT_EQ(run.code, 0) << run.err;
    }
    void read_all(std::string const& engine, std::string const& module) {
        if (execute(folder, {OVERTURN_PYTHON, "-c", "import h5py, xarray, " + module}).code != 0) {
            GTEST_SKIP() << "no xarray to read with (install python3-xarray python3-netcdf4 python3-h5netcdf)";
        }
        ASSERT_NO_FATAL_FAILURE(run_campaign());
        folder.write("check.py", check_all_groups);
        auto const read = execute(folder, {OVERTURN_PYTHON, "check.py", engine});
        EXPECT_EQ(read.code, 0) << read.err;
        EXPECT_EQ(read.out, "checked\n");
    }
    Folder folder;
};

// netCDF's own library, which drops what it has no type for, finds every column with its axis and its names.
TEST_F(ResultsElsewhere, AreReadByXarrayThroughNetcdf) { read_all("netcdf4", "netCDF4"); }

// h5netcdf, which refuses a group with a column that has no axis, finds the same.
TEST_F(ResultsElsewhere, AreReadByXarrayThroughH5netcdf) { read_all("h5netcdf", "h5netcdf"); }

// HDF5's own tool lists and prints the whole file, names for numbers.
TEST_F(ResultsElsewhere, AreReadByH5dump) {
    if (execute(folder, {"/usr/bin/env", "h5dump", "--version"}).code != 0) {
        GTEST_SKIP() << "no h5dump to read with (install hdf5-tools)";
    }
    ASSERT_NO_FATAL_FAILURE(run_campaign());
    auto const whole = execute(folder, {"/usr/bin/env", "h5dump", "c.h5"});
    EXPECT_EQ(whole.code, 0) << whole.err;
    auto const bodies = execute(folder, {"/usr/bin/env", "h5dump", "-d", "/trials/body", "c.h5"});
    EXPECT_NE(bodies.out.find("scatters"), std::string::npos) << bodies.out;
}

// Groups are listed by name; each says which body of the campaign it is of.
TEST_F(ResultsElsewhere, NameTheBodyOfAGroup) {
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import h5py"}).code != 0) {
        GTEST_SKIP() << "no h5py to read with (install python3-h5py)";
    }
    ASSERT_NO_FATAL_FAILURE(run_campaign());
    folder.write("check.py", check_order);
    auto const read = execute(folder, {OVERTURN_PYTHON, "check.py"});
    EXPECT_EQ(read.code, 0) << read.err;
    EXPECT_EQ(read.out, "checked\n");
}

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
