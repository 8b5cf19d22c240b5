// Requirement R-706: limit states of the user's own are answered like overturning, by every verb, with the same bytes
// on any number of ranks, resumed and in parts; an independent reader finds them from the trials' columns.
#include <nlohmann/json.hpp>

#include "cli/campaign_files.hpp"
#include "support/command.hpp"
#include "support/csv_of_json.hpp"
#include "support/line_width.hpp"

namespace overturn::testing {
namespace {

using nlohmann::json;

std::string const limits =
    "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='4 cm'\n"
    "[[limits]]\nname='tilts'\nquantity='peak_rotation_ratio'\nabove=0.1\n"
    "[[limits]]\nname='either'\nany=['touches','tilts','overturning']\n"
    "[[limits]]\nname='both'\nall=['touches','tilts']\n";

class Limits : public ::testing::Test {
  protected:
    Limits() {
        folder.write("target.csv", target_csv);
        folder.write("c.toml", small_campaign() + limits);
        folder.write("plain.toml", small_campaign());
    }
    [[nodiscard]] json fit(std::string const& file) const {
        auto const ended = overturn(folder, {"fit", file, "--json"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    }

    Folder folder;
};

// R-1001.
TEST_F(Limits, SameBytesOnAnyNumberOfRanksResumedAndInParts) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "1.h5"}).code, 0);
    for (auto const* ranks : {"2", "3"}) {
        auto const name = std::string(ranks) + ".h5";
        auto const ended = execute(folder, mpirun(std::stoi(ranks), {"run", "c.toml", "-o", name}));
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_TRUE(folder.read("1.h5") == folder.read(name)) << ranks;
    }
    for (auto const* part : {"2/2", "1/2"}) {
        ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "p.h5", "--part", part}).code, 0);
    }
    ASSERT_EQ(overturn(folder, {"merge", "p.h5"}).code, 0);
    EXPECT_TRUE(folder.read("1.h5") == folder.read("p.h5"));
    EXPECT_EQ(overturn(folder, {"run", "c.toml", "-o", "r.h5", "--max-walltime", "1 ms"}).code, 3);
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "r.h5", "--resume"}).code, 0);
    EXPECT_TRUE(folder.read("1.h5") == folder.read("r.h5"));
    EXPECT_EQ(overturn(folder, {"status", "1.h5"}).code, 0);
    EXPECT_EQ(overturn(folder, {"replay", "1.h5", "--trial", "17"}).code, 0);
}

/// Limit states are asked of the trials, they do not change them: all columns are those of the campaign without them.
/// Counts, quantiles and their ends are found again with numpy alone.
TEST_F(Limits, AnIndependentReaderFindsThem) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "1.h5"}).code, 0);
    ASSERT_EQ(overturn(folder, {"run", "plain.toml", "-o", "0.h5"}).code, 0);
    folder.write("check.py", R"python(
import h5py, numpy as np
f, plain = h5py.File('1.h5'), h5py.File('0.h5')
def same(name, o):
    if isinstance(o, h5py.Dataset) and not name.startswith(('inputs', 'digests', 'limit_states')):  # of what differs anyway
        assert o[()].tobytes() == f[name][()].tobytes(), name
plain.visititems(same)
assert 'limits' not in plain
t = {k: v[:] for k, v in f['trials'].items() if isinstance(v, h5py.Dataset)}
verdicts = h5py.check_enum_dtype(f['trials/verdict'].dtype)
known = (t['verdict'] != verdicts['failed']) & (t['verdict'] != verdicts['contact-lost'])
slip, tilt, fell = t['peak_slip'] > 0.04, t['peak_rotation_ratio'] > 0.1, t['verdict'] == verdicts['overturned']
slip, tilt = slip | fell, tilt | fell  # what overturned has passed every limit
said = {'touches': slip, 'tilts': tilt, 'either': slip | tilt, 'both': slip & tilt}
text = lambda a: a.decode() if isinstance(a, bytes) else a
names_of = lambda d: [{v: k for k, v in h5py.check_enum_dtype(d.dtype).items()}[n] for n in d[:]]
definitions = dict(zip(names_of(f['limit_states/name']), names_of(f['limit_states/definition'])))
assert definitions['touches'] == 'peak_slip > 4 cm'
assert definitions['either'] == 'any of touches, tilts, overturning'
seen = 0
for b, body in enumerate(['type-a', 'type-b']):
    for l in range(3):
        mine = (t['body'] == b) & (t['level'] == l)
        for name, passed in said.items():
            s = f['limits'][name]['stripes'][body]
            assert h5py.h5ds.is_scale(s['amplitude'].id)
            assert s['trials'][l] == mine.sum() and s['exceeded'][l] == (mine & known & passed).sum(), (name, body, l)
            assert s['failed'][l] + s['undecided'][l] == (mine & ~known).sum()
            assert s['lower'][l] <= s['probability'][l] <= s['upper'][l]
            seen += s['exceeded'][l]
        q = f['quantiles'][body]
        names = ['peak_slip'] if body == 'type-a' else []  # type-b cannot slip
        for column in names:
            values = np.sort(np.where(fell, np.inf, t[column])[mine & known])
            for name, share in (('median', 0.5), ('p84', 0.84), ('p95', 0.95)):
                at = share * (len(values) - 1)
                low, high = values[int(np.floor(at))], values[int(np.ceil(at))]
                if len(values) < (20 if share == 0.95 else 5):
                    assert np.isnan(q[column][name][l]), 'too few for it'
                    continue
                right = low if low == high else low + (at % 1) * (high - low)
                assert q[column][name][l] == right or abs(q[column][name][l] - right) <= 1e-12 * (1 + right), (name, l)
            assert q[column]['overturned'][l] == np.isinf(values).sum()
            lower, upper = q[column]['median_lower'][l], q[column]['median_upper'][l]
            assert (lower, upper) == (values[2], values[9]), 'ranks 3 and 10 of 12'
            assert np.isnan(q[column]['p95_upper'][l])
        ratio = np.sort(np.where(fell, np.inf, t['peak_rotation_ratio'])[mine & known])
        median = np.mean(ratio[5:7])
        if np.isfinite(median):
            assert abs(q['peak_rotation_ratio']['median'][l] - median) <= 1e-12
        else:
            assert q['peak_rotation_ratio']['median'][l] == np.pi / 2 / f['bodies'][body]['alpha'][0]
assert seen > 20 and 'peak_slip' not in f['quantiles/type-b']
)python");
    auto const ended = execute(folder, {OVERTURN_PYTHON, "check.py"});
    EXPECT_EQ(ended.code, 0) << ended.err;
}

TEST_F(Limits, FitReportsThemByName) {
    auto const run = overturn(folder, {"run", "c.toml", "-o", "1.h5"});
    ASSERT_EQ(run.code, 0);
    EXPECT_EQ(run.out, overturn(folder, {"fit", "1.h5"}).out + "results: 1.h5\n");
    auto const told = overturn(folder, {"fit", "1.h5", "--full"});
    EXPECT_NE(told.out.find("type-a, limit state touches: peak_slip > 4 cm"), std::string::npos) << told.out;
    EXPECT_NE(told.out.find("peak_slip cm of the trials, with 95 % intervals"), std::string::npos) << told.out;
    EXPECT_EQ(too_wide(told.out), "");
    auto const json = fit("1.h5");

    ASSERT_EQ(json["limit_states"].size(), 5U);
    EXPECT_EQ(json["limit_states"][0]["name"], "overturning");
    EXPECT_EQ(json["limit_states"][4]["definition"], "all of touches, tilts");
    ASSERT_EQ(json["stripes"].size(), 5U * 2 * 3);
    for (std::size_t s = 0; s < json["stripes"].size(); ++s) {
        auto const& stripe = json["stripes"][s];
        EXPECT_EQ(stripe["limit"], json["limit_states"][s / 6]["name"]);
        EXPECT_EQ(stripe.contains("overturned"), s < 6);
        EXPECT_EQ(stripe.contains("exceeded"), s >= 6);
        if (s < 6) {
            std::int64_t sum = 0;
            for (auto const* end : {"at_rest", "slid", "rocked", "overturned", "contact_lost", "failed"}) {
                sum += stripe[end].get<std::int64_t>();
            }
            EXPECT_EQ(sum, stripe["trials"]) << "a row adds up";
        }
    }
    std::size_t const each = json["fragility"].size() / 5;
    EXPECT_EQ(json["fragility"][0]["limit"], "overturning");
    EXPECT_EQ(json["fragility"][each]["limit"], "touches");
    EXPECT_EQ(json["fragility"][each]["measure"], "pga");
    for (auto const& fit : json["fragility"]) {
        bool const own = fit["limit"] != "overturning";
        EXPECT_EQ(fit.contains("exceeded"), own);
        EXPECT_EQ(fit.contains("overturned"), !own);
        EXPECT_EQ(own && fit.dump().find("overturned") != std::string::npos, false) << fit["flags"];
    }
    ASSERT_EQ(json["quantiles"].size(), 9U) << "slip and rotation of type-a, rotation of type-b";
    EXPECT_EQ(json["quantiles"][0]["quantity"], "peak_slip");
    EXPECT_TRUE(json["quantiles"][0]["p95_upper"].is_null());
    for (auto const& row : json["quantiles"]) {
        EXPECT_LE(row["lowest"], row["highest"]) << row;
        EXPECT_TRUE(row["median"].is_null() || (row["lowest"] <= row["median"] && row["median"] <= row["highest"]))
            << row;
    }
    EXPECT_EQ(fit("1.h5"), json);
}

/// A section for the limit states and one for the responses, their tables as csv, the slip in the first lines; names as
/// odd as TOML allows.
TEST_F(Limits, ReportShowsThem) {
    if (execute(folder, {OVERTURN_PYTHON, "-c", "import matplotlib, h5py"}).code != 0) {
        GTEST_SKIP() << "nothing to draw with (install python3-matplotlib python3-h5py)";
    }
    folder.write("odd.toml",
                 small_campaign() + "[[limits]]\nname='_a $\\int < b$'\nquantity='peak_slip'\nabove='4 cm'\n");
    ASSERT_EQ(overturn(folder, {"run", "odd.toml", "-o", "1.h5"}).code, 0);
    auto const ended = overturn(folder, {"report", "1.h5", "-o", "a.html", "--figures", "figures"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    auto const page = folder.read("a.html");

    for (auto const* part :
         {"<section id=\"limits\"", "<section id=\"responses\"", "_a $\\int &lt; b$: peak_slip &gt; 4 cm",
          "<td class=short>slip [cm]</td>", "<th scope=col>at rest</th>", "every measure, with its rank (AUC)"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    auto const fitted = nlohmann::ordered_json::parse(overturn(folder, {"fit", "1.h5", "--json"}).out);
    auto const& stripes = fitted.at("stripes");
    expect_rows(folder.read("figures/stripes.csv"), rows_where(stripes, "limit", "overturning"));
    expect_rows(folder.read("figures/limits.csv"), rows_where(stripes, "limit", "_a $\\int < b$"));
    expect_rows(folder.read("figures/limit-fragility.csv"),
                rows_where(fitted.at("fragility"), "limit", "_a $\\int < b$"));
    expect_rows(folder.read("figures/quantiles.csv"),
                fitted.at("quantiles").get<std::vector<nlohmann::ordered_json>>());
    EXPECT_TRUE(folder.has("figures/peak-slip-type-a.svg"));
}

/// Of what only contact knows, fit recounts what the run counted, and every trial has it.
TEST_F(Limits, OfAModelsOwnQuantitiesAreRecounted) {
    folder.write("p.toml", small_campaign("shared", 4)
                               + "[[limits]]\nname='pressed'\nquantity='peak_contact_force_ratio'\nabove=1.5\n");
    auto const run = overturn(folder, {"run", "p.toml", "-o", "1.h5"});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, overturn(folder, {"fit", "1.h5"}).out + "results: 1.h5\n");
    std::int64_t passed = 0;
    auto const json = fit("1.h5");
    for (auto const& stripe : json["stripes"]) {
        passed += stripe.value("exceeded", 0);
        EXPECT_EQ(stripe["undecided"], 0);
    }
    EXPECT_GT(passed, 0);
    EXPECT_EQ(overturn(folder, {"replay", "1.h5", "--trial", "5"}).code, 0);
}

/// A damaged count is noticed.
TEST_F(Limits, DamagedCountsAreNoticed) {
    ASSERT_EQ(overturn(folder, {"run", "c.toml", "-o", "1.h5"}).code, 0);
    ASSERT_EQ(execute(folder, {OVERTURN_PYTHON, "-c",
                               "import h5py; h5py.File('1.h5','r+')['limits/both/stripes/type-a/exceeded'][1] += 1"})
                  .code,
              0);
    auto const ended = overturn(folder, {"fit", "1.h5"});

    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(is_one_error_line(ended.err));
    EXPECT_NE(ended.err.find("/limits/both/stripes/type-a/exceeded changed"), std::string::npos) << ended.err;
}

TEST_F(Limits, PlanReportsThemAndBodiesThatSlideFirst) {
    auto const plan = planned(folder, {"c.toml"}).out;
    EXPECT_NE(plan.find("limit     either: any of touches, tilts, overturning\n"), std::string::npos) << plan;
    EXPECT_NE(plan.find("  type-a: friction 0.5 < tan(alpha) 0.6507: slides before it rocks"), std::string::npos)
        << plan;
    EXPECT_NE(plan.find("  type-b: no friction stated: it does not slide\n"), std::string::npos) << plan;
    EXPECT_EQ(plan.find("effects   "), std::string::npos);

    auto strong = small_campaign();
    strong.insert(strong.find("friction=0.5\n"), "pad={strength='30 MPa'}\nbase={bedding='flat'}\n");
    folder.write("crush.toml", strong + "[[limits]]\nname='crushed'\nquantity='peak_crush'\nabove='1 mm'\n");
    auto const calls = planned(folder, {"crush.toml"}).out;
    EXPECT_NE(calls.find("effects   sliding, contact in every trial"), std::string::npos) << calls;
    EXPECT_NE(calls.find("0.5 < tan(alpha) 0.6507: slides first, and may rock too"), std::string::npos) << calls;
}

// R-703: A limit state's own target ends a run, at the same wave on any ranks, and overturning, of which the first
// look, after 32 waves, would tell enough here, does not: near P = 1/2 the exact interval of 128 is 0.18 wide, that of
// 64 is 0.26.
TEST_F(Limits, ATargetOfItsOwnEndsTheRun) {
    folder.write("t.toml",
                 small_campaign("shared", 200)
                     + "[[limits]]\nname='touches'\nquantity='peak_slip'\nabove='4 cm'\ntarget_half_width=0.09\n");
    std::vector<std::string> const at{
        "--set", "levels.values=['850 gal']",   "--set", "levels.design_basis='850 gal'",
        "--set", "bodies.1.base_width='1.36 m'"};  // as wide as the other: hardly any falls
    auto const alone = overturn(folder, joined({"run", "t.toml", "-o", "1.h5"}, at));
    ASSERT_EQ(alone.code, 0) << alone.err;
    EXPECT_NE(alone.err.find("precise enough after "), std::string::npos) << alone.err;
    ASSERT_EQ(execute(folder, mpirun(2, joined({"run", "t.toml", "-o", "2.h5"}, at))).code, 0);
    EXPECT_TRUE(folder.read("1.h5") == folder.read("2.h5"));
    auto const json = fit("1.h5");
    ASSERT_EQ(json["stripes"].size(), 4U);
    for (auto const& stripe : json["stripes"]) {
        EXPECT_EQ(stripe["trials"], 128) << stripe;
        if (stripe["limit"] == "overturning") {
            EXPECT_LT(stripe["overturned"], 10) << "so rare that 32 waves would do";
        }
    }
}

}  // namespace
}  // namespace overturn::testing
